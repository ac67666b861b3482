// Form factors of flat patches for a small receiver at the origin: the share of the light from its hemisphere, weighted
// by the cosine, that comes from the patch. Exact sums over edges (J. H. Lambert, "Photometria", 1760).
#pragma once

#include <gonio/scene/core_vector.hpp>
#include <gonio/shading/outline.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace gonio::detail {

// What the receiver sees of a flat quadrilateral, from either side: all above its horizon.
struct SeenPolygon {
    double form_factor = 0.0;
    glm::dvec3 middle{0.0}; // of its corners
};
inline SeenPolygon seen_above(const glm::dvec3& normal, const std::array<glm::dvec3, 4>& corners) {
    std::array<glm::dvec3, 5> above{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec3& a = corners[i];
        const glm::dvec3& b = corners[(i + 1) % 4];
        const double height_a = glm::dot(normal, a);
        const double height_b = glm::dot(normal, b);
        if (height_a >= 0.0) above[count++] = a;
        if ((height_a > 0.0 && height_b < 0.0) || (height_a < 0.0 && height_b > 0.0))
            above[count++] = a + height_a / (height_a - height_b) * (b - a);
    }
    SeenPolygon seen;
    if (count < 3) return seen;
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3& a = above[i];
        const glm::dvec3& b = above[(i + 1) % count];
        seen.middle += a / static_cast<double>(count);
        sum += shading::great_arc(vec(a), vec(b - a), vec(normal));
    }
    seen.form_factor = std::abs(sum) * std::numbers::inv_pi;
    return seen;
}

} // namespace gonio::detail
