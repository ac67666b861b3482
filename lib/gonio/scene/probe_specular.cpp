#include <gonio/light/light_color.hpp>
#include <gonio/light/shape_traits.hpp>
#include <gonio/scene/core_material.hpp>
#include <gonio/scene/core_vector.hpp>
#include <gonio/scene/detail/standard_methods.hpp>
#include <gonio/scene/probe_light.hpp>
#include <gonio/shading/coat_area.hpp>
#include <gonio/shading/falloff.hpp>
#include <gonio/shading/shade.hpp>
#include <gonio/shading/specular_in_double.hpp>
#include <gonio/shading/specular_ltc.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <variant>

namespace gonio::detail {

namespace {

using Vec = shading::vec3<double>;

// Not inlined: they do not depend on the material, and are compiled once for each light instead of once for each pair.
template<class CoreLight>
[[gnu::noinline]] double illuminance(const shading::SurfacePoint<double>& point, const CoreLight& light) {
    return shading::illuminance(point, light);
}
template<class CoreLight>
[[gnu::noinline]] double frostbite_diffuse(const shading::SurfacePoint<double>& point, const CoreLight& light,
                                           double linear_roughness) {
    return shading::diffuse_ltc(light, light.center, point.normal, point.view, linear_roughness);
}

template<class CoreLight>
[[gnu::noinline]] shading::CoatUnderLight<double> under(const shading::SurfacePoint<double>& point,
                                                        const CoreLight& light, const shading::Coat<double>& coat,
                                                        const shading::BaseLobe<double>& lobe) {
    return shading::coat_under(point, light, coat, lobe);
}

// Has a lobe, and nothing beside it, for which there are the methods by name.
template<class Core>
constexpr bool has_named = Core::lobe == shading::LobeKind::ggx || Core::lobe == shading::LobeKind::anisotropic_ggx;

struct ByMethod {
    const shading::SurfacePoint<double>& point; // at the origin
    const Material& material;
    IrradianceMethod method;

    NamedLuminance operator()(const shading::SunLight<double>& sun) const { return (*this)(shading::as_sphere(sun)); }
    template<class CoreLight>
    NamedLuminance operator()(const CoreLight& core_light) const {
        return std::visit(
            [&]<class Core>(const Core& core) {
                NamedLuminance nt;
                if constexpr (std::is_same_v<Core, shading::Coated>) {
                    nt = coated(core_light, core);
                } else {
                    nt.diffuse_nt = y_of(core_light.luminance * diffuse(core_light, core));
                    if constexpr (has_named<Core>) {
                        const auto gloss = shading::gloss(core);
                        const auto share = specular(core_light, gloss.lobe);
                        const auto channel = [&](double f0) {
                            return gloss.factor * share.scale * (f0 + (gloss.f90 - f0) * share.grazing);
                        };
                        nt.specular_nt = y_of(core_light.luminance *
                                              Vec{channel(gloss.f0.x), channel(gloss.f0.y), channel(gloss.f0.z)});
                    }
                }
                return nt;
            },
            core_material(material));
    }

private:
    static double y_of(Vec rgb) { return glm::dot(glm::dvec3(rgb.x, rgb.y, rgb.z), rec709_luminance); }

    template<class CoreLight>
    shading::SpecularLuminance<double> specular(const CoreLight& core_light,
                                                const shading::GgxLobe<double>& lobe) const {
        return shading::specular_in_double(specular_method(method), core_light, core_light.center, point.normal,
                                           point.view, lobe.alpha);
    }
    template<class CoreLight>
    shading::SpecularLuminance<double> specular(const CoreLight& core_light,
                                                const shading::AnisotropicGgxLobe<double>& lobe) const {
        return shading::specular_in_double(specular_method(method), core_light, core_light.center, point.normal,
                                           point.view, lobe);
    }

    // Per luminance of the light.
    template<class CoreLight, class Core>
    Vec diffuse(const CoreLight& core_light, const Core& core) const {
        if constexpr (std::is_same_v<Core, shading::Frostbite<double>>)
            if (method == IrradianceMethod::ltc)
                return core.albedo * frostbite_diffuse(point, core_light, core.linear_roughness);
        return shading::detail::finite(
            shading::scattered_parts(point, core_light, core, illuminance(point, core_light)).diffuse);
    }

