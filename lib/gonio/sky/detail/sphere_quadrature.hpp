// Integrals over the part of the sphere above one or two planes, in rings about an axis.
//
// The integrand may have a cusp at the axis (a CIE sky at its sun) and is smooth elsewhere. Rings end at the planes in
// closed form; the axis' angle χ is divided where a ring touches a plane or a corner, with nodes that gather at the
// ends of each part, where the length of the arcs has a root. 48 × 2 × 40 Gauss–Legendre nodes to a part: a CIE sky
// agrees with adaptive quadrature in other coordinates to 1e-9 (tests/unit/sky/cie_sky.cpp).
#pragma once

#include <gonio/base/gauss_legendre.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

namespace gonio::detail {

struct Arc {
    double begin;
    double end;
};

// Two arcs of the same circle meet in at most two.
struct Arcs {
    std::array<Arc, 2> arcs{};
    std::size_t count = 0;

    void add(double begin, double end) {
        if (end > begin && count < arcs.size()) arcs.at(count++) = {begin, end};
    }
};

// Two unit vectors perpendicular to a unit vector and to each other.
inline std::array<glm::dvec3, 2> perpendicular(const glm::dvec3& axis) {
    const glm::dvec3 other = std::abs(axis.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 first = glm::normalize(glm::cross(axis, other));
    return {first, glm::cross(axis, first)};
}

// ∫ g(ω, χ) dω over the directions ω with ω·n > 0 for each n of `above`: one or two unit vectors. χ is the angle
// between ω and the unit vector `axis`.
template<class Integrand>
double integrate_above(const glm::dvec3& axis, std::span<const glm::dvec3> above, const Integrand& g) {
    constexpr double pi = std::numbers::pi;
    static constexpr auto outer = gauss_legendre<48>();
    static constexpr auto inner = gauss_legendre<40>();
    const std::array across_axis = perpendicular(axis);
    const glm::dvec3& e = across_axis[0];
    const glm::dvec3& f = across_axis[1];

    // The angles χ at which a ring begins or ends to meet a plane or passes a corner.
    std::array<double, 8> ends{};
    std::size_t count = 0;
    ends.at(count++) = 0.0;
    ends.at(count++) = pi;
    const auto divide_at = [&](double angle) {
        ends.at(count++) = angle;
        ends.at(count++) = pi - angle;
    };
    for (const glm::dvec3& n : above)
        divide_at(std::asin(std::clamp(std::abs(glm::dot(axis, n)), 0.0, 1.0)));
    if (above.size() == 2) {
        const glm::dvec3 corner = glm::cross(above[0], above[1]);
        if (const double length = glm::length(corner); length > 1e-12)
            divide_at(std::acos(std::clamp(glm::dot(axis, corner) / length, -1.0, 1.0)));
    }
    std::sort(ends.begin(), ends.begin() + static_cast<std::ptrdiff_t>(count));

    const auto part_above = [&](const glm::dvec3& n, double sin_chi, double cos_chi) -> Arc {
        const double across = glm::dot(n, e);
        const double along = glm::dot(n, f);
        const double size = std::hypot(across, along) * sin_chi;
        const double height = glm::dot(n, axis) * cos_chi;
        const double middle = std::atan2(along, across);
        if (height >= size) return {middle - pi, middle + pi};
        if (height <= -size) return {middle, middle};
        const double half = std::acos(std::clamp(-height / size, -1.0, 1.0));
        return {middle - half, middle + half};
    };
    const auto ring = [&](double chi) {
        const double sin_chi = std::sin(chi);
        const double cos_chi = std::cos(chi);
        const Arc first = part_above(above[0], sin_chi, cos_chi);
        Arcs arcs;
        if (above.size() == 1) {
            arcs.add(first.begin, first.end);
        } else {
            const Arc second = part_above(above[1], sin_chi, cos_chi);
            for (int turn = -2; turn <= 2; ++turn)
                arcs.add(std::max(first.begin, second.begin + 2.0 * pi * turn),
                         std::min(first.end, second.end + 2.0 * pi * turn));
        }
        double sum = 0.0;
        for (std::size_t i = 0; i < arcs.count; ++i) {
            const Arc& arc = arcs.arcs.at(i);
            const double half = 0.5 * (arc.end - arc.begin);
            // From each end to the middle, ψ = end ± half t²: a gradation changes fastest at the horizon.
            for (const QuadratureNode& node : inner) {
                const double t = 0.5 * (1.0 + node.at);
                const double weight = node.weight * half * t;
                for (const double psi : {arc.begin + half * t * t, arc.end - half * t * t}) {
                    const glm::dvec3 direction = cos_chi * axis + sin_chi * (std::cos(psi) * e + std::sin(psi) * f);
                    sum += weight * g(direction, chi);
                }
            }
        }
        return sum * sin_chi;
    };

    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const double width = ends.at(i + 1) - ends.at(i);
        if (!(width > 0.0)) continue;
        for (const QuadratureNode& node : outer) {
            // χ = begin + width sin²(π/4 (1 + x))
            const double at = 0.25 * pi * (1.0 + node.at);
            const double sine = std::sin(at);
            const double slope = 0.5 * pi * sine * std::cos(at);
            sum += node.weight * width * slope * ring(ends.at(i) + width * sine * sine);
        }
    }
    return sum;
}

} // namespace gonio::detail
