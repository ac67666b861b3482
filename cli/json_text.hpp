// Parts of JSON reports.
#pragma once

#include <gonio/base/diagnostics.hpp>
#include <gonio/base/json.hpp>

#include <optional>
#include <string>

namespace gonio::cli {

using detail::Json;

// The number, or null if there is none: JSON writes null for one that is not finite.
Json number_or_null(const std::optional<double>& value);

Json diagnostics_json(const Diagnostics& diagnostics);

// The report with a newline at its end: in one line if `indent` is negative.
std::string dump(const Json& json, int indent);

} // namespace gonio::cli
