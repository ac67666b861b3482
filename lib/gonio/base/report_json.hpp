// Parts of JSON reports.
#pragma once

#include <gonio/base/diagnostics.hpp>
#include <gonio/base/json.hpp>

#include <optional>

namespace gonio::detail {

// The number, or null if there is none: JSON writes null for one that is not finite.
Json number_or_null(const std::optional<double>& value);

Json diagnostics_json(const Diagnostics& diagnostics);

} // namespace gonio::detail
