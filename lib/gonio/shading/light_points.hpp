// A few points of a light with their solid angles. The light that a material reflects is a sum over them, if the light
// is small as seen from the receiver or the material changes slowly over it.
//
// Rules of degree 5 over disk and rectangle (A. H. Stroud, "Approximate Calculation of Multiple Integrals", 1971; C. F.
// Gauss), 7 and 9 points; a sphere is the disk within its visible circle. A tube is the visible strip of its cylinder,
// 3 by 2 points, and half a disk at each end, 2 points each. Solid angles are accurate to the order of the rule, and 0
// for what faces away. Points below the horizon are included.
#pragma once

#include <gonio/shading/lights.hpp>
#include <gonio/shading/ltc_lobe.hpp>
#include <gonio/shading/seen_from.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/loop.hpp>

#include <cstddef>
#include <iterator>

namespace gonio::shading::detail {

// Rules are members of templates on the scalar: nothing here may be shared between instruction sets.
template<class Number>
struct RulePointOf {
    Number x, y, weight;
};
using RulePoint = RulePointOf<float>;

// The plane patch center + u·x + v·y; the receiver sees each point under the solid angle dω = strength·weight/|p|³.
template<class S>
struct LightPatch {
    vec3<S> center, u, v;
    S strength; // area times the distance of its plane

    template<class Work, std::size_t count>
    GONIO_FORCE_INLINE void for_each(const RulePoint (&rule)[count], const Work& work) const {
        simd::for_each_of<S>(
            rule, [&](const auto& at) __attribute__((always_inline)) {
                work(center + u * S(at.x) + v * S(at.y), strength * S(at.weight));
            });
    }
};

// A light with all lengths scaled by the same factor. Functions that use a transform or heights expect it in the
// receiver's frame (ltc_frame).
template<class S>
struct DiskPoints {
    static constexpr RulePoint rule[7] = {{0.0F, 0.0F, 0.25F},
                                          {0.81649658F, 0.0F, 0.125F},
                                          {0.40824829F, 0.70710678F, 0.125F},
                                          {-0.40824829F, 0.70710678F, 0.125F},
                                          {-0.81649658F, 0.0F, 0.125F},
                                          {-0.40824829F, -0.70710678F, 0.125F},
                                          {0.40824829F, -0.70710678F, 0.125F}};

    static constexpr std::size_t size = std::size(rule);

    LightPatch<S> patch;

    // How far the light reaches from the centre along the normal.
    GONIO_FORCE_INLINE S rise() const { return simd::sqrt(simd::mul_add(patch.u.z, patch.u.z, patch.v.z * patch.v.z)); }
    // The square of the radius after a lobe's transform.
    template<bool sheared>
    GONIO_FORCE_INLINE S transformed_size2(const LtcLobe<S, sheared>& lobe) const {
        const vec3<S> u = lobe(patch.u);
        const vec3<S> v = lobe(patch.v);
        return dot(u, u) + dot(v, v);
    }
    template<class Work>
    GONIO_FORCE_INLINE void for_each(const Work& work) const {
        patch.for_each(rule, work);
    }
};
// Of the disk within the visible circle of a sphere of angular radius σ: its points are as far away as their places in
// the rule say.
template<class S>
struct CapPoints : DiskPoints<S> {
    S center_distance, ring_distance; // of the rule's first point and of the others, as points_of_cap() scales them
};
template<class S>
struct RectanglePoints {
    static constexpr RulePoint rule[9] = {{-0.77459667F, -0.77459667F, 25.0F / 324},
                                          {0.0F, -0.77459667F, 40.0F / 324},
                                          {0.77459667F, -0.77459667F, 25.0F / 324},
                                          {-0.77459667F, 0.0F, 40.0F / 324},
                                          {0.0F, 0.0F, 64.0F / 324},
                                          {0.77459667F, 0.0F, 40.0F / 324},
                                          {-0.77459667F, 0.77459667F, 25.0F / 324},
                                          {0.0F, 0.77459667F, 40.0F / 324},
                                          {0.77459667F, 0.77459667F, 25.0F / 324}};
    static constexpr std::size_t size = std::size(rule);

    LightPatch<S> patch;

    GONIO_FORCE_INLINE S rise() const { return simd::abs(patch.u.z) + simd::abs(patch.v.z); }
    template<bool sheared>
    GONIO_FORCE_INLINE S transformed_size2(const LtcLobe<S, sheared>& lobe) const {
        const vec3<S> u = lobe(patch.u);
        const vec3<S> v = lobe(patch.v);
        return dot(u, u) + dot(v, v);
    }
    template<class Work>
    GONIO_FORCE_INLINE void for_each(const Work& work) const {
        patch.for_each(rule, work);
    }
};
template<class S>
struct TubePoints {
    static constexpr RulePoint rule[6] = {
        {-0.77459667F, -0.57735027F, 5.0F / 36}, {0.0F, -0.57735027F, 8.0F / 36},
        {0.77459667F, -0.57735027F, 5.0F / 36},  {-0.77459667F, 0.57735027F, 5.0F / 36},
        {0.0F, 0.57735027F, 8.0F / 36},          {0.77459667F, 0.57735027F, 5.0F / 36}};

