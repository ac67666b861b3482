// The share of a uniform sky that an occluder leaves visible: the irradiance of the occluder, subtracted.
//
// A sky of luminance L gives a receiver π L. An object in front of it removes the irradiance that it would give if it
// emitted L, so 1 − E/(π L) is left, exactly, horizon included: the occlusion volumes of Remember Me (DONTNOD, 2013)
// without their approximation. If two objects overlap as seen from the receiver, their common part is subtracted twice.
#pragma once

#include <gonio/shading/irradiance_sphere.hpp>
#include <gonio/shading/irradiance_tube.hpp>

#include <numbers>

namespace gonio::shading {

// Share of the sky's irradiance that is left, in [0, 1]: 0 inside the sphere. Arguments as irradiance_sphere.
template<class S>
GONIO_FORCE_INLINE S sky_visibility_sphere(vec3<S> center, S radius, vec3<S> normal) {
    const S left = S(1) - irradiance_sphere(center, radius, normal) * S(std::numbers::inv_pi);
    return simd::min(simd::max(left, S(0)), S(1));
}

// The same for a capsule; arguments as irradiance_tube.
template<class S>
GONIO_FORCE_INLINE S sky_visibility_tube(vec3<S> center, vec3<S> axis, S radius, S length_m, vec3<S> normal) {
    const S left = S(1) - irradiance_tube(center, axis, radius, length_m, normal) * S(std::numbers::inv_pi);
    return simd::min(simd::max(left, S(0)), S(1));
}

} // namespace gonio::shading
