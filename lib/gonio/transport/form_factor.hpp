// Form factors of flat patches for a small receiver at the origin: the share of the light from its hemisphere, weighted
// by the cosine, that comes from the patch. Exact sums over edges (J. H. Lambert, "Photometria", 1760).
#pragma once

#include <gonio/scene/core_vector.hpp>
#include <gonio/shading/outline.hpp>
#include <gonio/simd/math.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace gonio::detail {

// atan(√t)/√t for t ≥ 0. Below 1/4 by the seventh convergent of Gauss's continued fraction, to 2e-10: with the
// precision of simd/math.hpp throughout, pictures with bounced light take up to a twentieth longer.
inline double atan_ratio(double t) {
    if (!(t < 0.25)) return 1.0 + simd::atan_ratio_excess(t);
    const double above = 1.0 + t * (23.0 / 15.0 + t * (383.0 / 585.0 + t * (5053.0 / 75075.0)));
    const double below = 1.0 + t * (28.0 / 15.0 + t * (14.0 / 13.0 + t * (28.0 / 143.0 + t * (7.0 / 1287.0))));
    return above / below;
}

// Of the parts of a parallelogram, from either side.
struct Parallelogram {
    Parallelogram(const glm::dvec3& normal, const glm::dvec3& side_u, const glm::dvec3& side_v)
        : n(normal),
          u(side_u),
          v(side_v),
          u_n(glm::cross(u, n)),
          v_n(glm::cross(v, n)),
          uu(glm::dot(u, u)),
          vv(glm::dot(v, v)),
          uv(glm::dot(u, v)),
          v_u_n(glm::dot(v, u_n)),
          rise_u(std::abs(glm::dot(n, u))),
          rise_v(std::abs(glm::dot(n, v))) {}

    // Whether all of the part with its middle at `to`, and `half` of its sides in those of the whole, is above the
    // receiver's horizon.
    bool is_above(const glm::dvec3& to, const glm::dvec2& half) const {
        return glm::dot(n, to) >= half.x * rise_u + half.y * rise_v;
    }

    // Of such a part, from three of its half diagonals on: its edges subtend less than 45° then. The corners of an edge
    // are p ± s, so their dot product is p² − s² and their cross product 2 p×s.
    double form_factor(const glm::dvec3& to, const glm::dvec2& half) const {
        const double tt = glm::dot(to, to);
        const double tu = half.x * glm::dot(to, u);
        const double tv = half.y * glm::dot(to, v);
        const double t_u_n = half.x * glm::dot(to, u_n);
        const double t_v_n = half.y * glm::dot(to, v_n);
        const double su = half.x * half.x * uu;
        const double sv = half.y * half.y * vv;
        const double suv = half.x * half.y * uv;
        const double s_v_u_n = half.x * half.y * v_u_n; // −u·(v×n)
        const auto edge = [](double pp, double ps, double ss, double p_s_n) {
            const double along = pp - ss;
            const double tangent2 = std::max(4.0 * (pp * ss - ps * ps), 0.0) / (along * along);
            return atan_ratio(tangent2) / along * p_s_n;
        };
        const double sum = edge(tt - 2.0 * tv + sv, tu - suv, su, t_u_n - s_v_u_n) +
                           edge(tt + 2.0 * tu + su, tv + suv, sv, t_v_n - s_v_u_n) -
                           edge(tt + 2.0 * tv + sv, tu + suv, su, t_u_n + s_v_u_n) -
                           edge(tt - 2.0 * tu + su, tv - suv, sv, t_v_n + s_v_u_n);
        return std::abs(sum) * std::numbers::inv_pi;
    }

    glm::dvec3 n, u, v;
    glm::dvec3 u_n, v_n; // u×n, v×n
    double uu, vv, uv, v_u_n;
    double rise_u, rise_v;
};

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
