// The bodies of kernels_rays.hpp, for one scalar. Included only by kernels_rays_<set>.cpp; the rule of
// shading/kernels_impl.hpp applies here too.
#pragma once

#include <gonio/scene/spread.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>
#include <gonio/simd/packet.hpp>
#include <gonio/transport/kernels_rays.hpp>

#include <cstddef>

namespace gonio::transport::detail {

using gonio::detail::spread;
using shading::vec3;

// Where a ray enters a sphere, from the miss distance and not from b² − 4ac: far spheres keep their outline. Both are
// negative where it does not.
template<class S>
GONIO_FORCE_INLINE S entry(S radius, const vec3<S>& to_center, const vec3<S>& direction, S& exit) {
    const S along = dot(to_center, direction);
    const vec3<S> miss = to_center - direction * along;
    const S half_chord2 = radius * radius - dot(miss, miss);
    const S half_chord = simd::sqrt(simd::max(half_chord2, S(0.0F)));
    exit = simd::select(half_chord2 >= S(0.0F), along + half_chord, S(-1.0F));
    return simd::select(half_chord2 >= S(0.0F), along - half_chord, S(-1.0F));
}

// Whether a ray may enter bounds before `nearest`. It enters the cylinder if the two lines pass each other within its
// radius; of parallel lines both sides are 0. What roundings may add is a share of the distance.
template<class S>
GONIO_FORCE_INLINE auto may_enter(const RayBounds& bounds, const vec3<S>& to_center, const vec3<S>& direction,
                                  S nearest) {
    constexpr float roundings = 2e-6F;
    S exit;
    const S distance = entry(S(bounds.sphere.radius), to_center, direction, exit);
    const vec3<S> across = cross(direction, spread<S>(bounds.axis));
    const S reach = simd::mul_add(S(bounds.radius), simd::sqrt(dot(across, across)),
                                  S(roundings) * simd::sqrt(dot(to_center, to_center)));
    return simd::both(simd::both(exit > S(0.0F), distance < nearest), simd::abs(dot(across, to_center)) <= reach);
}

// Which sphere rays meet first, and where.
template<class S>
struct SphereHit {
    vec3<S> center{S(0.0F), S(0.0F), S(0.0F)};
    decltype(S(0.0F) < S(0.0F)) met = S(0.0F) < S(0.0F);

