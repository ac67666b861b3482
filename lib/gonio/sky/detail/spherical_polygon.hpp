// Small convex polygons on the unit sphere, with great circles as sides: clipping, solid angle, and the integral of the
// direction over them.
//
// Vertices run one way round; which way does not matter. Nothing here allocates.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace gonio::detail {

struct SphericalPolygon {
    // A quadrilateral gains at most one vertex per clipping plane; texels are clipped by at most eight.
    static constexpr std::size_t most = 16;

    std::array<glm::dvec3, most> vertex; // unit vectors
    std::size_t count = 0;

    void add(const glm::dvec3& unit) {
        if (count < most) vertex[count++] = unit;
    }
    [[nodiscard]] bool empty() const { return count < 3; }
};

// The part with ω·normal ≥ 0; the normal has any length. (Sutherland and Hodgman 1974; the cut of a side lies on its
// great circle.)
inline SphericalPolygon clipped(const SphericalPolygon& polygon, const glm::dvec3& normal) {
    SphericalPolygon kept;
    if (polygon.empty()) return kept;
    std::size_t before = polygon.count - 1;
    double side_before = glm::dot(polygon.vertex[before], normal);
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const double side = glm::dot(polygon.vertex[i], normal);
        if ((side >= 0.0) != (side_before >= 0.0) && side != 0.0 && side_before != 0.0)
            kept.add(glm::normalize(side_before * polygon.vertex[i] - side * polygon.vertex[before]) *
                     (side_before > side ? 1.0 : -1.0));
        if (side >= 0.0) kept.add(polygon.vertex[i]);
        before = i;
        side_before = side;
    }
    return kept;
}

// 2 tan⁻¹ of a triple product over 1 + a·b + b·c + c·a for each triangle of a fan (A. Van Oosterom and J. Strackee
// 1983), from differences of the vertices, so that small polygons keep their digits. Below a hemisphere.
inline double signed_solid_angle(const SphericalPolygon& polygon) {
    double sum = 0.0;
    for (std::size_t i = 2; i < polygon.count; ++i) {
        const glm::dvec3& a = polygon.vertex[0];
        const glm::dvec3& b = polygon.vertex[i - 1];
        const glm::dvec3& c = polygon.vertex[i];
        sum += 2.0 * std::atan2(glm::dot(a, glm::cross(b - a, c - a)),
                                1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
    }
    return sum;
}
inline double solid_angle(const SphericalPolygon& polygon) {
    return std::abs(signed_solid_angle(polygon));
}

// ∫ ω dω: half the sum of the sides' angles times the normals of their great circles (J. H. Lambert, Photometria,
// 1760). Its product with a normal above which the polygon lies is the integral of the cosine.
inline glm::dvec3 direction_integral(const SphericalPolygon& polygon) {
    glm::dvec3 sum(0.0);
    if (polygon.empty()) return sum;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const glm::dvec3& a = polygon.vertex[i];
        const glm::dvec3& b = polygon.vertex[i + 1 < polygon.count ? i + 1 : 0];
        const glm::dvec3 normal = glm::cross(a, b - a);
        const double sine = glm::length(normal);
        if (sine > 0.0) sum += normal * (0.5 * std::atan2(sine, glm::dot(a, b)) / sine);
    }
    return signed_solid_angle(polygon) < 0.0 ? -sum : sum;
}

} // namespace gonio::detail
