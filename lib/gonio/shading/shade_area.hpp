// shade.hpp for disk, rectangle and tube lights: exact illuminance; specular by one point of the light.
//
// Diffuse: the exact irradiance, with the Disney factors taken towards the centre (raised to the horizon when below
// it). Specular: coarse, the representative point of B. Karis, "Real Shading in Unreal Engine 4", 2013, carried over to
// these shapes: the light's point nearest to the mirrored ray takes all of its projected area, the lobe widened by the
// angle of the sphere of the same projected area. It knows no horizon but that of its one point.
#pragma once

#include <gonio/shading/irradiance_disk.hpp>
#include <gonio/shading/irradiance_rectangle.hpp>
#include <gonio/shading/irradiance_tube.hpp>
#include <gonio/shading/shade.hpp>

namespace gonio::shading {

template<class S>
struct DiskLight {
    vec3<S> center;    // [m]
    vec3<S> luminance; // [nt], three channels, of each side that emits
    vec3<S> axis;      // unit, where it emits to
    S radius;          // [m]
    S inverse_range;   // [1/m] of window_squared, by the distance of the centre; 0 = no window
    bool two_sided;
};

template<class S>
struct RectangleLight {
    vec3<S> center;          // [m]
    vec3<S> luminance;       // [nt], three channels, of each side that emits
    vec3<S> axis;            // unit, where it emits to
    vec3<S> width_direction; // unit, perpendicular to the axis
    S width, height;         // [m]
    S inverse_range;         // [1/m]; 0 = no window
    bool two_sided;
};

template<class S>
struct TubeLight {
    vec3<S> center;    // [m]
    vec3<S> luminance; // [nt], three channels
    vec3<S> axis;      // unit
    S radius, length;  // [m], of the cylinder without its round ends
    S inverse_range;   // [1/m]; 0 = no window
};

namespace detail {

template<class S, class Light>
GONIO_FORCE_INLINE vec3<S> facing_axis(const Light& light, vec3<S> to_center) {
    if (!light.two_sided) return light.axis;
    return select(dot(light.axis, to_center) > S(0), light.axis * S(-1), light.axis);
}

template<class S>
GONIO_FORCE_INLINE S irradiance(const DiskLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return irradiance_disk(to_center, light.axis, light.radius, normal, light.two_sided);
}
template<class S>
GONIO_FORCE_INLINE S irradiance(const RectangleLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return irradiance_rectangle(to_center, light.axis, light.width_direction, light.width, light.height, normal,
                                light.two_sided);
}
template<class S>
GONIO_FORCE_INLINE S irradiance(const TubeLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return irradiance_tube(to_center, light.axis, light.radius, light.length, normal);
}

template<class S>
GONIO_FORCE_INLINE Survey<S> survey(const SphereLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return {irradiance_sphere(to_center, light.radius, normal), S(0) > S(1)};
}
template<class S>
GONIO_FORCE_INLINE auto survey(const DiskLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return survey_disk(to_center, light.axis, light.radius, normal, light.two_sided);
}
template<class S>
GONIO_FORCE_INLINE auto survey(const RectangleLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return survey_rectangle(to_center, light.axis, light.width_direction, light.width, light.height, normal,
                            light.two_sided);
}
template<class S>
GONIO_FORCE_INLINE auto survey(const TubeLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    const auto tube = survey_tube(to_center, light.axis, light.radius, light.length, normal);
    return Survey<S>{tube.irradiance, simd::either(tube.hard, tube.end)};
}
template<class S>
GONIO_FORCE_INLINE auto survey_end(const TubeLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return survey_tube_end(to_center, light.axis, light.radius, light.length, normal);
}

// The same where the sphere about the light is above the horizon; hard are the lanes that `survey` should be asked for.
template<class Light, class S>
GONIO_FORCE_INLINE auto survey_above(const Light& light, vec3<S> to_center, vec3<S> normal) {
    return survey(light, to_center, normal);
}
template<class S>
GONIO_FORCE_INLINE Survey<S> survey_above(const SphereLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return {SphereAbove<S>(direction(to_center, normal), light.radius).irradiance, S(0) > S(1)};
}
template<class S>
GONIO_FORCE_INLINE auto survey_above(const RectangleLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return survey_rectangle_above(to_center, light.axis, light.width_direction, light.width, light.height, normal,
                                  light.two_sided);
}

// One point that stands for the whole light, everything divided by the distance of the centre (and again by that of the
// largest size where this is larger, so that nothing overflows).
template<class S>
struct Representative {
    vec3<S> at;       // from the receiver
    S projected_area; // towards the receiver
    S stretch;        // length of a line light, 0 for others
};

// Where the ray along `mirrored` meets the light's plane; where it does not, below or above its point at the centre's
// distance. From the centre, in the plane.
template<class S>
GONIO_FORCE_INLINE vec3<S> ray_in_plane(vec3<S> center, vec3<S> axis, vec3<S> mirrored) {
    const S toward = dot(center, axis);
    const S speed = dot(mirrored, axis);
    const auto meets = simd::both(toward * speed > S(0), simd::abs(speed) > S(1e-3));
    const S t = simd::select(meets, toward / simd::select(meets, speed, S(1)), length(center));
    const vec3<S> offset = mirrored * t - center;
    return offset - axis * dot(axis, offset);
}

template<class S>
GONIO_FORCE_INLINE Representative<S> representative(const DiskLight<S>& light, vec3<S> center, S scale,
                                                    vec3<S> mirrored) {
    const S r = simd::abs(light.radius) * scale;
    const vec3<S> offset = ray_in_plane(center, light.axis, mirrored);
    const vec3<S> at = center + offset * simd::min(r * reciprocal_or_zero(length(offset)), S(1));
    const S facing = -dot(facing_axis(light, center), normalized(at));
    return {at, S(std::numbers::pi) * r * r * simd::max(facing, S(0)), S(0)};
}

template<class S>
GONIO_FORCE_INLINE Representative<S> representative(const RectangleLight<S>& light, vec3<S> center, S scale,
                                                    vec3<S> mirrored) {
    const S x = S(0.5) * (simd::abs(light.width) * scale);
    const S y = S(0.5) * (simd::abs(light.height) * scale);
    const vec3<S> offset = ray_in_plane(center, light.axis, mirrored);
    const vec3<S> across = cross(light.axis, light.width_direction);
    const S along_x = simd::max(simd::min(dot(offset, light.width_direction), x), -x);
    const S along_y = simd::max(simd::min(dot(offset, across), y), -y);
    const vec3<S> at = center + light.width_direction * along_x + across * along_y;
    const S facing = -dot(facing_axis(light, center), normalized(at));
    return {at, S(4) * x * y * simd::max(facing, S(0)), S(0)};
}

template<class S>
GONIO_FORCE_INLINE Representative<S> representative(const TubeLight<S>& light, vec3<S> center, S scale,
                                                    vec3<S> mirrored) {
    const S r = simd::abs(light.radius) * scale;
    const S l = simd::abs(light.length) * scale;
    // The axis' point nearest to the ray's line, then the point of the sphere about it nearest to the ray.
    const S a_dot_m = dot(light.axis, mirrored);
    const S sine2 = S(1) - a_dot_m * a_dot_m;
    const auto crossing = sine2 > S(1e-4);
    const S foot = (a_dot_m * dot(mirrored, center) - dot(light.axis, center)) / simd::select(crossing, sine2, S(1));
    const S half = S(0.5) * l;
    const S along = simd::max(simd::min(simd::select(crossing, foot, S(0)), half), -half);
    const vec3<S> on_axis = center + light.axis * along;
    const vec3<S> to_ray = mirrored * dot(on_axis, mirrored) - on_axis;
    const vec3<S> at = on_axis + to_ray * simd::min(r * reciprocal_or_zero(length(to_ray)), S(1));
    const S side = length(cross(light.axis, normalized(center)));
    return {at, r * (S(2) * l * side + S(std::numbers::pi) * r), l};
}

template<class S>
GONIO_FORCE_INLINE S largest_size(const SphereLight<S>& light) {
    return simd::abs(light.radius);
}
template<class S>
GONIO_FORCE_INLINE S largest_size(const DiskLight<S>& light) {
    return simd::abs(light.radius);
}
template<class S>
GONIO_FORCE_INLINE S largest_size(const RectangleLight<S>& light) {
    return simd::max(simd::abs(light.width), simd::abs(light.height));
}
template<class S>
GONIO_FORCE_INLINE S largest_size(const TubeLight<S>& light) {
    return simd::max(simd::abs(light.radius), simd::abs(light.length));
}

template<class S, class Light>
GONIO_FORCE_INLINE S area_illuminance(const SurfacePoint<S>& point, const Light& light) {
    const vec3<S> to_center = light.center - point.position;
    return irradiance(light, to_center, point.normal) * window(to_center, light.inverse_range);
}

template<class S, class Light>
GONIO_FORCE_INLINE Incidence<S> incidence_area(const SurfacePoint<S>& point, const Light& light, S alpha) {
    const vec3<S> n = point.normal;
    const vec3<S> v = point.view;
    const vec3<S> to_center = light.center - point.position;
    const S faded = window(to_center, light.inverse_range);
    const Direction<S> d = direction(to_center, n);
    const vec3<S> l = d.scaled * d.inverse_distance;
    const vec3<S> raised = normalized(l - n * simd::min(d.n_dot_l, S(0)));

    const S scale =
        S(0.125) * simd::reciprocal_power_of_two(simd::max(largest_component(to_center), largest_size(light)));
    const vec3<S> mirrored = n * (S(2) * dot(n, v)) - v;
    const Representative<S> point_of_light = representative(light, to_center * scale, scale, mirrored);
    const S distance2 = dot(point_of_light.at, point_of_light.at);
    // No solid angle above that of the sphere it touches.
    const S solid_angle = simd::min(point_of_light.projected_area * reciprocal_or_zero(distance2), S(std::numbers::pi));
    const vec3<S> toward = normalized(point_of_light.at);
    const S sine = simd::sqrt(solid_angle * S(std::numbers::inv_pi));
    const S stretch =
        simd::min(alpha + point_of_light.stretch * simd::sqrt(reciprocal_or_zero(distance2)) * S(1.0 / 3.0), S(1));
    const S strength = solid_angle * simd::max(dot(n, toward), S(0)) * (alpha / simd::max(stretch, alpha)) * faded;
    return {irradiance(light, to_center, n) * faded, strength, raised, toward, sine * S(1.0 / 3.0)};
}

} // namespace detail

// Illuminance [lx] for a luminance of 1 nt: E/L times the window.
template<class S>
GONIO_FORCE_INLINE S illuminance(const SurfacePoint<S>& point, const DiskLight<S>& light) {
    return detail::area_illuminance(point, light);
}
template<class S>
GONIO_FORCE_INLINE S illuminance(const SurfacePoint<S>& point, const RectangleLight<S>& light) {
    return detail::area_illuminance(point, light);
}
template<class S>
GONIO_FORCE_INLINE S illuminance(const SurfacePoint<S>& point, const TubeLight<S>& light) {
    return detail::area_illuminance(point, light);
}

// What a material is asked with, for a lobe of `alpha`.
template<class S>
GONIO_FORCE_INLINE Incidence<S> incidence(const SurfacePoint<S>& point, const DiskLight<S>& light, S alpha) {
    return detail::incidence_area(point, light, alpha);
}
template<class S>
GONIO_FORCE_INLINE Incidence<S> incidence(const SurfacePoint<S>& point, const RectangleLight<S>& light, S alpha) {
    return detail::incidence_area(point, light, alpha);
}
template<class S>
GONIO_FORCE_INLINE Incidence<S> incidence(const SurfacePoint<S>& point, const TubeLight<S>& light, S alpha) {
    return detail::incidence_area(point, light, alpha);
}

} // namespace gonio::shading
