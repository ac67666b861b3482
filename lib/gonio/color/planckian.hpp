// The reference: the chromaticity of a black body as a sum over wavelengths, and the locus of these chromaticities.
//
// CIE 1931 2° observer, 360–830 nm in steps of 1 nm, plain sum; Planck's law in vacuum with c2 = hc/k of the SI (2019),
// 1.438776877e-2 m·K. CIE 015 keeps c2 = 1.4388e-2 (ITS-90), a difference of 1.6e-5 in temperature: 0.1 K at 6500 K,
// at most 3.8e-6 in u'v'. Every error that gonio states is relative to this sum. About 10 µs a call.
//
// The locus is a curve over t = 1000 K / T: t = 0 is infinite temperature, a regular point, and a step in t is about
// equally visible everywhere. Units: t in 1/kK (a mired is 1e-3 of it).
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/color/chromaticity.hpp>

#include <glm/vec3.hpp>

namespace gonio {

inline constexpr double c2_meter_kelvin = 1.438776877e-2;
inline constexpr double c2_its90_meter_kelvin = 1.4388e-2;

// The range of the sum; colour temperature is not used beyond it.
inline constexpr Kelvin coolest{500.0};
inline constexpr Kelvin hottest{1e6};

// A point of the locus in u, v (1960) with its first two derivatives by t.
struct LocusPoint {
    Uv at;
    Uv first;
    Uv second;
};

// 0 < t ≤ 2.
LocusPoint planckian_sum(double t_per_kk);

// XYZ with Y = 1; any T > 0, also infinite (λ⁻⁴).
glm::dvec3 planckian_xyz(Kelvin temperature, double c2 = c2_meter_kelvin);

// Luminous efficacy [lm/W] of the radiation of a black body: of all radiation (σT⁴), and of that in 360–830 nm.
struct BlackbodyEfficacy {
    double total_lm_per_w = 0.0;
    double band_lm_per_w = 0.0;
};
BlackbodyEfficacy blackbody_efficacy(Kelvin temperature);

// Luminance [nt] of a black body; the second form takes its efficacy and costs almost nothing.
Nits blackbody_luminance(Kelvin temperature);
Nits blackbody_luminance(Kelvin temperature, const BlackbodyEfficacy& efficacy);

} // namespace gonio
