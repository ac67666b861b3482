// The bodies of kernels_camera.hpp, for one scalar: double or simd::doubles. Included only by kernels_camera_<set>.cpp;
// the rule of shading/kernels_impl.hpp applies here too.
//
// The order of operations is GLM's, in CameraRays::ray() and scene/primitives.cpp.
#pragma once

#include <gonio/preview/kernels_camera.hpp>
#include <gonio/scene/spread.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/doubles_math.hpp>
#include <gonio/simd/packet.hpp>

#include <cstddef>

namespace gonio::preview::detail {

using gonio::detail::spread;
using shading::vec3;

template<class S>
GONIO_FORCE_INLINE S dot_as_glm(const vec3<S>& a, const vec3<S>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template<class S>
void directions(const CameraRow& row, std::size_t count, double* const (&direction)[3]) {
    const vec3<S> start = spread<S>(row.start);
    const vec3<S> step = spread<S>(row.step);
    const vec3<S> down = spread<S>(row.down);
    double number[simd::Traits<S>::lanes];
    for (std::size_t lane = 0; lane < simd::Traits<S>::lanes; ++lane)
        number[lane] = static_cast<double>(lane);
    S lane_number;
    simd::load(&number[0], lane_number);
    simd::for_each_packet<simd::Packet<S>>(count, [&](const simd::Packet<S>& packet) {
        const S at = S(row.first) + (S(static_cast<double>(packet.first)) + lane_number);
        const vec3<S> way = start + step * at + down;
        const vec3<S> unit = way * (S(1) / simd::sqrt(dot_as_glm(way, way)));
        packet.store(unit.x, direction[0]);
        packet.store(unit.y, direction[1]);
        packet.store(unit.z, direction[2]);
    });
}

// entry(direction): the distance, or 0 and less for none.
template<class S, class Entry>
GONIO_FORCE_INLINE void meet_by(const CameraRayArrays& rays, double number, double* distance, double* numbers,
                                const Entry& entry) {
    simd::for_each_packet<simd::Packet<S>>(rays.count, [&](const simd::Packet<S>& packet) {
        const S t = entry(
            vec3<S>{packet.load(rays.direction[0]), packet.load(rays.direction[1]), packet.load(rays.direction[2])});
        const S until_now = packet.load(distance);
        const auto is_met = simd::both(t > S(0), t < until_now);
        if (!simd::any(is_met)) return;
        packet.store(simd::select(is_met, t, until_now), distance);
        packet.store(simd::select(is_met, S(number), packet.load(numbers)), numbers);
    });
}

template<class S>
GONIO_FORCE_INLINE S plane_entry(const CameraTarget& plane, const vec3<S>& direction) {
    const S facing = dot_as_glm(direction, spread<S>(plane.normal));
    const auto is_facing = facing < S(0);
    return simd::select(is_facing, S(plane.height) / simd::select(is_facing, facing, S(-1)), S(0));
}

template<class S>
void meet(const CameraTarget& target, const CameraRayArrays& rays, double number, double* distance, double* numbers) {
    const vec3<S> middle = spread<S>(target.middle);
    switch (target.kind) {
    case CameraTarget::Kind::plane:
        return meet_by<S>(rays, number, distance, numbers,
                          [&](const vec3<S>& direction) { return plane_entry(target, direction); });
    case CameraTarget::Kind::panel: {
        const vec3<S> origin = spread<S>(rays.origin);
        return meet_by<S>(rays, number, distance, numbers, [&](const vec3<S>& direction) {
            const S t = plane_entry(target, direction);
            const vec3<S> at = origin + direction * t - middle;
            const auto is_within = simd::both(simd::abs(dot_as_glm(at, spread<S>(target.x))) <= S(target.half_size[0]),
                                              simd::abs(dot_as_glm(at, spread<S>(target.y))) <= S(target.half_size[1]));
            return simd::select(is_within, t, S(0));
        });
    }
    case CameraTarget::Kind::ball:
        break;
    }
    meet_by<S>(rays, number, distance, numbers, [&](const vec3<S>& direction) {
        const S along = dot_as_glm(middle, direction);
        const vec3<S> miss = middle - direction * along;
        const S half_chord2 = S(target.radius) * S(target.radius) - dot_as_glm(miss, miss);
        const auto is_met = half_chord2 >= S(0);
        return simd::select(is_met, along - simd::sqrt(simd::select(is_met, half_chord2, S(0))), S(0));
    });
}

// Loops that compilers turn into packs of the set.
template<class S>
void positions(const CameraRayArrays& rays, const double* distance, const double (&anchor)[3],
               float* const (&position)[3]) {
    for (int axis = 0; axis < 3; ++axis) {
        const double from = rays.origin[axis];
        const double less = anchor[axis];
        const double* const along = rays.direction[axis];
        float* const to = position[axis];
        for (std::size_t i = 0; i < rays.count; ++i)
            to[i] = static_cast<float>(from + distance[i] * along[i] - less);
    }
}

template<class S>
void views(const CameraRayArrays& rays, float* const (&view)[3]) {
    for (int axis = 0; axis < 3; ++axis) {
        const double* const along = rays.direction[axis];
        float* const to = view[axis];
        for (std::size_t i = 0; i < rays.count; ++i)
            to[i] = static_cast<float>(-along[i]);
    }
}

extern const CameraKernels kernels_camera_scalar;
extern const CameraKernels kernels_camera_sse2;
extern const CameraKernels kernels_camera_avx2;
extern const CameraKernels kernels_camera_avx512;
extern const CameraKernels kernels_camera_neon;
extern const CameraKernels kernels_camera_wasm128;

} // namespace gonio::preview::detail
