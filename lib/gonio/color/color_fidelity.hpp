// Colour fidelity and gamut of ANSI/IES TM-30 and CIE 224:2017: Rf, Rg, and shifts of chroma and hue by hue bin.
//
// 99 test colour samples under the light and under the reference illuminant of its colour temperature (a black body to
// 4000 K, a D illuminant from 5000 K, a mixture between), by the CIE 1964 10° observer: differences in CAM02-UCS with
// complete adaptation, 100 cd/m² and a background of 20 %. Over 380–780 nm at the wavelengths of the light
// (spectrum.hpp says which those are); radiance factors of the samples are interpolated between their 5 nm by
// Sprague's formula.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/color/reference_illuminant.hpp>
#include <gonio/color/spectrum.hpp>

#include <array>
#include <cstddef>

#pragma GCC visibility push(default)
namespace gonio {

// Test colour samples of CIE 224.
inline constexpr std::size_t fidelity_sample_count = 99;
// Bins of hue of TM-30.
inline constexpr std::size_t hue_bin_count = 16;

// A point of the plane a', b' of CAM02-UCS.
struct HuePoint {
    double a = 0.0;
    double b = 0.0;
};

// The samples whose hue under the reference is in one sixteenth of the circle, from its 22.5° · index.
struct HueBin {
    double fidelity = 0.0;     // Rf,h: 0 to 100
    double chroma_shift = 0.0; // Rcs,h, of the reference's chroma: 0.1 is 10 % more
    double hue_shift = 0.0;    // Rhs,h, of the reference's chroma: about radians; above 0 counter-clockwise
    int samples = 0;           // if there are none, all other values are NaN
    HuePoint light;            // means of the samples
    HuePoint reference;
};

// Colour fidelity and gamut by TM-30.
struct ColorFidelity {
    double rf = 0.0;                                     // 0 to 100
    double rg = 0.0;                                     // gamut area, 100: that of the reference
    std::array<HueBin, hue_bin_count> bins{};            // counter-clockwise from the reds
    std::array<double, fidelity_sample_count> samples{}; // Rf,CES of each: samples[0] is CES 1
    ReferenceIlluminant reference = ReferenceIlluminant::planckian;
};

// Fails (usage) on a light without a reference illuminant: no visible light, no colour temperature, or one outside
// 500–25000 K. Some 60 µs at 5 nm, 80 µs at 1 nm.
Result<ColorFidelity> color_fidelity(const Spectrum& spectrum);

} // namespace gonio
#pragma GCC visibility pop
