// Irradiance from a uniform sphere, exact with horizon clipping.
//
// E/L [sr] is the irradiance [lx] per luminance [nt], in [0, π]. Let s = r/d = sinσ for the sphere's angular radius σ,
// κ = cosσ, and c = n·l the cosine of its centre. Above the horizon (c ≥ s) the sphere acts as a point: π s² c. Below
// (c ≤ −s) nothing is seen. In between, with w = √((s−c)(s+c)),
//
//     E/L = s² c·atan2(w, −κc) − κw + atan2(w, κ)
//
// This is the cap's contour integral (cap arc and horizon arc) without the azimuths. It does not need the angle of c
// and has no 0/0 on the axis. It is stationary in w, so rounding in s−c does no harm. The last two terms cancel for
// small spheres and are combined as (atan τ − τ) + τ s² with τ = w/κ. README.md derives it.
#pragma once

#include <gonio/shading/direction.hpp>
#include <gonio/simd/math.hpp>

#include <numbers>

namespace gonio::shading {

// E/L where the horizon cuts the sphere: |c| ≤ s ≤ 1, with κ = √(1−s²) from a form that does not cancel at s = 1.
template<class S>
GONIO_FORCE_INLINE S irradiance_straddling_cap(S s, S kappa, S c) {
    const S w = simd::sqrt(simd::max((s - c) * (s + c), S(0)));
    const S phi = simd::atan2_above(w, -kappa * c);
    const S larger = simd::max(w, kappa);
    const S tau = simd::min(w, kappa) / simd::max(larger, S(1e-37)); // 0 where both are 0
    const S excess = simd::atan_excess(tau);
    const S narrow = simd::mul_add(tau, s * s, excess);
    const S wide = (S(std::numbers::pi / 2.0) - kappa * w) - (tau + excess);
    return simd::mul_add(s * s * c, phi, simd::select(w <= kappa, narrow, wide));
}

// The irradiance of a sphere as if nothing cut it, and where the horizon does cut it.
template<class S>
struct SphereAbove {
    S scaled_radius, s, irradiance;
    simd::mask_of<S> straddling;
    simd::mask_of<S> is_cut; // straddling, or so near that s is 1 within rounding or more

    GONIO_FORCE_INLINE SphereAbove(const Direction<S>& to_center, S radius) {
        const S c = to_center.n_dot_l;
        // The scaled distance is below 7: a larger radius makes no difference, and its square would overflow.
        scaled_radius = simd::min(simd::abs(radius) * to_center.scale, S(1e18));
        s = simd::min(scaled_radius * to_center.inverse_distance, S(1));
        irradiance = S(std::numbers::pi) * s * s * simd::max(c, S(0));
        const vec3<S> p = to_center.scaled;
        const auto near = dot(p, p) * S(1.0 - 1e-5) <= scaled_radius * scaled_radius;
        straddling = simd::abs(c) < s;
        is_cut = simd::either(near, straddling);
    }
};

// E/L [sr] of a sphere of radius r at `to_center` from the receiver, which has the unit normal `normal`. d < r: π. On
// the surface π(1 + n·l)/2; d = r = 0 gives 0. Any finite input; r < 0 counts as |r|.
template<class S>
GONIO_FORCE_INLINE S irradiance_sphere(const Direction<S>& to_center, S radius) {
    const SphereAbove<S> uncut(to_center, radius);
    if (!simd::any(uncut.is_cut)) return uncut.irradiance;

    const vec3<S> p = to_center.scaled;
    const S gap = simd::difference_of_squares(p.x, p.y, p.z, uncut.scaled_radius); // d² − r², to the last digit
    const S kappa = simd::sqrt(simd::max(gap, S(0))) * to_center.inverse_distance;
    const S cut = simd::max(irradiance_straddling_cap(uncut.s, kappa, to_center.n_dot_l), S(0));
    const S outside = simd::select(uncut.straddling, cut, uncut.irradiance);
    constexpr double pi = std::numbers::pi;
    return simd::min(simd::select(gap < S(0), S(pi), outside), S(pi));
}

template<class S>
GONIO_FORCE_INLINE S irradiance_sphere(vec3<S> to_center, S radius, vec3<S> normal) {
    return irradiance_sphere(direction(to_center, normal), radius);
}

} // namespace gonio::shading
