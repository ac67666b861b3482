// What a surface sends to the eye of light that comes from one direction, or from two that stand for a light with a
// size.
#pragma once

#include <gonio/shading/brdf.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

namespace gonio::shading {

template<class S>
struct SurfacePoint {
    vec3<S> position; // [m]
    vec3<S> normal;   // unit
    vec3<S> view;     // unit, towards the eye; not read for Lambert
};

// What a BRDF is asked with: the light's direction and strength, split into the irradiance that the diffuse part
// receives and the one that the specular part does.
template<class S>
struct Incidence {
    S diffuse;               // [lx] per unit of the light's colour
    S specular;              // the same, for the lobe that is widened as below
    vec3<S> diffuse_toward;  // unit, n·l ≥ 0
    vec3<S> specular_toward; // unit
    S lobe_widening;         // what is added to α
};

// Luminance of the three channels, of the two parts of a material.
template<class S>
struct Reflected {
    vec3<S> diffuse, specular;
};

namespace detail {

// The diffuse part of a light that is partly above the horizon is asked for just above it, if its centre is below.
template<class S>
GONIO_FORCE_INLINE vec3<S> above_horizon(vec3<S> n, vec3<S> l) {
    constexpr double least = 1e-6;
    return normalized(l + n * simd::max(S(least) - dot(n, l), S(0)));
}

template<class S, template<class> class Material>
GONIO_FORCE_INLINE Reflected<S> reflect_parts(const SurfacePoint<S>& point, const Material<S>& material,
                                              const Incidence<S>& light) {
    const vec3<S> n = point.normal;
    return {diffuse_part(material, n, above_horizon(n, light.diffuse_toward), point.view) * light.diffuse,
            specular_part(material, n, light.specular_toward, point.view, light.lobe_widening) * light.specular};
}
// Light that is scattered more than once takes the whole irradiance, as a diffuse part does.
template<class S>
GONIO_FORCE_INLINE Reflected<S> reflect_parts(const SurfacePoint<S>& point, const KullaConty<S>& material,
                                              const Incidence<S>& light) {
    const vec3<S> n = point.normal;
    const Ggx<S> once{material.f0, material.loss.alpha};
    const vec3<S> l = above_horizon(n, light.diffuse_toward);
    return {{S(0), S(0), S(0)},
            specular_part(once, n, light.specular_toward, point.view, light.lobe_widening) * light.specular +
                multiple_scattering(material, n, l, point.view) * light.diffuse};
}

template<class S, template<class> class Material>
GONIO_FORCE_INLINE vec3<S> reflect(const SurfacePoint<S>& point, const Material<S>& material,
                                   const Incidence<S>& light) {
    const Reflected<S> parts = reflect_parts(point, material, light);
    return parts.diffuse + parts.specular;
}
// The same for the material that most surfaces have, in fewer steps.
template<class S>
GONIO_FORCE_INLINE vec3<S> reflect(const SurfacePoint<S>& point, const Frostbite<S>& material,
                                   const Incidence<S>& light) {
    const vec3<S> n = point.normal;
    const vec3<S> v = point.view;
    const S n_dot_v = dot(n, v);
    const auto seen = n_dot_v > S(0);
    const vec3<S> l = light.diffuse_toward;
    const S l_dot_h = simd::min(simd::max(dot(l, normalized(l + v)), S(0)), S(1));
    const S diffuse = diffuse_frostbite(simd::max(dot(n, l), S(0)), n_dot_v, l_dot_h, material.linear_roughness);
    const S of_diffuse = simd::select(seen, diffuse * light.diffuse, S(0));

    const S alpha = lobe_alpha(material);
    const S widened = widened_alpha(alpha, light.lobe_widening);
    const SpecularTerms<S> specular = specular_ggx(n, light.specular_toward, v, alpha, widened);
    const S of_specular = specular.scale * light.specular;
    const auto channel = [&](S albedo, S f0) {
        return simd::mul_add(albedo, of_diffuse, of_specular * simd::mul_add(material.f90 - f0, specular.grazing, f0));
    };
    return {channel(material.albedo.x, material.f0.x), channel(material.albedo.y, material.f0.y),
            channel(material.albedo.z, material.f0.z)};
}

} // namespace detail

} // namespace gonio::shading
