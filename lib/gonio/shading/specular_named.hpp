// The specular luminance of an area light from one direction, by the methods of other renderers: kept for comparison
// with ltc.
//
// All evaluate GGX once, towards one point, with the light's whole solid angle; none accounts for the part that the
// horizon cuts off. README.md gives their errors.
//
// * representative-point (B. Karis, "Real Shading in Unreal Engine 4", 2013): the light's point nearest to the mirrored
//   ray, α widened by a third of the light's angle, the peak lowered as if the lobe kept its own width; for a line, the
//   peak is also multiplied by α/(α + l/3d).
// * dominant-direction (S. Lagarde and C. de Rousiers, 2014): the same with the ray lerp(n, mirrored, 1 − √α): rough
//   lobes lean towards the normal.
// * specular-d (Karis 2013, before it was replaced): towards the centre, α widened by a third of the light's angle, the
//   lobe normalised again.
// * spherical-hack (the idea of SpecularPowerHack in "The Art of Remember Me", S. Lagarde and L. Harduin, 2013):
//   towards the centre, Blinn's power lowered so that the lobe's variance grows by that of the half vector over the
//   light's disk, s²/16 in each direction. The power replaces α by p + 2 = 2/α².
// * sun-disk (Lagarde and de Rousiers 2014): the point of the light's disk closest to the mirrored ray, nothing is
//   widened.
#pragma once

#include <gonio/shading/gloss.hpp>
#include <gonio/shading/lights.hpp>
#include <gonio/shading/specular_ltc.hpp>
#include <gonio/shading/specular_method.hpp>

#include <numbers>

