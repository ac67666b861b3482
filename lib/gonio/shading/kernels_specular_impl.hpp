// The bodies of the specular kernels, for one scalar. Included only by kernels_specular_<set>.cpp; the rule of
// kernels_impl.hpp applies here too.
#pragma once

#include <gonio/shading/kernels_specular.hpp>
#include <gonio/shading/packet.hpp>
#include <gonio/shading/specular_named.hpp>
#include <gonio/shading/specular_tables.hpp>

#include <cstddef>

namespace gonio::shading::detail {

template<class S, class Light, class Lobe, SpecularMethod method>
void specular_batch(const Surfaces& surfaces, const LightConstants& light_constants, const Lobe& lobe, float* scale,
                    float* grazing) {
    Light light;
    constants(light_constants, light);
    simd::for_each_packet<Packet<S>>(surfaces.count, [&](const Packet<S>& packet) {
        const vec3<S> center = way_to(light, packet.load(surfaces.position));
        const SpecularLuminance<S> found =
            specular_by<method>(light, center, packet.load(surfaces.normal), packet.load(surfaces.view), lobe);
        packet.store(found.scale, scale);
        packet.store(found.grazing, grazing);
    });
}

// There is one α, so one row of the table of lobes serves all points.
template<class S, class Light, class Lobe>
void specular_ltc_batch(const Surfaces& surfaces, const LightConstants& light_constants, const Lobe& lobe, float* scale,
                        float* grazing) {
    Light light;
    constants(light_constants, light);
    float alpha[simd::Traits<S>::lanes];
    simd::store(lobe.alpha, &alpha[0]);
    const LtcGgxOfAlpha<S> cosine_of(alpha[0]);
    simd::for_each_packet<Packet<S>>(surfaces.count, [&](const Packet<S>& packet) {
        const vec3<S> center = way_to(light, packet.load(surfaces.position));
        const SpecularLuminance<S> found =
            specular_ltc(light, center, packet.load(surfaces.normal), packet.load(surfaces.view), lobe, cosine_of);
        packet.store(found.scale, scale);
        packet.store(found.grazing, grazing);
    });
}

// With GONIO_STANDARD_METHODS, where nobody can choose a method, none is compiled but the standard one: others give no
// number.
template<class S, class Light, class Lobe>
void specular_light(const Surfaces& surfaces, const LightConstants& light, const Lobe& lobe, SpecularMethod method,
                    float* scale, float* grazing) {
#ifdef GONIO_STANDARD_METHODS
    if (method == SpecularMethod::ltc) return specular_ltc_batch<S, Light, Lobe>(surfaces, light, lobe, scale, grazing);
    for (std::size_t i = 0; i < surfaces.count; ++i)
        scale[i] = grazing[i] = __builtin_nanf("");
#else
    switch (method) {
    case SpecularMethod::ltc:
        return specular_ltc_batch<S, Light, Lobe>(surfaces, light, lobe, scale, grazing);
    case SpecularMethod::representative_point:
        return specular_batch<S, Light, Lobe, SpecularMethod::representative_point>(surfaces, light, lobe, scale,
                                                                                    grazing);
    case SpecularMethod::dominant_direction:
        return specular_batch<S, Light, Lobe, SpecularMethod::dominant_direction>(surfaces, light, lobe, scale,
                                                                                  grazing);
    case SpecularMethod::specular_d:
        return specular_batch<S, Light, Lobe, SpecularMethod::specular_d>(surfaces, light, lobe, scale, grazing);
    case SpecularMethod::spherical_hack:
        return specular_batch<S, Light, Lobe, SpecularMethod::spherical_hack>(surfaces, light, lobe, scale, grazing);
    case SpecularMethod::sun_disk:
        return specular_batch<S, Light, Lobe, SpecularMethod::sun_disk>(surfaces, light, lobe, scale, grazing);
    }
#endif
}

template<class S, class Lobe>
void specular_lobe(const Surfaces& surfaces, const LightConstants& light, const Lobe& lobe, SpecularMethod method,
                   float* scale, float* grazing) {
    const auto of = [&]<template<class> class Light>(OfKind<Light>) {
        specular_light<S, Light<S>>(surfaces, light, lobe, method, scale, grazing);
    };
    if (light.kind == LightConstants::Kind::sun) return of(OfKind<SunLight>{});
    for (std::size_t i = 0; light.kind == LightConstants::Kind::punctual && i < surfaces.count; ++i) {
        scale[i] = 0.0F;
        grazing[i] = 0.0F;
    }
    with_area_light(light.kind, of);
}

template<class S>
void specular_any(const Surfaces& surfaces, const LightConstants& light, float alpha, SpecularMethod method,
                  float* scale, float* grazing) {
    const GgxLobe<S> lobe{simd::min(simd::max(S(alpha), S(minimum_alpha)), S(1))};
    specular_lobe<S>(surfaces, light, lobe, method, scale, grazing);
}

template<class S>
void specular_power_any(const Surfaces& surfaces, const LightConstants& light, float power, SpecularMethod method,
                        float* scale, float* grazing) {
    Blinn<S> material{};
    material.power = S(power);
    specular_lobe<S>(surfaces, light, gloss(material).lobe, method, scale, grazing);
}

} // namespace gonio::shading::detail
