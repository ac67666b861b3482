// One surface point lit by one light: illuminance and outgoing luminance, as templates on the scalar.
//
// With double this is the truth that the kernels are tested against and what numbers are probed with; with packs it is
// what kernels.cpp runs. Light and material are types, so each pair is its own straight code.
// Results are finite and not negative for any finite input; illuminance ends at `illuminance_ceiling`.
#pragma once

#include <gonio/shading/brdf_frostbite.hpp>
#include <gonio/shading/brdf_lambert.hpp>
#include <gonio/shading/direction.hpp>
#include <gonio/shading/falloff.hpp>
#include <gonio/shading/irradiance_sphere.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

#include <numbers>

namespace gonio::shading {

template<class S>
struct SurfacePoint {
    vec3<S> position; // [m]
    vec3<S> normal;   // unit
    vec3<S> view;     // unit, towards the eye; not read for Lambert
};

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

// What a BRDF is asked with: the light's direction and strength, split into the irradiance that the diffuse part
// receives and the one that the specular part does.
template<class S>
struct Incidence {
    S diffuse;               // [lx] per unit of the light's colour
    S specular;              // the same, for the lobe that is widened as below
    vec3<S> diffuse_toward;  // unit, n·l ≥ 0
    vec3<S> specular_toward; // unit
    S lobe_widening;         // what is added to α
};

template<class S>
GONIO_FORCE_INLINE vec3<S> reflect_frostbite(const SurfacePoint<S>& point, const Frostbite<S>& material,
                                             const Incidence<S>& light) {
    const vec3<S> n = point.normal;
    const vec3<S> v = point.view;
    const S n_dot_v = dot(n, v);
    const auto seen = n_dot_v > S(0);
    const vec3<S> l = light.diffuse_toward;
    const S l_dot_h = simd::min(simd::max(dot(l, normalized(l + v)), S(0)), S(1));
    const S diffuse = diffuse_frostbite(simd::max(dot(n, l), S(0)), n_dot_v, l_dot_h, material.linear_roughness);
    const S of_diffuse = simd::select(seen, diffuse * light.diffuse, S(0));

    const S alpha = simd::max(material.alpha, S(minimum_alpha));
    const S widened = simd::min(alpha + light.lobe_widening, S(1));
    const SpecularTerms<S> specular = specular_ggx(n, light.specular_toward, v, alpha, widened);
    const S of_specular = specular.scale * light.specular;
    const auto channel = [&](S albedo, S f0) {
        return simd::mul_add(albedo, of_diffuse, of_specular * simd::mul_add(material.f90 - f0, specular.grazing, f0));
    };
    return {channel(material.albedo.x, material.f0.x), channel(material.albedo.y, material.f0.y),
            channel(material.albedo.z, material.f0.z)};
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

// Outgoing luminance [nt] of the three channels.
template<class S>
GONIO_FORCE_INLINE vec3<S> shade(const SurfacePoint<S>& point, const PunctualLight<S>& light,
                                 const Lambert<S>& material) {
    return detail::finite(material.albedo * light.color * (illuminance(point, light) * S(std::numbers::inv_pi)));
}

template<class S>
GONIO_FORCE_INLINE vec3<S> shade(const SurfacePoint<S>& point, const SphereLight<S>& light,
                                 const Lambert<S>& material) {
    return detail::finite(material.albedo * light.luminance * (illuminance(point, light) * S(std::numbers::inv_pi)));
}

template<class S>
GONIO_FORCE_INLINE vec3<S> shade(const SurfacePoint<S>& point, const PunctualLight<S>& light,
                                 const Frostbite<S>& material) {
    const Direction<S> d = direction(light.position - point.position, point.normal);
    const vec3<S> l = d.scaled * d.inverse_distance;
    const S lx = illuminance(point, light);
    return detail::finite(light.color * detail::reflect_frostbite(point, material, {lx, lx, l, l, S(0)}));
}

// Diffuse: the exact irradiance, with the Disney factors taken towards the centre (raised to the horizon when below
// it). Specular: the representative point of B. Karis, "Real Shading in Unreal Engine 4", 2013: the point of the sphere
// nearest to the mirrored ray, α widened by r/(3d). Inside the sphere its strength stays that of d = r. README.md gives
// its error, which is large for smooth surfaces.
template<class S>
GONIO_FORCE_INLINE vec3<S> shade(const SurfacePoint<S>& point, const SphereLight<S>& light,
                                 const Frostbite<S>& material) {
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

    const detail::Incidence<S> incidence{irradiance_sphere(d, light.radius) * faded,
                                         S(std::numbers::pi) * s * s * n_dot_nearest * faded, raised, nearest,
                                         s * S(1.0 / 3.0)};
    return detail::finite(light.luminance * detail::reflect_frostbite(point, material, incidence));
}

} // namespace gonio::shading
