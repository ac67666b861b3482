// Contour integrals over a light's outline on the unit sphere around the receiver.
//
// E/L [sr] = ½ ∮ n·(ω × dω) over the visible part of a uniform light, the outline taken counter-clockwise as seen from
// outside the sphere (J. H. Lambert, "Photometria", 1760; D. R. Baum, H. E. Rushmeier, J. M. Winget, "Improving
// Radiosity Solutions Through the Use of Analytically Determined Form-Factors", 1989). Each function here returns the
// contribution of one arc, the ½ included; n is unit. Where the receiver's horizon cuts the outline, the pieces above
// it are joined by a `horizon_arc` from the point where the outline goes below the horizon to the point where it rises
// again. Finite for finite input; nothing fails.
#pragma once

#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

#include <cstddef>

namespace gonio::shading {

// Great arc from p to q = p + edge, of any length, p ≠ 0. Taking the edge as input, the plane p × edge does not cancel
// where the light is far; 0 where p and edge are parallel.
template<class S>
GONIO_FORCE_INLINE S great_arc(vec3<S> p, vec3<S> edge, vec3<S> normal) {
    const vec3<S> plane = cross(p, edge);
    const S area = length(plane);
    const S angle = simd::atan2(area, dot(p, p + edge));
    return S(0.5) * angle * dot(normal, plane) * reciprocal_or_zero(area);
}

// Arc of the circle at the angle σ about an axis a, from azimuth φ0 to φ1 in the basis u × v = a; n_a, n_u, n_v are the
// normal's components.
template<class S>
GONIO_FORCE_INLINE S cap_arc(S sin_sigma, S cos_sigma, S n_a, S n_u, S n_v, S phi0, S phi1) {
    const S slanted = (simd::sin(phi1) - simd::sin(phi0)) * n_u + (simd::cos(phi0) - simd::cos(phi1)) * n_v;
    return S(0.5) * sin_sigma * (sin_sigma * (phi1 - phi0) * n_a - cos_sigma * slanted);
}

// Half the angle from p to q = p + step about the normal, in [0, π/2]. Both lie on the horizon within rounding: their
// components off the horizon are ignored, because between opposite points they would make up the whole error.
template<class S>
GONIO_FORCE_INLINE S horizon_arc(vec3<S> p, vec3<S> step, vec3<S> normal) {
    const vec3<S> q = p + step;
    const S along = simd::mul_add(-dot(normal, p), dot(normal, q), dot(p, q));
    return S(0.5) * simd::atan2_above(simd::abs(dot(normal, fused_cross(p, step))), along);
}

namespace detail {

// A sum of arcs as an irradiance: in [0, π], and 0 where it is NaN.
template<class S>
GONIO_FORCE_INLINE S clamp_irradiance(S e) {
    return simd::min(simd::max(e, S(0)), S(3.14159265358979323846));
}

// The vector minus its component along the unit vector `axis`, subtracted twice, so that only the rounding error of the
// rest is left along the axis.
template<class S>
GONIO_FORCE_INLINE vec3<S> perpendicular(vec3<S> v, vec3<S> axis) {
    const vec3<S> once = v - axis * dot(axis, v);
    return once - axis * dot(axis, once);
}

// The result of a form in straight code, without a function call (for which packets would have to keep their numbers in
// memory), and the lanes that it leaves to other forms.
template<class S>
struct Survey {
    S irradiance;
    simd::mask_of<S> hard; // to be evaluated otherwise, in double: the receiver almost touches the light
};

// `easy` where `hard` is false; elsewhere Exact::evaluate in double, lane by lane, on the same float inputs: for
// receivers that almost touch the light. A separate function, so that other packets do not bear its cost.
template<class Exact, class S, std::size_t count>
[[gnu::noinline]] S in_double(simd::mask_of<S> hard, S easy, const S (&inputs)[count]) {
    constexpr std::size_t lanes = simd::Traits<S>::lanes;
    float chosen[lanes];
    float result[lanes];
    float values[count][lanes];
    simd::store(simd::select(hard, S(1), S(0)), &chosen[0]);
    simd::store(easy, &result[0]);
    for (std::size_t k = 0; k < count; ++k)
        simd::store(inputs[k], &values[k][0]);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        if (chosen[lane] == 0.0F) continue;
        double v[count];
        for (std::size_t k = 0; k < count; ++k)
            v[k] = static_cast<double>(values[k][lane]);
        result[lane] = static_cast<float>(Exact::evaluate(v));
    }
    S all;
    simd::load(&result[0], all);
    return all;
}

} // namespace detail

} // namespace gonio::shading
