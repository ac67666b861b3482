// The bodies of the specular kernels, for one scalar. Included only by kernels_specular_<set>.cpp; the rule of
// kernels_impl.hpp applies here too.
#pragma once

#include <gonio/shading/anisotropic_lobe.hpp>
#include <gonio/shading/kernels_specular.hpp>
#include <gonio/shading/packet.hpp>
#include <gonio/shading/specular_in_double.hpp>
#include <gonio/shading/specular_named.hpp>
#include <gonio/shading/specular_tables.hpp>
#include <gonio/shading/with_specular_method.hpp>

#include <cstddef>

namespace gonio::shading::detail {

// A lobe whose kind is known at run time alone: for methods that are there to be compared with, and for kernels that
// are to be small.
template<class S>
struct AnyLobe {
    static constexpr bool is_even = true;

    S alpha, power;
    bool is_power;

    GONIO_FORCE_INLINE AnyLobe(GgxLobe<S> lobe) : alpha(lobe.alpha), power(S(0)), is_power(false) {}
    GONIO_FORCE_INLINE AnyLobe(CosinePowerLobe<S> lobe) : alpha(lobe.alpha), power(lobe.power), is_power(true) {}

    GONIO_FORCE_INLINE S value(vec3<S> l, vec3<S> v, const HalfVector<S>& h) const {
        return is_power ? CosinePowerLobe<S>{alpha, power}.value(l, v, h) : GgxLobe<S>{alpha}.value(l, v, h);
    }
    GONIO_FORCE_INLINE EvenSlopes<S> slopes() const { return GgxLobe<S>{alpha}.slopes(); }
    GONIO_FORCE_INLINE S width(vec2<S> /*direction*/) const { return alpha; }
    GONIO_FORCE_INLINE S albedo_share(S n_dot_v) const {
        return is_power ? CosinePowerLobe<S>{alpha, power}.albedo_share(n_dot_v) : S(1);
    }
    GONIO_FORCE_INLINE SpecularTerms<S> operator()(vec3<S> n, vec3<S> l, vec3<S> v, S widened) const {
        return is_power ? CosinePowerLobe<S>{alpha, power}(n, l, v, widened) : GgxLobe<S>{alpha}(n, l, v, widened);
    }
};
#ifdef GONIO_SMALL_KERNELS
template<class S, template<class> class Lobe>
using lobe_for = AnyLobe<S>;
#else
template<class S, template<class> class Lobe>
using lobe_for = Lobe<S>;
#endif

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

// specular_ltc() of a packet, in small kernels once for all lights that are seen as the same.
#ifdef GONIO_SMALL_KERNELS
template<class S, class Seen, class Lobe>
[[gnu::noinline]] void specular_of_seen(const Seen& light, const vec3<S>& to_center, const SurfacePoint<S>& point,
                                        const Lobe& lobe, const LtcGgxOfAlpha<S>& cosine_of,
                                        SpecularLuminance<S>& found) {
    found = specular_ltc(light, to_center, point.normal, point.view, lobe, cosine_of);
}
template<class S, class Light, class Lobe>
GONIO_FORCE_INLINE SpecularLuminance<S> specular_of(const Light& light, const SurfacePoint<S>& point, const Lobe& lobe,
                                                    const LtcGgxOfAlpha<S>& cosine_of) {
    const auto seen = seen_from(light, way_to(light, point.position));
    SpecularLuminance<S> found;
    specular_of_seen(seen.light, seen.to_center, point, lobe, cosine_of, found);
    return found;
}
#else
template<class S, class Light, class Lobe>
GONIO_FORCE_INLINE SpecularLuminance<S> specular_of(const Light& light, const SurfacePoint<S>& point, const Lobe& lobe,
                                                    const LtcGgxOfAlpha<S>& cosine_of) {
    return specular_ltc(light, way_to(light, point.position), point.normal, point.view, lobe, cosine_of);
}
#endif

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
        const SurfacePoint<S> point{packet.load(surfaces.position), packet.load(surfaces.normal),
                                    packet.load(surfaces.view)};
        const SpecularLuminance<S> found = specular_of(light, point, lobe, cosine_of);
        packet.store(found.scale, scale);
        packet.store(found.grazing, grazing);
    });
}

