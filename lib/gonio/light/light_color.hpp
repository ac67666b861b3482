// The colour of a light: a chromaticity as linear Rec.709 RGB of luminance 1, so that a light's photometric quantity
// keeps its meaning for every colour.
#pragma once

#include <gonio/base/result.hpp>

#include <glm/vec3.hpp>

#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

class FileScope;
struct Spectrum;

// Y of linear Rec.709 RGB: the middle row of the RGB to XYZ matrix derived from the primaries and white of ITU-R
// BT.709.
inline constexpr glm::dvec3 rec709_luminance{0.21263900587151027, 0.71516867876775592, 0.072192315360733714};

// "2700K" and "2700K/0.003" (black body, with its Duv), "d65" (white), another CIE illuminant ("LED-B3"),
// "spectrum:FILE" (CSV or TM-33), "rgb(r,g,b)" (linear Rec.709), "#ffd9a0" (sRGB-encoded). Colours outside Rec.709
// (including black bodies below 1900 K) are clipped at constant luminance, and a warning in `diagnostics`, if given,
// reports by how much. FILE may be any file or, if `files` is given, one that `files` allows. Fails (usage) on anything
// else and on black, and as uv_of and read_spectrum do.
Result<glm::dvec3> parse_light_color(std::string_view text, Diagnostics* diagnostics = nullptr,
                                     FileScope* files = nullptr);

// Colour of a spectrum, clipped as above. Fails as color_of() does.
Result<glm::dvec3> light_color_of(const Spectrum& spectrum, Diagnostics* diagnostics = nullptr);

// "rgb(r,g,b)", or one number for all three. Does not normalise. Fails (usage) on numbers that are not finite or are
// negative.
Result<glm::dvec3> parse_rgb(std::string_view text);

} // namespace gonio
#pragma GCC visibility pop
