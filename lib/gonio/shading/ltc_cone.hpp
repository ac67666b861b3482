// Contour integrals over a circle's cone after a linear transform: an elliptic cone, in closed form.
//
// A circle (the rim of a disk, or the visible rim of a sphere or of a tube's end) is p(t) = A + U cos t + V sin t, and
// its image under a matrix has the same form with other A, U, V. The wanted ½∮ z·(p × dp)/|p|² does not change when p
// is scaled or t re-parametrised; so A, U, V may be transformed into each other by anything that keeps (1, cos t,
// sin t) on its null cone: rotations of U, V and boosts of A, U or A, V. These are applied until all three are
// perpendicular: the one-sided Jacobi method for a product of a matrix with a hyperbolic one (after K. Veselić,
// Numerische Mathematik 64, 1993). The columns themselves are transformed, never their products, so that narrow and
// long cones keep their digits in float. The method converges quadratically. Then, with a = |U|/|A|, b = |V|/|A| and s
// for t,
//
//     z·(p × dp)/|p|² = (ab n_A − b n_U cos s − a n_V sin s) ds / (1 + a² cos² s + b² sin² s)
//
// The antiderivatives are angles and one logarithm. The whole cone gives π n_A ab/√((1 + a²)(1 + b²)), in which nothing
// cancels however small it is.
#pragma once

#include <gonio/shading/outline.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

namespace gonio::shading::detail {

// Rotates u and v until they are perpendicular, the longer first.
template<class S>
GONIO_FORCE_INLINE void make_perpendicular(vec3<S>& u, vec3<S>& v) {
    constexpr double least = 1e-36;
    const S u2 = dot(u, u);
    const S v2 = dot(v, v);
    const S inverse = S(1) / simd::max(u2 + v2, S(least));
    const S difference = (u2 - v2) * inverse;
    const S product = S(2) * dot(u, v) * inverse;
    const S h = simd::sqrt(simd::mul_add(difference, difference, product * product));
    const auto turned = h > S(1e-12);
    const S inverse_h = S(1) / simd::select(turned, h, S(1));
    const S larger = simd::sqrt(S(0.5) * simd::min(S(1) + simd::abs(difference) * inverse_h, S(2)));
    const S smaller = S(0.5) * simd::abs(product) * inverse_h / simd::max(larger, S(0.5));
    const auto swapped = difference < S(0);
    const S cosine = simd::select(turned, simd::select(swapped, smaller, larger), S(1));
    const S sine = simd::select(turned, simd::copysign(simd::select(swapped, larger, smaller), product), S(0));
    const vec3<S> turned_u = u * cosine + v * sine;
    v = v * cosine - u * sine;
    u = turned_u;
}

// Boosts a and u until they are perpendicular. Returns how far they were from perpendicular: the boost's hyperbolic
// tangent.
template<class S>
GONIO_FORCE_INLINE S boost(vec3<S>& a, vec3<S>& u) {
    constexpr double least = 1e-36;
    const vec3<S> p = a + u;
    const vec3<S> m = a - u;
    const S sum = dot(a, a) + dot(u, u);
    const S inverse = S(1) / simd::max(sum, S(least));
    const S product = (dot(p, p) * inverse) * (dot(m, m) * inverse); // 1 − (2a·u/sum)², without cancellation
    const S tangent = S(-2) * dot(a, u) * inverse / (S(1) + simd::sqrt(simd::max(product, S(0))));
    const S t = simd::max(simd::min(tangent, S(0.9999999)), S(-0.9999999));
    const S cosine = S(1) / simd::sqrt((S(1) - t) * (S(1) + t));
    const vec3<S> boosted = (a + u * t) * cosine;
    u = (u + a * t) * cosine;
    a = boosted;
    return simd::abs(t);
}

// A cone in its own axes.
template<class S>
struct LtcCone {
    vec3<S> a, u, v;
    S a2, u2, v2; // squares of their lengths

    // p(t) = a + u cos t + v sin t, right-handed: a·(u × v) > 0.
    GONIO_FORCE_INLINE LtcCone(vec3<S> center, vec3<S> cosine, vec3<S> sine) : a(center), u(cosine), v(sine) {
        constexpr int sweeps = __is_same(S, double) ? 6 : 3; // tested: 3 leave at most 1e-5 of the subtended angle
        make_perpendicular(u, v);
        for (int i = 0; i < sweeps; ++i) {
            const S by_u = boost(a, u);
            const S by_v = boost(a, v);
            make_perpendicular(u, v);
            // The remaining error is the square of this one.
            if (!simd::any(simd::max(by_u, by_v) > S(__is_same(S, double) ? 1e-9 : 3e-4))) break;
        }
        constexpr double least = 1e-36;
        a2 = simd::max(dot(a, a), S(least));
        u2 = simd::max(dot(u, u), S(least));
        v2 = simd::max(dot(v, v), S(least));
    }

