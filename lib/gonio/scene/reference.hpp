// Reference: the illuminance of an area light and the resulting luminance of a material, by adaptive quadrature of the
// true BRDF over the directions in which the light is visible, to a requested error.
//
// Area shapes and the sun, in double. The receiver's horizon cuts the light's outline in closed form
// (detail/light_region.hpp); the rest is integrated in polar coordinates about the mirrored view, with a radial map
// that follows the lobe, or about the light's middle (detail/polar_cubature.hpp). README.md gives the accuracy. No
// randomness and no threads: always the same bits. Behind a mask, or as a face of a luminous opening, a shape has
// the luminance Light::luminance times Light::luminance_share_at() towards the receiver; the illuminance of an image is
// the sum over its pixels. Cost: 0.1 to 1 ms per light and
// receiver at a relative error of 1e-6; more for webs with many kinks.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/material.hpp>

#include <glm/vec3.hpp>

#include <cstddef>

#pragma GCC visibility push(default)
namespace gonio {

// When quadrature stops.
struct ReferenceGoal {
    double relative_error = 1e-6;             // of each value separately, at least 1e-13
    std::size_t most_evaluations = 4'000'000; // of the integrand; then returns the result reached so far
};

// The result of a quadrature.
struct ReferenceValue {
    double value = 0.0;
    double error_estimate = 0.0; // absolute; not less than the error except in about one case in a thousand
    std::size_t evaluations = 0;
    bool converged = true; // the estimate is within the requested error
};

// Sum of two lights' values; their errors add.
ReferenceValue operator+(const ReferenceValue& a, const ReferenceValue& b);

// Luminance of the surface, as the Y of its colour [nt].
struct ReferenceLuminance {
    ReferenceValue diffuse;
    ReferenceValue specular;
};

// Whether the shape has a size and so is integrated at all; other shapes give 0 below.
bool has_extent(const Shape& shape);

// [lx]. `normal` is unit.
ReferenceValue reference_illuminance(const Light& light, const glm::dvec3& position, const glm::dvec3& normal,
                                     const ReferenceGoal& goal = {});

// [nt] towards `view`; `view` and `normal` are unit. 0 where the view is not above the surface.
ReferenceLuminance reference_luminance(const Light& light, const glm::dvec3& position, const glm::dvec3& normal,
                                       const glm::dvec3& view, const Material& material,
                                       const ReferenceGoal& goal = {});

} // namespace gonio
#pragma GCC visibility pop
