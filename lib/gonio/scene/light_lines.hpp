// An area light as parallel lines over its visible part, as seen from a point. Where rays would sample the light's
// area, a line takes a whole stripe at once, since a convex object hides one piece of it (shadow_line.hpp).
//
// The lines lie in planes that turn about one axis through the receiver, and each ends where its plane leaves the
// light's outline. In terms of the sine s of the elevation towards that axis and the turn β, solid angle is ds dβ: the
// integral is exact along a piece of a line, and uses the midpoint of the stripe across it.
#pragma once

#include <gonio/light/light.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace gonio::detail {

inline constexpr std::size_t light_line_count = 8;

struct LightLine {
    glm::dvec3 from{0.0}; // the ends, relative to the receiver [m]: on the light, or where rays are tangent to it
    glm::dvec3 to{0.0};
    glm::dvec3 across{0.0}; // unit: in the line's plane, perpendicular to the axis
    double low = 0.0;       // sines of the elevation, of `from` and of `to`
    double high = 0.0;
    double turn = 0.0; // dβ of its stripe [rad]
};

struct LightLines {
    glm::dvec3 axis{0.0}; // unit
    std::array<LightLine, light_line_count> lines;
    std::size_t count = 0; // 0 where the light is not visible, or where the receiver is inside

    double sine_of(const glm::dvec3& point) const { return glm::dot(axis, point) / glm::length(point); }
    glm::dvec3 direction(const LightLine& line, double sine) const {
        return sine * axis + std::sqrt((1.0 - sine) * (1.0 + sine)) * line.across;
    }
};

// For spheres, disks, ellipses, rectangles, tubes and cylinders; other shapes have no lines. The lines run as close to
// the direction `along` (of any length) as the shape allows, for a tube along the tube, each in the middle of its
// stripe.
LightLines light_lines(const Light& light, const glm::dvec3& receiver, const glm::dvec3& along);

} // namespace gonio::detail
