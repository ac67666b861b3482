// The colour of a light: a chromaticity as linear Rec.709 RGB of luminance 1, so that a light's photometric quantity
// keeps its meaning whatever its colour.
#pragma once

#include <gonio/base/result.hpp>

#include <glm/vec3.hpp>

#include <string_view>

namespace gonio {

class FileScope;
struct Spectrum;

// Y of linear Rec.709 RGB: the middle row of the RGB to XYZ matrix that follows from the primaries and white of
// ITU-R BT.709.
inline constexpr glm::dvec3 rec709_luminance{0.21263900587151027, 0.71516867876775592, 0.072192315360733714};

// "2700K" and "2700K/0.003" (black body, with its Duv), "d65" (white), another CIE illuminant ("LED-B3"),
// "spectrum:FILE" (CSV or TM-33), "rgb(r,g,b)" (linear Rec.709), "#ffd9a0" (sRGB-encoded). Colours outside Rec.709
// (black bodies below 1900 K among them) are clipped, their luminance kept, and a warning says by how much; without
// `diagnostics` nobody hears it. FILE is any file, or where `files` is given one that these allow. Fails (usage) on
// anything else and on black, and as uv_of and read_spectrum do.
Result<glm::dvec3> parse_light_color(std::string_view text, Diagnostics* diagnostics = nullptr,
                                     FileScope* files = nullptr);

// Of a spectrum, clipped as above. Fails as color_of() does.
Result<glm::dvec3> light_color_of(const Spectrum& spectrum, Diagnostics* diagnostics = nullptr);

// "rgb(r,g,b)", or one number for all three. No normalisation. Fails (usage) on numbers that are not finite or
// negative.
Result<glm::dvec3> parse_rgb(std::string_view text);

} // namespace gonio
