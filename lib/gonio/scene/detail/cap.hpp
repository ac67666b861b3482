// A cap of the sphere, given by its half angle, and the angle between two directions.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <numbers>

namespace gonio::detail {

// The cap's solid angle 2π(1 − cos a) [sr] without cancellation.
inline double cap_area(double a) {
    const double s = std::sin(0.5 * a);
    return 4.0 * std::numbers::pi * s * s;
}

// In [0, π], for any two vectors that are not 0 (W. Kahan, "How Futile are Mindless Assessments of Roundoff in
// Floating-Point Computation?", 2006, §12): keeps the digits of small angles.
inline double angle_between(const glm::dvec3& p, const glm::dvec3& q) {
    const glm::dvec3 p_scaled = glm::length(q) * p;
    const glm::dvec3 q_scaled = glm::length(p) * q;
    return 2.0 * std::atan2(glm::length(p_scaled - q_scaled), glm::length(p_scaled + q_scaled));
}

} // namespace gonio::detail
