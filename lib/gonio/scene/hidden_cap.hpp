// How much of a sphere light a ball before it hides, with the cosine: projected_cap_overlap() (occlusion.hpp) for many
// receivers at once, in double or simd::doubles. Its series end where 1e-12 is left, and caps that are nearly
// hemispheres are left to it. Nothing is fused, so every set gives the same bits.
#pragma once

#include <gonio/scene/unfused.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/doubles_math.hpp>

namespace gonio::detail {

// The smaller of two caps may have at most this half angle [rad].
inline constexpr double most_of_smaller_cap = 1.4;

// The directions to a sphere from outside of it.
template<class S>
struct SphereCap {
    shading::vec3<S> axis; // unit
    S sine, cosine, angle; // of the half angle [rad]
};
// Lanes in the sphere, or without a distance to its centre, have no meaning.
template<class S>
GONIO_FORCE_INLINE SphereCap<S> cap_of(const shading::vec3<S>& to_center, S distance, S radius) {
    const S inverse = S(1.0) / distance;
    const S sine = simd::min(radius * inverse, S(1.0));
    return {to_center * inverse, sine, simd::sqrt((S(1.0) - sine) * (S(1.0) + sine)), simd::arc_sine(sine)};
}
template<class S>
GONIO_FORCE_INLINE SphereCap<S> select(simd::mask_of<S> where, const SphereCap<S>& a, const SphereCap<S>& b) {
    return {shading::select<S>(where, a.axis, b.axis), simd::select(where, a.sine, b.sine),
            simd::select(where, a.cosine, b.cosine), simd::select(where, a.angle, b.angle)};
}

// sin x for x in [0, π], to 1e-13 of it: the Taylor series to the middle, and its mirror image.
template<class S>
GONIO_FORCE_INLINE S sine_to_half_turn(S x) {
    constexpr double pi = 3.14159265358979323846;
    const S rising = simd::min(x, S(pi) - x);
    const S t = rising * rising;
    S sum(1.0);
    for (int k = 9; k >= 1; --k)
        sum = S(1.0) - t * S(1.0 / ((2.0 * k) * (2.0 * k + 1.0))) * sum;
    return rising * sum;
}

// The part of a cap beyond a chord of its outline, as cap_overlap.cpp divides a lens into two. A, half of the angle
// that it spans about the cap's axis, is given by its squared sine and cosine of A/2, up to a common factor.
template<class S>
class CapSegment {
public:
    GONIO_FORCE_INLINE CapSegment(const SphereCap<S>& cap, S sine2_half, S cosine2_half) {
        const S inverse = S(1.0) / (sine2_half + cosine2_half);
        const S sine = S(2.0) * simd::sqrt(sine2_half * cosine2_half) * inverse; // of A
        const S cosine = (cosine2_half - sine2_half) * inverse;
        const S more = chord_excess(cap, sine, cosine);
        along_ = cap.sine * (cap.sine * angle_less_triangle(sine, cosine) - cosine * more);
        across_ = cap.cosine * more;
    }

    // ∫ n·ω dω for the n whose products with the axis, and with the direction across it to the chord, are these.
    GONIO_FORCE_INLINE S moment(S n_along, S n_across) const { return along_ * n_along + across_ * n_across; }

private:
    static constexpr double narrow = 0.2; // a sine: below, differences that begin with a cube are summed as series

    // A − sin A cos A.
    GONIO_FORCE_INLINE static S angle_less_triangle(S sine, S cosine) {
        const S t = sine * sine;
        // 2 Σ (2k choose k)/4ᵏ sin^(2k+3)/(2k+3).
        S series(0.0);
        for (int k = 8; k >= 0; --k)
            series = series * t + S(2.0 * central_binomial(k) / (2.0 * k + 3.0));
        series = sine * t * series;
        const auto is_narrow = simd::both(sine<S(narrow), cosine> S(0.0));
        if (!simd::any(!is_narrow)) return series;
        return simd::select(is_narrow, series, angle(sine, cosine) - sine * cosine);
    }
    // c/cos c − sin c of half the chord, sin c = sin a sin A.
    GONIO_FORCE_INLINE static S chord_excess(const SphereCap<S>& cap, S sine_of, S cosine_of) {
        const S sine = cap.sine * sine_of;
        const S t = sine * sine;
        S series(1.0);
        for (int k = 9; k >= 1; --k)
            series = S(1.0) + series * t * S((2.0 * k + 2.0) / (2.0 * k + 3.0));
        series = S(2.0 / 3.0) * sine * t * series;
        const auto is_narrow = sine < S(narrow);
        if (!simd::any(!is_narrow)) return series;
        const S aside = cap.sine * cosine_of;
        const S cosine = simd::sqrt(aside * aside + cap.cosine * cap.cosine);
        return simd::select(is_narrow, series, angle(sine, cosine) / cosine - sine);
    }
    GONIO_FORCE_INLINE static S angle(S sine, S cosine) {
        constexpr double pi = 3.14159265358979323846;
        return simd::angle_deg(sine, cosine) * S(pi / 180.0);
    }
    // (2k choose k)/4ᵏ
    static constexpr double central_binomial(int k) {
        double number = 1.0;
        for (int i = 1; i <= k; ++i)
            number *= (2.0 * i - 1.0) / (2.0 * i);
        return number;
    }