    GONIO_FORCE_INLINE S whole() const {
        constexpr double pi = 3.14159265358979323846;
        const S share = simd::sqrt(u2 / (a2 + u2)) * simd::sqrt(v2 / (a2 + v2));
        return S(pi) * a.z * share / simd::sqrt(a2);
    }

    // The arc from p to q, both on the outline. `sliver`: the arc is shorter than its rounding error.
    GONIO_FORCE_INLINE S arc(vec3<S> p, vec3<S> q, simd::mask_of<S> sliver) const {
        constexpr double tau = 6.28318530717958647693;
        constexpr double least = 1e-30;
        const S inverse_a2 = S(1) / a2;
        const S eu = u2 * inverse_a2; // a²
        const S ev = v2 * inverse_a2; // b²
        const auto on_circle = [&](vec3<S> at, S & cosine, S & sine) __attribute__((always_inline)) {
            const S x = dot(at, u) / u2;
            const S y = dot(at, v) / v2;
            const S inverse = S(1) / simd::max(simd::sqrt(simd::mul_add(x, x, y * y)), S(least));
            cosine = x * inverse;
            sine = y * inverse;
        };
        S c0, s0, c1, s1;
        on_circle(p, c0, s0);
        on_circle(q, c1, s1);
        const S pu2 = S(1) + eu;
        const S pv2 = S(1) + ev;
        const S pu = simd::sqrt(pu2);
        const S pv = simd::sqrt(pv2);
        const S e2 = simd::max(eu - ev, S(0));
        const S e = simd::sqrt(e2);
        // ∫ ds/Q, Q = 1 + a² cos² + b² sin²
        const S turn =
            simd::atan2(pu * pv * simd::mul_add(s1, c0, -(c1 * s0)), simd::mul_add(pu2 * c0, c1, pv2 * s0 * s1));
        const S span = simd::select(turn < S(0), simd::select(sliver, S(0), turn + S(tau)), turn);
        const S plain = span / (pu * pv);
        // ∫ cos s ds/Q = atanh(e sin s/pu)/(e pu)
        const S step_s = s1 - s0;
        const S denominator = simd::max(simd::mul_add(-e2 * s0, s1, pu2), S(least));
        const S g = simd::min(simd::abs(e * pu * step_s / denominator), S(1));
        const auto steep = g > S(0.5);
        S cosines = step_s / denominator * simd::atanh_ratio(simd::min(g * g, S(0.25)));
        if (simd::any(steep)) {
            const auto logarithm = [&](S cosine, S sine) __attribute__((always_inline)) {
                const S q2 = simd::mul_add(eu * cosine, cosine, simd::mul_add(ev * sine, sine, S(1)));
                const S x = (pu + e * simd::abs(sine)) / simd::sqrt(q2);
                constexpr double ln_2 = 0.69314718055994530942;
                return simd::copysign(S(ln_2) * simd::log2(x), sine);
            };
            const S by_logarithm = (logarithm(c1, s1) - logarithm(c0, s0)) / simd::max(e * pu, S(least));
            cosines = simd::select(steep, by_logarithm, cosines);
        }
        // ∫ sin s ds/Q = −atan(e cos s/pv)/(e pv)
        const S step_c = c0 - c1;
        const S beside = simd::mul_add(e2 * c0, c1, pv2);
        const S opposite = e * pv * step_c;
        const auto small = simd::abs(opposite) < beside;
        const S ratio = opposite / simd::select(small, beside, S(1));
        const S narrow = step_c / simd::select(small, beside, S(1)) *
                         (S(1) + simd::atan_ratio_excess(simd::min(ratio * ratio, S(1))));
        const S wide = simd::atan2(opposite, beside) / simd::max(e * pv, S(least));
        const S sines = simd::select(small, narrow, wide);

        const S by_a = a.z * simd::sqrt(inverse_a2) * simd::sqrt(eu * ev);
        const S by_u = u.z / simd::sqrt(u2) * simd::sqrt(ev);
        const S by_v = v.z / simd::sqrt(v2) * simd::sqrt(eu);
        return S(0.5) * (by_a * plain - by_u * cosines - by_v * sines);
    }
};

} // namespace gonio::shading::detail
