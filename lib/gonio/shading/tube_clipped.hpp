// The irradiance of a capsule that the receiver's plane cuts: irradiance_tube.hpp's outline, clipped.
//
// The outline is walked T0+ → T1+ (great arc), end 1's circle, T1− → T0− (great arc), end 0's circle. Mirrored so that
// n_a, n_g ≥ 0, along the outline the first great arc can only rise above the horizon and the second only go below it.
// The outline otherwise goes below on end 1's circle or rises on end 0's, or both happen on one circle. So each of the
// four arcs has at most the two end points of one interval, and the visible part of a circle is the angle of one
// complex number, made from exp(±iφ) of those end points.
#pragma once

#include <gonio/shading/outline.hpp>

namespace gonio::shading::detail {

// In (f, a, g): from the receiver perpendicular to the axis line, along the axis, and across; mirrored, of moderate
// size.
template<class S>
struct TubePose {
    S r, half; // radius, half of the length
    S inverse_r;
    S z, z_rest;          // of the centre along the axis, and its rounding error
    S z0, z1;             // of the ends' centres, each to its last digit
    S d, inverse_d;       // D, the distance of the axis line
    S gap2;               // D² − r²
    S tangent0, tangent1; // |P|² − r² of the ends' centres
    S n_f, n_a, n_g;      // the receiver's normal; n_a, n_g ≥ 0
    S up;                 // height of the centre over the receiver's plane
};

// A tube scaled to moderate size by a power of two, which is exact. Negative sizes become positive.
template<class S>
struct ScaledTube {
    vec3<S> center;
    S r, half;

