// Packets from the kernels' arrays, and the kernels' constants spread over lanes.
#pragma once

#include <gonio/shading/brdf.hpp>
#include <gonio/shading/irradiance_cylinder.hpp>
#include <gonio/shading/irradiance_ellipse.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/shading/lights.hpp>
#include <gonio/shading/reflect.hpp>
#include <gonio/simd/packet.hpp>

#include <cstddef>

namespace gonio::shading::detail {

template<class S>
struct Packet : simd::Packet<S> {
    using simd::Packet<S>::load;
    using simd::Packet<S>::store;
    GONIO_FORCE_INLINE vec3<S> load(const float* const from[3]) const {
        return {load(from[0]), load(from[1]), load(from[2])};
    }
    GONIO_FORCE_INLINE void store(vec3<S> value, float* const to[3]) const {
        store(value.x, to[0]);
        store(value.y, to[1]);
        store(value.z, to[2]);
    }
};

template<class S>
GONIO_FORCE_INLINE vec3<S> broadcast(const float (&v)[3]) {
    return {S(v[0]), S(v[1]), S(v[2])};
}

template<class S>
GONIO_FORCE_INLINE void constants(const LightConstants& from, PunctualLight<S>& to) {
    to = {broadcast<S>(from.position), broadcast<S>(from.color), S(0), S(from.inverse_range)};
}
template<class S>
GONIO_FORCE_INLINE void constants(const LightConstants& from, SphereLight<S>& to) {
    to = {broadcast<S>(from.position), broadcast<S>(from.color), S(from.radius), S(from.inverse_range)};
}
template<class S>
GONIO_FORCE_INLINE void constants(const LightConstants& from, DiskLight<S>& to) {
    to = {broadcast<S>(from.position), broadcast<S>(from.color),
          broadcast<S>(from.axis),     S(from.radius),
          S(from.inverse_range),       from.two_sided};
}
template<class S>
GONIO_FORCE_INLINE void constants(const LightConstants& from, EllipseLight<S>& to) {
    to = {broadcast<S>(from.position), broadcast<S>(from.color),
          broadcast<S>(from.axis),     broadcast<S>(from.width_direction),
          S(0.5F * from.width),        S(0.5F * from.height),
          S(from.inverse_range),       from.two_sided};
}
template<class S>
GONIO_FORCE_INLINE void constants(const LightConstants& from, RectangleLight<S>& to) {
    to = {broadcast<S>(from.position),
          broadcast<S>(from.color),
          broadcast<S>(from.axis),
          broadcast<S>(from.width_direction),
          S(from.width),
          S(from.height),
          S(from.inverse_range),
          from.two_sided};
}
template<class S>
GONIO_FORCE_INLINE void constants(const LightConstants& from, TubeLight<S>& to) {
    to = {
        broadcast<S>(from.position), broadcast<S>(from.color), broadcast<S>(from.axis), S(from.radius), S(from.length),
        S(from.inverse_range)};
}
template<class S>
GONIO_FORCE_INLINE void constants(const LightConstants& from, CylinderLight<S>& to) {
    to = {
        broadcast<S>(from.position), broadcast<S>(from.color), broadcast<S>(from.axis), S(from.radius), S(from.length),
        S(from.inverse_range)};
}
template<class S>
GONIO_FORCE_INLINE void constants(const LightConstants& from, SunLight<S>& to) {
    const float radius = simd::min(simd::max(from.angular_radius, 0.0F), 1.57079637F);
    to = {broadcast<S>(from.axis) * S(-1), broadcast<S>(from.color), S(simd::sin(radius)),
          S(simd::max(simd::cos(radius), 0.0F))};
}

template<template<class> class Light>
struct OfKind {};

// Calls work(OfKind<SphereLight>{}) and so on; not for a punctual light or a sun. The only place that maps a kind to a
// light of the core.
template<class Work>
GONIO_FORCE_INLINE void with_area_light(LightConstants::Kind kind, const Work& work) {
    switch (kind) {
    case LightConstants::Kind::punctual:
    case LightConstants::Kind::sun:
        return;
    case LightConstants::Kind::sphere:
        return work(OfKind<SphereLight>{});
    case LightConstants::Kind::disk:
        return work(OfKind<DiskLight>{});
    case LightConstants::Kind::ellipse:
        return work(OfKind<EllipseLight>{});
    case LightConstants::Kind::rectangle:
        return work(OfKind<RectangleLight>{});
    case LightConstants::Kind::tube:
        return work(OfKind<TubeLight>{});
    case LightConstants::Kind::cylinder:
        return work(OfKind<CylinderLight>{});
    }
}

// Calls work(light) with the light's own type; not for a punctual light.
template<class S, class Work>
GONIO_FORCE_INLINE void with_light(const LightConstants& from, const Work& work) {
    const auto spread = [&]<template<class> class Light>(OfKind<Light>) {
        Light<S> light;
        constants(from, light);
        work(light);
    };
    if (from.kind == LightConstants::Kind::sun) return spread(OfKind<SunLight>{});
    with_area_light(from.kind, spread);
}

template<class S, template<class> class Material>
GONIO_FORCE_INLINE vec3<S> load_view(const Packet<S>& packet, const Surfaces& surfaces, const Material<S>& /*reads*/) {
    return packet.load(surfaces.view);
}
template<class S>
GONIO_FORCE_INLINE vec3<S> load_view(const Packet<S>& /*packet*/, const Surfaces& /*surfaces*/,
                                     const Lambert<S>& /*reads none*/) {
    return {S(0), S(0), S(0)};
}

// One receiver per lane, from `first` on; without the view.
template<class S>
GONIO_FORCE_INLINE SurfacePoint<S> receiver(const Surfaces& surfaces, std::size_t first) {
    SurfacePoint<S> point;
    simd::load(surfaces.position[0] + first, point.position.x);
    simd::load(surfaces.position[1] + first, point.position.y);
    simd::load(surfaces.position[2] + first, point.position.z);
    simd::load(surfaces.normal[0] + first, point.normal.x);
    simd::load(surfaces.normal[1] + first, point.normal.y);
    simd::load(surfaces.normal[2] + first, point.normal.z);
    point.view = {S(0), S(0), S(0)};
    return point;
}

// `count` receivers from `first` on; without the view.
template<class S>
GONIO_FORCE_INLINE Surfaces part_of(const Surfaces& all, std::size_t first, std::size_t count) {
    Surfaces part;
    for (std::size_t k = 0; k < 3; ++k) {
        part.position[k] = all.position[k] + first;
        part.normal[k] = all.normal[k] + first;
    }
    part.count = count;
    return part;
}

// The same with the view, if there is one.
template<class S>
GONIO_FORCE_INLINE Surfaces seen_part_of(const Surfaces& all, std::size_t first, std::size_t count) {
    Surfaces part = part_of<S>(all, first, count);
    for (std::size_t k = 0; k < 3; ++k)
        part.view[k] = all.view[k] == nullptr ? nullptr : all.view[k] + first;
    return part;
}

// The receivers from `first` on, fewer than a packet; the last one is repeated to fill it.
template<class S>
struct PaddedPacket {
    static constexpr std::size_t lanes = simd::Traits<S>::lanes;
    float values[6][lanes];

    PaddedPacket(const Surfaces& from, std::size_t first) {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const std::size_t i = first + lane < from.count ? first + lane : from.count - 1;
            for (std::size_t k = 0; k < 3; ++k) {
                values[k][lane] = from.position[k][i];
                values[3 + k][lane] = from.normal[k][i];
            }
        }
    }
    [[nodiscard]] Surfaces surfaces() const {
        Surfaces packet;
        for (std::size_t k = 0; k < 3; ++k) {
            packet.position[k] = &values[k][0];
            packet.normal[k] = &values[3 + k][0];
        }
        packet.count = lanes;
        return packet;
    }
};

} // namespace gonio::shading::detail
