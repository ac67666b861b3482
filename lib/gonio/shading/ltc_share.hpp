// The share of a lobe that a light covers: the integral of an LtcLobe over each shape, clipped by the receiver's
// horizon.
//
// In [0, 1], and 1 from inside a sphere or a tube: luminance towards the eye per luminance of the light is this share
// times the lobe's albedo. Poses are given in the lobe's frame (ltc_frame), so the horizon is z = 0. The outline is
// clipped there, transformed, and integrated as in outline.hpp: great arcs stay great arcs, circles become elliptic
// cones (ltc_cone.hpp), and an arc in the transformed horizon closes the outline where the horizon cuts it. In float
// and packs, lanes in which the sum would cancel are evaluated in double: a tube that is small after the transform, or
// a disk seen edge-on, if the horizon cuts it; and a light that the receiver almost touches. Finite and not negative
// for any finite input; a shape without size gives 0.
#pragma once

#include <gonio/shading/ltc_cone.hpp>
#include <gonio/shading/ltc_lobe.hpp>

namespace gonio::shading {

namespace detail {

// A sum of arcs as a share of the lobe above the horizon.
template<class S>
GONIO_FORCE_INLINE S lobe_share(S integral, const LtcLobe<S>& lobe) {
    constexpr double pi = 3.14159265358979323846;
    const S share = integral / (S(pi) * simd::max(lobe.horizon_z, S(1e-12)));
    return simd::min(simd::max(share, S(0)), S(1));
}

template<class S>
struct LtcSurvey {
    S integral;
    simd::mask_of<S> hard; // to be evaluated in double
};

// Half of the transformed horizon's arc from the point where the outline goes below the horizon to the point where it
// rises again, both transformed.
template<class S>
GONIO_FORCE_INLINE S ltc_closing(const LtcLobe<S>& lobe, vec3<S> sink, vec3<S> rise) {
    return lobe.horizon_z * horizon_arc(sink, rise - sink, lobe.horizon());
}

// Where the horizon cuts the circle a + u cos t + v sin t.
template<class S>
struct CircleCut {
    simd::mask_of<S> cut, below;
    S cos_middle, sin_middle; // the highest point
    S cos_reach, sin_reach;   // the part above the horizon reaches this far from the middle to both sides

