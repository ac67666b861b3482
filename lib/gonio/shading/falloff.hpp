// Falloff with distance: the inverse square, and the windows that bring it to zero at a range. Falloff of spots with
// angle.
//
// A window is an error budget, not physics: it removes at most 1.0887·I/r² (squared, at 0.904 r) or I/r² (glTF, at r)
// from I/d², in lux for I in candela and r in metres. The guards that renderers use against d → 0 are not here.
#pragma once

#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

namespace gonio::shading {

// ⟨1 − (d/r)⁴⟩², as in Frostbite and Unreal Engine 4 (B. Karis, "Real Shading in Unreal Engine 4", 2013). In [0, 1].
// inverse_range = 1/r ≥ 0; 0 gives 1.
template<class S>
GONIO_FORCE_INLINE S window_squared(S distance, S inverse_range) {
    const S x = distance * inverse_range;
    const S x2 = x * x;
    const S w = simd::max(S(1) - x2 * x2, S(0));
    return w * w;
}

// max(min(1 − (d/r)⁴, 1), 0), of KHR_lights_punctual. In [0, 1].
template<class S>
GONIO_FORCE_INLINE S window_gltf(S distance, S inverse_range) {
    const S x = distance * inverse_range;
    const S x2 = x * x;
    return simd::max(S(1) - x2 * x2, S(0));
}

// The range r [m] that gives I/r² = `threshold_lx` at the edge of its squared window: r = √(I/E).
template<class S>
GONIO_FORCE_INLINE S range_of_threshold(S intensity_cd, S threshold_lx) {
    return simd::sqrt(intensity_cd / threshold_lx);
}

// Factor of Frostbite's spot lobe, saturate(cosθ·scale + offset)² with scale = 1/(cos a − cos b) for the inner and
// outer half angles a < b and offset = −cos b·scale; θ is the angle between the aim and the direction from the light.
template<class S>
GONIO_FORCE_INLINE S spot_squared_linear(S cos_theta, S scale, S offset) {
    const S x = simd::min(simd::max(simd::mul_add(cos_theta, scale, offset), S(0)), S(1));
    return x * x;
}

// Spot lobes as functions of the angle θ from the aim, for inner and outer half angles a ≤ b, all in [0, π] radians: 1
// up to a, 0 from b on; each family interpolates differently between them. a = b gives `hard`, which includes its edge.
// They take the angle, not its cosine, which has no digits left in a narrow cone: cosθ − cos b is formed as
// 2 sin((b+θ)/2) sin((b−θ)/2). Their flux is in the room light/.

// θ between the aim (unit) and the direction from the light to the receiver (any length but 0), accurate to the last
// digits for narrow angles: atan2(|a × d|, a·d).
template<class S>
GONIO_FORCE_INLINE S angle_from_aim(vec3<S> aim, vec3<S> from_light) {
    return simd::atan2(length(cross(aim, from_light)), dot(aim, from_light));
}

namespace detail {

// (cosθ − cos b)/(cos a − cos b) in [0, 1]; a step where a = b.
template<class S>
GONIO_FORCE_INLINE S ramp_in_cosine(S theta, S inner, S outer) {
    const S t = simd::max(simd::min(theta, outer), inner);
    const S rise = simd::sin(S(0.5) * (outer + t)) * simd::sin(S(0.5) * (outer - t));
    const S full = simd::sin(S(0.5) * (outer + inner)) * simd::sin(S(0.5) * (outer - inner));
    const S ramp = simd::min(rise * reciprocal_or_zero(full), S(1));
    return simd::select(full > S(0), ramp, simd::select(theta <= outer, S(1), S(0)));
}

// (b − θ)/(b − a) in [0, 1]; a step where a = b.
template<class S>
GONIO_FORCE_INLINE S ramp_in_angle(S theta, S inner, S outer) {
    const S t = simd::max(simd::min(theta, outer), inner);
    const S full = outer - inner;
    const S ramp = simd::min((outer - t) * reciprocal_or_zero(full), S(1));
    return simd::select(full > S(0), ramp, simd::select(theta <= outer, S(1), S(0)));
}

template<class S>
GONIO_FORCE_INLINE S smoothstep(S x) {
    return x * x * (S(3) - S(2) * x);
}

} // namespace detail

// 1 up to the outer half angle, 0 beyond.
template<class S>
GONIO_FORCE_INLINE S lobe_hard(S theta, S /*inner*/, S outer) {
    return simd::select(theta <= outer, S(1), S(0));
}

// Squared, linear in the cosine: Frostbite, glTF, Filament. Omits Frostbite's guard max(0.001, cos a − cos b).
template<class S>
GONIO_FORCE_INLINE S lobe_frostbite(S theta, S inner, S outer) {
    const S x = detail::ramp_in_cosine(theta, inner, outer);
    return x * x;
}

template<class S>
GONIO_FORCE_INLINE S lobe_linear_cos(S theta, S inner, S outer) {
    return detail::ramp_in_cosine(theta, inner, outer);
}

// Smoothstep in the cosine: pbrt, Cycles.
template<class S>
GONIO_FORCE_INLINE S lobe_smoothstep_cos(S theta, S inner, S outer) {
    return detail::smoothstep(detail::ramp_in_cosine(theta, inner, outer));
}

// Linear in the angle: Mitsuba.
template<class S>
GONIO_FORCE_INLINE S lobe_linear_angle(S theta, S inner, S outer) {
    return detail::ramp_in_angle(theta, inner, outer);
}

// Smoothstep in the angle: UsdLux.
template<class S>
GONIO_FORCE_INLINE S lobe_smoothstep_angle(S theta, S inner, S outer) {
    return detail::smoothstep(detail::ramp_in_angle(theta, inner, outer));
}

// 1 inside a frustum with full apex angles 2·half_x and 2·half_y (half angles in [0, π/2)), else 0. The direction from
// the light is in the light's frame, z along the aim; any length.
template<class S>
GONIO_FORCE_INLINE S inside_frustum(vec3<S> from_light, S half_x, S half_y) {
    const auto in_x = simd::abs(from_light.x) * simd::cos(half_x) <= from_light.z * simd::sin(half_x);
    const auto in_y = simd::abs(from_light.y) * simd::cos(half_y) <= from_light.z * simd::sin(half_y);
    return simd::select(simd::both(from_light.z > S(0), simd::both(in_x, in_y)), S(1), S(0));
}

} // namespace gonio::shading
