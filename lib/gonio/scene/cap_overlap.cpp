// The overlap of two caps of the sphere.
//
// The great arc between the crossings of their outlines divides the lens into a segment of each cap. A segment with
// half angle A at the axis of a cap of half angle a is ½ its sector minus the triangle of its ends and the axis. Where
// the segment is narrow or its cap is small, those two are nearly equal, so their difference is taken analytically
// before anything is rounded. The terms left to add are positive.
#include <gonio/scene/detail/cap.hpp>
#include <gonio/scene/occlusion.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio {

namespace {

using detail::cap_area;

constexpr double pi = std::numbers::pi;
// Half angles beyond which the great arc may run along the outlines: the segments cannot be distinguished there, and
// nothing small is left that could cancel.
constexpr double nearly_hemispheres = 1.4;
// Below this value, differences that begin with a cubic term are summed as series.
constexpr double narrow = 0.2;

// Σ x^k term_k with term_0 = 1 and term_k = ratio(k) term_{k−1}; |x ratio| must be well below 1.
template<class Ratio>
double series(double x, const Ratio& ratio) {
    double term = 1.0;
    double sum = 1.0;
    for (int k = 1; std::fabs(term) > 1e-17 * sum; ++k) {
        term *= x * ratio(k);
        sum += term;
    }
    return sum;
}

// A − sin A cos A.
double angle_less_triangle(double angle) {
    if (angle >= narrow) return angle - std::sin(angle) * std::cos(angle);
    return 2.0 / 3.0 * angle * angle * angle *
           series(-4.0 * angle * angle, [](int k) { return 1.0 / ((2.0 * k + 2.0) * (2.0 * k + 3.0)); });
}

// The two caps, a ≤ b, and how their outlines cross.
struct Lens {
    double a, b;
    bool apart = false;  // no overlap
    bool within = false; // the smaller one is inside the larger
    // Half the angle between the crossings at either axis, and half the angle between the axes at a crossing.
    double at_a = 0.0, at_b = 0.0, at_crossing = 0.0;

    Lens(double smaller, double larger, double d) : a(smaller), b(larger) {
        const double left = b - d; // exact where it is small
        apart = a + left <= 0.0;
        within = left >= a;
        if (apart || within) return;
        // For the spherical triangle with the sides a, b and d: the sines of half its circumference s, and of s minus
        // each side.
        const double sine_less_d = std::sin(0.5 * (a + left));
        const double sine_less_b = std::sin(0.5 * (a - left));
        const double sine_less_a = std::max(std::sin(b - 0.5 * (a + left)), 0.0);
        const double sine = std::max(std::sin(b + 0.5 * (a - left)), 0.0);
        at_a = 2.0 * std::atan2(std::sqrt(sine_less_d * sine_less_a), std::sqrt(sine * sine_less_b));
        at_b = 2.0 * std::atan2(std::sqrt(sine_less_d * sine_less_b), std::sqrt(sine * sine_less_a));
        at_crossing = 2.0 * std::atan2(std::sqrt(sine_less_a * sine_less_b), std::sqrt(sine * sine_less_d));
    }
};

// Half a segment's solid angle: A (1 − cos a) minus half the excess of its triangle, which is cos a sin²a ∫₀ᴬ
// sin²x/(1 − sin²a sin²x) dx. With u = sin x the integrand's series is that of 1/(1 − sin²a u²) times that of
// 1/√(1 − u²); the product has the coefficients c_k = sin²a c_{k−1} + (2k choose k)/4ᵏ.
double half_segment(double a, double at_a) {
    const double sine = std::sin(at_a);
    if (at_a >= narrow) {
        const double sine_half = std::sin(0.5 * a);
        const double fallen = 2.0 * sine_half * sine_half; // 1 − cos a
        return at_a * fallen - std::atan2(fallen * sine * std::cos(at_a), 1.0 - fallen * sine * sine);
    }
    const double q = std::sin(a) * std::sin(a);
    double binomial = 1.0;
    double coefficient = 1.0;
    double power = sine * sine * sine;
    double sum = 0.0;
    for (int k = 0;; ++k) {
        const double term = coefficient * power / (2.0 * k + 3.0);
        sum += term;
        if (!(term > 1e-17 * sum)) break;
        binomial *= (2.0 * k + 1.0) / (2.0 * k + 2.0);
        coefficient = q * coefficient + binomial;
        power *= sine * sine;
    }
    return std::cos(a) * q * sum;
}

// ∫ ω dω over a segment is `axis` times the axis of its cap plus `across` times the unit vector from that axis to the
// middle of its arc.
struct SegmentMoment {
    double axis, across;
};

// With the half chord c, sin c = sin a sin A. The arc contributes (A sin²a, −sin a cos a sin A); the chord contributes
// c times the normal of its plane, (−sin a cos A, cos a)/cos c.
SegmentMoment segment_moment(double a, double at_a) {
    const double sine_a = std::sin(a);
    const double cosine_a = std::cos(a);
    const double cosine_at_a = std::cos(at_a);
    const double sine = sine_a * std::sin(at_a);
    const double sine2 = sine * sine;
    // c/cos c − sin c.
    double more = 0.0;
    if (sine < narrow) {
        more = 2.0 / 3.0 * sine * sine2 * series(sine2, [](int k) { return (2.0 * k + 2.0) / (2.0 * k + 3.0); });
    } else {
        const double cosine = std::hypot(sine_a * cosine_at_a, cosine_a);
        more = std::atan2(sine, cosine) / cosine - sine;
    }
    return {sine_a * (sine_a * angle_less_triangle(at_a) - cosine_at_a * more), cosine_a * more};
}

// The unit vector perpendicular to `from`, towards `to`.
glm::dvec3 across(const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 way = to - from;
    return glm::normalize(way - glm::dot(way, from) * from);
}

} // namespace

