// The irradiance of every area light by the approximations of other renderers, under one name for all.
#pragma once

#include <gonio/shading/irradiance_cylinder.hpp>
#include <gonio/shading/irradiance_named.hpp>
#include <gonio/shading/irradiance_sphere_named.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/shading/lights.hpp>

namespace gonio::shading::detail {

// E/L of one side. If the method has no form for the shape, that of a point light.
template<class S, Approximation method>
GONIO_FORCE_INLINE S approximate(const SphereLight<S>& light, vec3<S> center, vec3<S> n) {
    if constexpr (method == Approximation::frostbite) return irradiance_sphere_frostbite(center, light.radius, n);
    if constexpr (method == Approximation::ue4) return irradiance_sphere_ue4(center, light.radius, n);
    return irradiance_sphere_point(center, light.radius, n);
}
template<class S, Approximation method>
GONIO_FORCE_INLINE S approximate(const DiskLight<S>& light, vec3<S> center, vec3<S> n) {
    if constexpr (method == Approximation::frostbite)
        return irradiance_disk_frostbite(center, light.axis, light.radius, n);
    return irradiance_disk_point(center, light.axis, light.radius, n);
}
template<class S, Approximation method>
GONIO_FORCE_INLINE S approximate(const RectangleLight<S>& light, vec3<S> center, vec3<S> n) {
    if constexpr (method == Approximation::frostbite)
        return irradiance_rectangle_frostbite(center, light.axis, light.width_direction, light.width, light.height, n);
    return irradiance_rectangle_point(center, light.axis, light.width_direction, light.width, light.height, n);
}
template<class S, Approximation method>
GONIO_FORCE_INLINE S approximate(const TubeLight<S>& light, vec3<S> center, vec3<S> n) {
    if constexpr (method == Approximation::frostbite)
        return irradiance_tube_frostbite(center, light.axis, light.radius, light.length, n);
    if constexpr (method == Approximation::ue4)
        return irradiance_tube_ue4(center, light.axis, light.radius, light.length, n);
    return irradiance_tube_point(center, light.axis, light.radius, light.length, n);
}

template<class S, Approximation method>
GONIO_FORCE_INLINE S approximate(const CylinderLight<S>& light, vec3<S> center, vec3<S> n) {
    return irradiance_cylinder_point(center, light.axis, light.radius, light.length, n);
}

// A light that the methods treat as another light: an ellipse counts as the disk of its area.
template<class S, Approximation method, class Light>
requires requires(const Light& light) {
    light.approximated();
}
GONIO_FORCE_INLINE S approximate(const Light& light, vec3<S> center, vec3<S> n) {
    return approximate<S, method>(light.approximated(), center, n);
}

} // namespace gonio::shading::detail
