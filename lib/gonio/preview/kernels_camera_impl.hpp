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

// approach() of scene/primitives.cpp.
template<class S>
struct Approach {
    S along;
    S miss2;

    GONIO_FORCE_INLINE Approach(const vec3<S>& to_point, const vec3<S>& direction)
        : along(dot_as_glm(to_point, direction)) {
        const vec3<S> miss = to_point - direction * along;
        miss2 = dot_as_glm(miss, miss);
    }
    GONIO_FORCE_INLINE S entry(double radius) const {
        const S half_chord2 = S(radius) * S(radius) - miss2;
        const auto is_met = half_chord2 >= S(0);
        return simd::select(is_met, along - simd::sqrt(simd::select(is_met, half_chord2, S(0))), S(0));
    }
};

template<class S>
GONIO_FORCE_INLINE S panel_entry(const CameraTarget& panel, const vec3<S>& origin, const vec3<S>& direction) {
    const S t = plane_entry(panel, direction);
    const vec3<S> at = origin + direction * t - spread<S>(panel.middle);
    const auto is_within = simd::both(simd::abs(dot_as_glm(at, spread<S>(panel.x))) <= S(panel.half_size[0]),
                                      simd::abs(dot_as_glm(at, spread<S>(panel.y))) <= S(panel.half_size[1]));
    return simd::select(is_within, t, S(0));
}

template<class S>
GONIO_FORCE_INLINE S box_entry(const CameraTarget& box, const vec3<S>& direction) {
    const double* const axes[3] = {box.x, box.y, box.normal};
    S entry(-__builtin_inf());
    S exit(__builtin_inf());
    auto is_between = S(0) <= S(0); // the planes that it is parallel to
    for (int axis = 0; axis < 3; ++axis) {
        const S along = dot_as_glm(direction, vec3<S>{S(axes[axis][0]), S(axes[axis][1]), S(axes[axis][2])});
        const S origin(box.middle[axis]);
        const S half(box.half_size[axis]);
        const auto is_parallel = along == S(0);
        const S per_along = simd::select(is_parallel, S(1), along);
        const S towards = simd::copysign(half, along);
        entry = simd::select(is_parallel, entry, simd::max(entry, (-towards - origin) / per_along));
        exit = simd::select(is_parallel, exit, simd::min(exit, (towards - origin) / per_along));
        is_between = simd::both(is_between, simd::either(!is_parallel, simd::abs(origin) < half));
    }
    return simd::select(simd::both(is_between, entry <= exit), entry, S(0));
}

template<class S>
GONIO_FORCE_INLINE S capsule_entry(const CameraTarget& capsule, const vec3<S>& direction) {
    const vec3<S> middle = spread<S>(capsule.middle);
    const double reach = capsule.half_size[0] + capsule.radius;
    const auto is_near = Approach<S>(middle, direction).miss2 <= S(reach * reach);
    if (!simd::any(is_near)) return S(0);
    const vec3<S> axis = spread<S>(capsule.x);
    const S height(capsule.height);
    const S along_axis = dot_as_glm(direction, axis);
    const vec3<S> across = direction - axis * along_axis;
    const S speed2 = dot_as_glm(across, across);
    const auto is_turned = speed2 > S(1e-20);
    const S per = simd::select(is_turned, speed2, S(1));
    const S closest = dot_as_glm(middle, across) / per;
    const vec3<S> miss = middle - axis * height - across * closest;
    const S half_chord2 = (S(capsule.radius) * S(capsule.radius) - dot_as_glm(miss, miss)) / per;
    const auto is_met = half_chord2 >= S(0);
    const S t = closest - simd::sqrt(simd::select(is_met, half_chord2, S(0)));
    const S at = t * along_axis - height;
    const auto on_side = simd::both(is_turned, simd::abs(at) <= S(capsule.half_size[0]));
    const auto is_first = simd::either(simd::both(is_turned, at < S(0)), simd::both(!is_turned, along_axis >= S(0)));
    const vec3<S> end = shading::select<S>(is_first, spread<S>(capsule.ends[0]), spread<S>(capsule.ends[1]));
    const S of_end = Approach<S>(end, direction).entry(capsule.radius);
    const auto may_meet = simd::both(is_near, simd::either(!is_turned, is_met));
    return simd::select(may_meet, simd::select(on_side, t, of_end), S(0));
}

template<class S>
void meet(const CameraTarget& target, const CameraRayArrays& rays, double number, double* distance, double* numbers) {
    const auto meet_at = [&](const auto& entry) { meet_by<S>(rays, number, distance, numbers, entry); };
    switch (target.kind) {
    case CameraTarget::Kind::plane:
        return meet_at([&](const vec3<S>& direction) { return plane_entry(target, direction); });
    case CameraTarget::Kind::panel: {
        const vec3<S> origin = spread<S>(rays.origin);
        return meet_at([&](const vec3<S>& direction) { return panel_entry(target, origin, direction); });
    }
    case CameraTarget::Kind::ball: {
        const vec3<S> middle = spread<S>(target.middle);
        return meet_at([&](const vec3<S>& direction) { return Approach<S>(middle, direction).entry(target.radius); });
    }
    case CameraTarget::Kind::box:
        return meet_at([&](const vec3<S>& direction) { return box_entry(target, direction); });
    case CameraTarget::Kind::capsule:
        break;
    }
    meet_at([&](const vec3<S>& direction) { return capsule_entry(target, direction); });
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
