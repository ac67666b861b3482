// The light that a surface reflects towards the eye, from one direction.
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

// The light that a BRDF is evaluated for.
template<class S>
struct Incidence {
    S lx;           // per unit of the light's colour
    vec3<S> toward; // unit
};

namespace detail {

template<class S>
GONIO_FORCE_INLINE vec3<S> mirrored_view(vec3<S> normal, vec3<S> view) {
    return normal * (S(2) * dot(normal, view)) - view;
}

// If the centre of a light that is partly above the horizon is below it, the diffuse part is evaluated just above the
// horizon.
template<class S>
GONIO_FORCE_INLINE vec3<S> above_horizon(vec3<S> n, vec3<S> l) {
    constexpr double least = 1e-6;
    return normalized(l + n * simd::max(S(least) - dot(n, l), S(0)));
}

// The part without a glossy lobe, of the two parts that a material scatters [1/sr], for light from `l`. Light that is
// scattered more than once counts as specular.
template<class S, template<class> class Material>
GONIO_FORCE_INLINE Reflected<S> scattered(const SurfacePoint<S>& point, const Material<S>& material, vec3<S> l) {
    const vec3<S> none{S(0), S(0), S(0)};
    if constexpr (Material<S>::lobe == LobeKind::ggx_and_more)
        return {none, multiple_scattering(material, point.normal, l, point.view)};
    else
        return {diffuse_part(material, point.normal, l, point.view), none};
}

template<class S, template<class> class Material>
GONIO_FORCE_INLINE Reflected<S> reflect_parts(const SurfacePoint<S>& point, const Material<S>& material,
                                              const Incidence<S>& light) {
    const vec3<S> n = point.normal;
    return {diffuse_part(material, n, light.toward, point.view) * light.lx,
            specular_part(material, n, light.toward, point.view, S(0)) * light.lx};
}

template<class S, template<class> class Material>
GONIO_FORCE_INLINE vec3<S> reflect(const SurfacePoint<S>& point, const Material<S>& material,
                                   const Incidence<S>& light) {
    return brdf(material, point.normal, light.toward, point.view) * light.lx;
}
// The same for the most common material, in fewer steps.
template<class S>
GONIO_FORCE_INLINE vec3<S> reflect(const SurfacePoint<S>& point, const Frostbite<S>& material,
                                   const Incidence<S>& light) {
    const vec3<S> n = point.normal;
    const vec3<S> v = point.view;
    const vec3<S> l = light.toward;
    const S n_dot_v = dot(n, v);
    const auto seen = n_dot_v > S(0);
    const S diffuse = diffuse_frostbite(simd::max(dot(n, l), S(0)), n_dot_v, dot(l, v), material.linear_roughness);
    const S of_diffuse = simd::select(seen, diffuse * light.lx, S(0));

    const S alpha = lobe_alpha(material);
    const SpecularTerms<S> specular = specular_ggx(n, l, v, alpha, alpha);
    const S of_specular = specular.scale * light.lx;
    const auto channel = [&](S albedo, S f0) {
        return simd::mul_add(albedo, of_diffuse, of_specular * simd::mul_add(material.f90 - f0, specular.grazing, f0));
    };
    return {channel(material.albedo.x, material.f0.x), channel(material.albedo.y, material.f0.y),
            channel(material.albedo.z, material.f0.z)};
}

} // namespace detail

} // namespace gonio::shading
