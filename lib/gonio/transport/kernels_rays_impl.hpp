// The bodies of kernels_rays.hpp, for one scalar. Included only by kernels_rays_<set>.cpp; the rule of
// shading/kernels_impl.hpp applies here too.
#pragma once

#include <gonio/scene/spread.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>
#include <gonio/simd/packet.hpp>
#include <gonio/transport/kernels_rays.hpp>

#include <cstddef>
#include <numbers>

namespace gonio::transport::detail {

using gonio::detail::spread;
using shading::vec3;

// Where a ray enters a sphere, from the miss distance and not from b² − 4ac: far spheres keep their outline. Negative
// where it does not.
template<class S>
GONIO_FORCE_INLINE S entry(S radius, const vec3<S>& to_center, const vec3<S>& direction) {
    const S along = dot(to_center, direction);
    const vec3<S> miss = to_center - direction * along;
    const S half_chord2 = radius * radius - dot(miss, miss);
    const S half_chord = simd::sqrt(simd::max(half_chord2, S(0.0F)));
    return simd::select(half_chord2 >= S(0.0F), along - half_chord, S(-1.0F));
}

// Where a ray enters a capsule: the endless cylinder about its axis, or the ball at the end of it where the ray leaves
// or passes the straight part. From the distance of the two lines, as of spheres. Negative where it does not.
template<class S>
GONIO_FORCE_INLINE S entry(const RayCapsule& capsule, const vec3<S>& to_center, const vec3<S>& direction) {
    const vec3<S> axis = spread<S>(capsule.axis);
    const S radius(capsule.radius);
    const vec3<S> across = cross(direction, axis);
    constexpr float parallel = 1e-8F;
    const S sine2 = dot(across, across);
    const S per_sine2 = S(1.0F) / simd::max(sine2, S(parallel));
    const S apart = dot(to_center, across);
    const S half_chord2 = simd::mul_add(radius, radius, -(apart * apart * per_sine2));
    const S along = (dot(cross(to_center, axis), across) -
                     simd::sqrt(simd::max(half_chord2, S(0.0F)) * simd::max(sine2, S(parallel)))) *
                    per_sine2;
    const S ahead = dot(direction, axis);
    const S center_ahead = dot(to_center, axis);
    // A ray along the axis is in the cylinder from far behind on.
    const S height = simd::select(sine2 > S(parallel), simd::mul_add(along, ahead, -center_ahead), -ahead * S(1e30F));
    const S half_length(capsule.half_length);
    const auto is_beyond = simd::abs(height) > half_length;
    const S end = simd::select(height > S(0.0F), half_length, -half_length);
    const S on_end = entry(radius, mul_add(axis, end, to_center), direction);
    return simd::select(is_beyond, on_end, simd::select(half_chord2 >= S(0.0F), along, S(-1.0F)));
}

// Those of the capsules that rays meet before `nearest`. `from`: where they start, from the point of the targets.
template<class S>
GONIO_FORCE_INLINE void meet_capsules(const RayTargets& targets, const vec3<S>& from, const vec3<S>& direction,
                                      S& nearest, S& target) {
    const std::size_t before = targets.rectangle_count + targets.sphere_count;
    for (std::size_t i = 0; i < targets.capsule_count; ++i) {
        const S distance = entry(targets.capsules[i], spread<S>(targets.capsules[i].center) - from, direction);
        const auto first = simd::both(distance > S(0.0F), distance < nearest);
        nearest = simd::select(first, distance, nearest);
        target = simd::select(first, S(static_cast<float>(before + i)), target);
    }
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
            const vec3<S> center = spread<S>(targets.spheres[i].center);
            const S distance = entry(S(targets.spheres[i].radius), center, direction);
            const auto first = simd::both(distance > S(0.0F), distance < nearest);
            nearest = simd::select(first, distance, nearest);
            target = simd::select(first, S(static_cast<float>(targets.rectangle_count + i)), target);
            on_sphere.note(first, center);
        }
        on_sphere.coordinates(direction * nearest, u, v);
        meet_capsules(targets, vec3<S>{S(0.0F), S(0.0F), S(0.0F)}, direction, nearest, target);
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
            const vec3<S> center = spread<S>(targets.spheres[i].center);
            const S distance = entry(S(targets.spheres[i].radius), center - origin, direction);
            const auto first = simd::both(distance > S(0.0F), distance < nearest);
            nearest = simd::select(first, distance, nearest);
            target = simd::select(first, S(static_cast<float>(targets.rectangle_count + i)), target);
            on_sphere.note(first, center);
        }
        on_sphere.coordinates(mul_add(direction, nearest, origin), u, v);
        meet_capsules(targets, origin, direction, nearest, target);
        packet.store(target, hits.target);
        packet.store(nearest, hits.distance);
        packet.store(u, hits.u);
        packet.store(v, hits.v);
    });
}

template<class S>
void cell_links(const RayCells& cells, const float (&place)[3], const RayFrame& frame, const RayLinks& links) {
    constexpr float to_sides = 0.5F * std::numbers::sqrt2_v<float>; // of a cell's spread, which is that of its corners
    const vec3<S> from = spread<S>(place);
    simd::for_each_packet<simd::Packet<S>>(cells.count, [&](const simd::Packet<S>& packet) {
        const vec3<S> position{packet.load(cells.position[0]), packet.load(cells.position[1]),
                               packet.load(cells.position[2])};
        const vec3<S> normal{packet.load(cells.normal[0]), packet.load(cells.normal[1]), packet.load(cells.normal[2])};
        const S turn = packet.load(cells.spread);
        const vec3<S> to = position - from;
        const S distance2 = dot(to, to);
        const S distance = simd::sqrt(distance2);
        const S per_distance = S(1.0F) / distance;
        const S here = dot(spread<S>(frame.z), to);
        const S there = -dot(normal, to);
        // They see each other if each is above the plane of the other; of a round one the plane that faces the place
        // most.
        const S faces = simd::min(here + packet.load(cells.reach), simd::mul_add(turn, distance, there));
        // The mean of the cosine at a round cell, whose cosines lie close together; 0 where it faces away.
        const S cosine = there * per_distance;
        const S half = simd::max(turn * S(to_sides), S(1e-30F));
        const S raised = simd::max(cosine + half, S(0.0F));
        const S facing = simd::select(cosine >= half, cosine, raised * raised / (half * S(4.0F)));
        const S factor = simd::max(here, S(0.0F)) * per_distance * facing *
                         (packet.load(cells.area_m2) * S(std::numbers::inv_pi_v<float>) / distance2);
        const S whole =
            simd::select(distance2 > packet.load(cells.least2), factor + S(RayLinks::least), S(RayLinks::divided));
        packet.store(simd::select(faces > S(0.0F), whole, S(0.0F)), links.share);
        packet.store(dot(spread<S>(frame.x), to) * per_distance, links.towards[0]);
        packet.store(dot(spread<S>(frame.y), to) * per_distance, links.towards[1]);
        packet.store(here * per_distance, links.towards[2]);
    });
}

extern const RayKernels kernels_rays_scalar;
extern const RayKernels kernels_rays_sse2;
extern const RayKernels kernels_rays_avx2;
extern const RayKernels kernels_rays_avx512;
extern const RayKernels kernels_rays_neon;
extern const RayKernels kernels_rays_wasm128;

} // namespace gonio::transport::detail
