// Correlated colour temperature and Duv: from chromaticity and back.
//
// The CCT of a chromaticity is the temperature of the nearest black body in u, v of 1960 (CIE 015); Duv is the distance
// to it, positive above the locus (greener), negative below (pinker), as in ANSI C78.377. The smallest radius of
// curvature of the locus is 0.100, at 5190 K, so there is one nearest point for |Duv| < 0.1 and no answer beyond. The
// CIE considers the term meaningful up to 0.05.
//
// `exact` functions work on the 1 nm sum of planckian.hpp, 500 K to 1e6 K, some 10 µs a step; `fast` ones on the double
// fit of locus.hpp, 800 K to 1e6 K, below 1 µs, 1.2e-12 in u'v' from the sum.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/color/chromaticity.hpp>

#include <span>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// A correlated colour temperature, and the distance Duv from the locus: positive is greenish, negative pinkish.
struct Cct {
    Kelvin temperature;
    double duv = 0.0;
};

// Beyond the first a Duv is refused, beyond the second there is a warning: the CIE does not call such a light white.
inline constexpr double greatest_duv = 0.1;
inline constexpr double meaningful_duv = 0.05;

// A curve of chromaticities over temperature.
enum class Locus {
    planckian, // black bodies
    daylight,  // the CIE D illuminants: 4000–25000 K
    blend      // as ANSI/IES TM-30: planckian to 4000 K, daylight from 5000 K, their mixture by Y in between
};
// A locus by its name in text.
struct LocusName {
    std::string_view name;
    Locus locus;
    std::string_view says;
};
// All of them.
std::span<const LocusName> locus_names();
// Fails (usage) on names other than those of locus_names().
Result<Locus> parse_locus(std::string_view text);

// From the sum. Fails (usage) outside 500 K to 1e6 K (daylight 4000–25000 K, blend 500–25000 K), for |Duv| > 0.1, for a
// Duv other than 0 off the Planckian locus (daylight has a Duv already), and if the offset leaves the real colours.
Result<Uv> exact_uv(Cct cct, Locus locus = Locus::planckian);

// The same, from the fit wherever it is valid (from 800 K): some 0.1 µs, at most 1.2e-12 in u'v' away on the locus and
// 6e-11 up to |Duv| = 0.05, where the error of the fit's normal matters.
Result<Uv> uv_of(Cct cct, Locus locus = Locus::planckian);

// The nearest black body. Fails (usage) if there is none: outside 500 K to 1e6 K, |Duv| > 0.1, not finite.
Result<Cct> exact_cct(Uv at);

// As exact_uv by the fit; NaN below 800 K and for |Duv| > 0.1. Does not check the upper limit of the temperature, or
// whether the colour is real. The kernels of kernels.hpp do this for arrays.
Uv fast_uv(Cct cct);

// As exact_cct by the fit; both values are NaN if there is no answer. Differs from exact_cct by at most 1e-5 K for
// 1500–40000 K and |Duv| ≤ 0.05. Does not allocate.
Cct fast_cct(Uv at);

// CIE 015: x as a cubic of 1/T in two pieces, y as a quadratic of x. T in 4000–25000 K, not checked.
Xy daylight_xy(Kelvin temperature);

// A warning if the CIE considers the CCT meaningless (0.05 < |Duv|).
Diagnostics remarks(Cct cct);

// Whether the chromaticity is a mixture of wavelengths: inside the spectral locus and the purple line.
bool is_real(Xy chromaticity);

// Tints: how programs express the distance from the locus, tint = per_duv · Duv.
struct TintConvention {
    std::string_view name;
    double per_duv = 0.0;
    std::string_view says;
};
// All of them.
std::span<const TintConvention> tint_conventions();

// "10@dng": the Duv that it means. Fails (usage) on a bare number, which could follow any convention.
Result<double> parse_tint(std::string_view text);

// "2700K", or "2700K/0.003" with its Duv. Fails (usage) on anything else; exact_uv checks the ranges.
Result<Cct> parse_cct(std::string_view text);

} // namespace gonio
#pragma GCC visibility pop
