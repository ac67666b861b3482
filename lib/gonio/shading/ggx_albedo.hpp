// The directional albedo of single-scattering GGX facets with Schlick's reflectance, by the cosine of the view.
//
// E(μ) = ∫ f n·l dl = S (f0 + (f90 − f0)(1 − μ̂)⁵): S = 1 − L is the albedo for a reflectance of 1 (GgxLoss), and μ̂ is
// the cosine at which Schlick's weight has its mean over the lobe; smooth facets have μ̂ = μ. fit/ggx_mean_cosine.cpp
// integrates it and prints the polynomial. E is within 1.3e-3 of the integral for α ≥ 1e-4 and μ ≥ 1e-5, with f0 = 0.04
// and f90 = 1.
#pragma once

#include <gonio/base/gauss_legendre.hpp>
#include <gonio/shading/brdf_kulla_conty.hpp>
#include <gonio/shading/ggx_mean_cosine_coefficients.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

#include <cstddef>

namespace gonio::shading {

// Of one α.
template<class S>
struct GgxAlbedo {
    GgxLoss<S> loss; // holds α too
    S c[detail::ggx_mean_cosine_of_z];

    // (1 − μ̂)⁵ for μ in [0, 1].
    GONIO_FORCE_INLINE S grazing(S mu) const {
        const S z = loss.alpha / (mu + loss.alpha);
        const S shift = detail::chebyshev_series(c, detail::ggx_mean_cosine_of_z, z + z - S(1));
        return schlick_weight(simd::min(simd::max(simd::mul_add(loss.alpha * z, shift, mu), S(0)), S(1)));
    }
    // E for μ in [0, 1].
    GONIO_FORCE_INLINE S operator()(S mu, S f0, S f90) const {
        return (S(1) - loss(mu)) * simd::mul_add(f90 - f0, grazing(mu), f0);
    }
    // ∫ 2μ E dμ.
    GONIO_FORCE_INLINE S mean(S f0, S f90) const {
        S sum = S(0);
        constexpr auto rule = gauss_legendre<24>();
        for (const QuadratureNode& node : rule) {
            const double root = 0.5 + 0.5 * node.at; // μ = root²
            sum = simd::mul_add(S(2.0 * node.weight * root * root * root), (*this)(S(root * root), f0, f90), sum);
        }
        return sum;
    }
};

// α in [0, 1], at least minimum_alpha.
template<class S>
GONIO_FORCE_INLINE GgxAlbedo<S> ggx_albedo(S alpha) {
    GgxAlbedo<S> albedo;
    albedo.loss = ggx_loss(alpha);
    const S x = S(2) * simd::sqrt(albedo.loss.alpha) - S(1);
    for (std::size_t i = 0; i < detail::ggx_mean_cosine_of_z; ++i)
        albedo.c[i] = detail::chebyshev_series(detail::ggx_mean_cosine_terms + i * detail::ggx_mean_cosine_of_root,
                                               detail::ggx_mean_cosine_of_root, x);
    return albedo;
}

// Fresnel's reflectance averaged over a glossy lobe, as "The Art of Remember Me" (S. Lagarde and L. Harduin, 2013)
// takes it for light from all around: F0 + (max(1 − r, F0) − F0)(1 − n·v)⁵, with r = √α in [0, 1].
template<class S>
GONIO_FORCE_INLINE S glossy_fresnel_remember_me(S f0, S linear_roughness, S n_dot_v) {
    const S f90 = simd::max(S(1) - linear_roughness, f0);
    return simd::mul_add(f90 - f0, schlick_weight(n_dot_v), f0);
}
// The same by integration over the GGX lobe: E/S.
template<class S>
GONIO_FORCE_INLINE S glossy_fresnel(const GgxAlbedo<S>& albedo, S f0, S n_dot_v) {
    return simd::mul_add(S(1) - f0, albedo.grazing(n_dot_v), f0);
}

} // namespace gonio::shading
