// The specular luminance of an area light along rows of points that the lobe places (lobe_rows.hpp), corrected by the
// share of a linearly transformed cosine (ltc_share.hpp): a candidate for the default, which measure/ compares with it.
//
// With F and C the sums of the lobe and of the cosine over the same points, and K the cosine's exact share,
//
//     F (1 + w² (K/C − 1)),  w = K C/((C − K)²/0.2² + K C)
//
// If the points give the cosine's share nearly, they err in the lobe as in the cosine, so K/C mends both; w is near 1
// then. If they do not, F stays.
#pragma once

#include <gonio/shading/lobe_rows.hpp>
#include <gonio/shading/specular_ltc.hpp>

namespace gonio::shading {

namespace detail {

// Below these sizes (a length over its distance, after the transform) the light's own points are used; the second holds
// where the horizon cuts the light.
inline constexpr double rows_from = 0.15;
inline constexpr double rows_from_if_cut = 1e-3;

// Whether the receiver is in the light, which then fills its hemisphere.
template<class S, class Light>
GONIO_FORCE_INLINE simd::mask_of<S> surrounded(const Light& /*light*/, vec3<S> /*to_center*/) {
    return S(0) > S(1);
}
template<class S>
GONIO_FORCE_INLINE simd::mask_of<S> surrounded(const SphereLight<S>& light, vec3<S> to_center) {
    const S scale = points_scale(light, to_center);
    const vec3<S> c = to_center * scale;
    return simd::difference_of_squares(c.x, c.y, c.z, light.radius * scale) < S(0);
}
template<class S>
GONIO_FORCE_INLINE simd::mask_of<S> surrounded(const TubeLight<S>& light, vec3<S> to_center) {
    const S scale = points_scale(light, to_center);
    const vec3<S> c = to_center * scale;
    const S half = S(0.5) * (simd::abs(light.length) * scale);
    const S along = dot(light.axis, c);
    const S within = simd::min(simd::max(along, -half), half);
    const vec3<S> nearest = perpendicular(c, light.axis) + light.axis * (along - within);
    return simd::difference_of_squares(nearest.x, nearest.y, nearest.z, light.radius * scale) < S(0);
}

// Whether the receiver is behind a flat light that emits to one side, or in its plane.
template<class S, class Light, class Points>
GONIO_FORCE_INLINE simd::mask_of<S> unlit_side(const Light& /*light*/, const Points& /*points*/) {
    return S(0) > S(1);
}
template<class S>
GONIO_FORCE_INLINE simd::mask_of<S> unlit_side(const DiskLight<S>& /*light*/, const DiskPoints<S>& points) {
    return !(points.patch.strength > S(0));
}
template<class S>
GONIO_FORCE_INLINE simd::mask_of<S> unlit_side(const RectangleLight<S>& /*light*/, const RectanglePoints<S>& points) {
    return !(points.patch.strength > S(0));
}

// The height of a light's centre above the horizon.
template<class S, class Points, class Light, class Frame>
GONIO_FORCE_INLINE S center_height(const Points& points, const Light& /*light*/, const Frame& /*frame*/,
                                   vec3<S> /*to_center*/) {
    return points.patch.center.z;
}
template<class S, class Frame>
GONIO_FORCE_INLINE S center_height(const TubePoints<S>& /*points*/, const TubeLight<S>& light, const Frame& frame,
                                   vec3<S> to_center) {
    return TubeSeen<S>(light, frame, to_center).center().z;
}

} // namespace detail

// As specular_ltc().
template<class S, class Light, template<class> class Lobe>
GONIO_FORCE_INLINE SpecularLuminance<S> specular_by_rows(const Light& light, vec3<S> to_center, vec3<S> normal,
                                                         vec3<S> view, const Lobe<S>& lobe) {
    const S n_dot_v = dot(normal, view);
    const auto seen = above_surface(n_dot_v);
    const LtcFrame<S> frame = ltc_frame(normal, view);
    const LtcLobe<S> cosine = ltc_ggx(lobe.alpha, n_dot_v, frame.sine);
    const vec3<S> v{-frame.sine, S(0), simd::select(seen, n_dot_v, S(1))};
    const auto points = detail::points_of(light, frame, to_center);
    const S height = detail::center_height(points, light, frame, to_center);
    const S rise = points.rise();
    const vec3<S> c1 = cosine(points.patch.center);
    const S distance2 = simd::max(dot(c1, c1), S(1e-36));
    const S size2 = points.transformed_size2(cosine);
    constexpr double from2 = detail::rows_from * detail::rows_from;
    constexpr double from2_if_cut = detail::rows_from_if_cut * detail::rows_from_if_cut;
    const auto small = size2 < simd::select(simd::abs(height) < rise, S(from2_if_cut), S(from2)) * distance2;
    const auto dark = simd::either(simd::either(height < -rise, detail::unlit_side<S>(light, points)), !seen);
    S value = S(0);
    S grazing = S(0);
    if (simd::any(simd::both(small, !dark))) {
        const detail::PointSums<S> sums = detail::point_sums<false>(points, lobe, cosine, v);
        value = sums.value;
        grazing = sums.grazing / simd::max(sums.value, S(1e-36));
    }
    if (!simd::all(simd::either(small, dark))) {
        const auto region = detail::region_of(cosine, points, light, frame, to_center);
        const detail::LobeSums<S> sums = detail::sums_over_rows(region, cosine, lobe, v);
        const S determinant = cosine.m11 * simd::mul_add(cosine.m00, cosine.m22, -(cosine.m02 * cosine.m20));
        const S albedo = cosine.albedo * lobe.albedo_share(v.z);
        const S k = detail::ltc_share(cosine, frame, light, to_center) * albedo;
        constexpr double inverse_pi = 0.31830988618379067154;
        const S c = sums.by_cosine * determinant * albedo * S(inverse_pi) / simd::max(cosine.horizon_z, S(1e-12));
        const auto both = simd::both(k > S(0), c > S(0));
        const S product = simd::select(both, k * c, S(0));
        const S apart = (c - k) * S(1.0 / 0.2);
        const S trust = product / simd::max(simd::mul_add(apart, apart, product), S(1e-36));
        const S ratio = simd::select(both, k / simd::select(both, c, S(1)), S(1));
        const S by_rows = sums.value * simd::mul_add(trust * trust, ratio - S(1), S(1));
        const auto surrounded = detail::surrounded(light, to_center);
        value = simd::select(small, value, simd::select(surrounded, albedo, by_rows));
        grazing = simd::select(
            small, grazing,
            simd::select(surrounded, cosine.grazing / cosine.albedo, sums.grazing / simd::max(sums.value, S(1e-36))));
    }
    return {simd::select(dark, S(0), simd::min(simd::max(value, S(0)), S(1))),
            simd::min(simd::max(grazing, S(0)), S(1))};
}

template<class S, class Light, template<class> class Lobe>
requires SeenAsAnother<Light, S> GONIO_FORCE_INLINE SpecularLuminance<S>
specular_by_rows(const Light& light, vec3<S> to_center, vec3<S> normal, vec3<S> view, const Lobe<S>& lobe) {
    const auto seen = light.seen_from(to_center);
    return specular_by_rows(seen.light, seen.to_center, normal, view, lobe);
}

} // namespace gonio::shading
