// The specular luminance of an area light in double, by a method that is named at run time. Compiled once, for probes
// and measurements: specular_by() is inlined into each caller, for each method and light.
#pragma once

#include <gonio/shading/lights.hpp>
#include <gonio/shading/seen_from.hpp>
#include <gonio/shading/specular_method.hpp>
#include <gonio/shading/vec3.hpp>

namespace gonio::shading {

// For GGX of α, clamped to [minimum_alpha, 1]. The light's centre is at `to_center` from the point, whatever its own
// position says; normal and view are unit.
template<class Light>
SpecularLuminance<double> specular_in_double(SpecularMethod method, const Light& light, vec3<double> to_center,
                                             vec3<double> normal, vec3<double> view, double alpha);

template<class Light>
requires SeenAsAnother<Light, double> SpecularLuminance<double>
specular_in_double(SpecularMethod method, const Light& light, vec3<double> to_center, vec3<double> normal,
                   vec3<double> view, double alpha) {
    const auto seen = light.seen_from(to_center);
    return specular_in_double(method, seen.light, seen.to_center, normal, view, alpha);
}

} // namespace gonio::shading
