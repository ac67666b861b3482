// A light of any kind as what materials see of it from a packet of receivers, so that they are compiled once and not
// once for each kind of light: for kernels that are to be small (GONIO_SMALL_KERNELS). The numbers are the same.
#pragma once

#include <gonio/shading/light_points.hpp>
#include <gonio/shading/reflect.hpp>
#include <gonio/shading/seen_from.hpp>
#include <gonio/shading/specular_named.hpp>
#include <gonio/shading/vec3.hpp>

#include <cstddef>

namespace gonio::shading::detail {

template<class S>
struct GatheredLight {
    GatheredPoints<S> points;
    vec3<S> luminance; // [nt]
    vec3<S> to_center;
    vec3<S> nearest; // unit, to the light's point nearest to the mirrored view
    S window;
};

// What of it a material reads.
struct GatheredParts {
    bool points, nearest;
};

template<class S>
GONIO_FORCE_INLINE vec3<S> way_to(const GatheredLight<S>& light, vec3<S> /*position*/) {
    return light.to_center;
}
template<class S>
GONIO_FORCE_INLINE S faded(const GatheredLight<S>& light, vec3<S> /*to_center*/) {
    return light.window;
}
template<class S, class Frame>
GONIO_FORCE_INLINE const GatheredPoints<S>& points_of(const GatheredLight<S>& light, const Frame& /*same*/,
                                                      vec3<S> /*to_center*/) {
    return light.points;
}
template<class S>
GONIO_FORCE_INLINE vec3<S> nearest_to(const GatheredLight<S>& light, vec3<S> /*position*/, vec3<S> /*ray*/) {
    return light.nearest;
}
// The direction to the light's point nearest to a ray.
template<class S, class Light>
GONIO_FORCE_INLINE vec3<S> nearest_to(const Light& light, vec3<S> position, vec3<S> ray) {
    const auto seen = seen_from(light, way_to(light, position));
    return approach(seen.light, seen.to_center, ray).toward;
}

template<class S, class Light>
[[gnu::noinline]] void gather(const void* from, const SurfacePoint<S>& point, GatheredParts parts,
                              GatheredLight<S>& to) {
    const Light& light = *static_cast<const Light*>(from);
    to.to_center = way_to(light, point.position);
    to.window = faded(light, to.to_center);
    if (parts.points) to.points.gather(points_of(light, SameFrame{}, to.to_center));
    if (parts.nearest) to.nearest = nearest_to(light, point.position, mirrored_view(point.normal, point.view));
}

// A light whose kind is known at run time alone; not a punctual one.
template<class S>
class AnyLight {
public:
    // `with` calls its argument with the light.
    template<class With>
    GONIO_FORCE_INLINE explicit AnyLight(const With& with) {
        with([&]<class Light>(const Light& light) {
            static_assert(sizeof(Light) <= sizeof room_);
            __builtin_memcpy(&room_[0], &light, sizeof light);
            luminance_ = light.luminance;
            gather_ = gather<S, Light>;
        });
    }

    GONIO_FORCE_INLINE void gathered(const SurfacePoint<S>& point, GatheredParts parts, GatheredLight<S>& to) const {
        to.luminance = luminance_;
        gather_(&room_[0], point, parts, to);
    }

private:
    S room_[20];
    vec3<S> luminance_;
    void (*gather_)(const void*, const SurfacePoint<S>&, GatheredParts, GatheredLight<S>&);
};

} // namespace gonio::shading::detail
