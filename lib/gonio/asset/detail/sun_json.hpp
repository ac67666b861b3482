// A sun beside an environment, in the JSON of sidecars; null if there is none.
#pragma once

#include <gonio/base/json.hpp>
#include <gonio/sky/sun_light.hpp>

#include <optional>

namespace gonio::detail {

Json to_json(const std::optional<SunLight>& sun);

} // namespace gonio::detail
