// Sampling of materials that have a diffuse part and a GGX lobe, or a lobe that a GGX lobe covers.
//
// Such a material M has a function Lobes<S> lobes(const M<S>&, S n_dot_v). The functions here are then its sample_brdf
// and pdf_brdf: visible normals for the lobe, the cosine for the rest.
#pragma once

#include <gonio/shading/brdf_sample.hpp>
#include <gonio/shading/ggx.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

namespace gonio::shading {

template<class S>
struct Lobes {
    S alpha;          // of the lobe, ≥ minimum_alpha
    S specular_share; // how often it is sampled, [0, 1]
};

// Shares by the reflectance of both parts towards the mirrored view. A part that is not zero gets at least one sample
// in ten.
template<class S>
GONIO_FORCE_INLINE Lobes<S> lobes_by_weight(S alpha, S specular, S diffuse) {
    const auto matte = diffuse > S(0);
    const S share = specular / simd::select(matte, specular + diffuse, S(1));
    return {simd::max(alpha, S(minimum_alpha)), simd::select(matte, simd::min(simd::max(share, S(0.1)), S(0.9)), S(1))};
}

template<template<class> class Material, class S>
concept HasLobes = requires(const Material<S>& material, S n_dot_v) {
    lobes(material, n_dot_v);
};

template<template<class> class Material, class S>
requires HasLobes<Material, S> GONIO_FORCE_INLINE S pdf_brdf(const Material<S>& material, vec3<S> n, vec3<S> v,
                                                             vec3<S> l) {
    const S n_dot_v = dot(n, v);
    const Lobes<S> of = lobes(material, n_dot_v);
    const S specular = pdf_reflected_ggx(n, v, l, of.alpha);
    const S diffuse = pdf_cosine(dot(n, l));
    return simd::select(above_surface(n_dot_v),
                        simd::mul_add(of.specular_share, specular, (S(1) - of.specular_share) * diffuse), S(0));
}

template<template<class> class Material, class S>
requires HasLobes<Material, S> GONIO_FORCE_INLINE BrdfSample<S> sample_brdf(const Material<S>& material, vec3<S> n,
                                                                            vec3<S> v, vec3<S> u) {
    const TangentFrame<S> frame(n);
    const vec3<S> local = frame.to_local(v);
    const Lobes<S> of = lobes(material, local.z);
    const vec3<S> l = frame.to_world(select(u.z < of.specular_share, reflected_direction_ggx(local, of.alpha, u.x, u.y),
                                            cosine_direction(u.x, u.y)));
    return {l, pdf_brdf(material, n, v, l)};
}

} // namespace gonio::shading
