// How much of a light a surface point sees past the balls of a stage.
#pragma once

#include <gonio/scene/stage.hpp>

#include <glm/vec3.hpp>

#include <cstddef>

namespace gonio {

// The share, in [0, 1], of the solid angle of a spherical light (radius 0: a point) that the stage's balls leave free
// as seen from `point` on surface `own`. Exact for one ball; where several overlap each other the product of their
// shares is taken. The share weighs all directions alike: with the cosine at the receiver it is exact for a ball that
// covers all or nothing, and in between for small lights.
double visible_share(const Stage& stage, std::size_t own, const glm::dvec3& point, const glm::dvec3& light_center,
                     double light_radius);

// Solid angle common to two caps of half angles a and b ∈ [0, π/2] whose axes are d ∈ [0, π] apart [sr].
// Closed form of the two overlapping circular segments on the sphere (Mazonka 2012); planar lens below 1e-4 rad,
// where the spherical form cancels.
double cap_overlap(double a, double b, double d);

} // namespace gonio
