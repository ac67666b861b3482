// The specular part of a material under an area light by linearly transformed cosines (ltc_lobe.hpp, ltc_share.hpp).
//
// One call gives both terms of the reflectance (specular_method.hpp). Positions are relative to the receiver.
#pragma once

#include <gonio/shading/gloss.hpp>
#include <gonio/shading/light_points.hpp>
#include <gonio/shading/lights.hpp>
#include <gonio/shading/ltc_tube.hpp>
#include <gonio/shading/seen_from.hpp>
#include <gonio/shading/specular_method.hpp>

namespace gonio::shading {

namespace detail {

template<class S>
GONIO_FORCE_INLINE S ltc_share(const LtcLobe<S>& lobe, const LtcFrame<S>& frame, const SphereLight<S>& light,
                               vec3<S> to_center) {
    return ltc_sphere(lobe, frame(to_center), light.radius);
}
template<class S>
GONIO_FORCE_INLINE S ltc_share(const LtcLobe<S>& lobe, const LtcFrame<S>& frame, const DiskLight<S>& light,
                               vec3<S> to_center) {
    return ltc_disk(lobe, frame(to_center), frame(light.axis), light.radius, light.two_sided);
}
template<class S>
GONIO_FORCE_INLINE S ltc_share(const LtcLobe<S>& lobe, const LtcFrame<S>& frame, const RectangleLight<S>& light,
                               vec3<S> to_center) {
    return ltc_rectangle(lobe, frame(to_center), frame(light.axis), frame(light.width_direction), light.width,
                         light.height, light.two_sided);
}
template<class S>
GONIO_FORCE_INLINE S ltc_share(const LtcLobe<S>& lobe, const LtcFrame<S>& frame, const TubeLight<S>& light,
                               vec3<S> to_center) {
    return ltc_tube(lobe, frame(to_center), frame(light.axis), light.radius, light.length);
}
template<class S>
GONIO_FORCE_INLINE S ltc_share(const LtcLobe<S>& lobe, const LtcFrame<S>& frame, const SunLight<S>& light,
                               vec3<S> toward) {
    return ltc_cap(lobe, frame(toward), light.sine, light.cosine);
}

} // namespace detail

namespace detail {

// Sums over those points of a light that are above the horizon, in ltc_frame's frame.
template<class S>
struct PointSums {
    S value;     // ∫ f n·l dω, of the lobe itself with F = 1
    S grazing;   // the same with F = (1 − l·h)⁵
    S by_cosine; // ∫ of the transformed cosine that approximates the lobe, up to a factor
};

template<bool with_cosine, class S, class Points, class Lobe>
GONIO_FORCE_INLINE PointSums<S> point_sums(const Points& points, const Lobe& lobe, const LtcLobe<S>& cosine,
                                           vec3<S> v) {
    PointSums<S> sums{S(0), S(0), S(0)};
    constexpr double least = 1e-18; // its cube is still a float
    points.for_each([&](vec3<S> p, S strength) __attribute__((always_inline)) {
        const S inverse = S(1) / simd::sqrt(simd::max(dot(p, p), S(least)));
        const vec3<S> l = p * inverse;
        const auto lit = above_surface(l.z);
        const S solid_angle = simd::select(lit, strength * inverse * inverse * inverse, S(0));
        const S n_dot_l = simd::select(lit, l.z, S(1));
        const HalfVector<S> h = half_vector(l, v);
        const S value = lobe.value(n_dot_l, v.z, h) * n_dot_l * solid_angle;
        sums.value = sums.value + value;
        sums.grazing = simd::mul_add(value, schlick_weight(h.l_dot_h), sums.grazing);
        if constexpr (with_cosine) {
            const vec3<S> q = cosine(l);
            const S inverse_q = S(1) / simd::max(dot(q, q), S(1e-36));
            sums.by_cosine = simd::mul_add(simd::max(q.z, S(0)) * inverse_q * inverse_q, solid_angle, sums.by_cosine);
        }
    });
    return sums;
}

// The same for points of any light: not inlined, where kernels are to be small.
template<bool with_cosine, class S, class Lobe>
[[gnu::noinline]] void sum_gathered(const GatheredPoints<S>& points, const Lobe& lobe, const LtcLobe<S>& cosine,
                                    const vec3<S>& v, PointSums<S>& sums) {
    sums = point_sums<with_cosine>(points, lobe, cosine, v);
}
template<bool with_cosine, class S, class Points, class Lobe>
GONIO_FORCE_INLINE PointSums<S> sums_over(const Points& points, const Lobe& lobe, const LtcLobe<S>& cosine, vec3<S> v) {
#ifdef GONIO_SMALL_KERNELS
    GatheredPoints<S> gathered;
    gathered.gather(points);
    PointSums<S> sums;
    sum_gathered<with_cosine>(gathered, lobe, cosine, v, sums);
    return sums;
#else
    return point_sums<with_cosine>(points, lobe, cosine, v);
#endif
}

// Sizes after the transform (a length over its distance). Below the first only the points are used; above the second
// they only correct the transformed cosine's share, with less and less weight from the third to the fourth.
inline constexpr double ltc_points_alone[2] = {0.15, 0.25};
inline constexpr double ltc_points_useful[2] = {0.8, 1.6};

} // namespace detail

// A lobe (gloss.hpp). `normal` and `view` are unit; `to_center` leads from the receiver to the light's centre. 0 where
// n·v is not positive. Light is any light with a size, or a SunLight; its window is not
// applied.
//
// The true lobe is summed over a few points of the light (light_points.hpp). If the light is small compared with the
// lobe, that sum is the result. Otherwise the sum corrects the transformed cosine: its exact share is multiplied by the
// ratio of both sums over the same points. The weight of this correction depends on how well the points reproduce the
// exact share.
//
// `cosine_of(n·v, ‖n×v‖)` gives the transformed cosine of the lobe's α.
template<class S, class Light, template<class> class Lobe, class CosineOf>
GONIO_FORCE_INLINE SpecularLuminance<S> specular_ltc(const Light& light, vec3<S> to_center, vec3<S> normal,
                                                     vec3<S> view, const Lobe<S>& lobe, const CosineOf& cosine_of) {
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
        const detail::PointSums<S> sums = detail::sums_over<false>(points, lobe, cosine, v);
        const S scale = simd::min(simd::max(simd::select(dark, S(0), sums.value), S(0)), S(1));
        return {scale, simd::min(sums.grazing / simd::max(sums.value, S(1e-36)), S(1))};
    }
    const detail::PointSums<S> sums = detail::sums_over<true>(points, lobe, cosine, v);
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

template<class S, class Light, template<class> class Lobe, class CosineOf>
requires SeenAsAnother<Light, S> GONIO_FORCE_INLINE SpecularLuminance<S> specular_ltc(const Light& light,
                                                                                      vec3<S> to_center, vec3<S> normal,
                                                                                      vec3<S> view, const Lobe<S>& lobe,
                                                                                      const CosineOf& cosine_of) {
    const auto seen = light.seen_from(to_center);
    return specular_ltc(seen.light, seen.to_center, normal, view, lobe, cosine_of);
}

// The same, with the transformed cosine from the table of all α.
template<class S, class Light, template<class> class Lobe>
GONIO_FORCE_INLINE SpecularLuminance<S> specular_ltc(const Light& light, vec3<S> to_center, vec3<S> normal,
                                                     vec3<S> view, const Lobe<S>& lobe) {
    return specular_ltc(
        light, to_center, normal, view,
        lobe, [&](S n_dot_v, S sine) __attribute__((always_inline)) { return ltc_ggx(lobe.alpha, n_dot_v, sine); });
}

// The renormalised Disney diffuse of albedo 1, in the same way: luminance per luminance of the light.
template<class S, class Light>
GONIO_FORCE_INLINE S diffuse_ltc(const Light& light, vec3<S> to_center, vec3<S> normal, vec3<S> view,
                                 S linear_roughness) {
    const S n_dot_v = dot(normal, view);
    const LtcLobe<S> lobe = ltc_diffuse(linear_roughness, n_dot_v);
    const auto seen = seen_from(light, to_center);
    const S share = detail::ltc_share(lobe, ltc_frame(normal, view), seen.light, seen.to_center);
    return simd::select(n_dot_v > S(0), share * lobe.albedo, S(0));
}

} // namespace gonio::shading