    GONIO_FORCE_INLINE CircleCut(S up, S by_u, S by_v) {
        constexpr double least = 1e-30;
        const S m = simd::max(simd::sqrt(simd::mul_add(by_u, by_u, by_v * by_v)), S(least));
        cut = simd::abs(up) < m;
        below = up <= -m;
        const S inverse = S(1) / m;
        cos_middle = by_u * inverse;
        sin_middle = by_v * inverse;
        cos_reach = simd::max(simd::min(-up * inverse, S(1)), S(-1));
        sin_reach = simd::sqrt((S(1) - cos_reach) * (S(1) + cos_reach));
    }
    GONIO_FORCE_INLINE S cos_sink() const { return cos_middle * cos_reach - sin_middle * sin_reach; }
    GONIO_FORCE_INLINE S sin_sink() const { return sin_middle * cos_reach + cos_middle * sin_reach; }
    GONIO_FORCE_INLINE S cos_rise() const { return cos_middle * cos_reach + sin_middle * sin_reach; }
    GONIO_FORCE_INLINE S sin_rise() const { return sin_middle * cos_reach - cos_middle * sin_reach; }
};

// Below this size after the transform (the tangent of its half angle) the arcs of a cut outline would cancel.
inline constexpr double least_ltc_size = 0.02;

// ∫ over a flat patch of `area` (a vector) about its centroid p, small as seen from the receiver; both transformed.
template<class S>
GONIO_FORCE_INLINE S ltc_patch(vec3<S> p, vec3<S> area) {
    constexpr double least = 1e-36;
    const S inverse = S(1) / simd::max(dot(p, p), S(least));
    return (p.z * inverse) * (dot(p, area) * inverse);
}

// The cone about a + u cos t + v sin t, a·(u × v) > 0. Hard where it is cut and so flat that floats cannot resolve
// where the cut is: the ends of the arc are off by a rounding error over the shorter axis.
template<class S>
GONIO_FORCE_INLINE LtcSurvey<S> ltc_circle(const LtcLobe<S>& lobe, vec3<S> a, vec3<S> u, vec3<S> v) {
    const CircleCut<S> horizon(a.z, u.z, v.z);
    if (!simd::any(!horizon.below)) return {S(0), horizon.cut};
    const vec3<S> to_a = lobe(a);
    const S inverse = reciprocal_or_zero(length(to_a));
    const vec3<S> a1 = to_a * inverse;
    const vec3<S> u1 = lobe(u) * inverse;
    const vec3<S> v1 = lobe(v) * inverse;
    const LtcCone<S> cone(a1, u1, v1);
    const S e = simd::select(horizon.below, S(0), cone.whole());
    if (!simd::any(horizon.cut)) return {e, horizon.cut};
    const auto at = [&](S cosine, S sine) { return a1 + u1 * cosine + v1 * sine; };
    const vec3<S> sink = at(horizon.cos_sink(), horizon.sin_sink());
    const vec3<S> rise = at(horizon.cos_rise(), horizon.sin_rise());
    const auto sliver = horizon.cos_reach > S(__is_same(S, double) ? 0.99999999 : 0.9999);
    const S cut = cone.arc(rise, sink, sliver) + ltc_closing(lobe, sink, rise);
    // A small circle, or a sliver: the disk's segment above the horizon, x = −t … 1 of a unit disk, at its centroid.
    const S t = -horizon.cos_reach;
    const S chord = horizon.sin_reach;
    const S segment = simd::mul_add(t, chord, simd::atan2_above(chord, horizon.cos_reach));
    const S middle = S(2.0 / 3.0) * chord * chord * chord / simd::max(segment, S(1e-30));
    const vec3<S> centroid = a1 + (u1 * horizon.cos_middle + v1 * horizon.sin_middle) * simd::min(middle, S(1));
    const S patch = ltc_patch(centroid, cross(u1, v1) * segment);
    constexpr double least = __is_same(S, double) ? 1e-8 : least_ltc_size * least_ltc_size;
    const auto small = simd::either(dot(u1, u1) + dot(v1, v1) < S(least), sliver);
    // Almost whole: the arc's span, just below 2π, could be rounded to just above 0.
    const auto whole = horizon.cos_reach < S(__is_same(S, double) ? -0.99999999 : -0.9999);
    const auto cut_by_arc = simd::both(horizon.cut, !whole);
    constexpr double flattest = 2e-4; // as good as 1e-3; below 1e-4 errors grow to 1e-3 of the light's luminance
    const auto flat = cone.v2 * cone.a2 < S(flattest * flattest) * (cone.a2 + cone.u2) * cone.u2;
    return {simd::select(cut_by_arc, simd::select(small, patch, cut), e),
            simd::both(simd::both(cut_by_arc, !small), flat)};
}

// The part above the horizon of the straight edge from p to q, and where the edge goes below the horizon or rises above
// it.
template<class S>
struct LtcEdge {
    vec3<S> from, to; // transformed; both the same where nothing is above
    simd::mask_of<S> sinks, rises;