namespace gonio::shading {

// A narrow lobe with a method that does not widen it may exceed the light's own luminance by any factor.
inline constexpr double specular_ceiling = 1e30;

// The direction within a disk about `toward` of angular radius `sine` that is closest to `ray`; all unit.
template<class S>
GONIO_FORCE_INLINE vec3<S> sun_disk_direction(vec3<S> toward, S sine, vec3<S> ray) {
    const S s = simd::min(sine, S(1));
    const S cosine = simd::sqrt((S(1) - s) * (S(1) + s));
    const S along = dot(toward, ray);
    const vec3<S> rim = normalized(toward * cosine + normalized(ray - toward * along) * s);
    return select(along < cosine, rim, ray);
}

namespace detail {

// One point that represents the whole light, everything divided by the distance of the centre (and also by the largest
// size where this is larger, so that nothing overflows).
template<class S>
struct Representative {
    vec3<S> at;       // from the receiver
    S projected_area; // projected towards the receiver
    S stretch;        // length of a line light, 0 for others
};

// Where the ray along `mirrored` meets the light's plane; where it does not, the plane's point below or above the ray's
// point at the centre's distance. Relative to the centre, in the plane.
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
    // The axis' point nearest to the ray's line, then the point nearest to the ray on the sphere about it.
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

// The sphere's point nearest to the ray, at the distance of its centre.
template<class S>
GONIO_FORCE_INLINE Representative<S> representative(const SphereLight<S>& light, vec3<S> center, S scale,
                                                    vec3<S> mirrored) {
    const S r = simd::abs(light.radius) * scale;
    const vec3<S> to_ray = mirrored * dot(center, mirrored) - center;
    const vec3<S> nearest = center + to_ray * simd::min(r * reciprocal_or_zero(length(to_ray)), S(1));
    return {normalized(nearest) * length(center), S(std::numbers::pi) * r * r, S(0)};
}
template<class S>
GONIO_FORCE_INLINE Representative<S> representative(const SunLight<S>& light, vec3<S> toward, S scale,
                                                    vec3<S> mirrored) {
    return representative(SphereLight<S>{toward, light.luminance, light.sine, S(0)}, toward, scale, mirrored);
}

// One direction that represents the light.
template<class S>
struct Approach {
    vec3<S> toward; // unit
    S solid_angle;  // at most π
    S sine;         // of the angular radius of a sphere of that solid angle
    S stretch;      // a line's length over its distance
};

template<class S, class Light>
GONIO_FORCE_INLINE Approach<S> approach(const Light& light, vec3<S> to_center, vec3<S> ray) {
    const S scale =
        S(0.125) * simd::reciprocal_power_of_two(simd::max(largest_component(to_center), largest_size(light)));
    const Representative<S> point = representative(light, to_center * scale, scale, ray);
    constexpr double least = 1e-30;
    const S distance2 = simd::max(dot(point.at, point.at), S(least));
    const S solid_angle = simd::min(point.projected_area / distance2, S(std::numbers::pi));
    return {normalized(point.at), solid_angle, simd::sqrt(solid_angle * S(std::numbers::inv_pi)),
            point.stretch / simd::sqrt(distance2)};
}

} // namespace detail

// A lobe (gloss.hpp) under a light, by one of the methods. `normal` and `view` are unit; `to_center` leads from the
// receiver to the light's centre. 0 where n·v is not positive. Light is any light with a size, or a
// SunLight; its window is not applied. Finite and not negative for any finite input.
template<SpecularMethod method, class S, class Light, template<class> class Lobe>
GONIO_FORCE_INLINE SpecularLuminance<S> specular_by(const Light& light, vec3<S> to_center, vec3<S> normal, vec3<S> view,
                                                    const Lobe<S>& lobe) {
    if constexpr (method == SpecularMethod::ltc) return specular_ltc(light, to_center, normal, view, lobe);
    const S a = lobe.alpha;
    const vec3<S> mirrored = normal * (S(2) * dot(normal, view)) - view;
    const auto unit_center = [&] {
        return normalized(to_center * simd::reciprocal_power_of_two(largest_component(to_center)));
    };
    vec3<S> ray = mirrored;
    if constexpr (method == SpecularMethod::dominant_direction)
        ray = normalized(normal + (mirrored - normal) * (S(1) - simd::sqrt(a)));
    if constexpr (method == SpecularMethod::specular_d || method == SpecularMethod::spherical_hack ||
                  method == SpecularMethod::sun_disk)
        ray = unit_center();
    const detail::Approach<S> light_at = detail::approach(light, to_center, ray);
    vec3<S> toward = light_at.toward;
    S widened = a;
    S peak = S(1); // of the lobe, relative to the α²/widened² of a normalised lobe
    S cosine = dot(normal, toward);
    if constexpr (method == SpecularMethod::representative_point || method == SpecularMethod::dominant_direction) {
        widened = simd::min(simd::mul_add(light_at.sine, S(1.0 / 3.0), a), S(1));
        peak = a / simd::min(simd::mul_add(light_at.stretch, S(1.0 / 3.0), a), S(1));
    }
    if constexpr (method == SpecularMethod::specular_d) {
        widened = simd::min(simd::mul_add(light_at.sine, S(1.0 / 3.0), a), S(1));
        peak = (widened / a) * (widened / a);
    }
    if constexpr (method == SpecularMethod::spherical_hack) {
        // 1/p = α²/2 except for the 2, so α'² = α² + s²/8.
        const S s2 = light_at.sine * light_at.sine;
        widened = simd::min(simd::sqrt(simd::mul_add(s2, S(1.0 / 8.0), a * a)), S(1));
        peak = (widened / a) * (widened / a);
    }
    if constexpr (method == SpecularMethod::sun_disk) toward = sun_disk_direction(toward, light_at.sine, mirrored);
    const SpecularTerms<S> terms = lobe(normal, toward, view, widened);
    const S scale = terms.scale * peak * light_at.solid_angle * simd::max(cosine, S(0));
    return {simd::min(simd::max(scale, S(0)), S(specular_ceiling)), simd::min(terms.grazing, S(1))};
}

template<SpecularMethod method, class S, class Light, template<class> class Lobe>
requires SeenAsAnother<Light, S> GONIO_FORCE_INLINE SpecularLuminance<S>
specular_by(const Light& light, vec3<S> to_center, vec3<S> normal, vec3<S> view, const Lobe<S>& lobe) {
    const auto seen = light.seen_from(to_center);
    return specular_by<method>(seen.light, seen.to_center, normal, view, lobe);
}

// GGX of α, clamped to [minimum_alpha, 1].
template<SpecularMethod method, class S, class Light>
GONIO_FORCE_INLINE SpecularLuminance<S> specular_by(const Light& light, vec3<S> to_center, vec3<S> normal, vec3<S> view,
                                                    S alpha) {
    const GgxLobe<S> lobe{simd::min(simd::max(alpha, S(minimum_alpha)), S(1))};
    return specular_by<method>(light, to_center, normal, view, lobe);
}

} // namespace gonio::shading
