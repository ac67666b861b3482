// The material of "Real Shading in Unreal Engine 4" (B. Karis, 2013): Lambert and GGX, with V height-correlated as for
// the other materials (Unreal of 2013 used the V of G. Smith and C. Schlick with k = (roughness + 1)²/8) and Schlick's
// own power of 5 (Unreal used an exponential fit of it).
//
// Reciprocal, not energy conserving: the diffuse part is not reduced by the light that the specular part reflects.
// README.md gives the measured albedos.
#pragma once

#include <gonio/shading/brdf_ggx.hpp>
#include <gonio/shading/brdf_lambert.hpp>
#include <gonio/shading/brdf_lobes.hpp>
#include <gonio/shading/brdf_sample.hpp>
#include <gonio/shading/gloss.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

namespace gonio::shading {

template<class S>
struct Ue4 {
    static constexpr Scattering scattering = Scattering::uniform;
    static constexpr LobeKind lobe = LobeKind::ggx;

    vec3<S> albedo; // of the diffuse part, cavity included
    vec3<S> f0;     // reflectance at normal incidence; 1 at grazing
    S cavity;       // factor of the specular part
    S alpha;        // roughness²
};

// Base colour, metallic, roughness, specular (0.5 is f0 = 0.04) and cavity, each in [0, 1].
template<class S>
GONIO_FORCE_INLINE Ue4<S> ue4_material(vec3<S> base, S metallic, S roughness, S specular, S cavity) {
    const S dielectric = S(0.08) * specular;
    const auto blend = [&](S channel) { return dielectric + metallic * (channel - dielectric); };
    return {base * ((S(1) - metallic) * cavity),
            {blend(base.x), blend(base.y), blend(base.z)},
            cavity,
            simd::max(roughness * roughness, S(minimum_alpha))};
}

template<class S>
GONIO_FORCE_INLINE S lobe_alpha(const Ue4<S>& material) {
    return simd::max(material.alpha, S(minimum_alpha));
}
template<class S>
GONIO_FORCE_INLINE vec3<S> diffuse_part(const Ue4<S>& material, vec3<S> n, vec3<S> l, vec3<S> v) {
    return diffuse_part(Lambert<S>{material.albedo}, n, l, v);
}
template<class S>
GONIO_FORCE_INLINE vec3<S> specular_part(const Ue4<S>& material, vec3<S> n, vec3<S> l, vec3<S> v, S widening) {
    return specular_part(Ggx<S>{material.f0, material.alpha}, n, l, v, widening) * material.cavity;
}

template<class S>
GONIO_FORCE_INLINE Gloss<S, GgxLobe<S>> gloss(const Ue4<S>& material) {
    return {{lobe_alpha(material)}, material.f0, S(1), material.cavity};
}
template<class S>
GONIO_FORCE_INLINE Lambert<S> diffuse_alone(const Ue4<S>& material) {
    return {material.albedo};
}

template<class S>
GONIO_FORCE_INLINE Lobes<S> lobes(const Ue4<S>& material, S n_dot_v) {
    const S f0 = mean(material.f0);
    const S specular = simd::mul_add(S(1) - f0, schlick_weight(n_dot_v), f0);
    return lobes_by_weight(lobe_alpha(material), specular * material.cavity, mean(material.albedo));
}

} // namespace gonio::shading
