// The light as a receiver sees it: the light itself, or another that has the same cone of directions, or nearly so.
#pragma once

#include <gonio/shading/vec3.hpp>

namespace gonio::shading {

// A light that is equivalent to another light for every receiver, as an ellipse is to a disk: `seen_from(to_center)`
// returns the other light, without a window, and the `to_center` of it.
template<class Light, class S>
concept SeenAsAnother = requires(const Light& light, vec3<S> to_center) {
    light.seen_from(to_center);
};

// A light whose seen_from() is an approximation, for highlights alone: the side of a cylinder as a rectangle.
template<class Light>
concept SeenApproximately = requires {
    Light::is_seen_approximately;
};

template<class Light, class S>
struct Seen {
    Light light;
    vec3<S> to_center;
};

template<class S, class Light>
GONIO_FORCE_INLINE auto seen_from(const Light& light, vec3<S> to_center) {
    if constexpr (SeenAsAnother<Light, S>)
        return light.seen_from(to_center);
    else
        return Seen<Light, S>{light, to_center};
}

// The same for samplers and the reference: the light itself where the other is only an approximation.
template<class S, class Light>
GONIO_FORCE_INLINE auto exactly_seen_from(const Light& light, vec3<S> to_center) {
    if constexpr (SeenApproximately<Light>)
        return Seen<Light, S>{light, to_center};
    else
        return seen_from(light, to_center);
}

} // namespace gonio::shading
