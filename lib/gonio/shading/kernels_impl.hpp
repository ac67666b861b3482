// The bodies of the kernels, for one scalar: shade.hpp over arrays. Included only by kernels_<set>.cpp.
//
// Only templates with S in their name may be instantiated from here: code compiled for a wide instruction set must not
// be a function that other files could call.
#pragma once

#include <gonio/shading/coat_area.hpp>
#include <gonio/shading/gathered_light.hpp>
#include <gonio/shading/irradiance_approximate.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/shading/packet.hpp>
#include <gonio/shading/shade.hpp>
#include <gonio/shading/sorted_batch.hpp>
#include <gonio/shading/specular_tables.hpp>
#include <gonio/simd/twin.hpp>

#include <cstddef>

namespace gonio::shading::detail {

template<class S>
void irradiance_punctual(const Surfaces& surfaces, const LightConstants& light_constants, float* lx) {
    PunctualLight<S> light;
    constants(light_constants, light);
    simd::for_each_packet<Packet<S>>(surfaces.count, [&](const Packet<S>& packet) {
        light.intensity_cd = packet.load(light_constants.intensity_cd);
        const SurfacePoint<S> point{packet.load(surfaces.position), packet.load(surfaces.normal), {S(0), S(0), S(0)}};
        packet.store(illuminance(point, light), lx);
    });
}

// A single float skips the work it does not need without sorting.
template<class S, template<class> class Light>
void irradiance_area(const Surfaces& surfaces, const LightConstants& light_constants, float* lx) {
    if constexpr (simd::Traits<S>::lanes == 1) {
        Light<S> light;
        constants(light_constants, light);
        for (std::size_t i = 0; i < surfaces.count; ++i)
            lx[i] = illuminance(receiver<S>(surfaces, i), light);
    } else {
        irradiance_sorted<S, Light>(surfaces, light_constants, lx);
    }
}

template<class S, class Light, Approximation method>
void approximate_batch(const Surfaces& surfaces, const LightConstants& light_constants, float* lx) {
    Light light;
    constants(light_constants, light);
    simd::for_each_packet<Packet<S>>(surfaces.count, [&](const Packet<S>& packet) {
        const vec3<S> center = light.center - packet.load(surfaces.position);
        const S faded = window(center, light.inverse_range);
        packet.store(finite(approximate<S, method>(light, center, packet.load(surfaces.normal)) * faded), lx);
    });
}

template<class S, class Light>
void approximate_light(const Surfaces& surfaces, const LightConstants& light, Approximation method, float* lx) {
    switch (method) {
    case Approximation::point:
        return approximate_batch<S, Light, Approximation::point>(surfaces, light, lx);
    case Approximation::frostbite:
        return approximate_batch<S, Light, Approximation::frostbite>(surfaces, light, lx);
    case Approximation::ue4:
        return approximate_batch<S, Light, Approximation::ue4>(surfaces, light, lx);
    }
}

template<class S>
void irradiance_sun(const Surfaces& surfaces, const LightConstants& light_constants, float* lx) {
    SunLight<S> light;
    constants(light_constants, light);
    simd::for_each_packet<Packet<S>>(surfaces.count, [&](const Packet<S>& packet) {
        packet.store(finite(irradiance(light, light.toward, packet.load(surfaces.normal))), lx);
    });
}

template<class S>
void irradiance_any(const Surfaces& surfaces, const LightConstants& light, float* lx) {
#ifdef GONIO_SMALL_KERNELS
    using Two = S;
#else
    using Two = simd::paired<S>; // two dependency chains fill each other's gaps
#endif
    if (light.kind == LightConstants::Kind::punctual) return irradiance_punctual<S>(surfaces, light, lx);
    if (light.kind == LightConstants::Kind::sun) return irradiance_sun<S>(surfaces, light, lx);
    with_area_light(light.kind, [&]<template<class> class Light>(OfKind<Light>) {
        irradiance_area<Two, Light>(surfaces, light, lx);
    });
}

template<class S, template<class> class Material>
void shade_punctual(const Surfaces& surfaces, const LightConstants& light_constants,
                    const MaterialConstants& material_constants, float* const rgb[3]) {
    PunctualLight<S> light;
    constants(light_constants, light);
    const auto material = material_of<Material, S>(material_constants);
    simd::for_each_packet<Packet<S>>(surfaces.count, [&](const Packet<S>& packet) {
        const SurfacePoint<S> point{packet.load(surfaces.position), packet.load(surfaces.normal),
                                    load_view(packet, surfaces, material)};
        light.intensity_cd = packet.load(light_constants.intensity_cd);
        packet.store(shade(point, light, material), rgb);
    });
}

template<class S, template<class> class Material>
void shade_coated_punctual(const Surfaces& surfaces, const LightConstants& light_constants,
                           const MaterialConstants& material_constants, float* const rgb[3]) {
    PunctualLight<S> light;
    constants(light_constants, light);
    const auto material = material_of<Material, S>(material_constants);
    const Coat<S> coat = coat_of<S>(material_constants.coat);
    simd::for_each_packet<Packet<S>>(surfaces.count, [&](const Packet<S>& packet) {
        const SurfacePoint<S> point{packet.load(surfaces.position), packet.load(surfaces.normal),
                                    packet.load(surfaces.view)};
        light.intensity_cd = packet.load(light_constants.intensity_cd);
        const Incidence<S> from = incidence(point, light);
        const vec3<S> f = coated_diffuse_part(coat, material, point.normal, from.toward, point.view) +
                          coated_specular_part(coat, material, point.normal, from.toward, point.view, S(0));
        packet.store(finite(light.color * (f * from.lx)), rgb);
    });
}

// The kernels of a part give their work a light: of its kind, or, where they are to be small, as gathered for a packet.
#ifdef GONIO_SMALL_KERNELS
template<class S>
[[gnu::noinline]] AnyLight<S> any_light(const LightConstants& from) {
    return AnyLight<S>([&](const auto& take) { with_light<S>(from, take); });
}
template<class S, class Work>
GONIO_FORCE_INLINE void with_light_seen(const LightConstants& from, const Work& work) {
    work(any_light<S>(from));
}
// Calls work(light) for the receivers of a packet.
template<class S, class Work>
GONIO_FORCE_INLINE auto seen_by(const AnyLight<S>& light, const SurfacePoint<S>& point, GatheredParts parts,
                                const Work& work) {
    GatheredLight<S> gathered;
    light.gathered(point, parts, gathered);
    return work(gathered);
}
#else
template<class S, class Work>
GONIO_FORCE_INLINE void with_light_seen(const LightConstants& from, const Work& work) {
    with_light<S>(from, work);
}
template<class S, class Light, class Work>
GONIO_FORCE_INLINE auto seen_by(const Light& light, const SurfacePoint<S>& /*point*/, GatheredParts /*parts*/,
                                const Work& work) {
    return work(light);
}
#endif

// The effect of an area light at the points of a part: illuminance [lx] and luminances of the glossy part, both for
// 1 nt.
template<class S>
struct PartUnderLight {
    static constexpr std::size_t most = 2048;
    float lx[most];
    float scale[most];
    float grazing[most];