// A lobe that is not the same in all directions of the surface has a row of the table for each point.
template<class S, class Light>
void specular_ltc_batch(const Surfaces& surfaces, const LightConstants& light_constants,
                        const AnisotropicGgxLobe<S>& lobe, float* scale, float* grazing) {
    specular_batch<S, Light, AnisotropicGgxLobe<S>, SpecularMethod::ltc>(surfaces, light_constants, lobe, scale,
                                                                         grazing);
}

// With GONIO_STANDARD_METHODS, where nobody can choose a method, others than the standard one give no number.
template<class S, class Light, class Lobe>
void specular_light(const Surfaces& surfaces, const LightConstants& light, const Lobe& lobe, SpecularMethod method,
                    float* scale, float* grazing) {
    const bool is_known = with_specular_method(method, [&]<SpecularMethod named>() {
        if constexpr (named == SpecularMethod::ltc) {
            specular_ltc_batch<S, Light>(surfaces, light, lobe, scale, grazing);
        } else {
            specular_batch<S, Light, AnyLobe<S>, named>(surfaces, light, AnyLobe<S>(lobe), scale, grazing);
        }
        return true;
    });
    for (std::size_t i = 0; i < surfaces.count && !is_known; ++i)
        scale[i] = grazing[i] = __builtin_nanf("");
}

// work(OfKind<Light>{}) for a light that has highlights; the others have none.
template<class Work>
void with_highlights(const Surfaces& surfaces, const LightConstants& light, float* scale, float* grazing,
                     const Work& work) {
    if (light.kind == LightConstants::Kind::sun) return work(OfKind<SunLight>{});
    for (std::size_t i = 0; light.kind == LightConstants::Kind::punctual && i < surfaces.count; ++i) {
        scale[i] = 0.0F;
        grazing[i] = 0.0F;
    }
    with_area_light(light.kind, work);
}

template<class S, class Lobe>
void specular_lobe(const Surfaces& surfaces, const LightConstants& light, const Lobe& lobe, SpecularMethod method,
                   float* scale, float* grazing) {
    with_highlights(surfaces, light, scale, grazing, [&]<template<class> class Light>(OfKind<Light>) {
        specular_light<S, Light<S>>(surfaces, light, lobe, method, scale, grazing);
    });
}

template<class S>
void specular_any(const Surfaces& surfaces, const LightConstants& light, float alpha, SpecularMethod method,
                  float* scale, float* grazing) {
    const lobe_for<S, GgxLobe> lobe(GgxLobe<S>{simd::min(simd::max(S(alpha), S(minimum_alpha)), S(1))});
    specular_lobe<S>(surfaces, light, lobe, method, scale, grazing);
}

template<class S>
void specular_power_any(const Surfaces& surfaces, const LightConstants& light, float power, SpecularMethod method,
                        float* scale, float* grazing) {
    Blinn<S> material{};
    material.power = S(power);
    const lobe_for<S, CosinePowerLobe> lobe(gloss(material).lobe);
    specular_lobe<S>(surfaces, light, lobe, method, scale, grazing);
}

// What is there to be compared with, and all of small kernels, in double, by the code of probes.
template<class S>
void specular_anisotropic_any(const Surfaces& surfaces, const LightConstants& light,
                              const AnisotropicLobeConstants& constants, SpecularMethod method, float* scale,
                              float* grazing) {
#ifndef GONIO_SMALL_KERNELS
    if (method == SpecularMethod::ltc)
        return with_highlights(surfaces, light, scale, grazing, [&]<template<class> class Light>(OfKind<Light>) {
            specular_ltc_batch<S, Light<S>>(surfaces, light, lobe_of<S>(constants), scale, grazing);
        });
#endif
    specular_in_double(surfaces, light, constants, method, scale, grazing);
}

} // namespace gonio::shading::detail
