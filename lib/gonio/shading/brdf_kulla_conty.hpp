// GGX with multiple scattering between facets: the single scattering of brdf_ggx.hpp and a wide lobe that carries the
// light it loses (C. Kulla and A. Conty, "Revisiting Physically Based Shading at Imageworks", SIGGRAPH 2017).
//
// Let L(μ) = 1 − E(μ) be the loss at F = 1, and L̄ = ∫ 2μ L dμ. The lobe is F_ms L(n·l) L(n·v)/(π L̄): reciprocal, and
// with F = 1 nothing is lost. F_ms = F̄² (1 − L̄)/(1 − F̄ L̄), F̄ = f0 + (1 − f0)/21 is the mean of Schlick's
// reflectance. L is a polynomial within 6e-5 of the exact loss (fit/ggx_loss.cpp), and L̄ is the mean of that
// polynomial, so a white surface reflects 1 ± 1e-4; below α = 0.01, and within μ = 10 α, 1 ± 6e-4. Smooth surfaces lose
// almost nothing, and the rounding of the polynomial's terms would exceed that loss. It is therefore stored as its
// value at μ = 1 plus (1 − s) times another polynomial. L in float then agrees with L in double to within 3e-7 (1 − s)
// and 3e-6 relative.
#pragma once

#include <gonio/base/gauss_legendre.hpp>
#include <gonio/shading/brdf_ggx.hpp>
#include <gonio/shading/brdf_lambert.hpp>
#include <gonio/shading/brdf_lobes.hpp>
#include <gonio/shading/brdf_sample.hpp>
#include <gonio/shading/ggx_loss_coefficients.hpp>
#include <gonio/shading/gloss.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

#include <cstddef>
#include <numbers>

namespace gonio::shading {

namespace detail {

// Σ c[k] T_k(x) for k < count, by C. W. Clenshaw's recurrence; |x| ≤ 1.
template<class S, class T>
GONIO_FORCE_INLINE S chebyshev_series(const T* c, std::size_t count, S x) {
    const S twice = x + x;
    S one = S(0);
    S two = S(0);
    for (std::size_t k = count - 1; k > 0; --k) {
        const S next = simd::mul_add(twice, one, S(c[k]) - two);
        two = one;
        one = next;
    }
    return simd::mul_add(x, one, S(c[0]) - two);
}

} // namespace detail

// L(μ) of one α: the loss of single scattering, c₀ + (1 − s) Σ c_{k+1} T_k(2s − 1), s = √(μ(1 + α)/(μ + α)).
template<class S>
struct GgxLoss {
    S alpha;
    S c[detail::ggx_loss_of_cosine];

    // μ in [0, 1].
    GONIO_FORCE_INLINE S operator()(S mu) const {
        const S inverse = S(1) / (mu + alpha);
        const S s = simd::min(simd::sqrt(mu * (S(1) + alpha) * inverse), S(1));
        const S rest = alpha * (S(1) - mu) * inverse / (S(1) + s); // 1 − s without cancellation
        const S sum = detail::chebyshev_series(c + 1, detail::ggx_loss_of_cosine - 1, s + s - S(1));
        return simd::max(simd::mul_add(rest, sum, c[0]), S(0));
    }
    // ∫ 2μ L(μ) dμ, with uniform steps in ln(μ + α): the loss is α² for each step, down to μ = α.
    GONIO_FORCE_INLINE S mean() const {
        const S range = simd::log2(S(1) + alpha) - simd::log2(alpha);
        S sum = S(0);
        constexpr auto rule = gauss_legendre<24>();
        for (const QuadratureNode& node : rule) {
            const S shifted = alpha * simd::exp2(range * S(0.5 + 0.5 * node.at));
            const S mu = simd::min(simd::max(shifted - alpha, S(0)), S(1));
            sum = simd::mul_add(S(0.5 * node.weight) * mu * shifted, (*this)(mu), sum);
        }
        return sum * range * S(2.0 * std::numbers::ln2);
    }
};

namespace detail {

// GgxLoss::c of one α.
GONIO_FORCE_INLINE void ggx_loss_in_double(double alpha, double (&c)[ggx_loss_of_cosine]) {
    double terms[ggx_loss_of_cosine];
    c[0] = 0.0;
    for (std::size_t i = 0; i < ggx_loss_of_cosine; ++i) {
        terms[i] = chebyshev_series(ggx_loss_terms + i * ggx_loss_of_alpha, ggx_loss_of_alpha, alpha + alpha - 1.0);
        c[0] += terms[i]; // the value at x = 1
    }
    // The series minus that value, divided by x − 1 = −2(1 − s): as x T_k = (T_{k+1} + T_{k−1})/2,
    // b_{k−1} = 2(a_k + b_k) − b_{k+1}.
    double b = 0.0;
    double above = 0.0;
    for (std::size_t k = ggx_loss_of_cosine - 1; k > 0; --k) {
        const double next = 2.0 * (terms[k] + b) - above;
        above = b;
        b = next;
        c[k] = k > 1 ? -2.0 * b : -b; // T_0 counts half
    }
}

} // namespace detail

// α in [0, 1], at least minimum_alpha.
template<class S>
GONIO_FORCE_INLINE GgxLoss<S> ggx_loss(S alpha) {
    using T = simd::value_of<S>;
    constexpr std::size_t lanes = simd::Traits<S>::lanes;
    GgxLoss<S> loss;
    loss.alpha = simd::max(alpha, S(minimum_alpha));
    T alphas[lanes];
    simd::store(loss.alpha, &alphas[0]);
    T c[detail::ggx_loss_of_cosine][lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        double of_lane[detail::ggx_loss_of_cosine];
        detail::ggx_loss_in_double(static_cast<double>(alphas[lane]), of_lane);
        for (std::size_t i = 0; i < detail::ggx_loss_of_cosine; ++i)
            c[i][lane] = static_cast<T>(of_lane[i]);
    }
    for (std::size_t i = 0; i < detail::ggx_loss_of_cosine; ++i)
        simd::load(&c[i][0], loss.c[i]);
    return loss;
}

template<class S>
struct KullaConty {
    static constexpr Scattering scattering = Scattering::one_color;
    static constexpr LobeKind lobe = LobeKind::ggx_and_more;