    GONIO_FORCE_INLINE ScaledTube(vec3<S> to_center, S radius, S length_m) {
        const S size = simd::abs(radius);
        const S span = simd::abs(length_m);
        const S scale =
            S(0.125) * simd::reciprocal_power_of_two(simd::max(largest_component(to_center), simd::max(size, span)));
        center = to_center * scale;
        r = size * scale;
        half = S(0.5) * (span * scale);
    }
};

// One end's circle. Its azimuth φ runs from −h to h along the outline; the part above the horizon is |φ − μ| < reach.
template<class S>
struct EndCircle {
    S inverse_distance, tangent; // 1/d; τ = √(d² − r²)
    S cos_h, sin_h;
    S cos_reach;
    S cos_sink, sin_sink, cos_rise, sin_rise; // at μ + reach and μ − reach
    S across;                                 // d n_u
    S n_v;
    simd::mask_of<S> dips, bumps; // both of its ends are above (below) the horizon and a part between them is not
};

// `up`: height of the end's centre; `sign`: the direction of the outline there, 1 for end 1, −1 for end 0.
template<class S>
GONIO_FORCE_INLINE EndCircle<S> end_circle(const TubePose<S>& t, S gap, S z, S tangent2, S up, S sign) {
    constexpr double least = 1e-24;
    const S distance2 = simd::mul_add(t.d, t.d, z * z);
    const S distance = simd::sqrt(distance2);
    EndCircle<S> c;
    c.tangent = simd::sqrt(simd::max(tangent2, S(least)));
    c.across = sign * simd::mul_add(t.d, t.n_a, -(z * t.n_f));
    c.n_v = -sign * t.n_g;
    const S side = distance * c.n_v;
    const S n = simd::sqrt(simd::max(simd::mul_add(c.across, c.across, side * side), S(least)));
    // A single division for three inverses.
    const S product = distance * c.tangent;
    const S inverse = S(1) / (product * n);
    const S inverse_tangent = inverse * distance * n;
    const S inverse_n = inverse * product;
    c.inverse_distance = inverse * c.tangent * n;
    c.cos_h = sign * t.r * t.inverse_d * z * inverse_tangent;
    c.sin_h = distance * gap * t.inverse_d * inverse_tangent;
    const S cos_middle = c.across * inverse_n;
    const S sin_middle = side * inverse_n;
    const S level = up * c.tangent * inverse_n * t.inverse_r;
    c.cos_reach = simd::max(simd::min(-level, S(1)), S(-1));
    const S sin_reach = simd::sqrt((S(1) - c.cos_reach) * (S(1) + c.cos_reach));
    c.cos_sink = simd::mul_add(cos_middle, c.cos_reach, -(sin_middle * sin_reach));
    c.sin_sink = simd::mul_add(sin_middle, c.cos_reach, cos_middle * sin_reach);
    c.cos_rise = simd::mul_add(cos_middle, c.cos_reach, sin_middle * sin_reach);
    c.sin_rise = simd::mul_add(sin_middle, c.cos_reach, -(cos_middle * sin_reach));
    c.dips = simd::both(level < S(1), -cos_middle >= c.cos_h);
    c.bumps = simd::both(level > S(-1), cos_middle >= c.cos_h);
    return c;
}

// The remaining slopes of circles and great arcs where nothing is cut, divided by r κ; `inverse` is 1/(|P0| |P1|)².
template<class S>
GONIO_FORCE_INLINE S whole_slope(const TubePose<S>& t, S inverse) {
    const S along = t.d * t.n_a * (t.z0 + t.z1);
    const S across = t.n_f * simd::mul_add(t.d, t.d, -(t.z0 * t.z1));
    return S(2) * t.half * (along + across) * inverse;
}

// The interval ends that a circle has.
template<class S>
struct EndFlags {
    simd::mask_of<S> start, end; // −h and h are above the horizon
    simd::mask_of<S> sinks, rises;
};

template<class S>
struct EndArcs {
    S azimuth; // of its visible part, in [0, 2π]
    S slanted; // ∮ of the circle's slope: Σ (sin φ) d n_u − (cos φ) d n_v over the intervals' ends
};

// Angle of the unit vector (cosine, sine) within rounding, sine ≥ 0.
template<class S>
GONIO_FORCE_INLINE S unit_angle(S sine, S cosine) {
    if constexpr (__is_same(S, double)) {
        return simd::atan2_above(sine, cosine);
    } else {
        const S t = sine / (S(1) + simd::abs(cosine)); // tangent of half of it, or of half of its difference to π
        const S half = simd::mul_add(t, simd::atan_ratio_excess(t * t), t);
        return simd::select(cosine < S(0), S(3.14159274F) - (half + half), half + half);
    }
}

// `apart`: D² ≥ 1.25 r².
template<bool apart, class S>
GONIO_FORCE_INLINE EndArcs<S> visible_arcs(const EndCircle<S>& c, const EndFlags<S>& has, S distance_n_v) {
    const S zero = S(0);
    // From −h or the rise to h or the sink. If there are two intervals, from −h to the sink and from the rise to h,
    // their sum is the interval from the rise to the sink plus 2h.
    const auto twice = simd::both(has.start, has.rises);
    const auto to_end = simd::both(has.end, !twice);
    const auto from_start = simd::both(has.start, !twice);
    const S to_cos = simd::select(to_end, c.cos_h, c.cos_sink);
    const S to_sin = simd::select(to_end, c.sin_h, c.sin_sink);
    const S from_cos = simd::select(from_start, c.cos_h, c.cos_rise);
    const S from_sin = simd::select(from_start, -c.sin_h, c.sin_rise);
    S cosine = simd::mul_add(to_cos, from_cos, to_sin * from_sin);
    S sine = simd::mul_add(to_sin, from_cos, -(to_cos * from_sin));
    S sines = to_sin - from_sin;
    const S cosines = to_cos - from_cos;
    if (simd::any(twice)) {
        const S more = simd::select(twice, c.sin_h + c.sin_h, zero);
        const S more_cos = simd::mul_add(-more, c.sin_h, S(1));
        const S more_sin = more * c.cos_h;
        const S alone = cosine;
        cosine = simd::mul_add(alone, more_cos, -(sine * more_sin));
        sine = simd::mul_add(sine, more_cos, alone * more_sin);
        sines = sines + more;
    }
    const S angle = unit_angle(simd::abs(sine), cosine);
    // Takes the value in [0, 2π] modulo 2π, except for rounding at its ends: an angle close to 2π can be visible only
    // if both h and the reach are above π/2; if both are close to π, at least 4 is visible.
    const auto large = simd::both(c.cos_h < zero, c.cos_reach < zero);
    auto beyond = simd::both(sine < zero, simd::either(large, angle > S(1)));
    if constexpr (!apart) { // else |cos h| ≤ r/D < 0.9
        const auto full = simd::both(c.cos_h < S(-0.9), c.cos_reach < S(-0.9));
        beyond = simd::either(beyond, simd::both(full, angle < S(2)));
    }
    const S azimuth = simd::select(beyond, S(6.28318530717958647693) - angle, angle);
    const auto seen = simd::either(simd::either(has.start, has.end), has.rises);
    return {simd::select(seen, azimuth, zero),
            simd::select(seen, simd::mul_add(sines, c.across, -(cosines * distance_n_v)), zero)};
}

// A point where the horizon cuts the outline, relative to the receiver and relative to the light's centre.
template<class S>
struct Crossing {
    vec3<S> direct, offset;
};

template<class S>
GONIO_FORCE_INLINE Crossing<S> select(simd::mask_of<S> condition, const Crossing<S>& a, const Crossing<S>& b) {
    return {select(condition, a.direct, b.direct), select(condition, a.offset, b.offset)};
}

// Points on the circles of ends 0 and 1 at their azimuths.
template<class S>
GONIO_FORCE_INLINE Crossing<S> on_circle(const TubePose<S>& t, const EndCircle<S>& end0, const EndCircle<S>& end1,
                                         simd::mask_of<S> at0, S cosine, S sine) {
    const S inverse = simd::select(at0, end0.inverse_distance, end1.inverse_distance);
    const S tangent = simd::select(at0, end0.tangent, end1.tangent);
    const S z = simd::select(at0, t.z0, t.z1);
    const S sense = simd::select(at0, S(1), S(-1)); // of v; the sign of u is the opposite
    const S round = t.r * tangent * inverse;
    const S inward = t.r * t.r * inverse * inverse;
    const S u = sense * round * inverse * cosine;
    const S g = sense * round * sine;
    const S visible = tangent * tangent * inverse * inverse;
    return {
        {simd::mul_add(t.d, visible, u * z), simd::mul_add(z, visible, -(u * t.d)), g},
        {simd::mul_add(u, z, -(t.d * inward)), simd::mul_add(-sense, t.half, -simd::mul_add(z, inward, u * t.d)), g}};
}

// Half the angle between two crossings.
template<bool apart, class S>
GONIO_FORCE_INLINE S closing_arc(const TubePose<S>& t, const Crossing<S>& sink, const Crossing<S>& rise) {
    const vec3<S>& p = sink.direct;
    const vec3<S> n{t.n_f, t.n_a, t.n_g};
    const vec3<S> step{rise.offset.x - sink.offset.x, rise.offset.y - sink.offset.y, rise.direct.z - p.z};
    if constexpr (apart) {
        return horizon_arc(p, step, n);
    }
    // Far away the offsets give a more accurate step between the crossings than the points themselves; near, the points
    // do.
    const S size = t.r + t.half;
    const auto far = simd::mul_add(t.d, t.d, t.z * t.z) > S(16) * size * size;
    const vec3<S> across = fused_cross(p, select(far, step, rise.direct));
    const S along = simd::mul_add(-dot(n, p), dot(n, rise.direct), dot(p, rise.direct)); // as in horizon_arc
    return S(0.5) * simd::atan2_above(simd::abs(dot(n, across)), along);
}

// The part above the horizon of a tube that the horizon cuts, as two sums.
template<class S>
struct ClippedTube {
    S arcs;    // great arcs, and the circles' azimuths
    S rest;    // the circles' slopes, and the arc along the horizon
    S inverse; // 1/(|P0| |P1|)
};

// Receiver outside, gap2 > 0, r > 0; `apart`: D² ≥ 1.25 r², and the centre no more than 20 D away.
template<bool apart, class S>
GONIO_FORCE_INLINE ClippedTube<S> clipped_tube(const TubePose<S>& t) {
    const S gap = simd::sqrt(t.gap2);
    const S s = t.r * t.inverse_d;
    const S kappa = gap * t.inverse_d;
    const S up_by = t.half * t.n_a;
    const S up0 = t.up - up_by;
    const S up1 = t.up + up_by;

    // Heights of the tangent points; all share the rounding error of `up`, so that the horizon may shift but does not
    // tilt.
    const S in = s * t.r * t.n_f;
    const S out = t.r * kappa * t.n_g;
    const S level = t.up - in;
    const S level_plus = level + out;
    const S level_minus = level - out;
    const auto above0_plus = level_plus - up_by >= S(0);
    const auto above0_minus = level_minus - up_by >= S(0);
    const auto above1_plus = level_plus + up_by >= S(0);
    const auto above1_minus = level_minus + up_by >= S(0);

    const EndCircle<S> end0 = end_circle(t, gap, t.z0, t.tangent0, up0, S(-1));
    const EndCircle<S> end1 = end_circle(t, gap, t.z1, t.tangent1, up1, S(1));
    const auto none = !above1_plus;
    const auto single1 = simd::either(simd::both(above0_minus, end1.dips), simd::both(none, end1.bumps));
    const auto single0 =
        simd::both(!single1, simd::either(simd::both(above0_minus, end0.dips), simd::both(none, end0.bumps)));
    const EndFlags<S> has1{above1_plus, above1_minus, simd::either(single1, simd::both(above1_plus, !above1_minus)),
                           single1};
    const EndFlags<S> has0{above0_minus, above0_plus, single0,
                           simd::either(single0, simd::both(above0_plus, !above0_minus))};
    // Great arcs, from the crossing to the higher end.
    constexpr double least = 1e-30;
    const S inverse_rate = S(-1) / simd::max(t.n_a, S(least));
    const S from_plus = simd::max(simd::min(level_plus * inverse_rate, t.half), -t.half);
    const S from_minus = simd::max(simd::min(level_minus * inverse_rate, t.half), -t.half);
    const S z_plus = (t.z + from_plus) + t.z_rest;
    const S z_minus = (t.z + from_minus) + t.z_rest;

    const S base = gap * kappa;
    const S side = t.r * kappa;
    const S back = -(s * t.r);
    const auto sink_on_great = simd::both(above1_minus, !above0_minus);
    const auto rise_on_great = simd::both(above1_plus, !above0_plus);
    const Crossing<S> sink =
        select(sink_on_great, Crossing<S>{{base, z_minus, -side}, {back, from_minus, -side}},
               on_circle(t, end0, end1, single0, simd::select(single0, end0.cos_sink, end1.cos_sink),
                         simd::select(single0, end0.sin_sink, end1.sin_sink)));
    const Crossing<S> rise =
        select(rise_on_great, Crossing<S>{{base, z_plus, side}, {back, from_plus, side}},
               on_circle(t, end0, end1, !single1, simd::select(single1, end1.cos_rise, end0.cos_rise),
                         simd::select(single1, end1.sin_rise, end0.sin_rise)));
    const S closing_angle = closing_arc<apart>(t, sink, rise); // the longest chain: the rest is computed meanwhile

    const S distance0 = simd::mul_add(t.d, t.d, t.z0 * t.z0) * end0.inverse_distance;
    const S distance1 = simd::mul_add(t.d, t.d, t.z1 * t.z1) * end1.inverse_distance;
    const EndArcs<S> arcs0 = visible_arcs<apart>(end0, has0, distance0 * end0.n_v);
    const EndArcs<S> arcs1 = visible_arcs<apart>(end1, has1, distance1 * end1.n_v);

    const S angle_plus = simd::atan2_above(gap * (t.half - from_plus), simd::mul_add(z_plus, t.z1, t.gap2));
    const S angle_minus = simd::atan2_above(gap * (t.half - from_minus), simd::mul_add(z_minus, t.z1, t.gap2));
    const S r2 = t.r * t.r;
    const S share0 = end0.inverse_distance * end0.inverse_distance * end0.inverse_distance;
    const S share1 = end1.inverse_distance * end1.inverse_distance * end1.inverse_distance;
    const S up = t.d * t.n_f; // computed again for the ends' heights, each to its own last digit
    const S caps = r2 * simd::mul_add(arcs0.azimuth * share0, simd::mul_add(t.z0, t.n_a, up),
                                      arcs1.azimuth * share1 * simd::mul_add(t.z1, t.n_a, up));
    const S slanted = t.r * simd::mul_add(end0.tangent, arcs0.slanted * share0, end1.tangent * arcs1.slanted * share1);
    const S facing = s * t.n_f;
    const S aside = kappa * t.n_g;
    const S great = simd::mul_add(facing - aside, angle_plus, (facing + aside) * angle_minus);

    const auto single = simd::either(single0, single1);
    const auto closed = simd::both(above0_minus, !single);
    const auto hidden = simd::both(none, !single);
    const S zero = S(0);
    return {simd::select(hidden, zero, S(0.5) * (great + caps)),
            simd::select(hidden, zero, simd::select(closed, zero, closing_angle) - S(0.5) * slanted),
            end0.inverse_distance * end1.inverse_distance};
}

// clipped_tube where `cut`, else as tube_above.
template<class S>
GONIO_FORCE_INLINE S tube_clipped(const TubePose<S>& t, simd::mask_of<S> cut) {
    const ClippedTube<S> visible = clipped_tube<false>(t);
    S rest = visible.rest;
    if (!simd::all(cut)) {
        // Without a cut the slopes are combined, and nothing cancels.
        const S kappa = simd::sqrt(t.gap2) * t.inverse_d;
        rest = simd::select(cut, rest, t.r * kappa * whole_slope(t, visible.inverse * visible.inverse));
    }
    return visible.arcs + rest;
}

} // namespace gonio::shading::detail