    PartUnderLight() {} // NOLINT(*-member-init, *-use-equals-default): what is read is written first

    void without_lobe(std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            scale[i] = 0.0F;
            grazing[i] = 0.0F;
        }
    }
    // Null: 1.
    void multiply_lx(const float* share, std::size_t count) {
        for (std::size_t i = 0; share != nullptr && i < count; ++i)
            lx[i] *= share[i];
    }
    void multiply_lobe(const float* share, std::size_t count) {
        for (std::size_t i = 0; share != nullptr && i < count; ++i)
            scale[i] *= share[i];
    }
};

// Lambert needs neither the view nor the direction of the light.
template<class S>
void reflect_part(const Surfaces& surfaces, const LightConstants& light, const Lambert<S>& material,
                  const PartUnderLight<S>& under, float* const rgb[3]) {
    const vec3<S> factor = material.albedo * broadcast<S>(light.color);
    simd::for_each_packet<Packet<S>>(surfaces.count, [&](const Packet<S>& packet) {
        packet.store(finite(factor * (packet.load(&under.lx[0]) * S(std::numbers::inv_pi))), rgb);
    });
}

template<class S, class Light, template<class> class Material>
void reflect_part(const Surfaces& surfaces, const Light& any, const Material<S>& material,
                  const PartUnderLight<S>& under, float* const rgb[3]) {
    simd::for_each_packet<Packet<S>>(surfaces.count, [&](const Packet<S>& packet) {
        const SurfacePoint<S> point{packet.load(surfaces.position), packet.load(surfaces.normal),
                                    packet.load(surfaces.view)};
        constexpr GatheredParts read{Material<S>::scattering != Scattering::uniform, false};
        seen_by(
            any, point, read, [&](const auto& light) __attribute__((always_inline)) {
                const Reflected<S> parts = scattered_under(point, light, material);
                vec3<S> luminance = (parts.diffuse + parts.specular) * packet.load(&under.lx[0]);
                if constexpr (Glossy<Material>) {
                    const S window_left = faded(light, way_to(light, point.position));
                    const SpecularTerms<S> terms{packet.load(&under.scale[0]) * window_left,
                                                 packet.load(&under.grazing[0])};
                    luminance = luminance + gloss(material)(terms);
                }
                packet.store(finite(light.luminance * luminance), rgb);
            });
    });
}

