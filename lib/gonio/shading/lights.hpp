// The lights of the core, as a surface point sees each of them: templates on the scalar.
#pragma once

#include <gonio/shading/direction.hpp>
#include <gonio/shading/falloff.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

namespace gonio::shading {

template<class S>
struct PunctualLight {
    vec3<S> position; // [m]
    vec3<S> color;    // weights of a colour of luminance Y = 1
    S intensity_cd;   // towards the surface point
    S inverse_range;  // [1/m] of window_squared; 0 = no window
};

template<class S>
struct SphereLight {
    vec3<S> center;    // [m]
    vec3<S> luminance; // [nt], three channels
    S radius;          // [m]
    S inverse_range;   // [1/m] of window_squared, by the distance of the centre; 0 = no window
};

template<class S>
struct DiskLight {
    vec3<S> center;    // [m]
    vec3<S> luminance; // [nt], three channels, of each side that emits
    vec3<S> axis;      // unit, the direction of emission
    S radius;          // [m]
    S inverse_range;   // [1/m] of window_squared, by the distance of the centre; 0 = no window
    bool two_sided;
};

template<class S>
struct RectangleLight {
    vec3<S> center;          // [m]
    vec3<S> luminance;       // [nt], three channels, of each side that emits
    vec3<S> axis;            // unit, the direction of emission
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
    S radius, length;  // [m]; length of the cylinder without its hemispherical ends
    S inverse_range;   // [1/m]; 0 = no window
};

// A cone of directions with uniform luminance: a disk so far away that it looks the same from every point.
template<class S>
struct SunLight {
    vec3<S> toward;    // unit, from the surface to its middle
    vec3<S> luminance; // [nt], three channels
    S sine, cosine;    // of its angular radius, which is at most π/2
};

// Replaces I/d² → ∞ where a point light lies on the surface, and products beyond the range of float.
inline constexpr double illuminance_ceiling = 1e30; // [lx]

namespace detail {

// A sum or product of finite terms that are not negative, made finite if it overflowed.
template<class S>
GONIO_FORCE_INLINE S finite(S x) {
    return simd::min(simd::max(x, S(0)), S(illuminance_ceiling));
}

template<class S>
GONIO_FORCE_INLINE vec3<S> finite(vec3<S> a) {
    return {finite(a.x), finite(a.y), finite(a.z)};
}

template<class S>
GONIO_FORCE_INLINE S window(vec3<S> to_center, S inverse_range) {
    if (!simd::any(inverse_range > S(0))) return S(1);
    return window_squared(length(to_center), inverse_range);
}

template<class S>
GONIO_FORCE_INLINE vec3<S> color_of(const PunctualLight<S>& light) {
    return light.color;
}
template<class S, class AreaLight>
GONIO_FORCE_INLINE vec3<S> color_of(const AreaLight& light) {
    return light.luminance;
}

// The vector from a receiver to the light's centre [m].
template<class S>
GONIO_FORCE_INLINE vec3<S> way_to(const PunctualLight<S>& light, vec3<S> position) {
    return light.position - position;
}
template<class S, class AreaLight>
GONIO_FORCE_INLINE vec3<S> way_to(const AreaLight& light, vec3<S> position) {
    return light.center - position;
}
template<class S>
GONIO_FORCE_INLINE vec3<S> way_to(const SunLight<S>& light, vec3<S> /*position*/) {
    return light.toward;
}

// The factor of the window.
template<class S, class Light>
GONIO_FORCE_INLINE S faded(const Light& light, vec3<S> to_center) {
    return window(to_center, light.inverse_range);
}
template<class S>
GONIO_FORCE_INLINE S faded(const SunLight<S>& /*light*/, vec3<S> /*to_center*/) {
    return S(1);
}

template<class S, class Light>
GONIO_FORCE_INLINE vec3<S> facing_axis(const Light& light, vec3<S> to_center) {
    if (!light.two_sided) return light.axis;
    return select(dot(light.axis, to_center) > S(0), light.axis * S(-1), light.axis);
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

template<class S>
GONIO_FORCE_INLINE S largest_size(const SunLight<S>& light) {
    return light.sine;
}

} // namespace detail

} // namespace gonio::shading
