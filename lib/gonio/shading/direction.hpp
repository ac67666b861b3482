// The vector from a receiver to a light's centre, safe from overflow and underflow.
#pragma once

#include <gonio/shading/vec3.hpp>
#include <gonio/simd/twin.hpp>

namespace gonio::shading {

template<class S>
struct Direction {
    vec3<S> scaled;     // the vector to the centre times `scale`; its largest component is in [1, 2)
    S scale;            // a power of two, so that scaling is exact
    S inverse_distance; // 1/|scaled|, 0 where the vector is zero
    S n_dot_l;          // cosine between the receiver's normal and the vector to the centre, 0 where that is zero
};

// `to_center`: any finite vector. `normal`: unit.
template<class S>
GONIO_FORCE_INLINE Direction<S> direction(vec3<S> to_center, vec3<S> normal) {
    const S scale = simd::reciprocal_power_of_two(largest_component(to_center));
    const vec3<S> scaled = to_center * scale;
    const S inverse_distance = reciprocal_or_zero(length(scaled));
    return {scaled, scale, inverse_distance, dot(normal, scaled) * inverse_distance};
}

} // namespace gonio::shading
