// EON: the energy-preserving Oren–Nayar diffuse reflectance (J. Portsmouth, P. Kutz and S. Hill, "EON: A Practical
// Energy-Preserving Rough Diffuse BRDF", Journal of Computer Graphics Techniques 14(1), 2025).
//
// Single scattering is Fujii's Oren–Nayar, with roughness r in [0, 1] and A = 1/(1 + (1/2 − 2/3π) r),
//     f = A/π (1 + r s/t),   s = l·v − n·l n·v,   t = max(n·l, n·v) where s > 0, else 1.
// Its albedo E(μ) = A (1 + r G(μ)/π) and its mean Ē = A (1 + (2/3 − 28/15π) r) are in closed form. A lobe of the kind
// of Kulla and Conty adds the energy that single scattering loses. Both are reciprocal, and a white surface reflects
// all of the light.
#pragma once

#include <gonio/shading/brdf_sample.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

#include <numbers>

namespace gonio::shading {

template<class S>
struct Eon {
    static constexpr Scattering scattering = Scattering::colored;
    static constexpr LobeKind lobe = LobeKind::none;

    vec3<S> albedo; // [0, 1], of single scattering; the colour saturates with roughness because of multiple scattering
    S roughness;    // [0, 1]; 0 is Lambert
};

namespace detail {

inline constexpr double eon_grazing = 0.5 - 2.0 / (3.0 * std::numbers::pi);      // G(0)/π: no loss at grazing
inline constexpr double eon_mean = 2.0 / 3.0 - 28.0 / (15.0 * std::numbers::pi); // ∫ 2μ G(μ)/π dμ

// (1 − E(μ))/(A r) = (G(0) − G(μ))/π, for μ in [0, 1].
template<class S>
GONIO_FORCE_INLINE S eon_loss(S mu) {
    const S sine = simd::sqrt((S(1) - mu) * (S(1) + mu));
    // (tanθ)(1 − sin³θ) with 1 − sinθ = μ²/(1 + sinθ): no division by μ.
    const S tangent = sine * mu * (S(1) + sine + sine * sine) / (S(1) + sine);
    const S g = sine * (simd::acos(mu) - sine * mu) + S(2.0 / 3.0) * (tangent - sine);
    return simd::max(simd::mul_add(g, S(-std::numbers::inv_pi), S(eon_grazing)), S(0));
}

} // namespace detail

// For cosines in [0, 1].
template<class S>
GONIO_FORCE_INLINE vec3<S> diffuse_eon(const Eon<S>& material, S n_dot_l, S n_dot_v, S l_dot_v) {
    const S r = material.roughness;
    const S a = S(1) / simd::mul_add(S(detail::eon_grazing), r, S(1));
    const S s = simd::mul_add(-n_dot_l, n_dot_v, l_dot_v);
    const auto forward = s > S(0);
    const S t = simd::select(forward, simd::max(simd::max(n_dot_l, n_dot_v), S(least_cosine)), S(1));
    const S single = S(std::numbers::inv_pi) * a * simd::max(simd::mul_add(r, s / t, S(1)), S(0));
    const S loss =
        detail::eon_loss(n_dot_l) * detail::eon_loss(n_dot_v) * S(1.0 / (detail::eon_grazing - detail::eon_mean));
    const S multiple = S(std::numbers::inv_pi) * a * r * loss;
    const S mean = a * simd::mul_add(S(detail::eon_mean), r, S(1));
    const auto channel = [&](S albedo) {
        return albedo * simd::mul_add(albedo * mean / (S(1) - albedo * (S(1) - mean)), multiple, single);
    };
    return {channel(material.albedo.x), channel(material.albedo.y), channel(material.albedo.z)};
}

template<class S>
GONIO_FORCE_INLINE vec3<S> diffuse_part(const Eon<S>& material, vec3<S> n, vec3<S> l, vec3<S> v) {
    const S n_dot_l = dot(n, l);
    const S n_dot_v = dot(n, v);
    const auto lit = simd::both(above_surface(n_dot_l), above_surface(n_dot_v));
    const auto cosine = [&](S c) { return simd::min(simd::select(lit, c, S(1)), S(1)); };
    return diffuse_eon(material, cosine(n_dot_l), cosine(n_dot_v), dot(l, v)) * simd::select(lit, S(1), S(0));
}
template<class S>
GONIO_FORCE_INLINE vec3<S> specular_part(const Eon<S>& /*none*/, vec3<S> /*n*/, vec3<S> /*l*/, vec3<S> /*v*/,
                                         S /*widening*/) {
    return {S(0), S(0), S(0)};
}
template<class S>
GONIO_FORCE_INLINE S lobe_alpha(const Eon<S>& /*none*/) {
    return S(1);
}
template<class S>
GONIO_FORCE_INLINE Eon<S> diffuse_alone(const Eon<S>& material) {
    return material;
}

namespace detail {

// Rough surfaces reflect much of the light of grazing views towards grazing directions: the share that is sampled
// uniformly.
template<class S>
GONIO_FORCE_INLINE S even_share(const Eon<S>& material) {
    return S(0.5) * material.roughness;
}

} // namespace detail

template<class S>
GONIO_FORCE_INLINE S pdf_brdf(const Eon<S>& material, vec3<S> n, vec3<S> v, vec3<S> l) {
    const S n_dot_l = dot(n, l);
    const S share = detail::even_share(material);
    const S pdf = simd::mul_add(share, pdf_even(n_dot_l), (S(1) - share) * pdf_cosine(n_dot_l));
    return simd::select(above_surface(dot(n, v)), pdf, S(0));
}

template<class S>
GONIO_FORCE_INLINE BrdfSample<S> sample_brdf(const Eon<S>& material, vec3<S> n, vec3<S> v, vec3<S> u) {
    const vec3<S> local =
        select(u.z < detail::even_share(material), even_direction(u.x, u.y), cosine_direction(u.x, u.y));
    const vec3<S> l = TangentFrame<S>(n).to_world(local);
    return {l, pdf_brdf(material, n, v, l)};
}

} // namespace gonio::shading
