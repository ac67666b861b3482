// One surface point lit by one light: outgoing luminance, as templates on the scalar.
//
// With double this is the truth that the kernels are tested against and what numbers are probed with; with packs it is
// what kernels.cpp runs. Light and material are types, so each pair is its own straight code.
// Results are finite and not negative for any finite input; illuminance ends at `illuminance_ceiling`.
//
// Under a light with a size the diffuse part takes the exact irradiance, with the factors of direction taken towards
// the centre (raised to the horizon when below it), and the glossy part is specular_named.hpp's, by the method asked
// for.
#pragma once

#include <gonio/shading/direction.hpp>
#include <gonio/shading/irradiance_area.hpp>
#include <gonio/shading/reflect.hpp>
#include <gonio/shading/specular_named.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

#include <numbers>

namespace gonio::shading {

// Illuminance [lx]: I⟨n·l⟩/d². 0 where the light lies on the point, which leaves it without a direction.
template<class S>
GONIO_FORCE_INLINE S illuminance(const SurfacePoint<S>& point, const PunctualLight<S>& light) {
    const vec3<S> to_light = light.position - point.position;
    const Direction<S> d = direction(to_light, point.normal);
    const S inverse_distance = d.scale * d.inverse_distance;
    const S cosine = simd::max(d.n_dot_l, S(0)) * detail::window(to_light, light.inverse_range);
    return detail::finite(light.intensity_cd * (cosine * inverse_distance * inverse_distance));
}

namespace detail {

template<class Light>
inline constexpr bool is_punctual = false;
template<class S>
inline constexpr bool is_punctual<PunctualLight<S>> = true;

template<class S>
GONIO_FORCE_INLINE Incidence<S> incidence(const SurfacePoint<S>& point, const PunctualLight<S>& light) {
    const Direction<S> d = direction(light.position - point.position, point.normal);
    return {illuminance(point, light), d.scaled * d.inverse_distance};
}

// Where the diffuse part's light comes from.
template<class S, class Light>
GONIO_FORCE_INLINE vec3<S> diffuse_toward(const SurfacePoint<S>& point, const Light& light) {
    const Direction<S> d = direction(way_to(light, point.position), point.normal);
    const vec3<S> l = d.scaled * d.inverse_distance;
    return above_horizon(point.normal, normalized(l - point.normal * simd::min(d.n_dot_l, S(0))));
}

// The glossy part per luminance of the light, its window included.
template<SpecularMethod method, class S, class Light, template<class> class Material>
GONIO_FORCE_INLINE vec3<S> glossy_part(const SurfacePoint<S>& point, const Light& light, const Material<S>& material) {
    const auto glossy = gloss(material);
    const vec3<S> to_center = way_to(light, point.position);
    const SpecularLuminance<S> seen = specular_by<method>(light, to_center, point.normal, point.view, glossy.lobe);
    return glossy({seen.scale * faded(light, to_center), seen.grazing});
}

} // namespace detail

// Outgoing luminance [nt] of the three channels, of the two parts of a material.
template<SpecularMethod method = standard_specular_method, class S, class Light, template<class> class Material>
GONIO_FORCE_INLINE Reflected<S> shade_parts(const SurfacePoint<S>& point, const Light& light,
                                            const Material<S>& material) {
    const vec3<S> color = detail::color_of<S>(light);
    if constexpr (detail::is_punctual<Light>) {
        const Reflected<S> parts = detail::reflect_parts(point, material, detail::incidence(point, light));
        return {detail::finite(color * parts.diffuse), detail::finite(color * parts.specular)};
    } else {
        Reflected<S> parts = detail::scattered(point, material, detail::diffuse_toward(point, light));
        const S lx = illuminance(point, light);
        parts.diffuse = parts.diffuse * lx;
        parts.specular = parts.specular * lx;
        if constexpr (Glossy<Material<S>>)
            parts.specular = parts.specular + detail::glossy_part<method>(point, light, material);
        return {detail::finite(color * parts.diffuse), detail::finite(color * parts.specular)};
    }
}

// Both parts together; Lambert's does not read the view.
template<SpecularMethod method = standard_specular_method, class S, class Light, template<class> class Material>
GONIO_FORCE_INLINE vec3<S> shade(const SurfacePoint<S>& point, const Light& light, const Material<S>& material) {
    if constexpr (__is_same(Material<S>, Lambert<S>)) {
        return detail::finite(material.albedo * detail::color_of<S>(light) *
                              (illuminance(point, light) * S(std::numbers::inv_pi)));
    } else if constexpr (detail::is_punctual<Light>) {
        return detail::finite(light.color * detail::reflect(point, material, detail::incidence(point, light)));
    } else {
        const Reflected<S> parts = shade_parts<method>(point, light, material);
        return detail::finite(parts.diffuse + parts.specular);
    }
}

} // namespace gonio::shading
