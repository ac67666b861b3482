// Other methods for the colour of a temperature and the temperature of a colour, from the literature and from other
// programs, kept for comparison with the 1 nm sum. Formulas and coefficients are those of the named papers and
// programs; the code is gonio's own.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/color/chromaticity.hpp>

#include <glm/vec3.hpp>

#include <span>
#include <string_view>
#include <vector>

namespace gonio {

// Temperature → colour.
struct ColorMethod {
    std::string_view name;
    Kelvin coolest; // the range that it is made for or that its program accepts
    Kelvin hottest;
    bool clamps = false; // beyond the range it returns the colour of the end; otherwise it extrapolates
    std::string_view source;
    // XYZ relative to D65. Y is the remaining luminance of a light of luminance 1: 1 if luminance is kept, less if the
    // greatest of the three channels is scaled to 1.
    glm::dvec3 (*xyz)(Kelvin temperature);
};
std::span<const ColorMethod> color_methods();

// Chromaticity → temperature. NaN if the method has no answer.
struct CctMethod {
    std::string_view name;
    Kelvin coolest;
    Kelvin hottest;
    std::string_view source;
    double (*cct_k)(Uv at);
};
std::span<const CctMethod> cct_methods();

// "krystek,usd", or "all". Fails (usage) on unknown names.
Result<std::vector<const ColorMethod*>> parse_color_methods(std::string_view list);
Result<std::vector<const CctMethod*>> parse_cct_methods(std::string_view list);

// The error of a method against the sum at one temperature.
struct ColorError {
    Uv at;
    double delta_uv_prime = 0.0;
    double cct_k = 0.0; // of the colour that it gives; NaN if that colour has none
    double duv = 0.0;
    double luminance = 1.0;
    bool in_range = true;
};
ColorError error_of(const ColorMethod& method, Kelvin temperature);

} // namespace gonio
