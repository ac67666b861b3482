// One surface point lit by one light: outgoing luminance, as templates on the scalar.
//
// With double this is the reference that the kernels are tested against and the source of probed numbers; with packs it
// is what kernels.cpp runs. Light and material are types, so each pair compiles to its own straight code. Results are
// finite and not negative for any finite input; illuminance is limited to `illuminance_ceiling`.
//
// Under an area light the diffuse part uses the exact irradiance; its directional factors are the mean over a few
// points of the light (light_points.hpp). The glossy part comes from specular_named.hpp, by the selected method.
#pragma once

#include <gonio/shading/direction.hpp>
#include <gonio/shading/irradiance_area.hpp>
#include <gonio/shading/light_points.hpp>
#include <gonio/shading/reflect.hpp>
#include <gonio/shading/specular_named.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/loop.hpp>
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

// The mean of `scattered` over a light, weighted by the irradiance of its points above the horizon; where no point is
// above it, the value towards the centre, raised to the horizon.
template<class S, class Light, template<class> class Material>
GONIO_FORCE_INLINE Reflected<S> mean_scattered(const SurfacePoint<S>& point, const Light& light,
                                               const Material<S>& material) {
    const vec3<S> to_center = way_to(light, point.position);
    const vec3<S> n = point.normal;
    if constexpr (Material<S>::scattering == Scattering::uniform) {
        return scattered(point, material, n);
    } else {
        Reflected<S> sum{{S(0), S(0), S(0)}, {S(0), S(0), S(0)}};
        S weights = S(0);
        const auto& points = points_of(light, SameFrame{}, to_center);
        for_each_direction<S>(
            points, [&](vec3<S> l, S solid_angle) __attribute__((always_inline)) {
                const S weight = solid_angle * simd::max(dot(n, l), S(0));
                const Reflected<S> value = scattered(point, material, l);
                const auto add = [&](vec3<S> & total, vec3<S> term) __attribute__((always_inline)) {
                    simd::accumulate(total.x, term.x);
                    simd::accumulate(total.y, term.y);
                    simd::accumulate(total.z, term.z);
                };
                add(sum.diffuse, value.diffuse * weight);
                add(sum.specular, value.specular * weight);
                simd::accumulate(weights, weight);
            });
        const auto known = weights > S(1e-30);
        const S inverse = S(1) / simd::select(known, weights, S(1));
        Reflected<S> mean{sum.diffuse * inverse, sum.specular * inverse};
        if (!simd::all(known)) {
            const Direction<S> d = direction(to_center, n);
            const vec3<S> l = d.scaled * d.inverse_distance;
            const vec3<S> raised = above_horizon(n, normalized(l - n * simd::min(d.n_dot_l, S(0))));
            const Reflected<S> towards = scattered(point, material, raised);
            mean.diffuse = select(known, mean.diffuse, towards.diffuse);
            mean.specular = select(known, mean.specular, towards.specular);
        }
        return mean;
    }
}
// The same, computed for one channel if all channels are alike.
template<class S, class Light, template<class> class Material>
GONIO_FORCE_INLINE Reflected<S> scattered_under(const SurfacePoint<S>& point, const Light& light,
                                                const Material<S>& material) {
    if constexpr (Material<S>::scattering != Scattering::one_color) {
        return mean_scattered(point, light, material);
    } else {
        const Reflected<S> mean = mean_scattered(point, light, white(material));
        const vec3<S> color = scattered_color(material);
        const vec3<S> none{S(0), S(0), S(0)};
        if constexpr (Material<S>::lobe == LobeKind::ggx_and_more)
            return {none, color * mean.specular.x};
        else
            return {color * mean.diffuse.x, none};
    }
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

// What a material scatters of the illuminance [lx] of an area light, without its glossy part; per colour of the light.
template<class S, class Light, template<class> class Material>
GONIO_FORCE_INLINE Reflected<S> scattered_parts(const SurfacePoint<S>& point, const Light& light,
                                                const Material<S>& material, S lx) {
    const Reflected<S> parts = detail::scattered_under(point, light, material);
    return {parts.diffuse * lx, parts.specular * lx};
}

// Outgoing luminance [nt] of the three channels, for the two parts of a material.
template<SpecularMethod method = standard_specular_method, class S, class Light, template<class> class Material>
GONIO_FORCE_INLINE Reflected<S> shade_parts(const SurfacePoint<S>& point, const Light& light,
                                            const Material<S>& material) {
    const vec3<S> color = detail::color_of<S>(light);
    if constexpr (detail::is_punctual<Light>) {
        const Reflected<S> parts = detail::reflect_parts(point, material, detail::incidence(point, light));
        return {detail::finite(color * parts.diffuse), detail::finite(color * parts.specular)};
    } else {
        Reflected<S> parts = scattered_parts(point, light, material, illuminance(point, light));
        if constexpr (Glossy<Material>)
            parts.specular = parts.specular + detail::glossy_part<method>(point, light, material);
        return {detail::finite(color * parts.diffuse), detail::finite(color * parts.specular)};
    }
}

// The sum of both parts; for Lambert it does not read the view.
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
