#include <gonio/shading/packet.hpp>
#include <gonio/shading/specular_in_double.hpp>
#include <gonio/shading/specular_named.hpp>
#include <gonio/shading/with_specular_method.hpp>

namespace gonio::shading {

template<class Light>
SpecularLuminance<double> specular_in_double(SpecularMethod method, const Light& light, vec3<double> to_center,
                                             vec3<double> normal, vec3<double> view, double alpha) {
    return with_specular_method(
        method, [&]<SpecularMethod named>() { return specular_by<named>(light, to_center, normal, view, alpha); });
}

template<class Light>
SpecularLuminance<double> specular_in_double(SpecularMethod method, const Light& light, vec3<double> to_center,
                                             vec3<double> normal, vec3<double> view,
                                             const AnisotropicGgxLobe<double>& lobe) {
    return with_specular_method(
        method, [&]<SpecularMethod named>() { return specular_by<named>(light, to_center, normal, view, lobe); });
}

using Vec = vec3<double>;
template SpecularLuminance<double> specular_in_double(SpecularMethod, const SphereLight<double>&, Vec, Vec, Vec,
                                                      double);
template SpecularLuminance<double> specular_in_double(SpecularMethod, const DiskLight<double>&, Vec, Vec, Vec, double);
template SpecularLuminance<double> specular_in_double(SpecularMethod, const RectangleLight<double>&, Vec, Vec, Vec,
                                                      double);
template SpecularLuminance<double> specular_in_double(SpecularMethod, const TubeLight<double>&, Vec, Vec, Vec, double);

using Grained = AnisotropicGgxLobe<double>;
template SpecularLuminance<double> specular_in_double(SpecularMethod, const SphereLight<double>&, Vec, Vec, Vec,
                                                      const Grained&);
template SpecularLuminance<double> specular_in_double(SpecularMethod, const DiskLight<double>&, Vec, Vec, Vec,
                                                      const Grained&);
template SpecularLuminance<double> specular_in_double(SpecularMethod, const RectangleLight<double>&, Vec, Vec, Vec,
                                                      const Grained&);
template SpecularLuminance<double> specular_in_double(SpecularMethod, const TubeLight<double>&, Vec, Vec, Vec,
                                                      const Grained&);

void specular_in_double(const Surfaces& surfaces, const LightConstants& constants,
                        const AnisotropicLobeConstants& lobe_constants, SpecularMethod method, float* scale,
                        float* grazing) {
    const auto lobe = lobe_of<double>(lobe_constants);
    const auto at = [](const float* const v[3], std::size_t i) {
        return Vec{static_cast<double>(v[0][i]), static_cast<double>(v[1][i]), static_cast<double>(v[2][i])};
    };
    const auto over = [&](const auto& light, const auto& way) {
        for (std::size_t i = 0; i < surfaces.count; ++i) {
            const SpecularLuminance<double> seen = specular_in_double(
                method, light, way(at(surfaces.position, i)), at(surfaces.normal, i), at(surfaces.view, i), lobe);
            scale[i] = static_cast<float>(seen.scale);
            grazing[i] = static_cast<float>(seen.grazing);
        }
    };
    for (std::size_t i = 0; i < surfaces.count; ++i)
        scale[i] = grazing[i] = 0.0F;
    if (constants.kind == LightConstants::Kind::sun) {
        SunLight<double> sun;
        detail::constants(constants, sun);
        const SphereLight<double> cap = as_sphere(sun);
        over(cap, [&](Vec /*position*/) { return cap.center; });
    } else {
        detail::with_area_light(constants.kind, [&]<template<class> class Light>(detail::OfKind<Light>) {
            Light<double> light;
            detail::constants(constants, light);
            over(light, [&](Vec position) { return light.center - position; });
        });
    }
}

} // namespace gonio::shading