    S along_, across_;
};

// ∫ n·ω dω over the overlap of two caps [sr], of which the smaller one has at most `most_of_smaller_cap`.
template<class S>
GONIO_FORCE_INLINE S projected_overlap(const SphereCap<S>& one, const SphereCap<S>& other,
                                       const shading::vec3<S>& normal) {
    constexpr double pi = 3.14159265358979323846;
    const auto in_order = one.angle <= other.angle;
    const SphereCap<S> a = select(in_order, one, other);
    const SphereCap<S> b = select(in_order, other, one);
    const shading::vec3<S> way = b.axis - a.axis;
    const S d = S(2.0) * simd::arc_sine(simd::min(S(0.5) * unfused::length(way), S(1.0)));
    const S left = b.angle - d;
    const auto apart = a.angle + left <= S(0.0);
    const auto within = left >= a.angle;
    const S on_a = unfused::dot(normal, a.axis);
    const S whole = simd::select(apart, S(0.0), S(pi) * a.sine * a.sine * on_a);
    const auto settled = simd::either(apart, within);
    if (!simd::any(!settled)) return whole;
    // Of the spherical triangle with the sides a, b and d: the sines of half its circumference, and of that less each
    // side.
    const S from = simd::max(S(0.5) * (a.angle + left), S(0.0));
    const S to = simd::max(S(0.5) * (a.angle - left), S(0.0));
    const S less_d = sine_to_half_turn(from);
    const S less_b = sine_to_half_turn(to);
    const S less_a = simd::max(sine_to_half_turn(simd::max(b.angle - from, S(0.0))), S(0.0));
    const S all = simd::max(sine_to_half_turn(b.angle + to), S(0.0));
    // From each axis towards the other one, perpendicular to it.
    const auto across = [&](const shading::vec3<S>& axis, const shading::vec3<S>& towards, S on_axis) {
        const S along = unfused::dot(towards, axis);
        const shading::vec3<S> level = towards - axis * along;
        const S length = simd::max(unfused::length(level), S(1e-150));
        return (unfused::dot(normal, towards) - along * on_axis) / length;
    };
    const S on_b = unfused::dot(normal, b.axis);
    const S sum = CapSegment<S>(a, less_d * less_a, all * less_b).moment(on_a, across(a.axis, way, on_a)) +
                  CapSegment<S>(b, less_d * less_b, all * less_a).moment(on_b, across(b.axis, way * S(-1.0), on_b));
    return simd::select(settled, whole, sum);
}

// What a receiver sees of a sphere light past a ball, as a share of its illuminance, in [0, 1]; negative where there is
// no such closed form: the light is not wholly above the horizon, the ball not wholly nearer than it, the receiver in
// the ball, or the caps nearly hemispheres.
template<class S>
GONIO_FORCE_INLINE S share_past_ball(const shading::vec3<S>& to_light, S light_radius, const shading::vec3<S>& to_ball,
                                     S ball_radius, const shading::vec3<S>& normal) {
    constexpr double pi = 3.14159265358979323846;
    const S light_distance = unfused::length(to_light);
    const S ball_distance = unfused::length(to_ball);
    const SphereCap<S> light = cap_of(to_light, light_distance, light_radius);
    const SphereCap<S> ball = cap_of(to_ball, ball_distance, ball_radius);
    const S cosine = unfused::dot(normal, light.axis);
    const auto is_above = cosine >= light.sine;
    const auto is_before =
        simd::both(ball_distance > ball_radius, ball_distance + ball_radius <= light_distance - light_radius);
    const auto is_small = simd::min(light.angle, ball.angle) <= S(most_of_smaller_cap);
    const auto is_known = simd::both(simd::both(is_above, is_before), is_small);
    const S hidden = projected_overlap(light, ball, normal);
    const S share = S(1.0) - hidden / (S(pi) * light.sine * light.sine * cosine);
    return simd::select(is_known, simd::min(simd::max(share, S(0.0)), S(1.0)), S(-1.0));
}

} // namespace gonio::detail
