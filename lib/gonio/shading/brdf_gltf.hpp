// The metallic-roughness material of glTF 2.0, following appendix B of its specification (Khronos, "glTF 2.0
// Specification", B.2 and B.3): material = mix(dielectric_brdf, metal_brdf, metallic) with
//     dielectric_brdf = mix(base/π, D V, F_d),   F_d = 0.04 + 0.96 w,   w = (1 − l·h)⁵,
//     metal_brdf = (base + (1 − base) w) D V,    α = roughness²,
// GGX and height-correlated Smith. Reflectances are linear in f0, so the two lobes are one, with f0 between 0.04 and
// base, and the diffuse part is base (1 − metallic) (1 − F_d)/π: all channels are dimmed alike. Editions before 2024
// print (1 − F) of the mixed f0 in the diffuse part. That is not the mix of the two parts that they define, and was
// corrected later; for metallic = 0 and 1 both are the same.
//
// Reciprocal, not energy conserving: w is that of the microfacet, and a white dielectric reflects up to 1.93 at grazing
// views. README.md gives the measured albedos.
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
struct Gltf {
    static constexpr Scattering scattering = Scattering::one_color;
    static constexpr LobeKind lobe = LobeKind::ggx;

    vec3<S> albedo; // base (1 − metallic)
    vec3<S> f0;     // reflectance at normal incidence
    S f90;          // reflectance at grazing incidence: 1
    S alpha;        // roughness²
};

inline constexpr double gltf_dielectric_f0 = 0.04; // an index of refraction of 1.5

// Base colour, metallic and roughness, each in [0, 1].
template<class S>
GONIO_FORCE_INLINE Gltf<S> gltf_material(vec3<S> base, S metallic, S roughness) {
    const auto blend = [&](S channel) {
        return simd::mul_add(metallic, channel - S(gltf_dielectric_f0), S(gltf_dielectric_f0));
    };
    return {base * (S(1) - metallic),
            {blend(base.x), blend(base.y), blend(base.z)},
            S(1),
            simd::max(roughness * roughness, S(minimum_alpha))};
}

template<class S>
GONIO_FORCE_INLINE S lobe_alpha(const Gltf<S>& material) {
    return simd::max(material.alpha, S(minimum_alpha));
}
template<class S>
GONIO_FORCE_INLINE vec3<S> diffuse_part(const Gltf<S>& material, vec3<S> n, vec3<S> l, vec3<S> v) {
    const auto lit = simd::both(above_surface(dot(n, l)), above_surface(dot(n, v)));
    const S x = simd::min(simd::max(dot(l, normalized(l + v)), S(0)), S(1));
    // 1 − y⁵ = (1 − y)(1 + y + y² + y³ + y⁴) for y = 1 − l·h: avoids a difference that would lose digits.
    const S y = S(1) - x;
    const S entered = x * (S(1) + y * (S(1) + y * (S(1) + y * (S(1) + y))));
    const S diffuse = S((1.0 - gltf_dielectric_f0) * std::numbers::inv_pi) * entered;
    return material.albedo * simd::select(lit, diffuse, S(0));
}
template<class S>
GONIO_FORCE_INLINE vec3<S> specular_part(const Gltf<S>& material, vec3<S> n, vec3<S> l, vec3<S> v, S widening) {
    const S alpha = lobe_alpha(material);
    return reflected_part(material.f0, material.f90, specular_ggx(n, l, v, alpha, widened_alpha(alpha, widening)));
}

template<class S>
GONIO_FORCE_INLINE Gloss<S, GgxLobe<S>> gloss(const Gltf<S>& material) {
    return {{lobe_alpha(material)}, material.f0, material.f90, S(1)};
}
template<class S>
GONIO_FORCE_INLINE Gltf<S> diffuse_alone(const Gltf<S>& material) {
    return {material.albedo, {S(0), S(0), S(0)}, S(0), material.alpha};
}
template<class S>
GONIO_FORCE_INLINE vec3<S> scattered_color(const Gltf<S>& material) {
    return material.albedo;
}
template<class S>
GONIO_FORCE_INLINE Gltf<S> white(const Gltf<S>& material) {
    return {{S(1), S(1), S(1)}, material.f0, material.f90, material.alpha};
}

template<class S>
GONIO_FORCE_INLINE Lobes<S> lobes(const Gltf<S>& material, S n_dot_v) {
    const S f0 = mean(material.f0);
    return lobes_by_weight(lobe_alpha(material), simd::mul_add(material.f90 - f0, schlick_weight(n_dot_v), f0),
                           S(1.0 - gltf_dielectric_f0) * mean(material.albedo));
}

} // namespace gonio::shading
