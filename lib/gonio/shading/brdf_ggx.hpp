// GGX alone, single scattering: the microfacets of ggx.hpp with a reflectance of 1 at grazing, no diffuse part.
// README.md gives the light lost between facets.
#pragma once

#include <gonio/shading/brdf_lambert.hpp>
#include <gonio/shading/brdf_sample.hpp>
#include <gonio/shading/gloss.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

namespace gonio::shading {

template<class S>
struct Ggx {
    static constexpr Scattering scattering = Scattering::uniform;
    static constexpr LobeKind lobe = LobeKind::ggx;

    vec3<S> f0; // reflectance at normal incidence, [0, 1]
    S alpha;    // [0, 1], used in D and V
};

template<class S>
GONIO_FORCE_INLINE S lobe_alpha(const Ggx<S>& material) {
    return simd::max(material.alpha, S(minimum_alpha));
}
template<class S>
GONIO_FORCE_INLINE vec3<S> diffuse_part(const Ggx<S>& /*none*/, vec3<S> /*n*/, vec3<S> /*l*/, vec3<S> /*v*/) {
    return {S(0), S(0), S(0)};
}
template<class S>
GONIO_FORCE_INLINE vec3<S> specular_part(const Ggx<S>& material, vec3<S> n, vec3<S> l, vec3<S> v, S widening) {
    const S alpha = lobe_alpha(material);
    return reflected_part(material.f0, S(1), specular_ggx(n, l, v, alpha, widened_alpha(alpha, widening)));
}

template<class S>
GONIO_FORCE_INLINE Gloss<S, GgxLobe<S>> gloss(const Ggx<S>& material) {
    return {{lobe_alpha(material)}, material.f0, S(1), S(1)};
}
template<class S>
GONIO_FORCE_INLINE Lambert<S> diffuse_alone(const Ggx<S>& /*none*/) {
    return {{S(0), S(0), S(0)}};
}

template<class S>
GONIO_FORCE_INLINE S pdf_brdf(const Ggx<S>& material, vec3<S> n, vec3<S> v, vec3<S> l) {
    return pdf_reflected_ggx(n, v, l, lobe_alpha(material));
}

template<class S>
GONIO_FORCE_INLINE BrdfSample<S> sample_brdf(const Ggx<S>& material, vec3<S> n, vec3<S> v, vec3<S> u) {
    const TangentFrame<S> frame(n);
    const S alpha = lobe_alpha(material);
    const vec3<S> l = frame.to_world(reflected_direction_ggx(frame.to_local(v), alpha, u.x, u.y));
    return {l, pdf_brdf(material, n, v, l)};
}

} // namespace gonio::shading
