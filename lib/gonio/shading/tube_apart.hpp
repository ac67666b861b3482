// The irradiance of a capsule that is well apart from the receiver, for which float is enough: all of it above the
// horizon, one end above it and the other below (irradiance_tube.hpp's outline in fewer terms), or cut in any way.
#pragma once

#include <gonio/shading/outline.hpp>
#include <gonio/shading/tube_clipped.hpp>

namespace gonio::shading::detail {

// In (f, a, g) as TubePose, without D itself: nothing here needs the root.
template<class S>
struct FlatTubePose {
    S r, half;
    S z, z0, z1; // along the axis: the centre and the ends' centres
    S d2, gap2;  // D², D² − r²
    S n_a;       // component of the receiver's normal along the axis
    S d_n_f;     // D n_f
};

// The whole capsule above the horizon, D > r. The sum of the arcs: ends' circles by their azimuths h, great arcs
// θ s n·f, and the remaining slopes of circles and arcs, combined over one denominator.
template<class S>
GONIO_FORCE_INLINE S tube_above(const FlatTubePose<S>& t) {
    const S distance0 = simd::sqrt(simd::mul_add(t.z0, t.z0, t.d2));
    const S distance1 = simd::sqrt(simd::mul_add(t.z1, t.z1, t.d2));
    const S gap = simd::sqrt(t.gap2);
    const S theta = simd::atan2_above(S(2) * gap * t.half, simd::mul_add(t.z0, t.z1, t.gap2));
    const S h0 = simd::atan2_above(distance0 * gap, -t.r * t.z0);
    const S h1 = simd::atan2_above(distance1 * gap, t.r * t.z1);
    const S product = distance0 * distance1;
    const S inverse_all = S(1) / (product * t.d2); // a single division for three inverses
    const S inverse = inverse_all * t.d2;
    const S n_f_over_d = inverse_all * product * t.d_n_f;
    const S inverse0 = inverse * distance1;
    const S inverse1 = inverse * distance0;
    // n·P / |P|³ of the ends, each times r² h.
    const S cap0 = h0 * simd::mul_add(t.z0, t.n_a, t.d_n_f) * (inverse0 * inverse0) * inverse0;
    const S cap1 = h1 * simd::mul_add(t.z1, t.n_a, t.d_n_f) * (inverse1 * inverse1) * inverse1;
    const S slope = simd::mul_add(t.n_a, t.z0 + t.z1, n_f_over_d * simd::mul_add(-t.z0, t.z1, t.d2));
    const S slopes = S(2) * gap * t.half * (inverse * inverse) * slope;
    return t.r * simd::mul_add(theta, n_f_over_d, simd::mul_add(t.r, cap0 + cap1, slopes));
}

// Where float is enough, by the distance from the tube and from its prolongation. A receiver so near in angle to the
// axis line that its distance from it has lost digits is too near; the limit is stricter where the outline is cut.
template<class S>
struct TubeApart {
    simd::mask_of<S> whole; // or split between the ends
    simd::mask_of<S> cut;
};

// Takes D² and z² of the centre, and the light's own sizes.
template<class S>
GONIO_FORCE_INLINE TubeApart<S> tube_apart(S d2, S z2, S r, S half) {
    const auto aside = d2 >= S(1.25) * r * r;
    const S extent2 = simd::max(z2 + d2, half * half);
    return {simd::both(aside, d2 > S(0.0025) * extent2), simd::both(aside, d2 > S(0.01) * extent2)};
}

// The pose in float alone.
template<class S>
struct ApartPose {
    FlatTubePose<S> tube;
    vec3<S> across; // from the receiver, perpendicular to the axis line
    TubeApart<S> apart;
};

template<class S>
GONIO_FORCE_INLINE ApartPose<S> apart_pose(vec3<S> center, vec3<S> axis, S radius, S length_m, vec3<S> normal) {
    const ScaledTube<S> scaled(center, radius, length_m);
    ApartPose<S> pose;
    FlatTubePose<S>& t = pose.tube;
    t.r = scaled.r;
    t.half = scaled.half;
    t.z = dot(axis, scaled.center);
    t.z0 = t.z - t.half;
    t.z1 = t.z + t.half;
    pose.across = mul_add(axis, -t.z, scaled.center);
    const S d2 = dot(pose.across, pose.across);
    const S gap2 = simd::mul_add(-t.r, t.r, d2);
    t.n_a = dot(normal, axis);
    t.d_n_f = dot(mul_add(axis, -t.n_a, normal), pose.across);
    pose.apart = tube_apart(d2, t.z * t.z, t.r, t.half);
    t.d2 = simd::max(d2, S(1e-30));
    t.gap2 = simd::max(gap2, S(1e-30));
    return pose;
}

// Mirrored along the axis, so that end 1 is the higher one.
template<class S>
GONIO_FORCE_INLINE void mirror(FlatTubePose<S>& t) {
    t.z = t.z * simd::copysign(S(1), t.n_a);
    t.z0 = t.z - t.half;
    t.z1 = t.z + t.half;
    t.n_a = simd::abs(t.n_a);
}

// D n_g, mirrored so that it is not negative.
template<class S>
GONIO_FORCE_INLINE S d_n_g(const ApartPose<S>& pose, vec3<S> axis, vec3<S> normal) {
    return simd::abs(dot(normal, fused_cross(axis, pose.across)));
}

// E/L of a capsule entirely above the horizon and well apart; the other lanes are marked hard.
template<class S>
GONIO_FORCE_INLINE Survey<S> survey_tube_above(vec3<S> center, vec3<S> axis, S radius, S length_m, vec3<S> normal) {
    const ApartPose<S> pose = apart_pose(center, axis, radius, length_m, normal);
    const FlatTubePose<S>& t = pose.tube;
    const S lowest = simd::mul_add(t.z, t.n_a, t.d_n_f) - t.half * simd::abs(t.n_a);
    const auto easy = simd::both(simd::both(lowest >= t.r, t.r > S(0)), pose.apart.whole);
    if (!simd::any(easy)) return {S(0), !easy};
    return {clamp_irradiance(tube_above(t)), !easy};
}

// One end's sphere above the horizon, the other's below. The horizon cuts both great arcs, all of the higher end's
// circle is seen and nothing of the lower one's: tube_clipped.hpp's sum without its case distinctions.
template<class S>
GONIO_FORCE_INLINE S tube_split(const FlatTubePose<S>& t, S d_n_g) {
    const S gap = simd::sqrt(t.gap2);
    const S square1 = simd::mul_add(t.z1, t.z1, t.d2);
    const S distance1 = simd::sqrt(square1);
    const S inverse_all = S(1) / (t.d2 * square1 * t.n_a); // a single division for three inverses
    const S inverse_d2 = inverse_all * square1 * t.n_a;
    const S inverse_square1 = inverse_all * t.d2 * t.n_a;
    const S inverse_n_a = inverse_all * t.d2 * square1;
    const S n_f_over_d = t.d_n_f * inverse_d2;
    const S n_g_over_d = d_n_g * inverse_d2;
    const S width = t.r * gap;

    // The crossings (D κ², z, ±r κ) of the tangent lines, in (f, a, g), and the distance from them to the higher end.
    const S level = simd::mul_add(t.z, t.n_a, t.gap2 * n_f_over_d);
    const S out = width * n_g_over_d;
    const S from_plus = -(level + out) * inverse_n_a;
    const S from_minus = -(level - out) * inverse_n_a;
    const S z_plus = t.z + from_plus;
    const S z_minus = t.z + from_minus;
    const S angle_plus = simd::atan2_above(gap * (t.half - from_plus), simd::mul_add(z_plus, t.z1, t.gap2));
    const S angle_minus = simd::atan2_above(gap * (t.half - from_minus), simd::mul_add(z_minus, t.z1, t.gap2));
    // Both lie on the horizon, so their cross product points along the normal.
    const S slant = simd::mul_add(n_f_over_d, z_minus + z_plus, S(-2) * t.gap2 * inverse_d2 * t.n_a);
    const S turn = simd::mul_add(width, slant, t.gap2 * n_g_over_d * (from_plus - from_minus));
    const S along = simd::mul_add(z_minus, z_plus, t.gap2 * simd::mul_add(-t.r, t.r, t.gap2) * inverse_d2);
    const S closing = simd::atan2_above(simd::abs(turn), along);

    const S azimuth = simd::atan2_above(distance1 * gap, t.r * t.z1); // half of the circle's azimuth
    const S toward = simd::mul_add(t.z1, t.n_a, t.d_n_f) * distance1 * inverse_square1;
    const S across = simd::mul_add(-t.z1, n_f_over_d, t.n_a);
    const S end = t.r * inverse_square1 * simd::mul_add(t.r * azimuth, toward, -(gap * across));
    const S facing = t.r * n_f_over_d;
    const S aside = gap * n_g_over_d;
    const S great = simd::mul_add(facing - aside, angle_plus, (facing + aside) * angle_minus);
    return simd::mul_add(S(0.5), great + closing, end);
}

// E/L of a capsule split in this way by the horizon and well apart; the other lanes are marked hard.
template<class S>
GONIO_FORCE_INLINE Survey<S> survey_tube_split(vec3<S> center, vec3<S> axis, S radius, S length_m, vec3<S> normal) {
    ApartPose<S> pose = apart_pose(center, axis, radius, length_m, normal);
    FlatTubePose<S>& t = pose.tube;
    mirror(t);
    const S height = simd::mul_add(t.z, t.n_a, t.d_n_f);
    const auto split = simd::abs(height) < simd::mul_add(t.half, t.n_a, -t.r);
    const auto easy = simd::both(simd::both(split, simd::min(t.n_a, t.r) > S(1e-20)), pose.apart.whole);
    if (!simd::any(easy)) return {S(0), !easy};
    return {clamp_irradiance(tube_split(t, d_n_g(pose, axis, normal))), !easy};
}

// E/L of a capsule that the horizon cuts anywhere and that is well apart; the other lanes are marked hard.
template<class S>
GONIO_FORCE_INLINE Survey<S> survey_tube_cut(vec3<S> center, vec3<S> axis, S radius, S length_m, vec3<S> normal) {
    ApartPose<S> pose = apart_pose(center, axis, radius, length_m, normal);
    FlatTubePose<S>& flat = pose.tube;
    mirror(flat);
    TubePose<S> t;
    t.r = flat.r;
    t.half = flat.half;
    t.inverse_r = S(1) / simd::max(t.r, S(1e-37));
    t.z = flat.z;
    t.z_rest = S(0);
    t.z0 = flat.z0;
    t.z1 = flat.z1;
    t.d = simd::sqrt(flat.d2);
    t.inverse_d = S(1) / t.d;
    t.gap2 = flat.gap2;
    t.tangent0 = simd::mul_add(t.z0, t.z0, t.gap2);
    t.tangent1 = simd::mul_add(t.z1, t.z1, t.gap2);
    t.n_f = flat.d_n_f * t.inverse_d;
    t.n_a = flat.n_a;
    t.n_g = d_n_g(pose, axis, normal) * t.inverse_d;
    t.up = simd::mul_add(t.z, t.n_a, flat.d_n_f);
    const auto exists = t.r > S(0);
    const auto cut = t.up - t.half * t.n_a < t.r;
    const auto easy = simd::both(simd::both(cut, exists), pose.apart.cut);
    const ClippedTube<S> visible = clipped_tube<true>(t);
    return {clamp_irradiance(visible.arcs + visible.rest), !easy};
}

} // namespace gonio::shading::detail
