// The same picture with other amounts and colours of its lights, without rendering it: light is linear.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/preview/render.hpp>

#include <optional>
#include <span>

namespace gonio {

// `picture` is the result of render() for the lights `before`. The lights `now` are the same but for their amounts and
// colours, and everything else is as it was. If all lights changed by one factor per channel, the picture is multiplied
// by it, which is the result of render() to float rounding; its `indirect` is null. Empty if they did not, if a channel
// that was dark is lit, or if factors do not give the illuminance: that of light that bounced and changed in colour.
// Not for pictures with a sky, whose light does not change with that of the lights.
std::optional<Rendering> relit(const Rendering& picture, std::span<const Light> before, std::span<const Light> now);

} // namespace gonio
