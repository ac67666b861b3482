// How others take the colour of a temperature, and the temperature of a colour: from the literature and by what other
// programs compute, kept for comparison with the 1 nm sum. Formulas and coefficients are those of the named papers and
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
    Kelvin coolest; // the range that it is made for or that its program lets through
    Kelvin hottest;
    bool clamps = false; // beyond the range it holds the colour of the end; else it goes on computing
    std::string_view source;
    // XYZ relative to D65. Y is the luminance that a light of luminance 1 is left with: 1 where luminance is kept, less
    // where the greatest of the three channels is made 1.
    glm::dvec3 (*xyz)(Kelvin temperature);
};
std::span<const ColorMethod> color_methods();

// Chromaticity → temperature. NaN where the method has no answer.
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
    double cct_k = 0.0; // of the colour that it gives; NaN where that has none
    double duv = 0.0;
    double luminance = 1.0;
    bool in_range = true;
};
ColorError error_of(const ColorMethod& method, Kelvin temperature);

} // namespace gonio
