// The material of "Moving Frostbite to Physically Based Rendering" (S. Lagarde and C. de Rousiers, 2014): renormalised
// Disney diffuse and GGX with height-correlated shadowing.
//
// Reciprocal, not energy conserving: README.md gives the measured albedos, up to 1.117 at grazing.
#pragma once

#include <gonio/shading/brdf_lobes.hpp>
#include <gonio/shading/brdf_sample.hpp>
#include <gonio/shading/ggx.hpp>
#include <gonio/shading/gloss.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

#include <numbers>

namespace gonio::shading {

template<class S>
struct Frostbite {
    static constexpr Scattering scattering = Scattering::one_color;
    static constexpr LobeKind lobe = LobeKind::ggx;

    vec3<S> albedo;     // of the diffuse part
    vec3<S> f0;         // reflectance at normal incidence
    S f90;              // reflectance at grazing incidence
    S linear_roughness; // 1 − smoothness
    S alpha;            // linear_roughness², used in D and V
};

// Base colour, smoothness, metal mask and reflectance, each in [0, 1] and clamped to it.
template<class S>
GONIO_FORCE_INLINE Frostbite<S> frostbite_material(vec3<S> base, S smoothness, S metal, S reflectance) {
    const auto saturate = [](S x) { return simd::min(simd::max(x, S(0)), S(1)); };
    const vec3<S> color{saturate(base.x), saturate(base.y), saturate(base.z)};
    const S r = S(1) - saturate(smoothness);
    const S m = saturate(metal);
    const S dielectric = S(0.16) * saturate(reflectance) * saturate(reflectance);
    const auto blend = [&](S channel) { return dielectric + m * (channel - dielectric); };
    const vec3<S> f0{blend(color.x), blend(color.y), blend(color.z)};
    const S f90 = saturate(S(50.0 / 3.0) * (f0.x + f0.y + f0.z));
    return {color * (S(1) - m), f0, f90, r, simd::max(r * r, S(minimum_alpha))};
}

// The diffuse part for albedo 1. 2 (l·h)² is 1 + l·v.
template<class S>
GONIO_FORCE_INLINE S diffuse_frostbite(S n_dot_l, S n_dot_v, S l_dot_v, S linear_roughness) {
    const S bias = S(0.5) * linear_roughness;
    const S factor = S(1) - linear_roughness * S(1.0 - 1.0 / 1.51);
    const S fd90_less_1 = simd::mul_add(S(1) + l_dot_v, linear_roughness, bias) - S(1);
    const S light = simd::mul_add(fd90_less_1, schlick_weight(n_dot_l), S(1));
    const S view = simd::mul_add(fd90_less_1, schlick_weight(n_dot_v), S(1));
    return light * view * factor * S(std::numbers::inv_pi);
}

template<class S>
GONIO_FORCE_INLINE S lobe_alpha(const Frostbite<S>& material) {
    return simd::max(material.alpha, S(minimum_alpha));
}
template<class S>
GONIO_FORCE_INLINE vec3<S> diffuse_part(const Frostbite<S>& material, vec3<S> n, vec3<S> l, vec3<S> v) {
    const S n_dot_l = dot(n, l);
    const S n_dot_v = dot(n, v);
    const auto lit = simd::both(above_surface(n_dot_l), above_surface(n_dot_v));
    const S diffuse = diffuse_frostbite(n_dot_l, n_dot_v, dot(l, v), material.linear_roughness);
    return material.albedo * simd::select(lit, diffuse, S(0));
}
template<class S>
GONIO_FORCE_INLINE vec3<S> specular_part(const Frostbite<S>& material, vec3<S> n, vec3<S> l, vec3<S> v, S widening) {
    const S alpha = lobe_alpha(material);
    return reflected_part(material.f0, material.f90, specular_ggx(n, l, v, alpha, widened_alpha(alpha, widening)));
}

template<class S>
GONIO_FORCE_INLINE Gloss<S, GgxLobe<S>> gloss(const Frostbite<S>& material) {
    return {{lobe_alpha(material)}, material.f0, material.f90, S(1)};
}
template<class S>
GONIO_FORCE_INLINE Frostbite<S> diffuse_alone(const Frostbite<S>& material) {
    Frostbite<S> matte = material;
    matte.f0 = {S(0), S(0), S(0)};
    matte.f90 = S(0);
    return matte;
}
template<class S>
GONIO_FORCE_INLINE vec3<S> scattered_color(const Frostbite<S>& material) {
    return material.albedo;
}
template<class S>
GONIO_FORCE_INLINE Frostbite<S> white(const Frostbite<S>& material) {
    Frostbite<S> changed = material;
    changed.albedo = {S(1), S(1), S(1)};
    return changed;
}

template<class S>
GONIO_FORCE_INLINE Lobes<S> lobes(const Frostbite<S>& material, S n_dot_v) {
    const S f0 = mean(material.f0);
    return lobes_by_weight(lobe_alpha(material), simd::mul_add(material.f90 - f0, schlick_weight(n_dot_v), f0),
                           mean(material.albedo));
}

} // namespace gonio::shading
