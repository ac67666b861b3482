// Parts of JSON reports.
#pragma once

#include <gonio/base/report_json.hpp>

#include <string>

namespace gonio::cli {

using detail::diagnostics_json;
using detail::Json;
using detail::number_or_null;

// The report with a newline at its end: in one line if `indent` is negative, else with a line for each value, but one
// for ten numbers or more in an array.
std::string dump(const Json& json, int indent);

// The same as an element of an array that is written piece by piece, two spaces deep, without a newline.
std::string dump_element(const Json& json);

} // namespace gonio::cli
