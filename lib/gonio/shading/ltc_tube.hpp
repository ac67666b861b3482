// The share of a lobe that a capsule (a tube with hemispherical ends) covers: ltc_share.hpp's integral over
// irradiance_tube.hpp's outline, two great arcs and two arcs of the ends' circles.
#pragma once

#include <gonio/shading/ltc_share.hpp>

namespace gonio::shading {

namespace detail {

// The part of an end's circle that is on the outline (azimuths −h … h) and above the horizon: one arc, or two where the
// horizon dips into it.
template<class S>
struct LtcEnd {
    vec3<S> a, u, v; // transformed
    CircleCut<S> horizon;
    S cos_h, sin_h;
    simd::mask_of<S> start, end; // −h and h are above the horizon
    simd::mask_of<S> dips, bumps;

    GONIO_FORCE_INLINE vec3<S> at(S cosine, S sine) const { return a + u * cosine + v * sine; }
    GONIO_FORCE_INLINE vec3<S> sink() const { return at(horizon.cos_sink(), horizon.sin_sink()); }
    GONIO_FORCE_INLINE vec3<S> rise() const { return at(horizon.cos_rise(), horizon.sin_rise()); }

    GONIO_FORCE_INLINE S arcs() const {
        const LtcCone<S> cone(a, u, v);
        const auto twice = simd::both(simd::both(start, end), dips);
        const auto to_end = simd::both(end, !twice);
        const S from_cos = simd::select(start, cos_h, horizon.cos_rise());
        const S from_sin = simd::select(start, -sin_h, horizon.sin_rise());
        const S to_cos = simd::select(to_end, cos_h, horizon.cos_sink());
        const S to_sin = simd::select(to_end, sin_h, horizon.sin_sink());
        const auto around = simd::both(simd::both(start, to_end), cos_h < S(0)); // nearly all of the circle
        const auto sliver = [](S c0, S s0, S c1, S s1) { return simd::mul_add(c0, c1, s0 * s1) > S(0.9999); };
        const auto visible = simd::either(simd::either(start, end), bumps);
        S sum = simd::select(visible,
                             cone.arc(at(from_cos, from_sin), at(to_cos, to_sin),
                                      simd::both(sliver(from_cos, from_sin, to_cos, to_sin), !around)),
                             S(0));
        if (simd::any(twice)) {
            const S more =
                cone.arc(rise(), at(cos_h, sin_h), sliver(horizon.cos_rise(), horizon.sin_rise(), cos_h, sin_h));
            sum = sum + simd::select(twice, more, S(0));
        }
        return sum;
    }
};

// Takes the end's axis p/d, u and v (local, of unit length), and sine and cosine of the circle's angle about the axis.
template<class S>
GONIO_FORCE_INLINE LtcEnd<S> ltc_end(const LtcLobe<S>& lobe, vec3<S> axis, vec3<S> u, vec3<S> v, S sine, S cosine,
                                     S cos_h, S sin_h, simd::mask_of<S> start, simd::mask_of<S> end) {
    const CircleCut<S> horizon(axis.z * cosine, u.z * sine, v.z * sine);
    const auto dips = simd::both(horizon.cut, -horizon.cos_middle >= cos_h);
    const auto bumps = simd::both(simd::both(horizon.cut, horizon.cos_middle >= cos_h), !simd::either(start, end));
    return {lobe(axis * cosine), lobe(u * sine), lobe(v * sine), horizon, cos_h, sin_h, start, end, dips, bumps};
}

// A capsule that is small after the transform and above the horizon: its visible strip at three points along the axis,
// and half a sphere's disk at each end.
template<class S>
GONIO_FORCE_INLINE S ltc_small_tube(const LtcLobe<S>& lobe, vec3<S> center, vec3<S> axis, S r, S half) {
    constexpr double pi = 3.14159265358979323846;
    constexpr double node = 0.77459666924148337704;
    constexpr double least = 1e-36;
    const S determinant = lobe.m11 * simd::mul_add(lobe.m00, lobe.m22, -(lobe.m02 * lobe.m20));
    const auto density = [&](vec3<S> p) __attribute__((always_inline)) { // per (dω |p|³)
        const vec3<S> q = lobe(p);
        const S inverse = S(1) / simd::max(dot(q, q), S(least));
        return determinant * inverse * (q.z * inverse);
    };
    const auto strip = [&](S along) __attribute__((always_inline)) {
        const vec3<S> p = center + axis * along;
        return length(cross(axis, p)) * density(p);
    };
    const auto cap = [&](S along) __attribute__((always_inline)) {
        const vec3<S> p = center + axis * along;
        return length(p) * density(p);
    };
    const S strips = S(5.0 / 18.0) * (strip(-half * S(node)) + strip(half * S(node))) + S(8.0 / 18.0) * strip(S(0));
    const S out = half + r * S(4.0 / (3.0 * pi));
    return S(4) * r * half * strips + S(0.5 * pi) * r * r * (cap(out) + cap(-out));
}

template<class S>
GONIO_FORCE_INLINE LtcSurvey<S> survey_ltc_tube(const LtcLobe<S>& lobe, vec3<S> center, vec3<S> axis, S radius,
                                                S length_m) {
    constexpr double pi = 3.14159265358979323846;
    const S size = simd::abs(radius);
    const S span = simd::abs(length_m);
    const S scale = ltc_scale(center, simd::max(size, span));
    const vec3<S> c = center * scale;
    const S r = size * scale;
    const S half = S(0.5) * (span * scale);
    const S z = dot(axis, c);
    const vec3<S> across = perpendicular(c, axis);
    const S d = length(across);
    const S z0 = z - half;
    const S z1 = z + half;
    const S gap2 = (d - r) * (d + r);
    const auto exists = r > S(0);
    const auto beyond = simd::either(z0 > S(0), z1 < S(0));
    const auto within = gap2 <= S(0);
    const auto inside = simd::both(within, !beyond);
    const auto end = simd::both(within, beyond);
    S e = simd::select(inside, S(pi) * lobe.horizon_z, S(0));
    auto hard = S(0) > S(1);
    if (simd::any(end)) {
        const vec3<S> nearer = c + axis * simd::copysign(half, -z);
        const LtcSurvey<S> sphere = survey_ltc_sphere(lobe, nearer, r);
        e = simd::select(end, sphere.integral, e);
        hard = simd::both(end, sphere.hard);
    }
    const S reach = simd::mul_add(half, simd::abs(axis.z), r); // above and below the centre
    const auto outside = simd::both(simd::both(exists, c.z > -reach), !within);
    if (simd::any(outside)) {
        const auto cut = c.z < reach;
        const vec3<S> c1 = lobe(c);
        const vec3<S> axis1 = lobe(axis);
        const S half2 = dot(axis1, axis1) * half * half;
        const S stretch = simd::max(simd::max(lobe.m00 * lobe.m00 + lobe.m02 * lobe.m02, lobe.m11 * lobe.m11),
                                    simd::mul_add(lobe.m20, lobe.m20, lobe.m22 * lobe.m22));
        const S distance2 = dot(c1, c1);
        const S size2 = simd::mul_add(stretch * r, r, half2);
        const auto small = simd::both(size2 < S(__is_same(S, double) ? 1e-7 : 5e-4) * distance2, !cut);
        S by_strips = S(0);
        if (simd::any(small)) by_strips = ltc_small_tube(lobe, c, axis, r, half);
        S by_outline = by_strips;
        if (!simd::all(simd::either(small, !outside))) {
            constexpr double least = 1e-18;
            const S inverse_d = S(1) / simd::max(d, S(least));
            const S gap = simd::sqrt(simd::max(gap2, S(1e-12) * d * d));
            const S s = r * inverse_d;
            const S kappa = gap * inverse_d;
            const vec3<S> f = across * inverse_d;
            const vec3<S> g = cross(axis, f);
            const vec3<S> f1 = lobe(f);
            const vec3<S> g1 = lobe(g);
            // The four points where the tangent planes touch the ends.
            const S base = gap * kappa;
            const S side = r * kappa;
            const auto point = [&](vec3<S> f_of, vec3<S> a_of, vec3<S> g_of, S along, S sign)
                __attribute__((always_inline)) {
                return f_of * base + a_of * along + g_of * (sign * side);
            };
            const auto height = [&](S along, S sign) __attribute__((always_inline)) {
                return simd::mul_add(f.z, base, simd::mul_add(axis.z, along, g.z * (sign * side)));
            };
            const S plus = S(1);
            const S minus = S(-1);
            const S up0_plus = height(z0, plus);
            const S up1_plus = height(z1, plus);
            const S up0_minus = height(z0, minus);
            const S up1_minus = height(z1, minus);
            const LtcEdge<S> edge_plus(up0_plus, up1_plus, point(f1, axis1, g1, z0, plus),
                                       point(f1, axis1, g1, z1, plus));
            const LtcEdge<S> edge_minus(up1_minus, up0_minus, point(f1, axis1, g1, z1, minus),
                                        point(f1, axis1, g1, z0, minus));
            // Always inline: an out-of-line lambda of the double form would be shared between instruction sets.
            const auto end_of = [&](S along, S sense, simd::mask_of<S> start, simd::mask_of<S> stop)
                __attribute__((always_inline)) {
                const S distance = simd::sqrt(simd::mul_add(d, d, along * along));
                const S inverse = S(1) / distance;
                const S sine = r * inverse;
                const S cosine = simd::sqrt(simd::max(simd::mul_add(along, along, gap * gap), S(0))) * inverse;
                const S x = sense * s * along;
                const S y = distance * kappa;
                const S inverse_h = S(1) / simd::max(simd::sqrt(simd::mul_add(x, x, y * y)), S(least));
                const vec3<S> to_end = (f * d + axis * along) * inverse;
                const vec3<S> u = (axis * d - f * along) * (sense * inverse);
                return ltc_end(lobe, to_end, u, g * -sense, sine, cosine, x * inverse_h, y * inverse_h, start, stop);
            };
            const auto above = [](S up) { return up >= S(0); };
            const LtcEnd<S> end1 = end_of(z1, plus, above(up1_plus), above(up1_minus));
            const LtcEnd<S> end0 = end_of(z0, minus, above(up0_minus), above(up0_plus));
            S sum = edge_plus.arc() + edge_minus.arc() + end0.arcs() + end1.arcs();
            if (simd::any(cut)) {
                const auto single1 = simd::either(simd::both(simd::both(end1.start, end1.end), end1.dips), end1.bumps);
                const auto single0 = simd::either(simd::both(simd::both(end0.start, end0.end), end0.dips), end0.bumps);
                const auto sinks1 = simd::either(single1, simd::both(end1.start, !end1.end));
                const auto rises1 = simd::either(single1, simd::both(end1.end, !end1.start));
                const vec3<S> sink =
                    select(edge_plus.sinks, edge_plus.to,
                           select(edge_minus.sinks, edge_minus.to, select(sinks1, end1.sink(), end0.sink())));
                const vec3<S> rise =
                    select(edge_plus.rises, edge_plus.from,
                           select(edge_minus.rises, edge_minus.from, select(rises1, end1.rise(), end0.rise())));
                const auto any0 = simd::either(single0, !(simd::both(end0.start, end0.end)));
                const auto any1 = simd::either(single1, !(simd::both(end1.start, end1.end)));
                const auto crossed = simd::either(any0, any1);
                const auto hidden =
                    simd::both(simd::both(!simd::either(end0.start, end0.end), !simd::either(end1.start, end1.end)),
                               !simd::either(end0.bumps, end1.bumps));
                sum = sum + simd::select(simd::both(crossed, !hidden), ltc_closing(lobe, sink, rise), S(0));
            }
            by_outline = simd::select(small, by_strips, sum);
        }
        const auto close = simd::either(gap2 < S(1e-3) * d * d, stretch * r * r < S(1e-6) * distance2);
        const auto tiny = simd::both(cut, size2 < S(0.01) * distance2);
        e = simd::select(outside, by_outline, e);
        hard = simd::either(hard, simd::both(simd::both(outside, !small), simd::either(close, tiny)));
    }
    return {simd::select(exists, e, S(0)), simd::both(exists, hard)};
}

struct LtcTubeInDouble {
    GONIO_FORCE_INLINE static double evaluate(const double (&v)[13]) {
        return survey_ltc_tube<double>(lobe_of(&v[0]), {v[5], v[6], v[7]}, {v[8], v[9], v[10]}, v[11], v[12]).integral;
    }
};

} // namespace detail

// A cylinder of `length_m` about `center` along `axis` (unit), with half spheres of the same radius as ends. 1 inside
// it. In lanes outside the mask `read` the result may be inexact.
template<class S, class Read = detail::AllLanes>
GONIO_FORCE_INLINE S ltc_tube(const LtcLobe<S>& lobe, vec3<S> center, vec3<S> axis, S radius, S length_m,
                              const Read& read = {}) {
    return detail::finish_ltc<detail::LtcTubeInDouble>(detail::survey_ltc_tube(lobe, center, axis, radius, length_m),
                                                       lobe,
                                                       {lobe.m00, lobe.m02, lobe.m11, lobe.m20, lobe.m22, center.x,
                                                        center.y, center.z, axis.x, axis.y, axis.z, radius, length_m},
                                                       read);
}

} // namespace gonio::shading
