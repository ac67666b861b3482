// The specular luminance of an area light by the share of a transformed cosine (ltc_share.hpp), corrected by a few
// points: half the work of rows of points (specular_ltc.hpp) and larger errors. Shaders can do it (shader/), and
// measure/ compares both.
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

// Where the points are enough.
template<class S>
GONIO_FORCE_INLINE SpecularLuminance<S> points_alone(const PointSums<S>& sums, simd::mask_of<S> dark) {
    return {simd::select(dark, S(0), simd::min(simd::max(sums.value, S(0)), S(1))),
            simd::min(sums.grazing / simd::max(sums.value, S(1e-36)), S(1))};
}

// The share of the transformed cosine by its sum, for the lobe's albedo.
template<class S, bool sheared>
GONIO_FORCE_INLINE S summed_share(const PointSums<S>& sums, const LtcLobe<S, sheared>& cosine, S albedo) {
    constexpr double inverse_pi = 0.31830988618379067154;
    return sums.by_cosine * cosine.determinant() * albedo * S(inverse_pi) / simd::max(cosine.horizon_z, S(1e-12));
}

// 1/(1 + (κ + 1/κ − 2)/width²) for the ratio κ of a share by points and the exact one; the fraction is (ln κ/width)²
// where κ is near 1.
template<class S>
GONIO_FORCE_INLINE S trust(S summed, S exact, double width) {
    const S product = summed * exact;
    const S apart = (summed - exact) * S(1.0 / width);
    return product / simd::max(simd::mul_add(apart, apart, product), S(1e-36));
}

} // namespace detail

// As specular_ltc(), for a light that is not seen as another.
template<class S, class Light, template<class> class Lobe, class CosineOf>
GONIO_FORCE_INLINE SpecularLuminance<S> specular_by_share(const Light& light, vec3<S> to_center, vec3<S> normal,
                                                          vec3<S> view, const Lobe<S>& lobe,
                                                          const CosineOf& cosine_of) {
    const auto pose = detail::lobe_pose(light, to_center, normal, view, cosine_of);
    const LtcLobe<S>& cosine = pose.cosine;
    constexpr double alone2 = detail::ltc_points_alone[0] * detail::ltc_points_alone[0];
    const auto small = pose.size2 < S(alone2) * pose.distance2;
    const auto dark = pose.is_below();
    if (simd::all(simd::either(small, dark)))
        return detail::points_alone(detail::sums_over(pose.points, lobe, cosine, pose.v), dark);
    const detail::PointSums<S> sums = detail::sums_over<true>(pose.points, lobe, cosine, pose.v);
    const S albedo = cosine.albedo * lobe.albedo_share(pose.v.z);
    const S share = detail::ltc_share(cosine, pose.frame, light, to_center) * albedo;
    const S by_cosine = detail::summed_share(sums, cosine, albedo);
    const S relative_size = simd::sqrt(pose.size2 / pose.distance2);
    const auto fall = [&](const double(&range)[2]) {
        return simd::min(simd::max((S(range[1]) - relative_size) * S(1.0 / (range[1] - range[0])), S(0)), S(1));
    };
    const S trust = detail::trust(by_cosine, share, 0.3);
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