    GONIO_FORCE_INLINE LtcEdge(S up_p, S up_q, vec3<S> p, vec3<S> q) {
        const auto p_above = up_p >= S(0);
        const auto q_above = up_q >= S(0);
        sinks = simd::both(p_above, !q_above);
        rises = simd::both(!p_above, q_above);
        const S t = up_p / simd::select(simd::either(sinks, rises), up_p - up_q, S(1));
        const vec3<S> crossing = p + (q - p) * simd::min(simd::max(t, S(0)), S(1));
        from = select(p_above, p, crossing);
        to = select(q_above, q, select(p_above, crossing, from));
        from = select(simd::either(p_above, q_above), from, to);
    }
    GONIO_FORCE_INLINE S arc() const { return great_arc(from, to - from, {S(0), S(0), S(1)}); }
};

template<class S>
GONIO_FORCE_INLINE S ltc_scale(vec3<S> center, S size) {
    return S(0.125) * simd::reciprocal_power_of_two(simd::max(largest_component(center), size));
}

template<class S>
GONIO_FORCE_INLINE LtcSurvey<S> survey_ltc_sphere(const LtcLobe<S>& lobe, vec3<S> center, S radius) {
    const S size = simd::abs(radius);
    const S scale = ltc_scale(center, size);
    const vec3<S> c = center * scale;
    const S r = size * scale;
    const S gap = simd::difference_of_squares(c.x, c.y, c.z, r);
    const S distance = length(c);
    const S inverse = reciprocal_or_zero(distance);
    const S sine = simd::min(r * inverse, S(1));
    // At the surface the cone is almost flat, but not completely: otherwise its axis would be undefined.
    const S cosine = simd::max(simd::sqrt(simd::max(gap, S(0))) * inverse, S(__is_same(S, double) ? 1e-9 : 1e-4));
    const vec3<S> l = select(distance > S(0), c * inverse, vec3<S>{S(0), S(0), S(1)});
    const TangentFrame<S> frame(l);
    const S circle = ltc_circle(lobe, l * cosine, frame.x * sine, frame.y * sine).integral;
    const auto inside = gap < S(0);
    constexpr double pi = 3.14159265358979323846;
    const S e = simd::select(inside, S(pi) * lobe.horizon_z, circle);
    const auto exists = r > S(0);
    const auto touching = simd::both(cosine < S(0.01), !inside);
    return {simd::select(exists, e, S(0)), simd::both(exists, touching)};
}

template<class S>
GONIO_FORCE_INLINE LtcSurvey<S> survey_ltc_disk(const LtcLobe<S>& lobe, vec3<S> center, vec3<S> axis, S radius,
                                                bool two_sided) {
    const S size = simd::abs(radius);
    const S scale = ltc_scale(center, size);
    const vec3<S> c = center * scale;
    const S r = size * scale;
    S depth = -dot(axis, c);
    vec3<S> away = axis * S(-1);
    if (two_sided) {
        away = select(depth < S(0), axis, away);
        depth = simd::abs(depth);
    }
    const auto seen = simd::both(depth >= S(0), r > S(0));
    const S floor = r * S(__is_same(S, double) ? 1e-9 : 1e-6);
    const vec3<S> raised = c + away * simd::max(floor - depth, S(0));
    const TangentFrame<S> frame(away);
    const LtcSurvey<S> circle = ltc_circle(lobe, raised, frame.x * r, frame.y * r);
    const auto close = simd::both(depth < S(0.02) * r, dot(c, c) < S(2) * r * r);
    return {simd::select(seen, circle.integral, S(0)), simd::both(seen, simd::either(close, circle.hard))};
}

template<class S>
GONIO_FORCE_INLINE LtcSurvey<S> survey_ltc_rectangle(const LtcLobe<S>& lobe, vec3<S> center, vec3<S> axis,
                                                     vec3<S> width_direction, S width, S height, bool two_sided) {
    const S w = simd::abs(width);
    const S h = simd::abs(height);
    const S scale = ltc_scale(center, simd::max(w, h));
    const S depth = -dot(axis, center) * scale;
    const vec3<S> x = width_direction * (S(0.5) * (w * scale));
    const vec3<S> y = cross(axis, width_direction) * (S(0.5) * (h * scale));
    const S longer = simd::max(w, h) * scale;
    const auto exists = simd::both(w > S(0), h > S(0));
    const auto seen = two_sided ? exists : simd::both(exists, depth >= S(0));
    const S sign = two_sided ? simd::copysign(S(1), depth) : S(1);
    const S floor = longer * S(__is_same(S, double) ? 1e-9 : 1e-6);
    const vec3<S> c = center * scale - axis * (sign * simd::max(floor - simd::abs(depth), S(0)));
    const S rise = simd::abs(x.z) + simd::abs(y.z);
    const auto cut = c.z < rise;
    const auto lit = simd::both(seen, c.z > -rise);
    if (!simd::any(lit)) return {S(0), lit};
    const vec3<S> c1 = lobe(c);
    const vec3<S> x1 = lobe(x);
    const vec3<S> y1 = lobe(y);
    const S half2 = dot(x1, x1) + dot(y1, y1);
    const S distance2 = dot(c1, c1);
    // Small and uncut: two by two points of its area (C. F. Gauss); the outline's sum would cancel.
    const auto small = simd::both(half2 < S(__is_same(S, double) ? 1e-5 : 5e-3) * distance2, !cut);
    S by_area = S(0);
    if (simd::any(small)) {
        constexpr double gauss = 0.57735026918962576451;
        const vec3<S> n = cross(y1, x1);
        for (int i = -1; i <= 1; i += 2)
            for (int k = -1; k <= 1; k += 2) {
                const vec3<S> p = c1 + x1 * S(i * gauss) + y1 * S(k * gauss);
                by_area = by_area + ltc_patch(p, n);
            }
    }
    S e = by_area;
    if (!simd::all(small)) {
        // Corner by corner, counter-clockwise seen from outside the sphere of directions where the front is seen;
        // relative to the centre, so that far edges keep their digits.
        const vec3<S> p[4] = {x1 * S(-1) - y1, y1 - x1, x1 + y1, x1 - y1};
        const S up[4] = {c.z - x.z - y.z, c.z - x.z + y.z, c.z + x.z + y.z, c.z + x.z - y.z};
        const vec3<S> n = cross(y1, x1);
        constexpr double least = __is_same(S, double) ? 1e-8 : least_ltc_size * least_ltc_size;
        const auto tiny = simd::both(half2 < S(least) * distance2, cut);
        vec3<S> sink{S(0), S(0), S(0)};
        vec3<S> rises = sink;
        S sum = S(0);
        S twice_area = S(0); // of the part above the horizon, over n², and its first moment
        vec3<S> moment = sink;
        const auto add_area = [&](vec3<S> from, vec3<S> to) __attribute__((always_inline)) {
            const S triangle = dot(cross(from, to), n);
            twice_area = twice_area + triangle;
            moment = moment + (from + to) * triangle;
        };
        for (int i = 0; i < 4; ++i) {
            const LtcEdge<S> edge(up[i], up[(i + 1) % 4], p[i], p[(i + 1) % 4]);
            sum = sum + great_arc(c1 + edge.from, edge.to - edge.from, {S(0), S(0), S(1)});
            if (simd::any(tiny)) add_area(edge.from, edge.to);
            sink = select(edge.sinks, edge.to, sink);
            rises = select(edge.rises, edge.from, rises);
        }
        S closing = S(0);
        if (simd::any(cut)) {
            const S arc = lobe.horizon_z * horizon_arc(c1 + sink, rises - sink, lobe.horizon());
            closing = simd::select(cut, arc, S(0));
        }
        S by_outline = simd::mul_add(sign, closing, sum);
        if (simd::any(tiny)) {
            add_area(sink, rises);
            constexpr double nothing = 1e-36;
            const S centroid = S(1.0 / 3.0) / simd::max(twice_area, S(nothing));
            const S share = S(0.5) * twice_area / simd::max(dot(n, n), S(nothing));
            const S patch = ltc_patch(c1 + moment * centroid, n * share);
            by_outline = simd::select(tiny, simd::select(twice_area > S(nothing), patch, S(0)), by_outline);
        }
        e = simd::select(small, by_area, by_outline);
    }
    const auto close = simd::both(simd::abs(depth) < S(1e-3) * longer, dot(c, c) < longer * longer);
    return {simd::select(lit, sign * e, S(0)), simd::both(lit, close)};
}

// What a caller reads of a result where it gives no mask.
struct AllLanes {};

// Evaluates the lanes marked `hard`, of those that are read, one by one in double; Shape names what to evaluate.
// Inputs: the lobe's five entries and the shape's numbers.
template<class Shape, class S, std::size_t count, class Read>
GONIO_FORCE_INLINE S finish_ltc(const LtcSurvey<S>& survey, const LtcLobe<S>& lobe, const S (&inputs)[count],
                                const Read& read) {
    S e = survey.integral;
    if constexpr (!__is_same(S, double)) {
        auto hard = survey.hard;
        if constexpr (!__is_same(Read, AllLanes)) hard = simd::both(hard, read);
        if (simd::any(hard)) e = in_double<Shape>(hard, e, inputs);
    }
    return lobe_share(e, lobe);
}

GONIO_FORCE_INLINE LtcLobe<double> lobe_of(const double* m) {
    LtcLobe<double> lobe{};
    lobe.m00 = m[0];
    lobe.m02 = m[1];
    lobe.m11 = m[2];
    lobe.m20 = m[3];
    lobe.m22 = m[4];
    const double inverse = 1.0 / __builtin_sqrt(m[0] * m[0] + m[3] * m[3]);
    lobe.horizon_x = -m[3] * inverse;
    lobe.horizon_z = m[0] * inverse;
    return lobe;
}

struct LtcSphereInDouble {
    GONIO_FORCE_INLINE static double evaluate(const double (&v)[9]) {
        return survey_ltc_sphere<double>(lobe_of(&v[0]), {v[5], v[6], v[7]}, v[8]).integral;
    }
};
struct LtcDiskInDouble {
    GONIO_FORCE_INLINE static double evaluate(const double (&v)[13]) {
        return survey_ltc_disk<double>(lobe_of(&v[0]), {v[5], v[6], v[7]}, {v[8], v[9], v[10]}, v[11], v[12] != 0.0)
            .integral;
    }
};
struct LtcRectangleInDouble {
    GONIO_FORCE_INLINE static double evaluate(const double (&v)[17]) {
        return survey_ltc_rectangle<double>(lobe_of(&v[0]), {v[5], v[6], v[7]}, {v[8], v[9], v[10]},
                                            {v[11], v[12], v[13]}, v[14], v[15], v[16] != 0.0)
            .integral;
    }
};

} // namespace detail

// Of each function: in lanes outside the mask `read` the result may be inexact.

// A sphere of radius r about `center`. d < r: 1.
template<class S, class Read = detail::AllLanes>
GONIO_FORCE_INLINE S ltc_sphere(const LtcLobe<S>& lobe, vec3<S> center, S radius, const Read& read = {}) {
    return detail::finish_ltc<detail::LtcSphereInDouble>(
        detail::survey_ltc_sphere(lobe, center, radius), lobe,
        {lobe.m00, lobe.m02, lobe.m11, lobe.m20, lobe.m22, center.x, center.y, center.z, radius}, read);
}

// A cap of directions about `toward` (unit), given the sine and cosine of its angular radius, at most π/2.
template<class S>
GONIO_FORCE_INLINE S ltc_cap(const LtcLobe<S>& lobe, vec3<S> toward, S sine, S cosine) {
    // A hemisphere's cone is almost flat, but not completely: otherwise its axis would be undefined.
    const S narrow = simd::max(cosine, S(__is_same(S, double) ? 1e-9 : 1e-4));
    const TangentFrame<S> frame(toward);
    return detail::lobe_share(detail::ltc_circle(lobe, toward * narrow, frame.x * sine, frame.y * sine).integral, lobe);
}

// A disk that emits towards +`axis` (unit), or to both sides. 0 behind its plane.
template<class S, class Read = detail::AllLanes>
GONIO_FORCE_INLINE S ltc_disk(const LtcLobe<S>& lobe, vec3<S> center, vec3<S> axis, S radius, bool two_sided = false,
                              const Read& read = {}) {
    return detail::finish_ltc<detail::LtcDiskInDouble>(
        detail::survey_ltc_disk(lobe, center, axis, radius, two_sided), lobe,
        {lobe.m00, lobe.m02, lobe.m11, lobe.m20, lobe.m22, center.x, center.y, center.z, axis.x, axis.y, axis.z, radius,
         S(two_sided ? 1 : 0)},
        read);
}

// A rectangle that emits towards +`axis`, or to both sides; `width` along `width_direction`, unit and perpendicular.
template<class S, class Read = detail::AllLanes>
GONIO_FORCE_INLINE S ltc_rectangle(const LtcLobe<S>& lobe, vec3<S> center, vec3<S> axis, vec3<S> width_direction,
                                   S width, S height, bool two_sided = false, const Read& read = {}) {
    return detail::finish_ltc<detail::LtcRectangleInDouble>(
        detail::survey_ltc_rectangle(lobe, center, axis, width_direction, width, height, two_sided), lobe,
        {lobe.m00, lobe.m02, lobe.m11, lobe.m20, lobe.m22, center.x, center.y, center.z, axis.x, axis.y, axis.z,
         width_direction.x, width_direction.y, width_direction.z, width, height, S(two_sided ? 1 : 0)},
        read);
}

} // namespace gonio::shading
