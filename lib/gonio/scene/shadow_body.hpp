// Primitives and lights as the numbers that shadows are computed from.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/primitives.hpp>
#include <gonio/scene/shadow_numbers.hpp>

namespace gonio::detail {

// `around`: a sphere that the light lies in.
LinedLight lined_light(const Light& light, const Ball& around);

ShadowBody shadow_body(const Primitive& body, const LinedLight& light);

} // namespace gonio::detail