double cap_overlap(double a, double b, double d) {
    const Lens lens(std::min(a, b), std::max(a, b), d);
    if (lens.apart) return 0.0;
    if (lens.within) return cap_area(lens.a);
    const double area =
        lens.a > nearly_hemispheres
            ? 2.0 * (pi - lens.at_crossing - lens.at_a * std::cos(lens.a) - lens.at_b * std::cos(lens.b))
            : 2.0 * (half_segment(lens.a, lens.at_a) + half_segment(lens.b, lens.at_b));
    return std::clamp(area, 0.0, cap_area(lens.a));
}

double projected_cap_overlap(const glm::dvec3& axis_a, double a, const glm::dvec3& axis_b, double b,
                             const glm::dvec3& normal) {
    if (a > b) return projected_cap_overlap(axis_b, b, axis_a, a, normal);
    const Lens lens(a, b, detail::angle_between(axis_a, axis_b));
    if (lens.apart) return 0.0;
    const double sine_a = std::sin(a);
    if (lens.within) return pi * sine_a * sine_a * glm::dot(normal, axis_a);
    const double on_a = glm::dot(normal, axis_a);
    const double on_b = glm::dot(normal, axis_b);
    const double from_a_to_b = glm::dot(normal, across(axis_a, axis_b));
    const double from_b_to_a = glm::dot(normal, across(axis_b, axis_a));
    if (a > nearly_hemispheres) {
        const double sine_b = std::sin(b);
        const double half_chord = sine_a * std::sin(lens.at_a);
        return lens.at_a * sine_a * sine_a * on_a + lens.at_b * sine_b * sine_b * on_b -
               half_chord * (std::cos(a) * from_a_to_b + std::cos(b) * from_b_to_a);
    }
    const SegmentMoment of_a = segment_moment(a, lens.at_a);
    const SegmentMoment of_b = segment_moment(b, lens.at_b);
    return of_a.axis * on_a + of_a.across * from_a_to_b + of_b.axis * on_b + of_b.across * from_b_to_a;
}

} // namespace gonio
