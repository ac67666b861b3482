// The colour of a light: a chromaticity as linear Rec.709 RGB of luminance 1, so that a light's photometric quantity
// keeps its meaning whatever its colour.
#pragma once

#include <gonio/base/result.hpp>

#include <glm/vec3.hpp>

#include <string_view>

namespace gonio {

// Y of linear Rec.709 RGB: the middle row of the RGB to XYZ matrix that follows from the primaries and white of
// ITU-R BT.709.
inline constexpr glm::dvec3 rec709_luminance{0.21263900587151027, 0.71516867876775592, 0.072192315360733714};

// "d65" (white), "rgb(r,g,b)" (linear Rec.709), "#ffd9a0" (sRGB-encoded). Fails: usage on anything else and on black,
// unsupported on a colour temperature.
Result<glm::dvec3> parse_light_color(std::string_view text);

// "rgb(r,g,b)", or one number for all three. No normalisation. Fails (usage) on numbers that are not finite or
// negative.
Result<glm::dvec3> parse_rgb(std::string_view text);

} // namespace gonio