// The lobe of one α, or of one power, at the points of a part.
template<class S, const SpecularKernels& specular>
void glossy_under(const Surfaces& part, const LightConstants& light, const GgxLobe<float>& lobe,
                  PartUnderLight<S>& under) {
    specular.specular(part, light, lobe.alpha, light.specular_method, &under.scale[0], &under.grazing[0]);
}
template<class S, const SpecularKernels& specular>
void glossy_under(const Surfaces& part, const LightConstants& light, const CosinePowerLobe<float>& lobe,
                  PartUnderLight<S>& under) {
    specular.specular_power(part, light, lobe.power, light.specular_method, &under.scale[0], &under.grazing[0]);
}

template<class S, const SpecularKernels& specular>
void glossy_under(const Surfaces& part, const LightConstants& light, const AnisotropicGgxLobe<float>& lobe,
                  PartUnderLight<S>& under) {
    specular.specular_anisotropic(part, light, constants_of(lobe), light.specular_method, &under.scale[0],
                                  &under.grazing[0]);
}

// The reflectance of a base's lobe, 0 without one, and the α of its width.
struct LobeReflectance {
    float f0[3] = {};
    float f90 = 0.0F, factor = 0.0F;
    float alpha = 1.0F;
};

// Turns what a base scatters into what it shows through a coat, and adds both lobes.
template<class S, class Light>
void add_coat(const Surfaces& surfaces, const Light& any, const CoatConstants& coat_constants,
              const LobeReflectance& lobe, const PartUnderLight<S>& base, const PartUnderLight<S>& top,
              const float* lobe_share, float* const rgb[3]) {
    const Coat<S> coat = coat_of<S>(coat_constants);
    const vec3<S> f0 = broadcast<S>(lobe.f0);
    simd::for_each_packet<Packet<S>>(surfaces.count, [&](const Packet<S>& packet) {
        const SurfacePoint<S> point{packet.load(surfaces.position), packet.load(surfaces.normal),
                                    packet.load(surfaces.view)};
        const SpecularTerms<S> of_base{packet.load(&base.scale[0]), packet.load(&base.grazing[0])};
        const SpecularTerms<S> of_top{packet.load(&top.scale[0]), packet.load(&top.grazing[0])};
        seen_by(
            any, point, {true, true}, [&](const auto& light) __attribute__((always_inline)) {
                const CoatUnderLight<S> left =
                    coat_under(point, light, coat, BaseLobe<S>{S(lobe.alpha), lobe.factor > 0.0F, of_base});
                const S shine = coat_reflected(coat, of_top);
                const vec3<S> lobes =
                    left.lobe.reflected(f0, S(lobe.f90), S(lobe.factor), of_base) + vec3<S>{shine, shine, shine};
                const S share = lobe_share == nullptr ? S(1) : packet.load(lobe_share);
                const vec3<S> color = light.luminance * (faded(light, way_to(light, point.position)) * share);
                packet.store(finite(packet.load(rgb) * left.scattered.scattered(coat) + color * lobes), rgb);
            });
    });
}

// What reflect_part() reads of a material: all that is not the shape of its lobe. The same code serves both kinds of
// glTF's material.
template<class S, template<class> class Material>
GONIO_FORCE_INLINE const Material<S>& apart_from_lobe(const Material<S>& material) {
    return material;
}
template<class S>
GONIO_FORCE_INLINE Gltf<S> apart_from_lobe(const Anisotropic<S>& material) {
    return as_isotropic(material);
}

