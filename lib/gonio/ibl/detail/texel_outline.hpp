// The outline of a texel on the sphere, as curves that Gauss nodes are laid on.
//
// Sides are great circles, or parallels for a lat-long's upper and lower side. Integrals of zonal functions and of
// spherical harmonics over a texel are integrals along its outline.
#pragma once

#include <gonio/sky/environment_layout.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace gonio::detail {

// A side, from `from` to `to`: ω(t) = middle + cos(s) e + sin(s) f, s = arc·t, t in [0, 1].
struct OutlineSide {
    glm::dvec3 middle; // of the circle: 0 for a great circle
    glm::dvec3 e;
    glm::dvec3 f;
    double arc = 0.0; // 0: no length

    [[nodiscard]] glm::dvec3 at(double t) const { return middle + std::cos(arc * t) * e + std::sin(arc * t) * f; }
    // dω/dt
    [[nodiscard]] glm::dvec3 step(double t) const { return arc * (std::cos(arc * t) * f - std::sin(arc * t) * e); }
};

// Counter-clockwise as seen from outside the sphere.
using TexelOutline = std::array<OutlineSide, 4>;

TexelOutline outline_of(const EnvironmentGrid& grid, TexelIndex texel);

} // namespace gonio::detail
