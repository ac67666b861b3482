// The irradiance of disks, rectangles and tubes as renderers approximate it, kept for comparison with the exact forms.
//
// Arguments are those of irradiance_disk, irradiance_rectangle and irradiance_tube. The listings are those of "Moving
// Frostbite to Physically Based Rendering" (S. Lagarde and C. de Rousiers, course notes 2014) with the printed errors
// corrected: balanced parentheses and one clamp per point, the solid angle by arctangents, guards where the receiver
// lies on the light. Never NaN nor negative where the square of the distance is a finite number other than 0; not
// limited to π unless stated.
#pragma once

#include <gonio/shading/irradiance_sphere_named.hpp>
#include <gonio/shading/outline.hpp>

namespace gonio::shading {

namespace detail {

// The solid angle of the triangle of three unit vectors, signed: A. van Oosterom and J. Strackee, "The Solid Angle of a
// Plane Triangle", 1983.
template<class S>
GONIO_FORCE_INLINE S solid_angle(vec3<S> a, vec3<S> b, vec3<S> c) {
    return S(2) * simd::atan2(dot(a, cross(b, c)), S(1) + dot(a, b) + dot(b, c) + dot(c, a));
}

// Frostbite's rectangle: its solid angle times the mean of ⟨n·l⟩ over the corners and the centre. x and y are half
// edges.
template<class S>
GONIO_FORCE_INLINE S five_points(vec3<S> center, vec3<S> x, vec3<S> y, vec3<S> normal) {
    const vec3<S> corner[4] = {normalized(center - x - y), normalized(center - x + y), normalized(center + x + y),
                               normalized(center + x - y)};
    S cosines = simd::max(dot(normalized(center), normal), S(0));
    for (const vec3<S>& each : corner)
        cosines = cosines + simd::max(dot(each, normal), S(0));
    const S omega = simd::abs(solid_angle(corner[0], corner[1], corner[2])) +
                    simd::abs(solid_angle(corner[0], corner[2], corner[3]));
    return omega * S(0.2) * cosines;
}

// A finite sum if it is not negative, or 0 for a NaN.
template<class S>
GONIO_FORCE_INLINE S not_negative(S x) {
    return simd::max(x, S(0));
}

} // namespace detail

// Intensity π r²⟨a·−l⟩ by the inverse square, as if at the centre: within 1 % from five diameters on ("five times
// rule").
template<class S>
GONIO_FORCE_INLINE S irradiance_disk_point(vec3<S> center, vec3<S> axis, S radius, vec3<S> normal) {
    const Direction<S> d = direction(center, normal);
    const S s = radius * d.scale * d.inverse_distance;
    const S facing = simd::max(-dot(axis, d.scaled) * d.inverse_distance, S(0));
    return detail::not_negative(S(std::numbers::pi) * s * s * facing * simd::max(d.n_dot_l, S(0)));
}

// The merged sphere-or-disk cap, as if the disk faced the receiver (then it is exact), times ⟨a·−l⟩. In [0, π].
template<class S>
GONIO_FORCE_INLINE S irradiance_disk_frostbite(vec3<S> center, vec3<S> axis, S radius, vec3<S> normal) {
    const S square_distance = dot(center, center);
    const S r2 = radius * radius;
    const vec3<S> l = normalized(center);
    return detail::frostbite_cap(dot(normal, l), r2 * reciprocal_or_zero(r2 + square_distance)) *
           simd::max(-dot(axis, l), S(0));
}

// Intensity w h ⟨a·−l⟩ by the inverse square, as if at the centre.
template<class S>
GONIO_FORCE_INLINE S irradiance_rectangle_point(vec3<S> center, vec3<S> axis, vec3<S> /*width_direction*/, S width,
                                                S height, vec3<S> normal) {
    const Direction<S> d = direction(center, normal);
    const S inverse = d.scale * d.inverse_distance;
    const S facing = simd::max(-dot(axis, d.scaled) * d.inverse_distance, S(0));
    return detail::not_negative((width * inverse) * (height * inverse) * facing * simd::max(d.n_dot_l, S(0)));
}

// Solid angle times the mean of ⟨n·l⟩ over five points; 0 behind the plane.
template<class S>
GONIO_FORCE_INLINE S irradiance_rectangle_frostbite(vec3<S> center, vec3<S> axis, vec3<S> width_direction, S width,
                                                    S height, vec3<S> normal) {
    const vec3<S> x = width_direction * (S(0.5) * width);
    const vec3<S> y = cross(axis, width_direction) * (S(0.5) * height);
    const S e = detail::five_points(center, x, y, normal);
    return simd::select(dot(axis, center) < S(0), detail::not_negative(e), S(0));
}

// Intensity (2 r l sinγ + π r²), γ measured from the axis, by the inverse square, as if at the centre.
template<class S>
GONIO_FORCE_INLINE S irradiance_tube_point(vec3<S> center, vec3<S> axis, S radius, S length_m, vec3<S> normal) {
    const Direction<S> d = direction(center, normal);
    const S inverse = d.scale * d.inverse_distance;
    const S side = length(cross(axis, d.scaled)) * d.inverse_distance;
    const S r = radius * inverse;
    const S area = r * (S(2) * (length_m * inverse) * side + S(std::numbers::pi) * r);
    return detail::not_negative(area * simd::max(d.n_dot_l, S(0)));
}

// A rectangle of the tube's length and diameter turned to face the receiver, plus the sphere at the nearest point of
// the axis as a point light at a distance of at least the radius.
template<class S>
GONIO_FORCE_INLINE S irradiance_tube_frostbite(vec3<S> center, vec3<S> axis, S radius, S length_m, vec3<S> normal) {
    const S half = S(0.5) * length_m;
    const S along = dot(axis, center);
    const vec3<S> to_line = center - axis * along;
    const vec3<S> y = normalized(cross(axis, to_line)) * radius;
    const S rectangle = detail::five_points(center, axis * half, y, normal);
    const vec3<S> nearest = center + axis * simd::max(simd::min(-along, half), -half);
    const S r2 = radius * radius;
    const S share = r2 * reciprocal_or_zero(simd::max(dot(nearest, nearest), r2));
    const S sphere = S(std::numbers::pi) * share * simd::max(dot(normalized(nearest), normal), S(0));
    return detail::not_negative(rectangle + sphere);
}

// The isotropic line of B. Karis, "Real Shading in Unreal Engine 4", 2013, with the tube's flux, that is, the intensity
// I = π r (l + 2r)/2 in every direction: I ½(n·p0/|p0| + n·p1/|p1|)·2/(|p0||p1| + p0·p1), p0 and p1 being the axis'
// ends; exact for such a line above the horizon. The listing, in centimetres, adds a guard of 1 to the denominator;
// this code does not.
template<class S>
GONIO_FORCE_INLINE S irradiance_tube_ue4(vec3<S> center, vec3<S> axis, S radius, S length_m, vec3<S> normal) {
    const vec3<S> half = axis * (S(0.5) * length_m);
    const vec3<S> p0 = center - half;
    const vec3<S> p1 = center + half;
    const S cosines = simd::max(dot(normal, normalized(p0)) + dot(normal, normalized(p1)), S(0));
    const S spread = length(p0) * length(p1) + dot(p0, p1);
    const S intensity = S(std::numbers::pi / 2.0) * radius * (length_m + S(2) * radius);
    return detail::not_negative(intensity * cosines * reciprocal_or_zero(simd::max(spread, S(0))));
}

} // namespace gonio::shading
