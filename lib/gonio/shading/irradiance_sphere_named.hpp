// The irradiance of a sphere as renderers approximate it, kept for comparison with the exact one.
#pragma once

#include <gonio/shading/direction.hpp>
#include <gonio/simd/math.hpp>

#include <numbers>

namespace gonio::shading {

// The sphere as a point: I⟨n·l⟩/d² with I = π r² L. Exact above the horizon; not limited inside the sphere: E/L may
// exceed π.
template<class S>
GONIO_FORCE_INLINE S irradiance_sphere_point(vec3<S> to_center, S radius, vec3<S> normal) {
    const Direction<S> d = direction(to_center, normal);
    const S s = radius * d.scale * d.inverse_distance;
    return S(std::numbers::pi) * s * s * simd::max(d.n_dot_l, S(0));
}

namespace detail {

// The cap of "Moving Frostbite to Physically Based Rendering" (Lagarde and de Rousiers, course notes 2014, listing 7)
// from the cosine of its centre, clamped to ±0.999, and sin²σ, clamped to 0.9999. The arguments of acos and sqrt are
// clamped; otherwise the result is NaN at case boundaries.
template<class S>
GONIO_FORCE_INLINE S frostbite_cap(S cosine, S square_sine) {
    const S cos_theta = simd::max(simd::min(cosine, S(0.999)), S(-0.999));
    const S sin_sigma2 = simd::min(square_sine, S(0.9999));
    const S sin_theta = simd::sqrt(S(1) - cos_theta * cos_theta);
    const S x = simd::sqrt(S(1) / simd::max(sin_sigma2, S(1e-30)) - S(1));
    const S y = simd::max(simd::min(-x * cos_theta / sin_theta, S(1)), S(-1));
    const S root = simd::sqrt(S(1) - y * y);
    const S straddling =
        (cos_theta * simd::acos(y) - x * sin_theta * root) * sin_sigma2 + simd::atan(sin_theta * root / x);
    const S above = S(std::numbers::pi) * sin_sigma2 * simd::max(cos_theta, S(0));
    return simd::max(simd::select(cos_theta * cos_theta > sin_sigma2, above, straddling), S(0));
}

} // namespace detail

// The tilted sphere of the same notes, with its distance clamped to at least the radius. Always exact in theory; its
// cotangents lose digits in float.
template<class S>
GONIO_FORCE_INLINE S irradiance_sphere_frostbite(vec3<S> to_center, S radius, vec3<S> normal) {
    const S square_distance = dot(to_center, to_center);
    return detail::frostbite_cap(dot(normal, normalized(to_center)),
                                 radius * radius * reciprocal_or_zero(square_distance));
}

// B. Karis, "Real Shading in Unreal Engine 4", 2013: the sphere as a point, and therefore exact above the horizon.
template<class S>
GONIO_FORCE_INLINE S irradiance_sphere_ue4(vec3<S> to_center, S radius, vec3<S> normal) {
    return irradiance_sphere_point(to_center, radius, normal);
}

} // namespace gonio::shading
