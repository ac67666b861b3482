// The specular luminance of an area light by the share of a transformed cosine (ltc_share.hpp), corrected by a few
// points: half the work of rows of points (specular_ltc.hpp) and larger errors. Shaders do it (shader/), and measure/
// compares both.
//
// The true lobe is summed over a few points of the light (light_points.hpp). If the light is small compared with the
// lobe, that sum is the result. Otherwise the sum corrects the transformed cosine: its exact share is multiplied by the
// ratio of both sums over the same points. The weight of this correction depends on how well the points reproduce the
// exact share.
#pragma once

#include <gonio/shading/specular_ltc.hpp>

namespace gonio::shading {

namespace detail {

// Sizes after the transform (a length over its distance). Below the first only the points are used; above the second
// they only correct the transformed cosine's share, with less and less weight from the third to the fourth.
inline constexpr double ltc_points_alone[2] = {0.15, 0.25};
inline constexpr double ltc_points_useful[2] = {0.8, 1.6};

} // namespace detail

// As specular_ltc(), for a light that is not seen as another.
template<class S, class Light, template<class> class Lobe, class CosineOf>
GONIO_FORCE_INLINE SpecularLuminance<S> specular_by_share(const Light& light, vec3<S> to_center, vec3<S> normal,
                                                          vec3<S> view, const Lobe<S>& lobe,
                                                          const CosineOf& cosine_of) {
    const S n_dot_v = dot(normal, view);
    const auto seen = above_surface(n_dot_v);
    const LtcFrame<S> frame = ltc_frame(normal, view);
    const LtcLobe<S> cosine = cosine_of(n_dot_v, frame.sine);
    const vec3<S> v{-frame.sine, S(0), simd::select(seen, n_dot_v, S(1))};
    const auto points = detail::points_of(light, frame, to_center);
    const vec3<S> c = points.patch.center;
    const S rise = points.rise();
    const vec3<S> c1 = cosine(c);
    const S distance2 = simd::max(dot(c1, c1), S(1e-36));
    const S size2 = points.transformed_size2(cosine);
    constexpr double alone2 = detail::ltc_points_alone[0] * detail::ltc_points_alone[0];
    const auto small = size2 < S(alone2) * distance2;
    const auto dark = simd::either(c.z < -rise, !seen);
    if (simd::all(simd::either(small, dark))) {
        const detail::PointSums<S> sums = detail::sums_over<detail::CosineSum::none>(points, lobe, cosine, v);
        const S scale = simd::min(simd::max(simd::select(dark, S(0), sums.value), S(0)), S(1));
        return {scale, simd::min(sums.grazing / simd::max(sums.value, S(1e-36)), S(1))};
    }
    const detail::PointSums<S> sums = detail::sums_over<detail::CosineSum::positive>(points, lobe, cosine, v);
    const S determinant = cosine.m11 * simd::mul_add(cosine.m00, cosine.m22, -(cosine.m02 * cosine.m20));
    const S albedo = cosine.albedo * lobe.albedo_share(v.z);
    const S share = detail::ltc_share(cosine, frame, light, to_center) * albedo;
    const S by_cosine =
        sums.by_cosine * determinant * albedo * S(0.31830988618379067154) / simd::max(cosine.horizon_z, S(1e-12));
    const S relative_size = simd::sqrt(size2 / distance2);
    const auto fall = [&](const double(&range)[2]) {
        return simd::min(simd::max((S(range[1]) - relative_size) * S(1.0 / (range[1] - range[0])), S(0)), S(1));
    };
    // (κ + 1/κ − 2)/0.3² for the ratio κ of both, which is (ln κ/0.3)² where κ is near 1.
    const S product = by_cosine * share;
    const S apart = (by_cosine - share) * S(1.0 / 0.3);
    const S trust = product / simd::max(simd::mul_add(apart, apart, product), S(1e-36));
    const S confidence = fall(detail::ltc_points_useful) * trust * trust;
    const S ratio = sums.value / simd::max(by_cosine, S(1e-30));
    const S corrected = share * simd::mul_add(confidence, ratio - S(1), S(1));
    const S alone = fall(detail::ltc_points_alone);
    const S scale = simd::mul_add(alone, sums.value - corrected, corrected);
    const S by_points = sums.grazing / simd::max(sums.value, S(1e-36));
    const S by_table = cosine.grazing / cosine.albedo;
    const S grazing = simd::mul_add(simd::max(confidence, alone), by_points - by_table, by_table);
    return {simd::select(dark, S(0), simd::min(simd::max(scale, S(0)), S(1))),
            simd::min(simd::max(grazing, S(0)), S(1))};
}

// The same, with the transformed cosine from the table of all α.
template<class S, class Light, template<class> class Lobe>
GONIO_FORCE_INLINE SpecularLuminance<S> specular_by_share(const Light& light, vec3<S> to_center, vec3<S> normal,
                                                          vec3<S> view, const Lobe<S>& lobe) {
    return specular_by_share(
        light, to_center, normal, view,
        lobe, [&](S n_dot_v, S sine) __attribute__((always_inline)) { return ltc_ggx(lobe.alpha, n_dot_v, sine); });
}

} // namespace gonio::shading
