// What all reflectances share: which directions are above a surface, a frame on the surface, and cosine sampling.
//
// Each material M<S> of the brdf_*.hpp has the same functions, for S = float, double and packs. All directions are unit
// and point away from the surface: n is its normal, l points towards the light, v towards the eye.
//
//   vec3<S> brdf(const M<S>&, n, l, v)
//       The value [1/sr] of the three channels: finite, ≥ 0, the same with l and v exchanged, 0 where n·l or n·v is not
//       above_surface().
//   vec3<S> diffuse_part(const M<S>&, n, l, v), specular_part(const M<S>&, n, l, v, widening)
//       Its two parts: light that enters the surface and leaves it again, and light that its facets mirror. The
//       specular lobe is widened for area lights by adding `widening` to α; its peak is then lowered.
//   S lobe_alpha(const M<S>&)
//       α of that lobe, 1 if there is none.
//   Gloss<S, L> gloss(const M<S>&)
//       The lobe L by itself and its reflectance (gloss.hpp), if there is one.
//   D<S> diffuse_alone(const M<S>&)
//       The material of the diffuse part alone: the same kind with a black lobe, or Lambert.
//   BrdfSample<S> sample_brdf(const M<S>&, n, v, u)
//       A direction towards the light, for three numbers u in [0, 1).
//   S pdf_brdf(const M<S>&, n, v, l)
//       The density of sample_brdf [1/sr], summed over all lobes; 0 where n·v is not above_surface().
//
// M<S> consists only of numbers S, which the kernels' constants rely on, and defines M<S>::scattering and M<S>::lobe.
// If a part is missing, the library does not compile (brdf.hpp).
//
// A sampled l may lie below the surface, where the value is 0: the density integrates to 1 over the whole sphere, and
// over the hemisphere to 1 minus what a lobe loses below the surface. So E[brdf · n·l / pdf] is the directional albedo.
#pragma once

#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

#include <numbers>

namespace gonio::shading {

// A direction this close to the surface counts as lying in it: half vectors of two such directions would exceed float's
// range.
inline constexpr double least_cosine = 1e-18;

template<class S>
GONIO_FORCE_INLINE simd::mask_of<S> above_surface(S cosine) {
    return cosine > S(least_cosine);
}

template<template<class> class Material, class S>
GONIO_FORCE_INLINE vec3<S> brdf(const Material<S>& material, vec3<S> n, vec3<S> l, vec3<S> v) {
    return diffuse_part(material, n, l, v) + specular_part(material, n, l, v, S(0));
}

// How the part without glossy lobes depends on the directions.
enum class Scattering : unsigned char {
    uniform,   // not at all
    one_color, // all channels alike: scattered_color(m) times the scattering of white(m)
    colored    // each channel in its own way
};

// The glossy lobes of a material.
enum class LobeKind : unsigned char {
    none,
    ggx,
    anisotropic_ggx, // wider along the surface's tangent than across it
    ggx_and_more,    // plus multiple_scattering(m, n, l, v), the light that the lobe loses; there is no diffuse part
    cosine_power
};

// Luminance of the three channels, for the two parts of a material.
template<class S>
struct Reflected {
    vec3<S> diffuse, specular;
};

template<class S>
struct BrdfSample {
    vec3<S> l; // unit
    S pdf;     // [1/sr]
};

// x, y and n, right-handed and orthonormal (T. Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1),
// 2017).
template<class S>
struct TangentFrame {
    vec3<S> x, y, n;

    GONIO_FORCE_INLINE explicit TangentFrame(vec3<S> normal) : n(normal) {
        const S sign = simd::copysign(S(1), n.z);
        const S a = S(-1) / (sign + n.z);
        const S b = n.x * n.y * a;
        x = {S(1) + sign * n.x * n.x * a, sign * b, -(sign * n.x)};
        y = {b, sign + n.y * n.y * a, -n.y};
    }
    // `tangent` is unit and perpendicular to the normal.
    GONIO_FORCE_INLINE TangentFrame(vec3<S> tangent, vec3<S> normal)
        : x(tangent), y(cross(normal, tangent)), n(normal) {}
    GONIO_FORCE_INLINE vec3<S> to_local(vec3<S> world) const { return {dot(x, world), dot(y, world), dot(n, world)}; }
    GONIO_FORCE_INLINE vec3<S> to_world(vec3<S> local) const { return x * local.x + y * local.y + n * local.z; }
};

// A direction in the frame's upper hemisphere with density cosθ/π, for two numbers in [0, 1).
template<class S>
GONIO_FORCE_INLINE vec3<S> cosine_direction(S u0, S u1) {
    const S r = simd::sqrt(u0);
    const S phi = S(2.0 * std::numbers::pi) * u1;
    return {r * simd::cos(phi), r * simd::sin(phi), simd::sqrt(S(1) - u0)};
}
template<class S>
GONIO_FORCE_INLINE S pdf_cosine(S n_dot_l) {
    return simd::max(n_dot_l, S(0)) * S(std::numbers::inv_pi);
}

// A direction in the upper hemisphere with density 1/(2π).
template<class S>
GONIO_FORCE_INLINE vec3<S> even_direction(S u0, S u1) {
    const S r = simd::sqrt(u0 * (S(2) - u0));
    const S phi = S(2.0 * std::numbers::pi) * u1;
    return {r * simd::cos(phi), r * simd::sin(phi), S(1) - u0};
}
template<class S>
GONIO_FORCE_INLINE S pdf_even(S n_dot_l) {
    return simd::select(n_dot_l > S(0), S(0.5 * std::numbers::inv_pi), S(0));
}

template<class S>
GONIO_FORCE_INLINE S mean(vec3<S> color) {
    return S(1.0 / 3.0) * (color.x + color.y + color.z);
}

// (1 − x)⁵ for x in [0, 1]: C. Schlick's reflectance is f0 + (f90 − f0)·schlick_weight(l·h).
template<class S>
GONIO_FORCE_INLINE S schlick_weight(S x) {
    const S y = simd::max(S(1) - x, S(0));
    const S y2 = y * y;
    return y2 * y2 * y;
}

} // namespace gonio::shading
