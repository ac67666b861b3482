// GGX microfacets that are rougher along one direction of the surface than across it: brushed or turned metal. As
// ggx.hpp, with α_x along the tangent x and α_y along n × x (E. Heitz, "Understanding the Masking-Shadowing Function in
// Microfacet-Based BRDFs", JCGT 3(2), 2014). Directions here are in the surface's frame (x, y, n). α_x, α_y ≥
// minimum_alpha; either may exceed 1.
#pragma once

#include <gonio/shading/ggx.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

#include <numbers>

namespace gonio::shading {

template<class S>
struct AnisotropicAlpha {
    S x, y;

    // α of the isotropic lobe with the same peak of the distribution.
    GONIO_FORCE_INLINE S mean() const { return simd::sqrt(x * y); }
};

// OpenPBR (1.1, "Microfacet model"): α is that of the isotropic surface, and α_x² + α_y² = 2 α². `anisotropy` in
// [0, 1]; at 1 α_y is minimum_alpha.
template<class S>
GONIO_FORCE_INLINE AnisotropicAlpha<S> openpbr_alpha(S alpha, S anisotropy) {
    const S ratio = S(1) - anisotropy;
    const S along = alpha * simd::sqrt(S(2) / simd::mul_add(ratio, ratio, S(1)));
    return {simd::max(along, S(minimum_alpha)), simd::max(ratio * along, S(minimum_alpha))};
}

// glTF (Khronos, KHR_materials_anisotropy): α_y = α and α_x = lerp(α, 1, strength²). `strength` in [0, 1].
template<class S>
GONIO_FORCE_INLINE AnisotropicAlpha<S> gltf_alpha(S alpha, S strength) {
    const S across = simd::max(alpha, S(minimum_alpha));
    return {simd::mul_add(strength * strength, S(1) - across, across), across};
}

// √((α_x x)² + (α_y y)² + z²) of a unit vector.
template<class S>
GONIO_FORCE_INLINE S widened_cosine_ggx(vec3<S> direction, AnisotropicAlpha<S> alpha) {
    const S x = alpha.x * direction.x;
    const S y = alpha.y * direction.y;
    return simd::sqrt(simd::mul_add(x, x, simd::mul_add(y, y, direction.z * direction.z)));
}

// The normal distribution at h, unit or not, for its square `h2`. `widened` as for distribution_ggx of ggx.hpp.
template<class S>
GONIO_FORCE_INLINE S distribution_ggx(vec3<S> h, S h2, AnisotropicAlpha<S> alpha, AnisotropicAlpha<S> widened) {
    const S ratio = widened.y / widened.x;
    const S area = widened.x * widened.y;
    const S t = simd::mul_add(ratio, h.x * h.x, simd::mul_add(h.y * h.y, S(1) / ratio, area * (h.z * h.z)));
    return alpha.x * alpha.y * (h2 * h2) / (S(std::numbers::pi) * t * t);
}

template<class S>
GONIO_FORCE_INLINE S visibility_ggx(vec3<S> l, vec3<S> v, AnisotropicAlpha<S> alpha) {
    return S(0.5) / simd::mul_add(l.z, widened_cosine_ggx(v, alpha), v.z * widened_cosine_ggx(l, alpha));
}

// Two directions and their half vector in the surface's frame. The half vector is computed before it is turned to that
// frame: of opposite directions, rounding each to the frame would leave nothing.
template<class S>
struct FacetPose {
    vec3<S> l, v, h; // unit

    GONIO_FORCE_INLINE FacetPose(const TangentFrame<S>& frame, vec3<S> to_light, vec3<S> to_eye)
        : l(frame.to_local(to_light)), v(frame.to_local(to_eye)), h(frame.to_local(normalized(to_light + to_eye))) {}
    // Of directions in the frame.
    GONIO_FORCE_INLINE FacetPose(vec3<S> to_light, vec3<S> to_eye)
        : l(to_light), v(to_eye), h(normalized(to_light + to_eye)) {}
};

// 0 where n·l or n·v is not above_surface().
template<class S>
GONIO_FORCE_INLINE SpecularTerms<S> specular_ggx(const FacetPose<S>& pose, AnisotropicAlpha<S> alpha,
                                                 AnisotropicAlpha<S> widened) {
    const auto& [l, v, h] = pose;
    const auto lit = simd::both(above_surface(l.z), above_surface(v.z));
    const vec3<S> lit_l{l.x, l.y, simd::select(lit, l.z, S(1))};
    const vec3<S> lit_v{v.x, v.y, simd::select(lit, v.z, S(1))};
    const S scale = distribution_ggx(h, S(1), alpha, widened) * visibility_ggx(lit_l, lit_v, alpha);
    return {simd::select(lit, scale, S(0)), schlick_weight(dot(l, h))};
}

// As visible_normal_ggx of ggx.hpp. The cap is turned with the view, so that its samples turn with the view too and are
// those of the isotropic lobe where α_x = α_y.
template<class S>
GONIO_FORCE_INLINE vec3<S> visible_normal_ggx(vec3<S> v, AnisotropicAlpha<S> alpha, S u0, S u1) {
    const vec3<S> stretched = normalized(vec3<S>{alpha.x * v.x, alpha.y * v.y, simd::max(v.z, S(0))});
    const S fallen = u0 * (S(1) + stretched.z);
    const S r = simd::sqrt(simd::max(fallen * (S(2) - fallen), S(0)));
    const S phi = S(2.0 * std::numbers::pi) * u1;
    const S level = simd::sqrt(simd::mul_add(v.x, v.x, v.y * v.y));
    const auto tilted = level > S(least_cosine);
    const S inverse = S(1) / simd::select(tilted, level, S(1));
    const S cos_v = simd::select(tilted, v.x * inverse, S(1));
    const S sin_v = simd::select(tilted, v.y * inverse, S(0));
    const S x = r * simd::cos(phi);
    const S y = r * simd::sin(phi);
    return normalized(vec3<S>{alpha.x * (x * cos_v - y * sin_v + stretched.x),
                              alpha.y * (x * sin_v + y * cos_v + stretched.y), (S(1) - u0) * (S(1) + stretched.z)});
}

template<class S>
GONIO_FORCE_INLINE vec3<S> reflected_direction_ggx(vec3<S> v, AnisotropicAlpha<S> alpha, S u0, S u1) {
    const vec3<S> h = visible_normal_ggx(v, alpha, u0, u1);
    return normalized(h * (S(2) * dot(v, h)) - v);
}

// The density of reflected_direction_ggx [1/sr].
template<class S>
GONIO_FORCE_INLINE S pdf_reflected_ggx(const FacetPose<S>& pose, AnisotropicAlpha<S> alpha) {
    const auto& [l, v, h] = pose;
    const auto seen = simd::both(above_surface(v.z), h.z > S(0));
    const S seen_share = S(0.5) / (simd::max(v.z, S(0)) + widened_cosine_ggx(v, alpha));
    return simd::select(seen, distribution_ggx(h, S(1), alpha, alpha) * seen_share, S(0));
}

} // namespace gonio::shading
