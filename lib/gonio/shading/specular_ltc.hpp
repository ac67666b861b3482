// The specular part of a material under an area light by linearly transformed cosines (ltc_lobe.hpp, ltc_share.hpp).
//
// One call gives both terms of the reflectance (specular_method.hpp). Positions are relative to the receiver.
#pragma once

#include <gonio/shading/lights.hpp>
#include <gonio/shading/ltc_tube.hpp>
#include <gonio/shading/specular_method.hpp>

namespace gonio::shading {

namespace detail {

template<class S>
GONIO_FORCE_INLINE S ltc_share(const LtcLobe<S>& lobe, const LtcFrame<S>& frame, const SphereLight<S>& light,
                               vec3<S> to_center) {
    return ltc_sphere(lobe, frame(to_center), light.radius);
}
template<class S>
GONIO_FORCE_INLINE S ltc_share(const LtcLobe<S>& lobe, const LtcFrame<S>& frame, const DiskLight<S>& light,
                               vec3<S> to_center) {
    return ltc_disk(lobe, frame(to_center), frame(light.axis), light.radius, light.two_sided);
}
template<class S>
GONIO_FORCE_INLINE S ltc_share(const LtcLobe<S>& lobe, const LtcFrame<S>& frame, const RectangleLight<S>& light,
                               vec3<S> to_center) {
    return ltc_rectangle(lobe, frame(to_center), frame(light.axis), frame(light.width_direction), light.width,
                         light.height, light.two_sided);
}
template<class S>
GONIO_FORCE_INLINE S ltc_share(const LtcLobe<S>& lobe, const LtcFrame<S>& frame, const TubeLight<S>& light,
                               vec3<S> to_center) {
    return ltc_tube(lobe, frame(to_center), frame(light.axis), light.radius, light.length);
}
template<class S>
GONIO_FORCE_INLINE S ltc_share(const LtcLobe<S>& lobe, const LtcFrame<S>& frame, const SunLight<S>& light,
                               vec3<S> toward) {
    return ltc_cap(lobe, frame(toward), light.sine, light.cosine);
}

} // namespace detail

// GGX of α. `normal` and `view` are unit; `to_center` leads from the receiver to the light's centre. 0 where n·v is not
// positive. Light is a SphereLight, DiskLight, RectangleLight, TubeLight or SunLight; its window is not applied.
template<class S, class Light>
GONIO_FORCE_INLINE SpecularLuminance<S> specular_ltc(const Light& light, vec3<S> to_center, vec3<S> normal,
                                                     vec3<S> view, S alpha) {
    const S n_dot_v = dot(normal, view);
    const LtcFrame<S> frame = ltc_frame(normal, view);
    const LtcLobe<S> lobe = ltc_ggx(alpha, n_dot_v, frame.sine);
    const S share = detail::ltc_share(lobe, frame, light, to_center);
    return {simd::select(n_dot_v > S(0), share * lobe.albedo, S(0)), lobe.grazing / lobe.albedo};
}

// The renormalised Disney diffuse of albedo 1, likewise: luminance per luminance of the light.
template<class S, class Light>
GONIO_FORCE_INLINE S diffuse_ltc(const Light& light, vec3<S> to_center, vec3<S> normal, vec3<S> view,
                                 S linear_roughness) {
    const S n_dot_v = dot(normal, view);
    const LtcLobe<S> lobe = ltc_diffuse(linear_roughness, n_dot_v);
    const S share = detail::ltc_share(lobe, ltc_frame(normal, view), light, to_center);
    return simd::select(n_dot_v > S(0), share * lobe.albedo, S(0));
}

} // namespace gonio::shading
