// The bodies of the kernels, for one scalar: shade.hpp over arrays. Included by kernels_<set>.cpp and by nothing else.
//
// Only templates with S in their name may be instantiated from here: what is compiled for a wide instruction set must
// not be a function that other files could call.
#pragma once

#include <gonio/shading/irradiance_named.hpp>
#include <gonio/shading/irradiance_sphere_named.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/shading/packet.hpp>
#include <gonio/shading/shade.hpp>
#include <gonio/shading/shade_area.hpp>
#include <gonio/shading/sorted_batch.hpp>
#include <gonio/simd/twin.hpp>

#include <cstddef>

namespace gonio::shading::detail {

template<class S, Approximation method>
GONIO_FORCE_INLINE S approximate(const SphereLight<S>& light, vec3<S> center, vec3<S> n) {
    if constexpr (method == Approximation::frostbite) return irradiance_sphere_frostbite(center, light.radius, n);
    if constexpr (method == Approximation::ue4) return irradiance_sphere_ue4(center, light.radius, n);
    return irradiance_sphere_point(center, light.radius, n);
}
template<class S, Approximation method>
GONIO_FORCE_INLINE S approximate(const DiskLight<S>& light, vec3<S> center, vec3<S> n) {
    if constexpr (method == Approximation::frostbite)
        return irradiance_disk_frostbite(center, light.axis, light.radius, n);
    return irradiance_disk_point(center, light.axis, light.radius, n);
}
template<class S, Approximation method>
GONIO_FORCE_INLINE S approximate(const RectangleLight<S>& light, vec3<S> center, vec3<S> n) {
    if constexpr (method == Approximation::frostbite)
        return irradiance_rectangle_frostbite(center, light.axis, light.width_direction, light.width, light.height, n);
    return irradiance_rectangle_point(center, light.axis, light.width_direction, light.width, light.height, n);
}
template<class S, Approximation method>
GONIO_FORCE_INLINE S approximate(const TubeLight<S>& light, vec3<S> center, vec3<S> n) {
    if constexpr (method == Approximation::frostbite)
        return irradiance_tube_frostbite(center, light.axis, light.radius, light.length, n);
    if constexpr (method == Approximation::ue4)
        return irradiance_tube_ue4(center, light.axis, light.radius, light.length, n);
    return irradiance_tube_point(center, light.axis, light.radius, light.length, n);
}

template<class S, class Light, class Material>
void shade_batch(const Surfaces& surfaces, const LightConstants& light_constants,
                 const MaterialConstants& material_constants, float* const rgb[3]) {
    Light light;
    Material material;
    constants(light_constants, light);
    constants(material_constants, material);
    simd::for_each_packet<Packet<S>>(surfaces.count, [&](const Packet<S>& packet) {
        const SurfacePoint<S> point{packet.load(surfaces.position), packet.load(surfaces.normal),
                                    load_view(packet, surfaces, material)};
        per_point(packet, light_constants, light);
        const vec3<S> luminance = shade(point, light, material);
        packet.store(luminance.x, rgb[0]);
        packet.store(luminance.y, rgb[1]);
        packet.store(luminance.z, rgb[2]);
    });
}

template<class S>
void irradiance_punctual(const Surfaces& surfaces, const LightConstants& light_constants, float* lx) {
    PunctualLight<S> light;
    constants(light_constants, light);
    simd::for_each_packet<Packet<S>>(surfaces.count, [&](const Packet<S>& packet) {
        per_point(packet, light_constants, light);
        const SurfacePoint<S> point{packet.load(surfaces.position), packet.load(surfaces.normal), {S(0), S(0), S(0)}};
        packet.store(illuminance(point, light), lx);
    });
}

// One float skips by itself what it does not need.
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

template<class S, class Light>
void shade_material(const Surfaces& surfaces, const LightConstants& light, const MaterialConstants& material,
                    float* const rgb[3]) {
    switch (material.kind) {
    case MaterialConstants::Kind::lambert:
        return shade_batch<S, Light, Lambert<S>>(surfaces, light, material, rgb);
    case MaterialConstants::Kind::frostbite:
        return shade_batch<S, Light, Frostbite<S>>(surfaces, light, material, rgb);
    case MaterialConstants::Kind::ggx:
        return shade_batch<S, Light, Ggx<S>>(surfaces, light, material, rgb);
    case MaterialConstants::Kind::ue4:
        return shade_batch<S, Light, Ue4<S>>(surfaces, light, material, rgb);
    case MaterialConstants::Kind::remember_me:
        return shade_batch<S, Light, RememberMe<S>>(surfaces, light, material, rgb);
    case MaterialConstants::Kind::eon:
        return shade_batch<S, Light, Eon<S>>(surfaces, light, material, rgb);
    case MaterialConstants::Kind::kulla_conty:
        return shade_batch<S, Light, KullaConty<S>>(surfaces, light, material, rgb);
    }
}

template<class S>
void shade_any(const Surfaces& surfaces, const LightConstants& light, const MaterialConstants& material,
               float* const rgb[3]) {
    switch (light.kind) {
    case LightConstants::Kind::punctual:
        return shade_material<S, PunctualLight<S>>(surfaces, light, material, rgb);
    case LightConstants::Kind::sphere:
        return shade_material<S, SphereLight<S>>(surfaces, light, material, rgb);
    case LightConstants::Kind::disk:
        return shade_material<S, DiskLight<S>>(surfaces, light, material, rgb);
    case LightConstants::Kind::rectangle:
        return shade_material<S, RectangleLight<S>>(surfaces, light, material, rgb);
    case LightConstants::Kind::tube:
        return shade_material<S, TubeLight<S>>(surfaces, light, material, rgb);
    }
}

template<class S>
void irradiance_any(const Surfaces& surfaces, const LightConstants& light, float* lx) {
    using Two = simd::paired<S>; // two chains fill each other's gaps
    switch (light.kind) {
    case LightConstants::Kind::punctual:
        return irradiance_punctual<S>(surfaces, light, lx);
    case LightConstants::Kind::sphere:
        return irradiance_area<Two, SphereLight>(surfaces, light, lx);
    case LightConstants::Kind::disk:
        return irradiance_area<Two, DiskLight>(surfaces, light, lx);
    case LightConstants::Kind::rectangle:
        return irradiance_area<Two, RectangleLight>(surfaces, light, lx);
    case LightConstants::Kind::tube:
        return irradiance_area<Two, TubeLight>(surfaces, light, lx);
    }
}

template<class S>
void approximate_any(const Surfaces& surfaces, const LightConstants& light, Approximation method, float* lx) {
    switch (light.kind) {
    case LightConstants::Kind::punctual:
        for (std::size_t i = 0; i < surfaces.count; ++i)
            lx[i] = 0.0F;
        return;
    case LightConstants::Kind::sphere:
        return approximate_light<S, SphereLight<S>>(surfaces, light, method, lx);
    case LightConstants::Kind::disk:
        return approximate_light<S, DiskLight<S>>(surfaces, light, method, lx);
    case LightConstants::Kind::rectangle:
        return approximate_light<S, RectangleLight<S>>(surfaces, light, method, lx);
    case LightConstants::Kind::tube:
        return approximate_light<S, TubeLight<S>>(surfaces, light, method, lx);
    }
}

// The tables, each in the file that is compiled for its set.
extern const Kernels kernels_scalar;
extern const Kernels kernels_sse2;
extern const Kernels kernels_avx2;
extern const Kernels kernels_avx512;
extern const Kernels kernels_neon;

} // namespace gonio::shading::detail
