// A coat under a light with a size, for any base: what it leaves of the base's parts, and its own lobe.
//
// The part of the base without a lobe is attenuated by the mean of T over a few points of the light (light_points.hpp),
// each weighted by its irradiance. A base's lobe is attenuated by T towards the point of the light nearest to the
// mirrored ray. The coat's lobe is that of any GGX material, by the selected method. So the kernels need no code for
// each pair of coat and base.
#pragma once

#include <gonio/shading/brdf.hpp>
#include <gonio/shading/coat.hpp>
#include <gonio/shading/light_points.hpp>
#include <gonio/shading/reflect.hpp>
#include <gonio/shading/seen_from.hpp>
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

// The mean over the points of the light above the horizon; where there are none, T at the horizon.
template<class S, class Light>
GONIO_FORCE_INLINE CoatPass<S> mean_pass(const SurfacePoint<S>& point, const Light& light, const Coat<S>& coat,
                                         S towards_eye) {
    constexpr double least = 1e-18; // its cube is still a float
    const vec3<S> n = point.normal;
    S sum = S(0);
    S weights = S(0);
    points_of(light, SameFrame{}, way_to(light, point.position))
        .for_each([&](vec3<S> p, S strength) __attribute__((always_inline)) {
            const S inverse = S(1) / simd::sqrt(simd::max(dot(p, p), S(least)));
            const vec3<S> l = p * inverse;
            const S cosine = simd::max(dot(n, l), S(0));
            const S weight = strength * inverse * inverse * (inverse * cosine);
            const S value = coat.order == CoatOrder::physical
                                ? coat_albedo(coat, cosine)
                                : coat_pass_of_facet(coat, facet_weight(l, point.view)).both;
            sum = simd::mul_add(weight, value, sum);
            weights = weights + weight;
        });
    const auto known = weights > S(1e-30);
    const S mean = sum / simd::select(known, weights, S(1));
    if (coat.order == CoatOrder::physical)
        return coat_pass(simd::select(known, mean, coat_albedo(coat, S(0))), towards_eye);
    return {simd::select(known, mean, S(0)), S(0)};
}

} // namespace detail

// `grazing` is that of the base's lobe under the light.
template<class S, class Light>
GONIO_FORCE_INLINE CoatUnderLight<S> coat_under(const SurfacePoint<S>& point, const Light& light, const Coat<S>& coat,
                                                S grazing) {
    const vec3<S> n = point.normal;
    const vec3<S> v = point.view;
    const S n_dot_v = dot(n, v);
    const S towards_eye = coat_albedo(coat, n_dot_v);
    const CoatPass<S> scattered = detail::mean_pass(point, light, coat, towards_eye);
    if (coat.order != CoatOrder::physical) return {scattered, coat_pass_of_facet(coat, grazing)};
    const vec3<S> mirrored = n * (S(2) * n_dot_v) - v;
    const auto seen = seen_from(light, detail::way_to(light, point.position));
    const vec3<S> nearest = detail::approach(seen.light, seen.to_center, mirrored).toward;
    return {scattered, coat_pass(coat_albedo(coat, dot(n, nearest)), towards_eye)};
}

} // namespace gonio::shading
