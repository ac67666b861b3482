// JSON texts: reading them within limits, and locating errors in them.
#pragma once

#include <gonio/base/json.hpp>
#include <gonio/base/result.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace gonio::detail {

// Line and column, from 1, of the byte at `offset`.
Location location_in(std::string_view text, std::size_t offset, const std::string& source);

// The value of the text. If a key is given twice, the last one counts. Fails (malformed), with line and column in
// `source`, on anything that is not JSON and beyond the limits json-depth, json-keys and json-values.
Result<Json> parse_json(std::string_view text, const std::string& source = {});

} // namespace gonio::detail
