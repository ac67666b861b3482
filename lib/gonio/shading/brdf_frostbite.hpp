// The material of "Moving Frostbite to Physically Based Rendering" (S. Lagarde and C. de Rousiers, 2014): renormalised
// Disney diffuse and GGX with height-correlated shadowing.
//
// l is towards the light, v towards the eye, n the normal, h the half vector; all unit. A BRDF value is 1/sr. It is
// reciprocal and not energy conserving: README.md gives the measured albedos, up to 1.117 at grazing.
#pragma once

#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

#include <numbers>

namespace gonio::shading {

inline constexpr double minimum_alpha = 1e-4; // below it D overflows its own peak in float

template<class S>
struct Frostbite {
    vec3<S> albedo;     // of the diffuse part
    vec3<S> f0;         // reflectance at normal incidence
    S f90;              // and at grazing
    S linear_roughness; // 1 − smoothness
    S alpha;            // linear_roughness², what enters D and V
};

// base colour, smoothness, metal mask and reflectance, each in [0, 1] and clamped to it.
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

// (1 − x)⁵ for x in [0, 1].
template<class S>
GONIO_FORCE_INLINE S schlick_weight(S x) {
    const S y = simd::max(S(1) - x, S(0));
    const S y2 = y * y;
    return y2 * y2 * y;
}

// Diffuse part for albedo 1.
template<class S>
GONIO_FORCE_INLINE S diffuse_frostbite(S n_dot_l, S n_dot_v, S l_dot_h, S linear_roughness) {
    const S bias = S(0.5) * linear_roughness;
    const S factor = S(1) - linear_roughness * S(1.0 - 1.0 / 1.51);
    const S fd90_less_1 = bias + S(2) * l_dot_h * l_dot_h * linear_roughness - S(1);
    const S light = simd::mul_add(fd90_less_1, schlick_weight(n_dot_l), S(1));
    const S view = simd::mul_add(fd90_less_1, schlick_weight(n_dot_v), S(1));
    return light * view * factor * S(std::numbers::inv_pi);
}

// GGX normal distribution, ‖n×h‖² given: never 1 − (n·h)², which cancels. `widened` is α, or more where a lobe is
// widened for an area light; the lobe's peak is then lowered by (α/widened)² (Karis 2013).
template<class S>
GONIO_FORCE_INLINE S distribution_ggx(S n_dot_h, S n_cross_h_square, S alpha, S widened) {
    const S t = widened * widened * n_dot_h * n_dot_h + n_cross_h_square;
    return alpha * alpha / (S(std::numbers::pi) * t * t);
}

// V = G/(4 n·l n·v), height-correlated Smith (E. Heitz, JCGT 3(2), 2014). n·l, n·v > 0.
template<class S>
GONIO_FORCE_INLINE S visibility_ggx(S n_dot_l, S n_dot_v, S alpha) {
    const S a2 = alpha * alpha;
    const S one_less_a2 = (S(1) - alpha) * (S(1) + alpha);
    const S v = n_dot_l * simd::sqrt(simd::mul_add(n_dot_v * n_dot_v, one_less_a2, a2));
    const S l = n_dot_v * simd::sqrt(simd::mul_add(n_dot_l * n_dot_l, one_less_a2, a2));
    return S(0.5) / (v + l);
}

template<class S>
struct SpecularTerms {
    S scale;   // D·V [1/sr]
    S grazing; // (1 − l·h)⁵: the reflectance is f0 + (f90 − f0)·grazing
};

// 0 where n·l or n·v is not positive.
template<class S>
GONIO_FORCE_INLINE SpecularTerms<S> specular_frostbite(vec3<S> n, vec3<S> l, vec3<S> v, S alpha, S widened) {
    const S n_dot_l = dot(n, l);
    const S n_dot_v = dot(n, v);
    const auto lit = simd::both(n_dot_l > S(0), n_dot_v > S(0));
    const vec3<S> h = normalized(l + v);
    const vec3<S> n_cross_h = cross(n, h);
    const S scale = distribution_ggx(dot(n, h), dot(n_cross_h, n_cross_h), alpha, widened) *
                    visibility_ggx(simd::select(lit, n_dot_l, S(1)), simd::select(lit, n_dot_v, S(1)), alpha);
    return {simd::select(lit, scale, S(0)), schlick_weight(dot(l, h))};
}

// The whole BRDF [1/sr] for one pair of directions; 0 where n·l or n·v is not positive.
template<class S>
GONIO_FORCE_INLINE vec3<S> brdf_frostbite(const Frostbite<S>& material, vec3<S> n, vec3<S> l, vec3<S> v) {
    const S n_dot_l = dot(n, l);
    const S n_dot_v = dot(n, v);
    const auto lit = simd::both(n_dot_l > S(0), n_dot_v > S(0));
    const S l_dot_h = dot(l, normalized(l + v));
    const S diffuse = simd::select(lit, diffuse_frostbite(n_dot_l, n_dot_v, l_dot_h, material.linear_roughness), S(0));
    const S alpha = simd::max(material.alpha, S(minimum_alpha));
    const SpecularTerms<S> specular = specular_frostbite(n, l, v, alpha, alpha);
    const auto channel = [&](S albedo, S f0) {
        return simd::mul_add(albedo, diffuse, specular.scale * simd::mul_add(material.f90 - f0, specular.grazing, f0));
    };
    return {channel(material.albedo.x, material.f0.x), channel(material.albedo.y, material.f0.y),
            channel(material.albedo.z, material.f0.z)};
}

} // namespace gonio::shading
