// A coat under a light with a size, for any base: what it leaves of the base's parts, and its own lobe.
//
// The part of the base without a lobe is attenuated by the mean of T over a few points of the light (light_points.hpp),
// each weighted by its irradiance. A base's lobe is attenuated by T towards the same points, weighted by the lobe
// there; what they do not show of the lobe counts at the light's point nearest to the mirrored ray. The coat's lobe is
// that of any GGX material, by the selected method. So the kernels need no code for each pair of coat and base.
#pragma once

#include <gonio/shading/brdf.hpp>
#include <gonio/shading/coat.hpp>
#include <gonio/shading/gathered_light.hpp>
#include <gonio/shading/ggx.hpp>
#include <gonio/shading/light_points.hpp>
#include <gonio/shading/reflect.hpp>
#include <gonio/shading/specular_named.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

#include <cstddef>

namespace gonio::shading {

// The coat that the constants describe, the same in every lane.
template<class S>
GONIO_FORCE_INLINE Coat<S> coat_of(const CoatConstants& constants) {
    constexpr std::size_t count = CoatConstants::most_numbers;
    static_assert(sizeof(CoatNumbers<float>) == count * sizeof(float));
    S numbers[count];
    for (std::size_t i = 0; i < count; ++i)
        numbers[i] = S(constants.numbers[i]);
    CoatNumbers<S> coat;
    __builtin_memcpy(&coat, &numbers[0], sizeof coat);
    return {coat, constants.order};
}

// What a coat leaves of the two parts of its base.
template<class S>
struct CoatUnderLight {
    CoatPass<S> scattered, lobe;
};

namespace detail {

// Of the coat's albedo towards the light, or of T for the orders of one facet: the mean over the points of the light
// above the horizon weighted by their irradiance, and the sums over them of the base's lobe. Where no point is above
// it, the mean is the value at the horizon.
template<class S>
struct OverLight {
    S mean;
    S lobe, lobe_and_albedo;
};

template<class S, class Light>
GONIO_FORCE_INLINE OverLight<S> over_light(const SurfacePoint<S>& point, const Light& light, const Coat<S>& coat,
                                           S alpha, bool has_lobe) {
    const vec3<S> n = point.normal;
    const bool physical = coat.order == CoatOrder::physical;
    S sum = S(0);
    S weights = S(0);
    OverLight<S> over{S(0), S(0), S(0)};
    const auto& points = points_of(light, SameFrame{}, way_to(light, point.position));
    for_each_direction<S>(
        points, [&](vec3<S> l, S solid_angle) __attribute__((always_inline)) {
            const S cosine = simd::max(dot(n, l), S(0));
            const S weight = solid_angle * cosine;
            const S value =
                physical ? coat_albedo(coat, cosine) : coat_pass_of_facet(coat, facet_weight(l, point.view)).both;
            sum = simd::mul_add(weight, value, sum);
            weights = weights + weight;
            if (physical && has_lobe) {
                const S lobe = weight * specular_ggx(n, l, point.view, alpha, alpha).scale;
                over.lobe = over.lobe + lobe;
                over.lobe_and_albedo = simd::mul_add(lobe, value, over.lobe_and_albedo);
            }
        });
    const auto known = weights > S(1e-30);
    const S mean = sum / simd::select(known, weights, S(1));
    over.mean = simd::select(known, mean, physical ? coat_albedo(coat, S(0)) : S(0));
    return over;
}

} // namespace detail

// The base's lobe: α of the GGX lobe of its width, and what it shows of the light per luminance, without the light's
// window.
template<class S>
struct BaseLobe {
    S alpha;
    bool is_there;
    SpecularTerms<S> seen;
};

template<class S, class Light>
GONIO_FORCE_INLINE CoatUnderLight<S> coat_under(const SurfacePoint<S>& point, const Light& light, const Coat<S>& coat,
                                                const BaseLobe<S>& lobe) {
    const detail::OverLight<S> over = detail::over_light(point, light, coat, lobe.alpha, lobe.is_there);
    if (coat.order != CoatOrder::physical) return {{over.mean, S(0)}, coat_pass_of_facet(coat, lobe.seen.grazing)};
    const vec3<S> n = point.normal;
    const S n_dot_v = dot(n, point.view);
    const S towards_eye = coat_albedo(coat, n_dot_v);
    const CoatPass<S> scattered = coat_pass(over.mean, towards_eye);
    if (!lobe.is_there) return {scattered, scattered};
    // What the points miss of the lobe is at the light's point nearest to the mirrored ray.
    const vec3<S> mirrored = detail::mirrored_view(n, point.view);
    const S nearest = coat_albedo(coat, dot(n, detail::nearest_to(light, point.position, mirrored)));
    const S missed = simd::max(lobe.seen.scale - over.lobe, S(0));
    const S all = missed + over.lobe;
    const auto known = all > S(1e-30);
    const S towards_light = simd::mul_add(missed, nearest, over.lobe_and_albedo) / simd::select(known, all, S(1));
    return {scattered, coat_pass(simd::select(known, towards_light, over.mean), towards_eye)};
}

} // namespace gonio::shading
