// The colour rendering index of CIE 13.3-1995: Ra and R1 to R15.
//
// Test colour samples under the light and under the reference illuminant of its colour temperature (a black body below
// 5000 K, else a D illuminant): differences in U*V*W* of 1964 after von Kries' adaptation in u, v of 1960. The CIE 1931
// observer, over 380–780 nm at the wavelengths of the light (spectrum.hpp says which those are); radiance factors of
// the samples are interpolated between their 5 nm by Sprague's formula.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/color/reference_illuminant.hpp>
#include <gonio/color/spectrum.hpp>

#include <array>
#include <cstddef>

#pragma GCC visibility push(default)
namespace gonio {

// 1 to 14 of CIE 13.3, and 15, Japanese skin, of JIS Z 8726.
inline constexpr std::size_t rendering_sample_count = 15;

// Colour rendering by CIE 13.3. 100 is no difference, and a light may have less than 0.
struct ColorRendering {
    double ra = 0.0;                                // the mean of R1 to R8
    std::array<double, rendering_sample_count> r{}; // r[8] is R9
    ReferenceIlluminant reference = ReferenceIlluminant::planckian;
    double reference_duv = 0.0; // from the light to its reference illuminant in u, v of 1960, never negative
};

// Beyond this `reference_duv` CIE 13.3 considers its figures inaccurate.
inline constexpr double greatest_reference_duv = 5.4e-3;

// Fails (usage) on a light without a reference illuminant: no visible light, no colour temperature, or one outside
// 500–25000 K. Some 10 µs at 5 nm, 40 µs at 1 nm.
Result<ColorRendering> color_rendering(const Spectrum& spectrum);

} // namespace gonio
#pragma GCC visibility pop