    vec3<S> f0;       // reflectance at normal incidence; 1 at grazing
    vec3<S> multiple; // F_ms/(π L̄)
    GgxLoss<S> loss;  // holds α too
};

// F_ms/(π L̄) of the three channels, for the mean loss L̄ in [0, 1]; 0 where nothing is lost.
template<class S>
GONIO_FORCE_INLINE vec3<S> multiple_scattering_factor(vec3<S> f0, S mean_loss) {
    const S inverse = reciprocal_or_zero(mean_loss) * S(std::numbers::inv_pi);
    const auto channel = [&](S f) {
        const S average = simd::mul_add(S(1) - f, S(1.0 / 21.0), f);
        return average * average * (S(1) - mean_loss) / (S(1) - average * mean_loss) * inverse;
    };
    return {channel(f0.x), channel(f0.y), channel(f0.z)};
}

// f0 and α in [0, 1].
template<class S>
GONIO_FORCE_INLINE KullaConty<S> kulla_conty_material(vec3<S> f0, S alpha) {
    const GgxLoss<S> loss = ggx_loss(alpha);
    return {f0, multiple_scattering_factor(f0, loss.mean()), loss};
}

namespace detail {

// The wide lobe [1/sr]: `factor` is F_ms/(π L̄), and the losses are functions of n·l and of n·v. A shader's caller has
// looked them up, so there they return its numbers (shader/).
template<class S, class LossOfLight, class LossOfView>
GONIO_FORCE_INLINE vec3<S> wide_lobe(vec3<S> factor, vec3<S> n, vec3<S> l, vec3<S> v, const LossOfLight& loss_of_light,
                                     const LossOfView& loss_of_view) {
    const S n_dot_l = dot(n, l);
    const S n_dot_v = dot(n, v);
    const auto lit = simd::both(above_surface(n_dot_l), above_surface(n_dot_v));
    const auto cosine = [&](S c) { return simd::min(simd::select(lit, c, S(1)), S(1)); };
    const S lost = loss_of_light(cosine(n_dot_l)) * loss_of_view(cosine(n_dot_v));
    return factor * simd::select(lit, lost, S(0));
}

} // namespace detail

// The wide lobe [1/sr].
template<class S>
GONIO_FORCE_INLINE vec3<S> multiple_scattering(const KullaConty<S>& material, vec3<S> n, vec3<S> l, vec3<S> v) {
    return detail::wide_lobe(material.multiple, n, l, v, material.loss, material.loss);
}

template<class S>
GONIO_FORCE_INLINE S lobe_alpha(const KullaConty<S>& material) {
    return material.loss.alpha;
}
template<class S>
GONIO_FORCE_INLINE vec3<S> diffuse_part(const KullaConty<S>& /*none*/, vec3<S> /*n*/, vec3<S> /*l*/, vec3<S> /*v*/) {
    return {S(0), S(0), S(0)};
}
// The single-scattering lobe plus the wide one. Only the first is widened.
template<class S>
GONIO_FORCE_INLINE vec3<S> specular_part(const KullaConty<S>& material, vec3<S> n, vec3<S> l, vec3<S> v, S widening) {
    return specular_part(Ggx<S>{material.f0, material.loss.alpha}, n, l, v, widening) +
           multiple_scattering(material, n, l, v);
}

// The single-scattering lobe.
template<class S>
GONIO_FORCE_INLINE Gloss<S, GgxLobe<S>> gloss(const KullaConty<S>& material) {
    return {{lobe_alpha(material)}, material.f0, S(1), S(1)};
}
template<class S>
GONIO_FORCE_INLINE Lambert<S> diffuse_alone(const KullaConty<S>& /*none*/) {
    return {{S(0), S(0), S(0)}};
}
template<class S>
GONIO_FORCE_INLINE vec3<S> scattered_color(const KullaConty<S>& material) {
    return material.multiple;
}
template<class S>
GONIO_FORCE_INLINE KullaConty<S> white(const KullaConty<S>& material) {
    KullaConty<S> changed = material;
    changed.multiple = {S(1), S(1), S(1)};
    return changed;
}

namespace detail {

// `lost` is L(n·v).
template<class S>
GONIO_FORCE_INLINE Lobes<S> kulla_conty_lobes(vec3<S> f0, S alpha, S lost, S n_dot_v) {
    const S mean_f0 = mean(f0);
    const S reflected = simd::mul_add(S(1) - mean_f0, schlick_weight(n_dot_v), mean_f0);
    return lobes_by_weight(alpha, reflected * (S(1) - lost), reflected * lost);
}

} // namespace detail

template<class S>
GONIO_FORCE_INLINE Lobes<S> lobes(const KullaConty<S>& material, S n_dot_v) {
    const S lost = material.loss(simd::min(simd::max(n_dot_v, S(0)), S(1)));
    return detail::kulla_conty_lobes(material.f0, material.loss.alpha, lost, n_dot_v);
}

} // namespace gonio::shading
