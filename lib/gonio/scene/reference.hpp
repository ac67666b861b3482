// Reference: the illuminance of an area light and the luminance that a material makes of it, by adaptive quadrature of
// the true BRDF over the directions in which the light is seen, to an error that is asked for.
//
// Area shapes and the sun, in double. The light's outline is cut by the receiver's horizon in closed form
// (detail/light_region.hpp); the rest is integrated in polar coordinates about the mirrored view, whose radial map
// follows the lobe, or about the light's middle (detail/polar_cubature.hpp). README.md says how true it is. No
// randomness and no threads: the same bits always. What a shape emits behind a mask is its luminance times the mask
// towards the receiver.
// Cost: 0.1 to 1 ms a light and receiver at a relative error of 1e-6; webs with many kinks more.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/material.hpp>

#include <glm/vec3.hpp>

#include <cstddef>

namespace gonio {

struct ReferenceGoal {
    double relative_error = 1e-6;             // of each value by itself, at least 1e-13
    std::size_t most_evaluations = 4'000'000; // of the integrand; then what was reached is given
};

struct ReferenceValue {
    double value = 0.0;
    double error_estimate = 0.0; // absolute; not less than the error in all but about one case of a thousand
    std::size_t evaluations = 0;
    bool converged = true; // the estimate is within what was asked for
};

// Sum of two lights' values; their errors add.
ReferenceValue operator+(const ReferenceValue& a, const ReferenceValue& b);

// Of the surface, as Y of its colour [nt].
struct ReferenceLuminance {
    ReferenceValue diffuse;
    ReferenceValue specular;
};

// Whether the shape has a size, so that it is integrated at all; others give 0 below.
bool has_extent(const Shape& shape);

// [lx]. `normal` is unit.
ReferenceValue reference_illuminance(const Light& light, const glm::dvec3& position, const glm::dvec3& normal,
                                     const ReferenceGoal& goal = {});

// [nt] towards `view`; both it and `normal` are unit. 0 where the view is not above the surface.
ReferenceLuminance reference_luminance(const Light& light, const glm::dvec3& position, const glm::dvec3& normal,
                                       const glm::dvec3& view, const Material& material,
                                       const ReferenceGoal& goal = {});

} // namespace gonio