// The exact irradiance and the glossy luminance have separate kernels; here they are combined, part by part.
template<class S, template<class> class Material, const SpecularKernels& specular>
void shade_area(const Surfaces& surfaces, const LightConstants& light, const MaterialConstants& material_constants,
                float* const rgb[3]) {
    const auto material = apart_from_lobe(material_of<Material, S>(material_constants));
    const CoatConstants& coat = material_constants.coat;
    constexpr std::size_t most = PartUnderLight<S>::most;
    PartUnderLight<S> under;
    for (std::size_t first = 0; first < surfaces.count; first += most) {
        const std::size_t rest = surfaces.count - first;
        const Surfaces part = seen_part_of<S>(surfaces, first, rest < most ? rest : most);
        float* const to[3] = {rgb[0] + first, rgb[1] + first, rgb[2] + first};
        const float* const share = light.share == nullptr ? nullptr : light.share + first;
        const float* const lobe_share = light.lobe_share == nullptr ? nullptr : light.lobe_share + first;
        irradiance_any<S>(part, light, &under.lx[0]);
        under.multiply_lx(share, part.count);
        // Through a coat the base shows its lobe in another way: it is added with the coat's.
        if (coat.is_on) {
            under.without_lobe(part.count);
        } else if constexpr (Glossy<Material>) {
            glossy_under<S, specular>(part, light, gloss(material_of<Material, float>(material_constants)).lobe, under);
            under.multiply_lobe(lobe_share, part.count);
        }
        if constexpr (__is_same(Material<S>, Lambert<S>))
            reflect_part<S>(part, light, material, under, to);
        else
            with_light_seen<S>(light, [&](const auto& spread) { reflect_part<S>(part, spread, material, under, to); });
        if (coat.is_on) {
            PartUnderLight<S> top;
            const float alpha = coat_alpha(coat_of<float>(coat));
            specular.specular(part, light, alpha, light.specular_method, &top.scale[0], &top.grazing[0]);
            LobeReflectance lobe;
            if constexpr (Glossy<Material>) {
                const auto glossy = gloss(material_of<Material, float>(material_constants));
                lobe = {{glossy.f0.x, glossy.f0.y, glossy.f0.z}, glossy.f90, glossy.factor, glossy.lobe.alpha};
                glossy_under<S, specular>(part, light, glossy.lobe, under);
            }
            with_light_seen<S>(
                light, [&](const auto& spread) { add_coat<S>(part, spread, coat, lobe, under, top, lobe_share, to); });
        }
    }
}

template<class S, const SpecularKernels& specular>
void shade_any(const Surfaces& surfaces, const LightConstants& light, const MaterialConstants& material,
               float* const rgb[3]) {
    with_material(material.kind, [&]<template<class> class Material>() {
        if (light.kind == LightConstants::Kind::punctual && material.coat.is_on)
            shade_coated_punctual<S, Material>(surfaces, light, material, rgb);
        else if (light.kind == LightConstants::Kind::punctual)
            shade_punctual<S, Material>(surfaces, light, material, rgb);
        else
            shade_area<S, Material, specular>(surfaces, light, material, rgb);
    });
}

// All methods treat the sun as one direction.
template<class S>
void approximate_sun(const Surfaces& surfaces, const LightConstants& light_constants, float* lx) {
    SunLight<S> light;
    constants(light_constants, light);
    const S strength = S(std::numbers::pi) * light.sine * light.sine;
    simd::for_each_packet<Packet<S>>(surfaces.count, [&](const Packet<S>& packet) {
        packet.store(finite(strength * dot(packet.load(surfaces.normal), light.toward)), lx);
    });
}

#ifdef GONIO_STANDARD_METHODS
// Where nobody can choose a method, none is compiled but the exact one: others give no number.
template<class S>
void approximate_any(const Surfaces& surfaces, const LightConstants& /*light*/, Approximation /*method*/, float* lx) {
    for (std::size_t i = 0; i < surfaces.count; ++i)
        lx[i] = __builtin_nanf("");
}
#else
template<class S>
void approximate_any(const Surfaces& surfaces, const LightConstants& light, Approximation method, float* lx) {
    if (light.kind == LightConstants::Kind::sun) return approximate_sun<S>(surfaces, light, lx);
    for (std::size_t i = 0; light.kind == LightConstants::Kind::punctual && i < surfaces.count; ++i)
        lx[i] = 0.0F;
    with_area_light(light.kind, [&]<template<class> class Light>(OfKind<Light>) {
        approximate_light<S, Light<S>>(surfaces, light, method, lx);
    });
}
#endif

// The tables, each defined in the file that is compiled for its instruction set.
extern const Kernels kernels_scalar;
extern const Kernels kernels_sse2;
extern const Kernels kernels_avx2;
extern const Kernels kernels_avx512;
extern const Kernels kernels_neon;
extern const Kernels kernels_wasm128;

} // namespace gonio::shading::detail
