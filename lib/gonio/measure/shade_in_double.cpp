#include <gonio/measure/shade_in_double.hpp>
#include <gonio/shading/coat_area.hpp>
#include <gonio/shading/packet.hpp>
#include <gonio/shading/shade.hpp>
#include <gonio/shading/specular_in_double.hpp>
#include <gonio/shading/with_specular_method.hpp>

namespace gonio::measure {

namespace {

using namespace shading;
using Point = SurfacePoint<double>;

// Not inlined: shade_parts() in one piece would be compiled for each light, material and method. These depend on two of
// them at most.
template<class CoreLight>
[[gnu::noinline]] double lux(const Point& point, const CoreLight& light) {
    return illuminance(point, light);
}
template<class CoreLight, class CoreMaterial>
[[gnu::noinline]] Reflected<double> scattered(const Point& point, const CoreLight& light,
                                              const CoreMaterial& material) {
    return scattered_parts(point, light, material, lux(point, light));
}
template<class CoreLight, class Lobe>
[[gnu::noinline]] SpecularLuminance<double> specular(SpecularMethod method, const Point& point, const CoreLight& light,
                                                     const Lobe& lobe) {
    const vec3<double> to_center = shading::detail::way_to(light, point.position);
    return with_specular_method(method, [&]<SpecularMethod named>() {
        return specular_by<named>(light, to_center, point.normal, point.view, lobe);
    });
}

template<class CoreLight>
concept IsSun = __is_same(CoreLight, SunLight<double>);

// GGX under the lights that the library itself compiles.
template<class CoreLight>
requires(!IsSun<CoreLight>) SpecularLuminance<double> specular(SpecularMethod method, const Point& point,
                                                               const CoreLight& light, const GgxLobe<double>& lobe) {
    return specular_in_double(method, light, shading::detail::way_to(light, point.position), point.normal, point.view,
                              lobe.alpha);
}

template<class CoreLight>
requires(!IsSun<CoreLight>) SpecularLuminance<double> specular(SpecularMethod method, const Point& point,
                                                               const CoreLight& light,
                                                               const AnisotropicGgxLobe<double>& lobe) {
    return specular_in_double(method, light, shading::detail::way_to(light, point.position), point.normal, point.view,
                              lobe);
}

// Attenuates the diffuse part and adds the coat's lobe.
template<class CoreLight>
[[gnu::noinline]] void add_coat(const Point& point, const CoreLight& light, SpecularMethod method,
                                const CoatConstants& constants, Reflected<double>& parts) {
    const Coat<double> coat = coat_of<double>(constants);
    const SpecularLuminance<double> seen = specular(method, point, light, GgxLobe<double>{coat_alpha(coat)});
    const double fade = shading::detail::faded(light, shading::detail::way_to(light, point.position));
    const double shine = coat_reflected(coat, SpecularTerms<double>{seen.scale * fade, seen.grazing});
    parts.diffuse = parts.diffuse *
                    coat_under(point, light, coat, BaseLobe<double>{1.0, false, {0.0, 0.0}}).scattered.scattered(coat);
    parts.specular = parts.specular + vec3<double>{shine, shine, shine};
}

} // namespace

Reflected<double> shade_parts_in_double(const Point& point, const LightConstants& light,
                                        const MaterialConstants& material) {
    Reflected<double> result{};
    shading::detail::with_light<double>(light, [&](const auto& typed) {
        with_material(material.kind, [&]<template<class> class Material>() {
            const Material<double> core = material_of<Material, double>(material);
            Reflected<double> parts = scattered(point, typed, core);
            if constexpr (Glossy<Material>) {
                const auto glossy = gloss(core);
                const SpecularLuminance<double> seen = specular(light.specular_method, point, typed, glossy.lobe);
                const double fade = shading::detail::faded(typed, shading::detail::way_to(typed, point.position));
                const SpecularTerms<double> terms{seen.scale * fade, seen.grazing};
                if (material.coat.is_on) {
                    const auto left = coat_under(
                        point, typed, coat_of<double>(material.coat),
                        BaseLobe<double>{glossy.lobe.alpha, glossy.factor > 0.0, {seen.scale, seen.grazing}});
                    parts.specular = parts.specular * left.scattered.scattered(coat_of<double>(material.coat)) +
                                     left.lobe.reflected(glossy.f0, glossy.f90, glossy.factor, terms);
                } else {
                    parts.specular = parts.specular + glossy(terms);
                }
            }
            if (material.coat.is_on) add_coat(point, typed, light.specular_method, material.coat, parts);
            const vec3<double> color = shading::detail::color_of<double>(typed);
            result = {shading::detail::finite(color * parts.diffuse), shading::detail::finite(color * parts.specular)};
        });
    });
    return result;
}

} // namespace gonio::measure