    template<class Mask>
    GONIO_FORCE_INLINE void note(Mask first, const vec3<S>& of) {
        center = {simd::select(first, of.x, center.x), simd::select(first, of.y, center.y),
                  simd::select(first, of.z, center.z)};
        met = simd::either(met, first);
    }
    GONIO_FORCE_INLINE void coordinates(const vec3<S>& end, S& u, S& v) const {
        if (!simd::any(met)) return;
        const vec3<S> out = end - center;
        u = simd::select(met, simd::atan2(out.y, out.x), u);
        v = simd::select(met, simd::atan2(out.z, simd::sqrt(simd::mul_add(out.x, out.x, out.y * out.y))), v);
    }
};

template<class S>
void first_hits(const RayTargets& targets, const RayFrame& frame, const float* const directions[3], std::size_t count,
                const RayHits& hits) {
    const vec3<S> frame_x = spread<S>(frame.x);
    const vec3<S> frame_y = spread<S>(frame.y);
    const vec3<S> frame_z = spread<S>(frame.z);
    simd::for_each_packet<simd::Packet<S>>(count, [&](const simd::Packet<S>& packet) {
        const vec3<S> direction =
            mul_add(frame_x, packet.load(directions[0]),
                    mul_add(frame_y, packet.load(directions[1]), frame_z * packet.load(directions[2])));
        // A rectangle is met at height/facing, and the nearest one is found without a division: both are at least 0.
        S height(3e38F);
        S facing(1.0F);
        S target(RayHits::nothing);
        S u(0.0F);
        S v(0.0F);
        for (std::size_t i = 0; i < targets.rectangle_count; ++i) {
            const RayRectangle& rectangle = targets.rectangles[i];
            const float sign = rectangle.height < 0.0F ? -1.0F : 1.0F;
            const S its_height(sign * rectangle.height);
            const S its_facing = S(sign) * dot(spread<S>(rectangle.normal), direction);
            const S along_x =
                simd::mul_add(its_height, dot(spread<S>(rectangle.x), direction), S(-rectangle.middle[0]) * its_facing);
            const S along_y =
                simd::mul_add(its_height, dot(spread<S>(rectangle.y), direction), S(-rectangle.middle[1]) * its_facing);
            const auto within = simd::both(simd::abs(along_x) <= S(rectangle.half_size[0]) * its_facing,
                                           simd::abs(along_y) <= S(rectangle.half_size[1]) * its_facing);
            const auto is_nearer = its_height * facing < height * its_facing;
            const auto first = simd::both(simd::both(its_facing > S(0.0F), is_nearer), within);
            height = simd::select(first, its_height, height);
            facing = simd::select(first, its_facing, facing);
            target = simd::select(first, S(static_cast<float>(i)), target);
            u = simd::select(first, along_x, u);
            v = simd::select(first, along_y, v);
        }
        const S per_facing = S(1.0F) / facing;
        S nearest = height * per_facing;
        u = u * per_facing;
        v = v * per_facing;
        SphereHit<S> on_sphere;
        for (std::size_t i = 0; i < targets.sphere_count; ++i) {
            S exit;
            const vec3<S> center = spread<S>(targets.spheres[i].center);
            const S distance = entry(S(targets.spheres[i].radius), center, direction, exit);
            const auto first = simd::both(distance > S(0.0F), distance < nearest);
            nearest = simd::select(first, distance, nearest);
            target = simd::select(first, S(static_cast<float>(targets.rectangle_count + i)), target);
            on_sphere.note(first, center);
        }
        on_sphere.coordinates(direction * nearest, u, v);
        for (std::size_t i = 0; i < targets.bound_count; ++i) {
            const vec3<S> center = spread<S>(targets.bounds[i].sphere.center);
            const auto maybe = may_enter(targets.bounds[i], center, direction, nearest);
            target = simd::select(maybe, S(RayHits::unknown), target);
        }
        packet.store(target, hits.target);
        packet.store(nearest, hits.distance);
        packet.store(u, hits.u);
        packet.store(v, hits.v);
    });
}

template<class S>
void first_hits_of_scattered(const RayTargets& targets, const float* const origins[3], const float* const directions[3],
                             std::size_t count, const RayHits& hits) {
    simd::for_each_packet<simd::Packet<S>>(count, [&](const simd::Packet<S>& packet) {
        const vec3<S> origin{packet.load(origins[0]), packet.load(origins[1]), packet.load(origins[2])};
        const vec3<S> direction{packet.load(directions[0]), packet.load(directions[1]), packet.load(directions[2])};
        // As in first_hits(), where a rectangle is met at height/steepness.
        S height(3e38F);
        S steepness(1.0F);
        S target(RayHits::nothing);
        S u(0.0F);
        S v(0.0F);
        for (std::size_t i = 0; i < targets.rectangle_count; ++i) {
            const RayRectangle& rectangle = targets.rectangles[i];
            const vec3<S> normal = spread<S>(rectangle.normal);
            const S facing = dot(normal, direction);
            const auto is_front = facing < S(0.0F);
            const S above = S(rectangle.height) - dot(normal, origin);
            const S its_height = simd::select(is_front, -above, above);
            const S its_steepness = simd::abs(facing);
            const S along_x =
                simd::mul_add(dot(spread<S>(rectangle.x), direction), its_height,
                              (dot(spread<S>(rectangle.x), origin) - S(rectangle.middle[0])) * its_steepness);
            const S along_y =
                simd::mul_add(dot(spread<S>(rectangle.y), direction), its_height,
                              (dot(spread<S>(rectangle.y), origin) - S(rectangle.middle[1])) * its_steepness);
            const auto within = simd::both(simd::abs(along_x) <= S(rectangle.half_size[0]) * its_steepness,
                                           simd::abs(along_y) <= S(rectangle.half_size[1]) * its_steepness);
            const auto is_nearer = its_height * steepness < height * its_steepness;
            auto first = simd::both(simd::both(its_height > S(0.0F), is_nearer), within);
            if (rectangle.is_solid) first = simd::both(first, is_front);
            const S number = simd::select(is_front, S(static_cast<float>(i)), S(RayHits::back));
            height = simd::select(first, its_height, height);
            steepness = simd::select(first, its_steepness, steepness);
            target = simd::select(first, number, target);
            u = simd::select(first, along_x, u);
            v = simd::select(first, along_y, v);
        }
        const S per_steepness = S(1.0F) / steepness;
        S nearest = height * per_steepness;
        u = u * per_steepness;
        v = v * per_steepness;
        SphereHit<S> on_sphere;
        for (std::size_t i = 0; i < targets.sphere_count; ++i) {
            S exit;
            const vec3<S> center = spread<S>(targets.spheres[i].center);
            const S distance = entry(S(targets.spheres[i].radius), center - origin, direction, exit);
            const auto first = simd::both(distance > S(0.0F), distance < nearest);
            nearest = simd::select(first, distance, nearest);
            target = simd::select(first, S(static_cast<float>(targets.rectangle_count + i)), target);
            on_sphere.note(first, center);
        }
        on_sphere.coordinates(mul_add(direction, nearest, origin), u, v);
        for (std::size_t i = 0; i < targets.bound_count; ++i) {
            const vec3<S> to_center = spread<S>(targets.bounds[i].sphere.center) - origin;
            const auto maybe = may_enter(targets.bounds[i], to_center, direction, nearest);
            target = simd::select(maybe, S(RayHits::unknown), target);
        }
        packet.store(target, hits.target);
        packet.store(nearest, hits.distance);
        packet.store(u, hits.u);
        packet.store(v, hits.v);
    });
}

extern const RayKernels kernels_rays_scalar;
extern const RayKernels kernels_rays_sse2;
extern const RayKernels kernels_rays_avx2;
extern const RayKernels kernels_rays_avx512;
extern const RayKernels kernels_rays_neon;
extern const RayKernels kernels_rays_wasm128;

} // namespace gonio::transport::detail