    static constexpr std::size_t size = std::size(rule) + 4; // and the ends

    LightPatch<S> patch; // u along the axis
    S radius, half;
    vec3<S> end[2];    // the centroids of the half disks
    vec3<S> beside;    // half a radius across
    S end_strength[2]; // of one half disk

    GONIO_FORCE_INLINE S rise() const { return simd::abs(patch.u.z) + radius; }
    template<bool sheared>
    GONIO_FORCE_INLINE S transformed_size2(const LtcLobe<S, sheared>& lobe) const {
        const vec3<S> u = lobe(patch.u);
        const S stretch = lobe.stretch2_across();
        return dot(u, u) + S(2) * radius * radius * stretch;
    }
    template<class Work>
    GONIO_FORCE_INLINE void for_each(const Work& work) const {
        patch.for_each(rule, work);
        for (std::size_t i = 0; i < 2; ++i) {
            work(end[i] + beside, S(0.5) * end_strength[i]);
            work(end[i] - beside, S(0.5) * end_strength[i]);
        }
    }
};

inline constexpr std::size_t most_points = 48; // rows of a tube

// The points of a light of any kind, or RowPoints (lobe_rows.hpp).
template<class S>
struct GatheredPoints {
    vec3<S> at[most_points];
    S strength[most_points];
    std::size_t count;

