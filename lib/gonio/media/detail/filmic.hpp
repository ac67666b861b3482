// The view "Filmic" of the built-in display: up to middle grey the numbers of Standard, and white for light without
// bound. Channels that reach 1 one after the other turn tungsten lemon yellow, so the curve acts on channels that are
// moved towards their luminance: black-body, red, amber and blue light then keep their hue within 5° in Oklab
// (Standard: 38 to 76°). Private to media.
#pragma once

#include <algorithm>

namespace gonio::media::detail {

// The share of a channel that becomes luminance before the curve, and back after it.
inline constexpr double filmic_mix = 0.7;
// Up to here the curve changes nothing.
inline constexpr double filmic_linear = 0.18;

constexpr double filmic_curve(double x) {
    if (x <= filmic_linear) return std::max(x, 0.0);
    const double t = (x - filmic_linear) / (1.0 - filmic_linear);
    return filmic_linear + (1.0 - filmic_linear) * t / (1.0 + t);
}

} // namespace gonio::media::detail
