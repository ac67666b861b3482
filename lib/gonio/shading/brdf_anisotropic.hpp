// The metallic-roughness material of glTF (brdf_gltf.hpp) with an anisotropic lobe (ggx_anisotropic.hpp), as
// KHR_materials_anisotropy of Khronos defines it; without albedo it is the lobe alone.
//
// The material knows its own direction across the tangent (Grain), which each point's normal turns into a frame: no
// other data of the surface is needed.
#pragma once

#include <gonio/shading/anisotropic_lobe.hpp>
#include <gonio/shading/brdf_gltf.hpp>
#include <gonio/shading/brdf_sample.hpp>
#include <gonio/shading/ggx_anisotropic.hpp>
#include <gonio/shading/gloss.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

namespace gonio::shading {

template<class S>
struct Anisotropic {
    static constexpr Scattering scattering = Scattering::one_color;
    static constexpr LobeKind lobe = LobeKind::anisotropic_ggx;

    vec3<S> albedo; // base (1 − metallic)
    vec3<S> f0;     // reflectance at normal incidence
    S f90;          // at grazing incidence
    AnisotropicAlpha<S> alphas;
    Grain<S> grain;
};

namespace detail {

template<class S>
GONIO_FORCE_INLINE AnisotropicAlpha<S> lobe_alphas(const Anisotropic<S>& material) {
    return {simd::max(material.alphas.x, S(minimum_alpha)), simd::max(material.alphas.y, S(minimum_alpha))};
}
template<class S>
GONIO_FORCE_INLINE Gltf<S> as_isotropic(const Anisotropic<S>& material) {
    return {material.albedo, material.f0, material.f90, lobe_alphas(material).mean()};
}

} // namespace detail

// The mean of both.
template<class S>
GONIO_FORCE_INLINE S lobe_alpha(const Anisotropic<S>& material) {
    return detail::lobe_alphas(material).mean();
}
template<class S>
GONIO_FORCE_INLINE vec3<S> diffuse_part(const Anisotropic<S>& material, vec3<S> n, vec3<S> l, vec3<S> v) {
    return diffuse_part(detail::as_isotropic(material), n, l, v);
}
template<class S>
GONIO_FORCE_INLINE Gloss<S, AnisotropicGgxLobe<S>> gloss(const Anisotropic<S>& material) {
    const AnisotropicAlpha<S> alphas = detail::lobe_alphas(material);
    return {{alphas, material.grain, alphas.mean()}, material.f0, material.f90, S(1)};
}
template<class S>
GONIO_FORCE_INLINE vec3<S> specular_part(const Anisotropic<S>& material, vec3<S> n, vec3<S> l, vec3<S> v, S widening) {
    const auto glossy = gloss(material);
    return reflected_part(material.f0, material.f90, glossy.lobe(n, l, v, glossy.lobe.alpha + widening));
}
template<class S>
GONIO_FORCE_INLINE Gltf<S> diffuse_alone(const Anisotropic<S>& material) {
    return diffuse_alone(detail::as_isotropic(material));
}
template<class S>
GONIO_FORCE_INLINE vec3<S> scattered_color(const Anisotropic<S>& material) {
    return material.albedo;
}
template<class S>
GONIO_FORCE_INLINE Gltf<S> white(const Anisotropic<S>& material) {
    return white(detail::as_isotropic(material));
}

template<class S>
GONIO_FORCE_INLINE S pdf_brdf(const Anisotropic<S>& material, vec3<S> n, vec3<S> v, vec3<S> l) {
    const TangentFrame<S> frame = material.grain.frame(n);
    const S n_dot_v = dot(n, v);
    const S share = lobes(detail::as_isotropic(material), n_dot_v).specular_share;
    const S specular = pdf_reflected_ggx(FacetPose<S>(frame, l, v), detail::lobe_alphas(material));
    return simd::select(above_surface(n_dot_v), simd::mul_add(share, specular, (S(1) - share) * pdf_cosine(dot(n, l))),
                        S(0));
}
template<class S>
GONIO_FORCE_INLINE BrdfSample<S> sample_brdf(const Anisotropic<S>& material, vec3<S> n, vec3<S> v, vec3<S> u) {
    const TangentFrame<S> frame = material.grain.frame(n);
    const vec3<S> local = frame.to_local(v);
    const S share = lobes(detail::as_isotropic(material), local.z).specular_share;
    const vec3<S> mirrored = reflected_direction_ggx(local, detail::lobe_alphas(material), u.x, u.y);
    const vec3<S> l = frame.to_world(select(u.z < share, mirrored, cosine_direction(u.x, u.y)));
    return {l, pdf_brdf(material, n, v, l)};
}

} // namespace gonio::shading
