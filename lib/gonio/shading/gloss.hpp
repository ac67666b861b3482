// The glossy lobe of a material, as what a light with a size makes of it is asked for.
#pragma once

#include <gonio/shading/brdf.hpp>
#include <gonio/shading/vec3.hpp>

namespace gonio::shading {

// GGX of α ≥ minimum_alpha.
template<class S>
struct GgxLobe {
    S alpha;

    // `widened` is α, or more: brdf_ggx.hpp.
    GONIO_FORCE_INLINE SpecularTerms<S> operator()(vec3<S> n, vec3<S> l, vec3<S> v, S widened) const {
        return specular_ggx(n, l, v, alpha, widened);
    }
};

// A power of n·h; `alpha` is that of the GGX lobe of the same peak.
template<class S>
struct CosinePowerLobe {
    S alpha, power;

    GONIO_FORCE_INLINE SpecularTerms<S> operator()(vec3<S> n, vec3<S> l, vec3<S> v, S widened) const {
        const S less = simd::max(S(2) / (widened * widened) - S(2), S(0));
        return specular_cosine_power(n, l, v, power, simd::select(widened > alpha, less, power));
    }
};

// A lobe times its reflectance, f0 + (f90 − f0)·grazing, and times `factor`.
template<class S, class Lobe>
struct Gloss {
    Lobe lobe;
    vec3<S> f0;
    S f90, factor;

    GONIO_FORCE_INLINE vec3<S> operator()(SpecularTerms<S> terms) const {
        return reflected_part(f0, f90, terms) * factor;
    }
};

template<class S>
GONIO_FORCE_INLINE Gloss<S, GgxLobe<S>> gloss(const Frostbite<S>& material) {
    return {{lobe_alpha(material)}, material.f0, material.f90, S(1)};
}
template<class S>
GONIO_FORCE_INLINE Gloss<S, GgxLobe<S>> gloss(const Ggx<S>& material) {
    return {{lobe_alpha(material)}, material.f0, S(1), S(1)};
}
template<class S>
GONIO_FORCE_INLINE Gloss<S, GgxLobe<S>> gloss(const Ue4<S>& material) {
    return {{lobe_alpha(material)}, material.f0, S(1), material.cavity};
}
// Of what is scattered once.
template<class S>
GONIO_FORCE_INLINE Gloss<S, GgxLobe<S>> gloss(const KullaConty<S>& material) {
    return {{lobe_alpha(material)}, material.f0, S(1), S(1)};
}
template<class S>
GONIO_FORCE_INLINE Gloss<S, CosinePowerLobe<S>> gloss(const RememberMe<S>& material) {
    return {{lobe_alpha(material), material.power}, material.f0, S(1), S(1)};
}

template<class Material>
concept Glossy = requires(const Material& material) {
    gloss(material);
};

} // namespace gonio::shading
