// The material of "The Art of Remember Me" (S. Lagarde and L. Harduin, 2013): Lambert, Blinn's cosine power, and the
// effect of water on both.
//
// f = albedo/π + F (p + 2)/(8π) (n·h)^p, where Schlick's F rises to 1 at grazing. There is no shadowing between facets,
// so the specular albedo falls with n·v; the diffuse part is not reduced by the specular albedo. Reciprocal, not energy
// conserving: README.md gives the measured albedos.
#pragma once

#include <gonio/shading/brdf_lambert.hpp>
#include <gonio/shading/brdf_lobes.hpp>
#include <gonio/shading/brdf_sample.hpp>
#include <gonio/shading/gloss.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

#include <numbers>

namespace gonio::shading {

template<class S>
struct Blinn {
    static constexpr Scattering scattering = Scattering::uniform;
    static constexpr LobeKind lobe = LobeKind::cosine_power;

    vec3<S> albedo; // of the diffuse part
    vec3<S> f0;     // reflectance at normal incidence; 1 at grazing
    S power;        // p, ≥ 2
};

// p = 2^(1 + 10 smoothness).
template<class S>
GONIO_FORCE_INLINE S specular_power(S smoothness) {
    return simd::exp2(simd::mul_add(S(10), smoothness, S(1)));
}

// Albedo, linear f0, smoothness and wetness, each in [0, 1]. Water darkens rough surfaces that are not metal, because
// it fills their pores, and makes every surface smoother.
template<class S>
GONIO_FORCE_INLINE Blinn<S> blinn_material(vec3<S> albedo, vec3<S> f0, S smoothness, S wetness) {
    const auto saturate = [](S x) { return simd::min(simd::max(x, S(0)), S(1)); };
    const S metalness = saturate(S(1000) * mean(f0) - S(500));
    const S porosity = saturate((S(0.5) - smoothness) * S(1.0 / 0.4));
    const S darkest = S(1) - S(0.8) * (S(1) - metalness) * porosity;
    const auto blend = [](S from, S to, S share) { return simd::mul_add(share, to - from, from); };
    const S smooth = blend(S(1), smoothness, blend(S(1), darkest, S(0.5) * wetness));
    return {albedo * blend(S(1), darkest, wetness), f0, specular_power(smooth)};
}

// (n·h)^p, given ‖n×h‖²: the logarithm of n·h is computed from ‖n×h‖² where n·h itself has lost its digits. 0 where n·h
// is not positive.
template<class S>
GONIO_FORCE_INLINE S cosine_power(S n_dot_h, S n_cross_h_square, S power) {
    constexpr double log2_e = std::numbers::log2e;
    const auto near = n_cross_h_square < S(0.5);
    const S x = simd::select(near, n_cross_h_square, S(0));
    const S y = x / (S(2) - x); // ln(1 − x) = −2 artanh y
    const S log_near = S(-2.0 * log2_e) * y * simd::atanh_ratio(y * y);
    const S cosine = simd::select(near, S(1), simd::max(n_dot_h, S(least_cosine)));
    const S log = simd::select(near, S(0.5) * log_near, simd::log2(cosine));
    return simd::select(n_dot_h > S(0), simd::exp2(power * log), S(0));
}

// The specular part [1/sr] is f0 + (1 − f0)·grazing times scale, as for specular_ggx. `widened` is p, or less where a
// lobe is widened for an area light; the peak is then lowered with the square of (p + 2), as the peak of a GGX lobe is
// with α⁻².
template<class S>
GONIO_FORCE_INLINE SpecularTerms<S> specular_cosine_power(vec3<S> n, vec3<S> l, vec3<S> v, S power, S widened) {
    const auto lit = simd::both(above_surface(dot(n, l)), above_surface(dot(n, v)));
    const vec3<S> h = normalized(l + v);
    const vec3<S> n_cross_h = cross(n, h);
    const S peak = (widened + S(2)) * ((widened + S(2)) / (power + S(2))) * S(0.125 * std::numbers::inv_pi);
    const S scale = peak * cosine_power(dot(n, h), dot(n_cross_h, n_cross_h), widened);
    return {simd::select(lit, scale, S(0)), schlick_weight(dot(l, h))};
}

// The lobe of a power of n·h; `alpha` is that of the GGX lobe with the same peak.
template<class S>
struct CosinePowerLobe {
    static constexpr bool is_even = true; // the same in all directions of the surface

    S alpha, power;

    GONIO_FORCE_INLINE S value(vec3<S> /*l*/, vec3<S> /*v*/, const HalfVector<S>& h) const {
        const S inverse = S(1) / h.square;
        return (power + S(2)) * S(0.125 * std::numbers::inv_pi) *
               cosine_power(simd::sqrt(h.along2 * inverse), h.across2 * inverse, power);
    }
    // Without shadowing V is 1/4; this is its ratio to the V of GGX for light from the mirrored eye.
    GONIO_FORCE_INLINE S albedo_share(S n_dot_v) const {
        const S mu = simd::max(n_dot_v, S(least_cosine));
        return S(0.25) / visibility_ggx(mu, mu, alpha);
    }
    GONIO_FORCE_INLINE EvenSlopes<S> slopes() const { return {S(1) / simd::max(alpha, S(minimum_alpha))}; }
    GONIO_FORCE_INLINE S width(vec2<S> /*direction*/) const { return alpha; }

    GONIO_FORCE_INLINE SpecularTerms<S> operator()(vec3<S> n, vec3<S> l, vec3<S> v, S widened) const {
        const S less = simd::max(S(2) / (widened * widened) - S(2), S(0));
        return specular_cosine_power(n, l, v, power, simd::select(widened > alpha, less, power));
    }
};

// α of the GGX lobe with the same peak of the distribution: α² = 2/(p + 2).
template<class S>
GONIO_FORCE_INLINE S lobe_alpha(const Blinn<S>& material) {
    return simd::sqrt(S(2) / (material.power + S(2)));
}
template<class S>
GONIO_FORCE_INLINE vec3<S> diffuse_part(const Blinn<S>& material, vec3<S> n, vec3<S> l, vec3<S> v) {
    return diffuse_part(Lambert<S>{material.albedo}, n, l, v);
}
template<class S>
GONIO_FORCE_INLINE vec3<S> specular_part(const Blinn<S>& material, vec3<S> n, vec3<S> l, vec3<S> v, S widening) {
    const S alpha = widened_alpha(lobe_alpha(material), widening);
    const S widened = simd::select(widening > S(0), simd::max(S(2) / (alpha * alpha) - S(2), S(0)), material.power);
    return reflected_part(material.f0, S(1), specular_cosine_power(n, l, v, material.power, widened));
}

template<class S>
GONIO_FORCE_INLINE Gloss<S, CosinePowerLobe<S>> gloss(const Blinn<S>& material) {
    return {{lobe_alpha(material), material.power}, material.f0, S(1), S(1)};
}
template<class S>
GONIO_FORCE_INLINE Lambert<S> diffuse_alone(const Blinn<S>& material) {
    return {material.albedo};
}

// Samples the normals of a GGX surface with the same peak of the distribution, α² = 2/(p + 2). Its tails cover those of
// a cosine power, and all sampled normals face the eye, unlike half vectors drawn from the power itself.
template<class S>
GONIO_FORCE_INLINE Lobes<S> lobes(const Blinn<S>& material, S n_dot_v) {
    const S f0 = mean(material.f0);
    return lobes_by_weight(lobe_alpha(material), simd::mul_add(S(1) - f0, schlick_weight(n_dot_v), f0),
                           mean(material.albedo));
}

} // namespace gonio::shading