    template<class CoreLight>
    NamedLuminance coated(const CoreLight& core_light, const shading::Coated& core) const {
        const shading::Coat<double>& coat = core.coat;
        const auto top = specular(core_light, shading::GgxLobe<double>{shading::coat_alpha(coat)});
        const double shine = shading::coat_reflected(coat, shading::SpecularTerms<double>{top.scale, top.grazing});
        Vec lobes{shine, shine, shine};
        return std::visit(
            [&]<class Base>(const Base& base) {
                shading::BaseLobe<double> lobe{1.0, false, {0.0, 0.0}};
                if constexpr (has_named<Base>) {
                    const auto share = specular(core_light, shading::gloss(base).lobe);
                    lobe = {shading::gloss(base).lobe.alpha, true, {share.scale, share.grazing}};
                }
                const auto left = under(point, core_light, coat, lobe);
                if constexpr (has_named<Base>) {
                    const auto gloss = shading::gloss(base);
                    lobes = lobes + left.lobe.reflected(gloss.f0, gloss.f90, gloss.factor, lobe.seen);
                }
                const Vec matte = diffuse(core_light, base) * left.scattered.scattered(coat);
                return NamedLuminance{y_of(core_light.luminance * matte), y_of(core_light.luminance * lobes)};
            },
            core.base);
    }
};

} // namespace

shading::SpecularMethod specular_method(IrradianceMethod method) {
    using Specular = shading::SpecularMethod;
    switch (method) {
    case IrradianceMethod::representative_point:
    case IrradianceMethod::ue4:
    case IrradianceMethod::point:
        return Specular::representative_point;
    case IrradianceMethod::dominant_direction:
    case IrradianceMethod::frostbite:
        return Specular::dominant_direction;
    case IrradianceMethod::specular_d:
        return Specular::specular_d;
    case IrradianceMethod::spherical_hack:
        return Specular::spherical_hack;
    case IrradianceMethod::sun_disk:
        return Specular::sun_disk;
    case IrradianceMethod::exact:
    case IrradianceMethod::reference:
    case IrradianceMethod::ltc:
        break;
    }
    return Specular::ltc;
}

bool is_specular_method(IrradianceMethod method) {
    switch (method) {
    case IrradianceMethod::ltc:
    case IrradianceMethod::representative_point:
    case IrradianceMethod::dominant_direction:
    case IrradianceMethod::specular_d:
    case IrradianceMethod::spherical_hack:
    case IrradianceMethod::sun_disk:
        return true;
    default:
        return false;
    }
}

bool has_named_lobe(const Material& material) {
    return std::visit(
        [](const auto& m) {
            using Core = decltype(core_material(m));
            return Core::lobe == shading::LobeKind::none || has_named<Core>;
        },
        base_of(material));
}

NamedLuminance named_luminance(const Light& light, const glm::dvec3& position, const glm::dvec3& normal,
                               const ProbeSurface& surface, IrradianceMethod method) {
    if constexpr (!has_named_luminance) {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        return {none, none};
    }
    const Vec center = vec(light.frame.origin - position);
    const shading::SurfacePoint<double> point{{0.0, 0.0, 0.0}, vec(normal), vec(surface.view)};
    Frame from_here = light.frame;
    from_here.origin -= position;
    NamedLuminance nt = with_core_light(light.shape, from_here, light.color * light.luminance.value, NamedLuminance(),
                                        ByMethod{point, surface.material, method});
    const double masked = share_from_center(light, position);
    nt.diffuse_nt *= masked;
    nt.specular_nt *= masked;
    if (light.range && class_of(light.shape) != ShapeClass::sun) {
        const double window = shading::window_squared(shading::length(center), 1.0 / light.range->value);
        nt.diffuse_nt *= window;
        nt.specular_nt *= window;
    }
    return nt;
}

} // namespace gonio::detail
