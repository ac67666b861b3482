// Directions towards lights with a size, recorded from the samplers of the core.
#pragma once

#include <gonio/shader/parameters.hpp>
// After the recording scalar.
#include <gonio/shading/sample_disk.hpp>
#include <gonio/shading/sample_rectangle.hpp>
#include <gonio/shading/sample_sphere.hpp>
#include <gonio/shading/sample_tube.hpp>

namespace gonio::shader {

inline core::SphereSampler<S> sampler_of(const Sphere& light) {
    return {light.to_center, light.radius};
}
inline core::DiskSampler<S> sampler_of(const Disk& light) {
    return {light.to_center, light.axis, light.radius};
}
inline core::RectangleSampler<S> sampler_of(const Rectangle& light) {
    return {light.to_center, light.axis, light.width_direction, light.width, light.height};
}
inline core::TubeSampler<S> sampler_of(const Tube& light) {
    return {light.to_center, light.axis, light.radius, light.length};
}

// The direction divided by its density: a function returns one vector, and a density that a later call finds by the
// outline would be 0 for the samples that rounding puts beside it.
template<class Light>
void sample_light(Function& f) {
    const Light light(f);
    const S u0 = f.size("u0", "a random number in [0, 1)");
    const S u1 = f.size("u1", "another one");
    const core::LightSample<S> drawn = sampler_of(light).sample(u0, u1);
    f.label("direction", drawn.direction);
    f.label("pdf", drawn.pdf);
    f.returns(drawn.direction * reciprocal_or_zero(drawn.pdf));
}

template<class Light>
void light_density(Function& f) {
    const Light light(f);
    f.returns(sampler_of(light).pdf(f.unit("direction", "unit, from the receiver")));
}

} // namespace gonio::shader
