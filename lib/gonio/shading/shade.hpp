// One surface point lit by one light: illuminance and outgoing luminance, as templates on the scalar.
//
// With double this is the truth that the kernels are tested against and what numbers are probed with; with packs it is
// what kernels.cpp runs. Light and material are types, so each pair is its own straight code.
// Results are finite and not negative for any finite input; illuminance ends at `illuminance_ceiling`.
#pragma once

#include <gonio/shading/direction.hpp>
#include <gonio/shading/falloff.hpp>
#include <gonio/shading/irradiance_sphere.hpp>
#include <gonio/shading/reflect.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

#include <numbers>

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

// Takes the place of I/d² → ∞ where a point light lies on the surface, and of products beyond the range of float.
inline constexpr double illuminance_ceiling = 1e30; // [lx]

namespace detail {

// A sum or product of finite terms that are not negative, whatever overflow made of it.
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

} // namespace detail

namespace detail {

template<class S>
GONIO_FORCE_INLINE vec3<S> color_of(const PunctualLight<S>& light) {
    return light.color;
}
template<class S, class AreaLight>
GONIO_FORCE_INLINE vec3<S> color_of(const AreaLight& light) {
    return light.luminance;
}

} // namespace detail

// Illuminance [lx]: I⟨n·l⟩/d². 0 where the light lies on the point, which leaves it without a direction.
template<class S>
GONIO_FORCE_INLINE S illuminance(const SurfacePoint<S>& point, const PunctualLight<S>& light) {
    const vec3<S> to_light = light.position - point.position;
    const Direction<S> d = direction(to_light, point.normal);
    const S inverse_distance = d.scale * d.inverse_distance;
    const S cosine = simd::max(d.n_dot_l, S(0)) * detail::window(to_light, light.inverse_range);
    return detail::finite(light.intensity_cd * (cosine * inverse_distance * inverse_distance));
}

// Illuminance [lx] for a luminance of 1 nt: E/L times the window.
template<class S>
GONIO_FORCE_INLINE S illuminance(const SurfacePoint<S>& point, const SphereLight<S>& light) {
    const vec3<S> to_center = light.center - point.position;
    return irradiance_sphere(to_center, light.radius, point.normal) * detail::window(to_center, light.inverse_range);
}

// Outgoing luminance [nt] of the three channels; Lambert's does not read the view.
template<class S, class Light>
GONIO_FORCE_INLINE vec3<S> shade(const SurfacePoint<S>& point, const Light& light, const Lambert<S>& material) {
    return detail::finite(material.albedo * detail::color_of<S>(light) *
                          (illuminance(point, light) * S(std::numbers::inv_pi)));
}

// What `reflect` is asked with; `alpha` is that of the lobe that is lit.
template<class S>
GONIO_FORCE_INLINE Incidence<S> incidence(const SurfacePoint<S>& point, const PunctualLight<S>& light, S /*alpha*/) {
    const Direction<S> d = direction(light.position - point.position, point.normal);
    const vec3<S> l = d.scaled * d.inverse_distance;
    const S lx = illuminance(point, light);
    return {lx, lx, l, l, S(0)};
}

// Diffuse: the exact irradiance, with the factors of direction taken towards the centre (raised to the horizon when
// below it). Specular: the representative point of B. Karis, "Real Shading in Unreal Engine 4", 2013: the point of the
// sphere nearest to the mirrored ray, α widened by r/(3d). Inside the sphere its strength stays that of d = r.
// README.md gives its error, which is large for smooth surfaces.
template<class S>
GONIO_FORCE_INLINE Incidence<S> incidence(const SurfacePoint<S>& point, const SphereLight<S>& light, S /*alpha*/) {
    const vec3<S> n = point.normal;
    const vec3<S> v = point.view;
    const vec3<S> to_center = light.center - point.position;
    const Direction<S> d = direction(to_center, n);
    const S faded = detail::window(to_center, light.inverse_range);
    const vec3<S> l = d.scaled * d.inverse_distance;
    const S s = simd::min(simd::abs(light.radius) * d.scale * d.inverse_distance, S(1));

    const vec3<S> raised = normalized(l - n * simd::min(d.n_dot_l, S(0)));

    const vec3<S> mirrored = n * (S(2) * dot(n, v)) - v;
    const vec3<S> center_to_ray = mirrored * dot(l, mirrored) - l;
    const S share = simd::min(s * reciprocal_or_zero(length(center_to_ray)), S(1));
    const vec3<S> nearest = normalized(l + center_to_ray * share);
    const S n_dot_nearest = simd::max(dot(n, nearest), S(0));

    return {irradiance_sphere(d, light.radius) * faded, S(std::numbers::pi) * s * s * n_dot_nearest * faded, raised,
            nearest, s * S(1.0 / 3.0)};
}

template<class S, class Light, template<class> class Material>
GONIO_FORCE_INLINE vec3<S> shade(const SurfacePoint<S>& point, const Light& light, const Material<S>& material) {
    const Incidence<S> of_light = incidence(point, light, lobe_alpha(material));
    return detail::finite(detail::color_of<S>(light) * detail::reflect(point, material, of_light));
}

// The same, part by part.
template<class S, class Light, template<class> class Material>
GONIO_FORCE_INLINE Reflected<S> shade_parts(const SurfacePoint<S>& point, const Light& light,
                                            const Material<S>& material) {
    const vec3<S> color = detail::color_of<S>(light);
    const Reflected<S> parts = detail::reflect_parts(point, material, incidence(point, light, lobe_alpha(material)));
    return {detail::finite(color * parts.diffuse), detail::finite(color * parts.specular)};
}

} // namespace gonio::shading
