// Exact irradiance and illuminance of every area light, under one name for all.
#pragma once

#include <gonio/shading/irradiance_cylinder.hpp>
#include <gonio/shading/irradiance_disk.hpp>
#include <gonio/shading/irradiance_ellipse.hpp>
#include <gonio/shading/irradiance_rectangle.hpp>
#include <gonio/shading/irradiance_sphere.hpp>
#include <gonio/shading/irradiance_tube.hpp>
#include <gonio/shading/lights.hpp>
#include <gonio/shading/reflect.hpp>

#include <numbers>

namespace gonio::shading {

namespace detail {

template<class S>
GONIO_FORCE_INLINE S irradiance(const SphereLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return irradiance_sphere(to_center, light.radius, normal);
}
// A cap of the sky, as in irradiance_sphere.hpp.
template<class S>
GONIO_FORCE_INLINE S irradiance(const SunLight<S>& light, vec3<S> toward, vec3<S> normal) {
    const S c = dot(normal, toward);
    const S s = light.sine;
    const S above = S(std::numbers::pi) * s * s * simd::max(c, S(0));
    const auto cut = simd::abs(c) < s;
    if (!simd::any(cut)) return above;
    const S clipped = simd::max(irradiance_straddling_cap(s, light.cosine, c), S(0));
    return simd::min(simd::select(cut, clipped, above), S(std::numbers::pi));
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
GONIO_FORCE_INLINE S irradiance(const EllipseLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return irradiance_ellipse(light, to_center, normal);
}
template<class S>
GONIO_FORCE_INLINE S irradiance(const TubeLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return irradiance_tube(to_center, light.axis, light.radius, light.length, normal);
}

template<class S>
GONIO_FORCE_INLINE S irradiance(const CylinderLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return irradiance_cylinder(to_center, light.axis, light.radius, light.length, normal);
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
// Hard where the horizon cuts it.
template<class S>
GONIO_FORCE_INLINE Survey<S> survey(const CylinderLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return survey_cylinder_above(to_center, light.axis, light.radius, light.length, normal);
}
template<class S>
GONIO_FORCE_INLINE auto survey_end(const TubeLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return survey_tube_end(to_center, light.axis, light.radius, light.length, normal);
}

// As `survey`, for a horizon that passes between a tube's ends, and for one that cuts a tube well apart from the
// receiver. Hard lanes need `survey`.
template<class S>
GONIO_FORCE_INLINE auto survey_split(const TubeLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return survey_tube_split(to_center, light.axis, light.radius, light.length, normal);
}
template<class S>
GONIO_FORCE_INLINE auto survey_cut(const TubeLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return survey_tube_cut(to_center, light.axis, light.radius, light.length, normal);
}

// The same where the sphere about the light is above the horizon. Hard lanes need `survey`.
template<class Light, class S>
GONIO_FORCE_INLINE auto survey_above(const Light& light, vec3<S> to_center, vec3<S> normal) {
    return survey(light, to_center, normal);
}
template<class S>
GONIO_FORCE_INLINE Survey<S> survey_above(const SphereLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    const SphereAbove<S> uncut(direction(to_center, normal), light.radius);
    return {uncut.irradiance, uncut.is_cut};
}
template<class S>
GONIO_FORCE_INLINE Survey<S> survey_above(const DiskLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return survey_disk_above(to_center, light.axis, light.radius, normal, light.two_sided);
}
template<class S>
GONIO_FORCE_INLINE Survey<S> survey_above(const TubeLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return survey_tube_above(to_center, light.axis, light.radius, light.length, normal);
}
template<class S>
GONIO_FORCE_INLINE auto survey_above(const RectangleLight<S>& light, vec3<S> to_center, vec3<S> normal) {
    return survey_rectangle_above(to_center, light.axis, light.width_direction, light.width, light.height, normal,
                                  light.two_sided);
}

} // namespace detail

// Illuminance [lx] of an area light or a sun with a luminance of 1 nt: E/L times the window.
template<class S, class Light>
GONIO_FORCE_INLINE S illuminance(const SurfacePoint<S>& point, const Light& light) {
    const vec3<S> to_center = detail::way_to(light, point.position);
    return detail::irradiance(light, to_center, point.normal) * detail::faded(light, to_center);
}

} // namespace gonio::shading