    template<class Points>
    GONIO_FORCE_INLINE void gather(const Points& points) {
        static_assert(Points::size <= most_points);
        count = 0;
        points.for_each([&](vec3<S> p, S s) __attribute__((always_inline)) {
            at[count] = p;
            strength[count] = s;
            ++count;
        });
    }
    template<class Work>
    GONIO_FORCE_INLINE void for_each(const Work& work) const {
        for (std::size_t i = 0; i < count; ++i)
            work(at[i], strength[i]);
    }
};

inline constexpr double least_distance = 1e-9; // the cube of its square is still a float

// work(l, dω) for each point as a unit direction and the solid angle that it stands for.
template<class S, class Points, class Work>
GONIO_FORCE_INLINE void for_each_direction(const Points& points, const Work& work) {
    points.for_each([&](vec3<S> p, S strength) __attribute__((always_inline)) {
        const S inverse = S(1) / simd::sqrt(simd::max(dot(p, p), S(least_distance * least_distance)));
        work(p * inverse, strength * inverse * inverse * inverse);
    });
}
template<class S, class Work>
requires(!simd::is_recorded<S>) GONIO_FORCE_INLINE
    void for_each_direction(const CapPoints<S>& points, const Work& work) {
    const LightPatch<S>& patch = points.patch;
    const auto inverse = [](S distance) { return S(1) / simd::max(distance, S(least_distance)); };
    const auto direct = [&](const RulePoint& at, S scale, S solid_angle) __attribute__((always_inline)) {
        work((patch.center + patch.u * S(at.x) + patch.v * S(at.y)) * scale, solid_angle * S(at.weight));
    };
    const S to_center = inverse(points.center_distance);
    direct(points.rule[0], to_center, patch.strength * to_center * to_center * to_center);
    const S to_ring = inverse(points.ring_distance);
    const S solid_angle = patch.strength * to_ring * to_ring * to_ring;
    for (std::size_t i = 1; i < points.size; ++i)
        direct(points.rule[i], to_ring, solid_angle);
}

// Scales so that no square exceeds the range of numbers: the centre's largest component, or the light's size where that
// is larger, becomes at most a quarter.
template<class S, class Light>
GONIO_FORCE_INLINE S points_scale(const Light& light, vec3<S> to_center) {
    return S(0.125) * simd::reciprocal_power_of_two(simd::max(largest_component(to_center), largest_size(light)));
}

// The identity: keeps the frame of the input.
struct SameFrame {
    template<class S>
    GONIO_FORCE_INLINE vec3<S> operator()(vec3<S> p) const {
        return p;
    }
};

// About the unit vector `toward`.
template<class S>
GONIO_FORCE_INLINE CapPoints<S> points_of_cap(vec3<S> toward, S sine, S cosine) {
    const TangentFrame<S> frame(toward);
    constexpr double pi = 3.14159265358979323846;
    constexpr double ring2 = 2.0 / 3.0; // of the rule
    return {{{toward * cosine, frame.x * sine, frame.y * sine, S(pi) * sine * sine * cosine}},
            cosine,
            simd::sqrt(simd::mul_add(cosine, cosine, S(ring2) * sine * sine))};
}
template<class S, class Frame>
GONIO_FORCE_INLINE CapPoints<S> points_of(const SphereLight<S>& light, const Frame& frame, vec3<S> to_center) {
    const S scale = points_scale(light, to_center);
    const vec3<S> c = frame(to_center) * scale;
    const S r = simd::abs(light.radius) * scale;
    const S inverse = reciprocal_or_zero(length(c));
    const vec3<S> l = select(inverse > S(0), c * inverse, vec3<S>{S(0), S(0), S(1)});
    const S sine = simd::min(r * inverse, S(1));
    return points_of_cap(l, sine, simd::sqrt((S(1) - sine) * (S(1) + sine)));
}
template<class S, class Frame>
GONIO_FORCE_INLINE CapPoints<S> points_of(const SunLight<S>& light, const Frame& frame, vec3<S> toward) {
    return points_of_cap(frame(toward), light.sine, light.cosine);
}
template<class S, class Frame>
GONIO_FORCE_INLINE DiskPoints<S> points_of(const DiskLight<S>& light, const Frame& frame, vec3<S> to_center) {
    constexpr double pi = 3.14159265358979323846;
    const S scale = points_scale(light, to_center);
    const vec3<S> c = frame(to_center) * scale;
    const vec3<S> axis = frame(light.axis);
    const S r = simd::abs(light.radius) * scale;
    const S depth = -dot(axis, c);
    const TangentFrame<S> across(axis);
    return {
        {c, across.x * r, across.y * r, S(pi) * r * r * (light.two_sided ? simd::abs(depth) : simd::max(depth, S(0)))}};
}
template<class S, class Frame>
GONIO_FORCE_INLINE RectanglePoints<S> points_of(const RectangleLight<S>& light, const Frame& frame, vec3<S> to_center) {
    const S scale = points_scale(light, to_center);
    const vec3<S> c = frame(to_center) * scale;
    const vec3<S> axis = frame(light.axis);
    const vec3<S> x = frame(light.width_direction);
    const S w = S(0.5) * (simd::abs(light.width) * scale);
    const S h = S(0.5) * (simd::abs(light.height) * scale);
    const S depth = -dot(axis, c);
    return {
        {c, x * w, cross(axis, x) * h, S(4) * w * h * (light.two_sided ? simd::abs(depth) : simd::max(depth, S(0)))}};
}
template<class S, class Frame>
GONIO_FORCE_INLINE TubePoints<S> points_of(const TubeLight<S>& light, const Frame& frame, vec3<S> to_center) {
    constexpr double pi = 3.14159265358979323846;
    const S scale = points_scale(light, to_center);
    const vec3<S> c = frame(to_center) * scale;
    const vec3<S> a = frame(light.axis);
    const S r = simd::abs(light.radius) * scale;
    const S half = S(0.5) * (simd::abs(light.length) * scale);
    const S z = dot(a, c);
    const vec3<S> across = c - a * z;
    const S d = length(across);
    const S inverse_d = reciprocal_or_zero(d);
    const vec3<S> f = across * inverse_d;
    const S s = simd::min(r * inverse_d, S(1));
    const S kappa = simd::sqrt((S(1) - s) * (S(1) + s));
    // The strip between the lines where the tangent planes touch.
    const vec3<S> g = cross(a, f);
    const S plane = d * kappa * kappa;
    TubePoints<S> points;
    points.patch = {f * plane + a * z, a * half, g * (r * kappa), S(4) * half * r * kappa * plane};
    points.radius = r;
    points.half = half;
    points.beside = g * (S(0.5) * r);
    const auto end = [&](std::size_t i, S sign) {
        const S along = simd::mul_add(sign, half, z);
        const S distance = simd::sqrt(simd::mul_add(d, d, along * along));
        const vec3<S> out = (a * d - f * along) * (sign * reciprocal_or_zero(distance));
        points.end[i] = f * d + a * along + out * (r * S(4.0 / (3.0 * pi)));
        points.end_strength[i] = S(0.5 * pi) * r * r * distance;
    };
    end(0, S(-1));
    end(1, S(1));
    return points;
}

template<class S, class Light, class Frame>
requires SeenAsAnother<Light, S> GONIO_FORCE_INLINE auto points_of(const Light& light, const Frame& frame,
                                                                   vec3<S> to_center) {
    const auto seen = light.seen_from(to_center);
    return points_of(seen.light, frame, seen.to_center);
}

} // namespace gonio::shading::detail
