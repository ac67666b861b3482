// Lambert: the same radiance in every direction.
#pragma once

#include <gonio/shading/brdf_sample.hpp>
#include <gonio/shading/vec3.hpp>

#include <numbers>

namespace gonio::shading {

template<class S>
struct Lambert {
    static constexpr Scattering scattering = Scattering::uniform;
    static constexpr LobeKind lobe = LobeKind::none;

    vec3<S> albedo; // [0, 1]
};

template<class S>
GONIO_FORCE_INLINE vec3<S> diffuse_part(const Lambert<S>& material, vec3<S> n, vec3<S> l, vec3<S> v) {
    const auto lit = simd::both(above_surface(dot(n, l)), above_surface(dot(n, v)));
    return material.albedo * simd::select(lit, S(std::numbers::inv_pi), S(0));
}
template<class S>
GONIO_FORCE_INLINE vec3<S> specular_part(const Lambert<S>& /*none*/, vec3<S> /*n*/, vec3<S> /*l*/, vec3<S> /*v*/,
                                         S /*widening*/) {
    return {S(0), S(0), S(0)};
}
template<class S>
GONIO_FORCE_INLINE S lobe_alpha(const Lambert<S>& /*none*/) {
    return S(1);
}
template<class S>
GONIO_FORCE_INLINE Lambert<S> diffuse_alone(const Lambert<S>& material) {
    return material;
}

template<class S>
GONIO_FORCE_INLINE S pdf_brdf(const Lambert<S>& /*material*/, vec3<S> n, vec3<S> v, vec3<S> l) {
    return simd::select(above_surface(dot(n, v)), pdf_cosine(dot(n, l)), S(0));
}

template<class S>
GONIO_FORCE_INLINE BrdfSample<S> sample_brdf(const Lambert<S>& material, vec3<S> n, vec3<S> v, vec3<S> u) {
    const vec3<S> l = TangentFrame<S>(n).to_world(cosine_direction(u.x, u.y));
    return {l, pdf_brdf(material, n, v, l)};
}

} // namespace gonio::shading
