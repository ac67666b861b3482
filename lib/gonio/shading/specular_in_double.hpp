// The specular luminance of an area light in double, by a method that is named at run time. Compiled once, for probes
// and measurements: specular_by() is inlined into each caller, for each method and light.
#pragma once

#include <gonio/shading/anisotropic_lobe.hpp>
#include <gonio/shading/lights.hpp>
#include <gonio/shading/seen_from.hpp>
#include <gonio/shading/specular_method.hpp>
#include <gonio/shading/vec3.hpp>

namespace gonio::shading {

// The sun as a sphere at distance 1 is the same cap; limited to less than a hemisphere, where that sphere would touch
// the receiver.
inline SphereLight<double> as_sphere(const SunLight<double>& sun) {
    return {sun.toward, sun.luminance, sun.sine < 1.0 - 1e-12 ? sun.sine : 1.0 - 1e-12, 0.0};
}

// For GGX of α, clamped to [minimum_alpha, 1]. The light's centre is at `to_center` from the point, whatever its own
// position says; normal and view are unit.
template<class Light>
SpecularLuminance<double> specular_in_double(SpecularMethod method, const Light& light, vec3<double> to_center,
                                             vec3<double> normal, vec3<double> view, double alpha);

template<class Light>
SpecularLuminance<double> specular_in_double(SpecularMethod method, const Light& light, vec3<double> to_center,
                                             vec3<double> normal, vec3<double> view,
                                             const AnisotropicGgxLobe<double>& lobe);

// SpecularKernels::specular_anisotropic() one point at a time, for kernels that are to be small.
void specular_in_double(const Surfaces& surfaces, const LightConstants& light, const AnisotropicLobeConstants& lobe,
                        SpecularMethod method, float* scale, float* grazing);

template<class Light>
requires SeenAsAnother<Light, double> SpecularLuminance<double>
specular_in_double(SpecularMethod method, const Light& light, vec3<double> to_center, vec3<double> normal,
                   vec3<double> view, double alpha) {
    const auto seen = light.seen_from(to_center);
    return specular_in_double(method, seen.light, seen.to_center, normal, view, alpha);
}
template<class Light>
requires SeenAsAnother<Light, double> SpecularLuminance<double>
specular_in_double(SpecularMethod method, const Light& light, vec3<double> to_center, vec3<double> normal,
                   vec3<double> view, const AnisotropicGgxLobe<double>& lobe) {
    const auto seen = light.seen_from(to_center);
    return specular_in_double(method, seen.light, seen.to_center, normal, view, lobe);
}

} // namespace gonio::shading
