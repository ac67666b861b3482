// GGX microfacets: the distribution of their normals, height-correlated shadowing, Schlick's reflectance, and sampling
// of the normals that the eye sees. Single scattering only.
#pragma once

#include <gonio/shading/brdf_sample.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

#include <numbers>

namespace gonio::shading {

// Smaller α, 0 included, count as this value: the lobe of a mirror is 0.006° wide. For smaller α the peak of D would
// overflow in float.
inline constexpr double minimum_alpha = 1e-4;

// GGX normal distribution, given ‖n×h‖²: never 1 − (n·h)², which cancels. `widened` is α, or more where a lobe is
// widened for an area light; the lobe's peak is then lowered by (α/widened)² (Karis 2013).
template<class S>
GONIO_FORCE_INLINE S distribution_ggx(S n_dot_h, S n_cross_h_square, S alpha, S widened) {
    const S t = widened * widened * n_dot_h * n_dot_h + n_cross_h_square;
    return alpha * alpha / (S(std::numbers::pi) * t * t);
}

// √(α² + (1 − α²)c²): the cosine c of a direction, larger for rough surfaces.
template<class S>
GONIO_FORCE_INLINE S widened_cosine_ggx(S cosine, S alpha) {
    const S one_less_a2 = (S(1) - alpha) * (S(1) + alpha);
    return simd::sqrt(simd::mul_add(cosine * cosine, one_less_a2, alpha * alpha));
}

// V = G/(4 n·l n·v), height-correlated Smith (E. Heitz, JCGT 3(2), 2014). n·l, n·v > 0.
template<class S>
GONIO_FORCE_INLINE S visibility_ggx(S n_dot_l, S n_dot_v, S alpha) {
    const S v = n_dot_l * widened_cosine_ggx(n_dot_v, alpha);
    const S l = n_dot_v * widened_cosine_ggx(n_dot_l, alpha);
    return S(0.5) / (v + l);
}

template<class S>
struct SpecularTerms {
    S scale;   // D·V [1/sr]
    S grazing; // (1 − l·h)⁵: the reflectance is f0 + (f90 − f0)·grazing
};

// The lobe times Schlick's reflectance of each channel.
template<class S>
GONIO_FORCE_INLINE vec3<S> reflected_part(vec3<S> f0, S f90, SpecularTerms<S> lobe) {
    const auto channel = [&](S f) { return lobe.scale * simd::mul_add(f90 - f, lobe.grazing, f); };
    return {channel(f0.x), channel(f0.y), channel(f0.z)};
}

// α of a lobe that is widened for an area light.
template<class S>
GONIO_FORCE_INLINE S widened_alpha(S alpha, S widening) {
    return simd::min(alpha + widening, S(1));
}

// 0 where n·l or n·v is not above_surface(). α ≥ minimum_alpha.
template<class S>
GONIO_FORCE_INLINE SpecularTerms<S> specular_ggx(vec3<S> n, vec3<S> l, vec3<S> v, S alpha, S widened) {
    const S n_dot_l = dot(n, l);
    const S n_dot_v = dot(n, v);
    const auto lit = simd::both(above_surface(n_dot_l), above_surface(n_dot_v));
    const vec3<S> h = normalized(l + v);
    const vec3<S> n_cross_h = cross(n, h);
    const S scale = distribution_ggx(dot(n, h), dot(n_cross_h, n_cross_h), alpha, widened) *
                    visibility_ggx(simd::select(lit, n_dot_l, S(1)), simd::select(lit, n_dot_v, S(1)), alpha);
    return {simd::select(lit, scale, S(0)), schlick_weight(dot(l, h))};
}

// A microfacet normal in the frame of v, with density in proportion to the projected area that the eye sees:
// D(h) G₁(v) ⟨v·h⟩/n·v. Spherical caps: J. Dupuy and A. Benyoub, "Sampling Visible GGX Normals with Spherical Caps",
// Computer Graphics Forum 42(8), 2023. A v below the surface counts as lying in it.
template<class S>
GONIO_FORCE_INLINE vec3<S> visible_normal_ggx(vec3<S> v, S alpha, S u0, S u1) {
    const vec3<S> stretched = normalized(vec3<S>{alpha * v.x, alpha * v.y, simd::max(v.z, S(0))});
    // A point of the cap about +Z that reaches down to −stretched.z: its height is 1 − fallen.
    const S fallen = u0 * (S(1) + stretched.z);
    const S r = simd::sqrt(simd::max(fallen * (S(2) - fallen), S(0)));
    const S phi = S(2.0 * std::numbers::pi) * u1;
    return normalized(vec3<S>{alpha * (r * simd::cos(phi) + stretched.x), alpha * (r * simd::sin(phi) + stretched.y),
                              (S(1) - u0) * (S(1) + stretched.z)});
}

// v mirrored at a visible normal; both are in the frame of the surface.
template<class S>
GONIO_FORCE_INLINE vec3<S> reflected_direction_ggx(vec3<S> v, S alpha, S u0, S u1) {
    const vec3<S> h = visible_normal_ggx(v, alpha, u0, u1);
    return normalized(h * (S(2) * dot(v, h)) - v);
}

// The density of reflected_direction_ggx [1/sr]: D G₁(v)/(4 n·v). α ≥ minimum_alpha.
template<class S>
GONIO_FORCE_INLINE S pdf_reflected_ggx(vec3<S> n, vec3<S> v, vec3<S> l, S alpha) {
    const vec3<S> h = normalized(l + v);
    const vec3<S> n_cross_h = cross(n, h);
    const S n_dot_h = dot(n, h);
    const S n_dot_v = dot(n, v);
    const auto seen = simd::both(above_surface(n_dot_v), n_dot_h > S(0));
    const S seen_share = S(0.5) / (simd::max(n_dot_v, S(0)) + widened_cosine_ggx(n_dot_v, alpha));
    return simd::select(seen, distribution_ggx(n_dot_h, dot(n_cross_h, n_cross_h), alpha, alpha) * seen_share, S(0));
}

} // namespace gonio::shading
