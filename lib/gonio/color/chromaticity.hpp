// Chromaticity: the colour of light without its amount, for the CIE 1931 2° observer.
//
// Three coordinate systems for the same thing: x, y of 1931; u, v of 1960, which defines colour temperature;
// u', v' of 1976, in which differences are stated (u' = u, v' = 1.5 v). Tristimulus values are XYZ with Y = 1 unless
// stated otherwise. Nothing here checks its arguments: y = 0 (v = 0) gives infinities.
#pragma once

#include <glm/vec3.hpp>

#include <cmath>

#pragma GCC visibility push(default)
namespace gonio {

// A chromaticity, CIE 1931.
struct Xy {
    double x = 0.0;
    double y = 0.0;
};

struct Uv { // CIE 1960
    double u = 0.0;
    double v = 0.0;
};

struct UvPrime { // CIE 1976
    double u = 0.0;
    double v = 0.0;
};

// The same chromaticity in other coordinates.
constexpr Uv to_uv(Xy c) {
    const double d = 12.0 * c.y - 2.0 * c.x + 3.0;
    return {4.0 * c.x / d, 6.0 * c.y / d};
}
// The same chromaticity in other coordinates.
constexpr Uv to_uv(UvPrime c) {
    return {c.u, c.v / 1.5};
}
constexpr Uv to_uv(const glm::dvec3& xyz) {
    const double d = xyz.x + 15.0 * xyz.y + 3.0 * xyz.z;
    return {4.0 * xyz.x / d, 6.0 * xyz.y / d};
}
constexpr UvPrime to_uv_prime(Uv c) {
    return {c.u, 1.5 * c.v};
}
// The same chromaticity in other coordinates.
constexpr Xy to_xy(Uv c) {
    const double d = 2.0 * c.u - 8.0 * c.v + 4.0;
    return {3.0 * c.u / d, 2.0 * c.v / d};
}
constexpr Xy to_xy(const glm::dvec3& xyz) {
    const double sum = xyz.x + xyz.y + xyz.z;
    return {xyz.x / sum, xyz.y / sum};
}

// XYZ of luminance 1.
constexpr glm::dvec3 to_xyz(Uv c) {
    return {1.5 * c.u / c.v, 1.0, (4.0 - c.u - 10.0 * c.v) / (2.0 * c.v)};
}
constexpr glm::dvec3 to_xyz(Xy c) {
    return {c.x / c.y, 1.0, (1.0 - c.x - c.y) / c.y};
}

// Δu'v', the distance in the 1976 diagram.
inline double delta_uv_prime(Uv a, Uv b) {
    return std::hypot(a.u - b.u, 1.5 * (a.v - b.v));
}

// D65 as used in the definitions of colour spaces (ITU-R BT.709), and the white of the ACES spaces.
inline constexpr Xy d65_white{0.3127, 0.3290};
inline constexpr Xy aces_white{0.32168, 0.33767};

} // namespace gonio
#pragma GCC visibility pop
