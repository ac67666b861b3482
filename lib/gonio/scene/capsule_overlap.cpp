#include <gonio/scene/camera.hpp>
#include <gonio/scene/capsule_overlap.hpp>
#include <gonio/scene/occlusion.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace gonio {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double turn = 2.0 * pi;

// A circle on the unit sphere about an axis, counter-clockwise: ω(φ) = cos ρ q + sin ρ (cos φ u + sin φ v).
struct Circle {
    glm::dvec3 q, u, v;  // u × v = q
    double cosine, sine; // of ρ

    // φ is measured from the direction of `start`.
    Circle(const glm::dvec3& axis, double cosine_of_radius, double sine_of_radius, const glm::dvec3& start)
        : q(axis), u(0.0), v(0.0), cosine(cosine_of_radius), sine(sine_of_radius) {
        const glm::dvec3 across = start - glm::dot(start, q) * q;
        const double length = glm::length(across);
        u = length > 0.0
                ? across / length
                : glm::normalize(glm::cross(q, std::abs(q.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
        v = glm::cross(q, u);
    }

    glm::dvec3 at(double phi) const { return cosine * q + sine * (std::cos(phi) * u + std::sin(phi) * v); }
    double azimuth(const glm::dvec3& direction) const {
        const double phi = std::atan2(glm::dot(direction, v), glm::dot(direction, u));
        return phi < 0.0 ? phi + turn : phi;
    }
    // ½ ∮ n·(ω × dω) from `from` to `to`.
    double arc(double from, double to, const glm::dvec3& n) const {
        const double slanted =
            (std::sin(to) - std::sin(from)) * glm::dot(n, u) + (std::cos(from) - std::cos(to)) * glm::dot(n, v);
        return 0.5 * sine * (sine * (to - from) * glm::dot(n, q) - cosine * slanted);
    }
    // The part within `cosine_of_cap` of an axis: |φ − middle| < reach, reach in [0, π].
    struct Within {
        double middle, reach;
    };
    Within within(const glm::dvec3& axis, double cosine_of_cap) const {
        const double along = glm::dot(axis, q);
        const double x = glm::dot(axis, u);
        const double y = glm::dot(axis, v);
        const double across = std::sqrt(x * x + y * y);
        const double over = cosine_of_cap - cosine * along;
        const double most = sine * across;
        if (over >= most) return {0.0, 0.0};
        if (over <= -most) return {0.0, pi};
        return {std::atan2(y, x), std::acos(over / most)};
    }
};

// An arc of a circle, starting at azimuth 0.
struct Arc {
    Circle circle;
    double span;

    // The contribution to the outline integral of the part inside the cap.
    double in_cap(const glm::dvec3& axis, double cosine_of_cap, const glm::dvec3& n) const {
        const Circle::Within cap = circle.within(axis, cosine_of_cap);
        if (cap.reach == 0.0) return 0.0;
        if (cap.reach == pi) return circle.arc(0.0, span, n);
        double sum = 0.0;
        for (const double shift : {-turn, 0.0, turn}) {
            const double from = std::max(cap.middle - cap.reach + shift, 0.0);
            const double to = std::min(cap.middle + cap.reach + shift, span);
            if (from < to) sum += circle.arc(from, to, n);
        }
        return sum;
    }
};

} // namespace

double projected_capsule_overlap(const glm::dvec3& cap_axis, double half_angle, const Capsule& capsule,
                                 const glm::dvec3& normal) {
    const double r = capsule.radius;
    const double along = glm::dot(capsule.center, capsule.axis);
    const glm::dvec3 to_line = capsule.center - along * capsule.axis;
    const double distance = glm::length(to_line);
    if (!(distance > r) || capsule.half_length == 0.0) {
        // Within the prolonged capsule only its nearer end is visible.
        const glm::dvec3 end = capsule.center - std::copysign(capsule.half_length, along) * capsule.axis;
        const double length = glm::length(end);
        return projected_cap_overlap(cap_axis, half_angle, end / length, std::asin(std::min(r / length, 1.0)), normal);
    }
    const glm::dvec3 f = to_line / distance;
    const glm::dvec3 g = glm::cross(capsule.axis, f);
    const double s = r / distance;
    const double kappa = std::sqrt((1.0 - s) * (1.0 + s));
    const glm::dvec3 outward0 = kappa * g - s * f; // of the planes tangent to its side
    const glm::dvec3 outward1 = -kappa * g - s * f;
    const glm::dvec3 end0 = capsule.center - capsule.half_length * capsule.axis;
    const glm::dvec3 end1 = capsule.center + capsule.half_length * capsule.axis;
    // Counter-clockwise: along plane 0 towards end 1, around it, along plane 1 back, around end 0.
    const auto great = [](const glm::dvec3& outward, const glm::dvec3& from, const glm::dvec3& to) {
        const Circle circle(-outward, 0.0, 1.0, from);
        return Arc{circle, circle.azimuth(to)};
    };
    const auto round = [&](const glm::dvec3& end, const glm::dvec3& from, const glm::dvec3& to) {
        const double length = glm::length(end);
        const double sine = r / length;
        const Circle circle(end / length, std::sqrt((1.0 - sine) * (1.0 + sine)), sine, from);
        return Arc{circle, circle.azimuth(to)};
    };
    const std::array<Arc, 4> outline{great(outward0, end0 + r * outward0, end1 + r * outward0),
                                     round(end1, end1 + r * outward0, end1 + r * outward1),
                                     great(outward1, end1 + r * outward1, end0 + r * outward1),
                                     round(end0, end0 + r * outward1, end0 + r * outward0)};
    const double cosine = std::cos(half_angle);
    double sum = 0.0;
    for (const Arc& arc : outline)
        sum += arc.in_cap(cap_axis, cosine, normal);

    // The cap's own circle, where it is in front of the capsule.
    const Circle own(cap_axis, cosine, std::sin(half_angle), f);
    std::array<double, 10> cuts{};
    std::size_t count = 0;
    cuts[count++] = 0.0;
    for (const Arc& arc : outline) {
        const Circle::Within cut = own.within(arc.circle.q, arc.circle.cosine);
        if (cut.reach == 0.0 || cut.reach == pi) continue;
        for (const double phi : {cut.middle - cut.reach, cut.middle + cut.reach})
            cuts[count++] = phi - turn * std::floor(phi / turn);
    }
    cuts[count++] = turn;
    std::sort(cuts.begin(), cuts.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t i = 0; i + 1 < count; ++i) {
        if (!(cuts[i] < cuts[i + 1])) continue;
        const glm::dvec3 middle = own.at(0.5 * (cuts[i] + cuts[i + 1]));
        if (distance_to(capsule, {glm::dvec3(0.0), middle})) sum += own.arc(cuts[i], cuts[i + 1], normal);
    }
    return sum;
}

} // namespace gonio
