// Irradiance from a uniform capsule (a tube with hemispherical ends), exact with horizon clipping.
//
// E/L [sr] in [0, π]. Seen from outside, its outline is two great arcs (the tangent planes through the receiver) and
// two arcs of the end spheres' circles. In the frame a (axis), f (from the receiver to the axis line, distance D), g =
// a × f, with s = r/D and κ = √(1 − s²), the tangent planes have the unit normals −m±, m± = ±κ g − s f, and both great
// arcs span the same angle θ. Where nothing is cut, the sum of all four arcs has a form without cancellation
// (`tube_above`, tube_apart.hpp). Where the horizon cuts: tube_clipped.hpp. Terms that cancel near the surface and
// beside the ends are computed in double and rounded once. README.md derives both.
#pragma once

#include <gonio/shading/irradiance_sphere.hpp>
#include <gonio/shading/outline.hpp>
#include <gonio/shading/tube_apart.hpp>
#include <gonio/shading/tube_clipped.hpp>

namespace gonio::shading {

namespace detail {

template<class S>
GONIO_FORCE_INLINE TubePose<S> tube_pose(vec3<S> center, vec3<S> axis, S radius, S length_m, vec3<S> normal) {
    const ScaledTube<S> scaled(center, radius, length_m);
    constexpr double least = 1e-37;
    TubePose<S> t;
    t.r = scaled.r;
    t.half = scaled.half;
    t.inverse_r = S(1) / simd::max(t.r, S(least));
    const vec3<simd::wider<S>> c = widen(scaled.center);
    const vec3<simd::wider<S>> a = widen(axis);
    t.n_a = dot(normal, axis);
    const auto depth = dot(a, c);
    const vec3<simd::wider<S>> across = c - a * depth;
    const auto across2 = dot(across, across);
    const auto r = simd::widen(t.r);
    vec3<S> f;
    S z;
    S z_rest;
    simd::narrow(across.x, f.x);
    simd::narrow(across.y, f.y);
    simd::narrow(across.z, f.z);
    simd::narrow(depth, z);
    simd::narrow(depth - simd::widen(z), z_rest);
    simd::narrow(across2 - r * r, t.gap2);
    // Mirrored along the axis where n_a < 0.
    const S side = simd::copysign(S(1), t.n_a);
    t.z = z * side;
    t.z_rest = z_rest * side;
    t.z0 = (t.z - t.half) + t.z_rest; // where this cancels, the difference is exact
    t.z1 = (t.z + t.half) + t.z_rest;
    t.tangent0 = simd::mul_add(t.z0, t.z0, t.gap2);
    t.tangent1 = simd::mul_add(t.z1, t.z1, t.gap2);
    constexpr double least_d = 1e-15; // on the axis line, where the receiver sees an end sphere instead of the tube
    t.d = simd::sqrt(simd::max(dot(f, f), S(least_d * least_d)));
    t.inverse_d = S(1) / t.d;
    t.n_f = dot(mul_add(axis, -t.n_a, normal), f) * t.inverse_d; // f may be mostly rounding error along the axis
    t.n_a = simd::abs(t.n_a);
    t.n_g = simd::abs(dot(normal, fused_cross(axis, f))) * t.inverse_d;
    t.up = simd::mul_add(t.d, t.n_f, t.z * t.n_a);
    return t;
}

// The nearer end's sphere alone: all that is seen from beyond an end and within the prolonged tube.
template<class S>
GONIO_FORCE_INLINE Survey<S> survey_tube_end(vec3<S> center, vec3<S> axis, S radius, S length_m, vec3<S> normal) {
    const ScaledTube<S> scaled(center, radius, length_m);
    const auto back = simd::widen(simd::copysign(scaled.half, -dot(axis, scaled.center)));
    const vec3<simd::wider<S>> c = widen(scaled.center);
    const vec3<simd::wider<S>> a = widen(axis);
    vec3<S> to_end;
    simd::narrow(c.x + a.x * back, to_end.x);
    simd::narrow(c.y + a.y * back, to_end.y);
    simd::narrow(c.z + a.z * back, to_end.z);
    const S r = scaled.r;
    const S least2 = simd::max(S(1e-4) * r * r, S(2.5e-6) * scaled.half * scaled.half); // as for the whole tube
    return {irradiance_sphere(to_end, r, normal), simd::abs(dot(to_end, to_end) - r * r) < least2};
}

// The same as a separate function that takes copies, as in_double. Inputs: center, axis, radius, length, normal.
template<simd::SinglePrecision S>
[[gnu::noinline]] Survey<S> nearer_end(const S (&inputs)[11]) {
    return survey_tube_end<S>({inputs[0], inputs[1], inputs[2]}, {inputs[3], inputs[4], inputs[5]}, inputs[6],
                              inputs[7], {inputs[8], inputs[9], inputs[10]});
}

// The minimum of D² − r² as a share of D²: on the surface the tangent points would coincide; slightly apart, they keep
// their order.
template<class S>
inline constexpr double least_tube_gap2 = 1e-13;
template<>
inline constexpr double least_tube_gap2<double> = 1e-24;

struct TubeInDouble;

template<class S>
GONIO_FORCE_INLINE FlatTubePose<S> flat(const TubePose<S>& t) {
    return {t.r, t.half, t.z, t.z0, t.z1, t.d * t.d, t.gap2, t.n_a, t.d * t.n_f};
}

template<class S>
struct TubeSurvey {
    S irradiance;
    simd::mask_of<S> hard; // the tangent points turn by the rounding error of the distance to the surface
    simd::mask_of<S> end;  // beyond an end and within the prolonged tube: the nearer sphere hides the rest
};

// As irradiance_tube, except in the hard and end lanes.
template<class S>
GONIO_FORCE_INLINE TubeSurvey<S> survey_tube(vec3<S> center, vec3<S> axis, S radius, S length_m, vec3<S> normal) {
    constexpr double pi = 3.14159265358979323846;
    TubePose<S> t = tube_pose(center, axis, radius, length_m, normal);
    const auto beyond0 = t.z0 > S(0); // before end 0, or past end 1
    const auto beyond1 = t.z1 < S(0);
    const auto exists = t.r > S(0);
    const auto within = simd::both(exists, t.gap2 <= S(0));
    const auto end = simd::both(within, simd::either(beyond0, beyond1));
    const auto inside = simd::both(simd::both(exists, t.gap2 < S(0)), !end);
    const auto lit = simd::both(exists, t.up + t.half * t.n_a > -t.r);
    const auto outside = simd::both(lit, !simd::either(inside, end));
    const S easy = simd::select(inside, S(pi), S(0));
    if (!simd::any(outside)) return {easy, S(0) > S(1), end};
    // Square of the distance to the nearest point of the axis, minus r².
    const S nearest2 = simd::select(beyond0, t.tangent0, simd::select(beyond1, t.tangent1, t.gap2));
    const S least2 = simd::max(S(1e-4) * t.r * t.r, S(2.5e-6) * t.half * t.half);
    const auto hard = simd::both(outside, simd::either(nearest2 < least2, t.gap2 < S(1e-9) * t.d * t.d));
    t.gap2 = simd::max(t.gap2, S(least_tube_gap2<S>) * t.d * t.d);
    const auto cut = t.up - t.half * t.n_a < t.r;
    const S e = simd::any(simd::both(outside, cut)) ? tube_clipped(t, cut) : tube_above(flat(t));
    return {simd::select(outside, clamp_irradiance(e), easy), hard, end};
}

} // namespace detail

// E/L [sr] of a capsule about `center` [m, from the receiver] along `axis`: a cylinder of `length_m` with half spheres
// of the same radius at its ends, not included in `length_m`. `axis` and the receiver's `normal` are unit. Inside π; on
// the surface the limit π(1 + n·l)/2 from outside. Any finite input; negative sizes count as positive; radius 0 gives
// 0, length 0 the sphere. In float and packs, receivers within 5e-5 of the radius from the surface, and those with a
// squared distance from it below 2.5e-6 of the square of half the length, are evaluated in double, lane by lane.
template<class S>
GONIO_FORCE_INLINE S irradiance_tube(vec3<S> center, vec3<S> axis, S radius, S length_m, vec3<S> normal) {
    if constexpr (!__is_same(S, double)) {
        const auto above = detail::survey_tube_above(center, axis, radius, length_m, normal);
        if (!simd::any(above.hard)) return above.irradiance;
    }
    const auto tube = detail::survey_tube(center, axis, radius, length_m, normal);
    S e = tube.irradiance;
    if constexpr (__is_same(S, double)) {
        if (tube.end) e = detail::survey_tube_end(center, axis, radius, length_m, normal).irradiance;
    } else {
        auto hard = tube.hard;
        if (simd::any(tube.end)) {
            const detail::Survey<S> end = detail::nearer_end<S>(
                {center.x, center.y, center.z, axis.x, axis.y, axis.z, radius, length_m, normal.x, normal.y, normal.z});
            e = simd::select(tube.end, end.irradiance, e);
            hard = simd::either(hard, simd::both(tube.end, end.hard));
        }
        if (simd::any(hard))
            return detail::in_double<detail::TubeInDouble>(
                hard, e,
                {center.x, center.y, center.z, axis.x, axis.y, axis.z, radius, length_m, normal.x, normal.y, normal.z});
    }
    return e;
}

namespace detail {

struct TubeInDouble {
    GONIO_FORCE_INLINE static double evaluate(const double (&v)[11]) {
        return irradiance_tube<double>({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, v[6], v[7], {v[8], v[9], v[10]});
    }
};

} // namespace detail

} // namespace gonio::shading
