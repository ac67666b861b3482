// The Planckian locus as rational functions: once for float, double and packs.
//
// u' and v' over t = 1000 K / T, 0 ≤ t ≤ 1.25: 800 K to infinity. Largest Δu'v' against the 1 nm sum (planckian.hpp):
// 2.1e-7 in float, 1.2e-12 in double; fit/locus_fit.cpp prints the coefficients and these errors. Outside that range
// the functions are meaningless; the caller must check.
#pragma once

#include <gonio/color/locus_coefficients.hpp>
#include <gonio/simd/pack.hpp>

#include <cstddef>

namespace gonio::color {

inline constexpr double greatest_t = 1.25; // [1/kK]

// Σ c[k] tᵏ from k on, with its first two derivatives as `order` requires (the second one halved).
template<class S, int order>
struct Jet {
    S value;
    S first;
    S half_second;
};

// The arrays of the coefficient structs would become weak symbols; constants that are named one by one do not.
template<const auto& c, std::size_t k, int order, class S>
GONIO_FORCE_INLINE Jet<S, order> horner(S t) {
    if constexpr (k + 1 == sizeof(c) / sizeof(c[0])) {
        return {S(c[k]), S(0), S(0)};
    } else {
        const Jet<S, order> rest = horner<c, k + 1, order>(t);
        Jet<S, order> sum = rest;
        if constexpr (order >= 2) sum.half_second = simd::mul_add(rest.half_second, t, rest.first);
        if constexpr (order >= 1) sum.first = simd::mul_add(rest.first, t, rest.value);
        sum.value = simd::mul_add(rest.value, t, S(c[k]));
        return sum;
    }
}

// The four polynomials at t.
template<class S, int order>
struct LocusParts {
    Jet<S, order> pu, qu, pv, qv;
};

template<int order, class S>
GONIO_FORCE_INLINE LocusParts<S, order> locus_parts(S t) {
    using C = LocusCoefficients<simd::value_of<S>>;
    return {horner<C::pu, 0, order>(t), horner<C::qu, 0, order>(t), horner<C::pv, 0, order>(t),
            horner<C::qv, 0, order>(t)};
}

// u', v' and their first two derivatives by t.
template<class S>
struct LocusJet {
    S u, v;
    S du, dv;
    S ddu, ddv;
};

// Derivatives above `order` stay undefined.
template<int order, class S>
GONIO_FORCE_INLINE LocusJet<S> locus_jet(S t) {
    const LocusParts<S, order> parts = locus_parts<order>(t);
    const S one = S(1);
    const S over_both = one / (parts.qu.value * parts.qv.value);
    const S over_qu = over_both * parts.qv.value;
    const S over_qv = over_both * parts.qu.value;
    LocusJet<S> jet;
    jet.u = parts.pu.value * over_qu;
    jet.v = parts.pv.value * over_qv;
    if constexpr (order >= 1) { // (P/Q)' = (P' − (P/Q) Q')/Q
        jet.du = (parts.pu.first - jet.u * parts.qu.first) * over_qu;
        jet.dv = (parts.pv.first - jet.v * parts.qv.first) * over_qv;
    }
    if constexpr (order >= 2) { // (P/Q)'' = (P'' − 2 (P/Q)' Q' − (P/Q) Q'')/Q
        const S two = S(2);
        jet.ddu = two * (parts.pu.half_second - jet.du * parts.qu.first - jet.u * parts.qu.half_second) * over_qu;
        jet.ddv = two * (parts.pv.half_second - jet.dv * parts.qv.first - jet.v * parts.qv.half_second) * over_qv;
    }
    return jet;
}

template<class S>
struct UvPrimeOf {
    S u, v;
};

// The point at a distance Duv from the locus, along its normal in u, v of 1960; positive above it (greener), as in ANSI
// C78.377.
template<class S>
GONIO_FORCE_INLINE UvPrimeOf<S> off_locus(S t, S duv) {
    const LocusJet<S> jet = locus_jet<1>(t);
    // In (u, v) the tangent is (u', ⅔v'); rotated to the left, because u rises with t.
    const S dv = jet.dv * S(2.0 / 3.0);
    const S scale = duv / simd::sqrt(jet.du * jet.du + dv * dv);
    return {jet.u - dv * scale, jet.v + S(1.5) * jet.du * scale};
}

// RGB with Y = 1 of a linear space, given by XYZ → RGB, as a·A + b·B + c for A = u'/v', B = 1/v': the matrix reduces to
// this because X/Y = 2.25 u'/v' and Z/Y = 3/v' − 0.75 u'/v' − 5.
template<class S>
struct RgbRows {
    S a[3];
    S b[3];
    S c[3];
};

template<class S>
struct RgbOf {
    S r, g, b;
};

template<class S>
GONIO_FORCE_INLINE RgbOf<S> rgb_of(const RgbRows<S>& rows, S a, S b) {
    return {simd::mul_add(rows.a[0], a, simd::mul_add(rows.b[0], b, rows.c[0])),
            simd::mul_add(rows.a[1], a, simd::mul_add(rows.b[1], b, rows.c[1])),
            simd::mul_add(rows.a[2], a, simd::mul_add(rows.b[2], b, rows.c[2]))};
}

// Σ c[k] s^(n−k): the polynomial of t = 1/s, times sⁿ.
template<const auto& c, std::size_t k, class S>
GONIO_FORCE_INLINE S horner_reversed(S s) {
    if constexpr (k == 0) {
        return S(c[0]);
    } else {
        return simd::mul_add(horner_reversed<c, k - 1>(s), s, S(c[k]));
    }
}
template<const auto& c, class S>
GONIO_FORCE_INLINE S reversed(S s) {
    return horner_reversed<c, sizeof(c) / sizeof(c[0]) - 1>(s);
}

// From s = T / 1000 K, 0.8 ≤ s ≤ 1000: one division for t, both functions and the projection.
template<class S>
GONIO_FORCE_INLINE RgbOf<S> planckian_rgb(const RgbRows<S>& rows, S kilokelvin) {
    using C = LocusCoefficients<simd::value_of<S>>;
    const S qu = reversed<C::qu>(kilokelvin);
    const S pv = reversed<C::pv>(kilokelvin);
    const S scaled = reversed<C::qv>(kilokelvin) / (qu * pv); // the powers of s cancel
    return rgb_of(rows, reversed<C::pu>(kilokelvin) * scaled, qu * scaled);
}

template<class S>
GONIO_FORCE_INLINE RgbOf<S> off_locus_rgb(const RgbRows<S>& rows, S t, S duv) {
    const UvPrimeOf<S> at = off_locus(t, duv);
    const S over = S(1) / at.v;
    return rgb_of(rows, at.u * over, over);
}

// Krystek (1985), 1000–15000 K, as a function of T: u and v of 1960. For comparison.
template<class S>
GONIO_FORCE_INLINE UvPrimeOf<S> krystek_uv_prime(S temperature) {
    const S t = temperature;
    const S u = simd::mul_add(simd::mul_add(S(1.28641212e-7), t, S(1.54118254e-4)), t, S(0.860117757)) /
                simd::mul_add(simd::mul_add(S(7.08145163e-7), t, S(8.42420235e-4)), t, S(1));
    const S v = simd::mul_add(simd::mul_add(S(4.20481691e-8), t, S(4.22806245e-5)), t, S(0.317398726)) /
                simd::mul_add(simd::mul_add(S(1.61456053e-7), t, S(-2.89741816e-5)), t, S(1));
    return {u, S(1.5) * v};
}

template<class S>
GONIO_FORCE_INLINE RgbOf<S> krystek_rgb(const RgbRows<S>& rows, S temperature) {
    const UvPrimeOf<S> at = krystek_uv_prime(temperature);
    const S over = S(1) / at.v;
    return rgb_of(rows, at.u * over, over);
}

} // namespace gonio::color
