// Primitives and lights as the numbers that shadows are computed from.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/primitives.hpp>
#include <gonio/scene/shadow_numbers.hpp>

namespace gonio::detail {

// `around_light`: a sphere that the light lies in.
ShadowBody shadow_body(const Primitive& body, const Ball& around_light);

LinedLight lined_light(const Light& light, const Ball& around);

} // namespace gonio::detail
