// A light with a size as parallel lines over what is seen of it from a point: where rays would sample its area, a line
// takes all of a stripe at once, since a convex body hides one piece of it (shadow_line.hpp).
//
// The lines lie in planes that turn about one axis through the receiver, and each ends where its plane leaves the
// light's outline. By the sine s of the elevation towards that axis, and the turn β, solid angle is ds dβ: what a piece
// of a line stands for is exact along it, and the midpoint of the stripe across it.
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
    glm::dvec3 from{0.0}; // the ends, relative to the receiver [m]: on the light, or where rays touch it
    glm::dvec3 to{0.0};
    glm::dvec3 across{0.0}; // unit: of the line's plane, perpendicular to the axis
    double low = 0.0;       // sines of the elevation, of `from` and of `to`
    double high = 0.0;
    double turn = 0.0; // dβ of its stripe [rad]
};

struct LightLines {
    glm::dvec3 axis{0.0}; // unit
    std::array<LightLine, light_line_count> lines;
    std::size_t count = 0; // 0 where nothing is seen of the light, or where the receiver is inside

    double sine_of(const glm::dvec3& point) const { return glm::dot(axis, point) / glm::length(point); }
    glm::dvec3 direction(const LightLine& line, double sine) const {
        return sine * axis + std::sqrt((1.0 - sine) * (1.0 + sine)) * line.across;
    }
};

// Of spheres, disks, rectangles and tubes; no lines of others. They run as near to the direction `along` (of any
// length) as the shape lets them, a tube's along the tube, each in the middle of its stripe.
LightLines light_lines(const Light& light, const glm::dvec3& receiver, const glm::dvec3& along);

} // namespace gonio::detail
