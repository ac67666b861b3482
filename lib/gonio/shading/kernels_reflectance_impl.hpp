// The bodies of the kernels of kernels_reflectance.hpp, for one scalar. Included only by kernels_reflectance_<set>.cpp,
// under the rule of kernels_impl.hpp: only templates with S in their name are instantiated from here.
#pragma once

#include <gonio/shading/brdf.hpp>
#include <gonio/shading/coat_area.hpp>
#include <gonio/shading/kernels_reflectance.hpp>
#include <gonio/shading/packet.hpp>

#include <cstddef>

namespace gonio::shading::detail {

template<class S, class Value>
void reflectance_of_each(const DirectionPairs& pairs, float* const rgb[3], const Value& value) {
    const vec3<S> normal{S(0), S(0), S(1)};
    simd::for_each_packet<Packet<S>>(pairs.count, [&](const Packet<S>& packet) {
        packet.store(finite(value(normal, packet.load(pairs.to_light), packet.load(pairs.to_eye))), rgb);
    });
}

template<class S>
bool are_unit(const float* const vectors[3], std::size_t count) {
    simd::mask_of<S> others = S(0) > S(0); // none so far
    simd::for_each_packet<Packet<S>>(count, [&](const Packet<S>& packet) {
        const vec3<S> v = packet.load(vectors);
        others = simd::either(others, !(simd::abs(dot(v, v) - S(1)) <= S(1e-5)));
    });
    return !simd::any(others);
}

template<class S>
void reflectance_any(const DirectionPairs& pairs, const MaterialConstants& constants, float* const rgb[3]) {
    with_material(constants.kind, [&]<template<class> class Material>() {
        const auto material = material_of<Material, S>(constants);
        if (!constants.coat.is_on)
            return reflectance_of_each<S>(pairs, rgb, [&](vec3<S> n, vec3<S> l, vec3<S> v) {
                return diffuse_part(material, n, l, v) + specular_part(material, n, l, v, S(0));
            });
        const Coat<S> coat = coat_of<S>(constants.coat);
        reflectance_of_each<S>(pairs, rgb, [&](vec3<S> n, vec3<S> l, vec3<S> v) {
            return coated_diffuse_part(coat, material, n, l, v) + coated_specular_part(coat, material, n, l, v, S(0));
        });
    });
}

extern const ReflectanceKernels reflectance_kernels_scalar;
extern const ReflectanceKernels reflectance_kernels_sse2;
extern const ReflectanceKernels reflectance_kernels_avx2;
extern const ReflectanceKernels reflectance_kernels_avx512;
extern const ReflectanceKernels reflectance_kernels_neon;
extern const ReflectanceKernels reflectance_kernels_wasm128;

} // namespace gonio::shading::detail
