// Lobes: how a spot and a frustum distribute their intensity over directions, and the flux that follows.
//
// A lobe is the factor in [0, 1] on the intensity along the axis. Angles are radians from the axis. Every formula here
// is free of cancellation, while the textbook formulas in 1 − cos are off by orders of magnitude.
#pragma once

#include <gonio/light/shape.hpp>

#include <glm/vec3.hpp>

namespace gonio {

// Factor at `theta` ≥ 0 from the axis: 1 up to the inner angle, 0 from the outer angle on, except that a hard edge
// itself belongs to the cone.
double lobe(const SpotShape& spot, Radians theta);

// 1 inside the pyramid and on its faces, else 0. `direction` in the light's frame (axis −Z), any length > 0.
double lobe(const FrustumShape& frustum, const glm::dvec3& direction);

// Φ/I = 2π ∫ f(θ) sinθ dθ of the lobe, in closed form for each falloff.
Steradians lobe_solid_angle(const SpotShape& spot);

// Φ/I = 4 asin(sin(h/2) sin(v/2)), the solid angle of a right pyramid, as an arctangent that holds up to 180°.
Steradians lobe_solid_angle(const FrustumShape& frustum);

// "Φ = 4π sin²(b/2) I": what lobe_solid_angle() computes, for display; a and b are the inner and outer half angles.
const char* flux_formula(const SpotShape& spot);

} // namespace gonio
