// The bodies of the specular kernels, for one scalar. Included by kernels_specular_<set>.cpp and by nothing else; the
// rule of kernels_impl.hpp holds here too.
#pragma once

#include <gonio/shading/kernels_specular.hpp>
#include <gonio/shading/packet.hpp>
#include <gonio/shading/specular_named.hpp>

#include <cstddef>

namespace gonio::shading::detail {

template<class S, class Light, SpecularMethod method>
void specular_batch(const Surfaces& surfaces, const LightConstants& light_constants, float alpha, float* scale,
                    float* grazing) {
    Light light;
    constants(light_constants, light);
    simd::for_each_packet<Packet<S>>(surfaces.count, [&](const Packet<S>& packet) {
        const vec3<S> center = light.center - packet.load(surfaces.position);
        const SpecularLuminance<S> found =
            specular_by<method>(light, center, packet.load(surfaces.normal), packet.load(surfaces.view), S(alpha));
        packet.store(found.scale, scale);
        packet.store(found.grazing, grazing);
    });
}

template<class S, class Light>
void specular_light(const Surfaces& surfaces, const LightConstants& light, float alpha, SpecularMethod method,
                    float* scale, float* grazing) {
    switch (method) {
    case SpecularMethod::ltc:
        return specular_batch<S, Light, SpecularMethod::ltc>(surfaces, light, alpha, scale, grazing);
    case SpecularMethod::representative_point:
        return specular_batch<S, Light, SpecularMethod::representative_point>(surfaces, light, alpha, scale, grazing);
    case SpecularMethod::dominant_direction:
        return specular_batch<S, Light, SpecularMethod::dominant_direction>(surfaces, light, alpha, scale, grazing);
    case SpecularMethod::specular_d:
        return specular_batch<S, Light, SpecularMethod::specular_d>(surfaces, light, alpha, scale, grazing);
    case SpecularMethod::spherical_hack:
        return specular_batch<S, Light, SpecularMethod::spherical_hack>(surfaces, light, alpha, scale, grazing);
    case SpecularMethod::sun_disk:
        return specular_batch<S, Light, SpecularMethod::sun_disk>(surfaces, light, alpha, scale, grazing);
    }
}

template<class S>
void specular_any(const Surfaces& surfaces, const LightConstants& light, float alpha, SpecularMethod method,
                  float* scale, float* grazing) {
    switch (light.kind) {
    case LightConstants::Kind::punctual:
        for (std::size_t i = 0; i < surfaces.count; ++i) {
            scale[i] = 0.0F;
            grazing[i] = 0.0F;
        }
        return;
    case LightConstants::Kind::sphere:
        return specular_light<S, SphereLight<S>>(surfaces, light, alpha, method, scale, grazing);
    case LightConstants::Kind::disk:
        return specular_light<S, DiskLight<S>>(surfaces, light, alpha, method, scale, grazing);
    case LightConstants::Kind::rectangle:
        return specular_light<S, RectangleLight<S>>(surfaces, light, alpha, method, scale, grazing);
    case LightConstants::Kind::tube:
        return specular_light<S, TubeLight<S>>(surfaces, light, alpha, method, scale, grazing);
    }
}

// The tables, each in the file that is compiled for its set.
extern const SpecularKernels specular_kernels_scalar;
extern const SpecularKernels specular_kernels_sse2;
extern const SpecularKernels specular_kernels_avx2;
extern const SpecularKernels specular_kernels_avx512;
extern const SpecularKernels specular_kernels_neon;

} // namespace gonio::shading::detail
