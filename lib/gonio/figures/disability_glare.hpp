// Disability glare: the veil that lights lay over what a driver or a player looks at.
//
// Lv = 9.86 (1 + (A/66.4)⁴) Σ E/θ² (EN 13201-3:2015, after Stiles and Holladay, with the age term of CIE 146), with the
// illuminance E [lx] at the eye on the plane perpendicular to the line of sight, and the angle θ [°] from it, from 1.5°
// to 60°. A light outside that is left out.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/figures/glare.hpp>
#include <gonio/light/light.hpp>

#include <glm/vec3.hpp>

#include <optional>
#include <span>

#pragma GCC visibility push(default)
namespace gonio {

inline constexpr double standard_age_years = 23.0; // the factor is 10.00 then

// What one light adds to the veiling luminance of an observer, whose `view` is the line of sight; 0 outside the angles
// above.
Nits veiling_luminance(const Light& light, const Observer& observer, double age_years = standard_age_years);

// That of all of them.
Nits veiling_luminance(std::span<const Light> lights, const Observer& observer, double age_years = standard_age_years);

// The threshold increment f_TI in per cent: by how much the contrast of an object must be raised to stay visible under
// the veil, on a road of this mean luminance as new. 65 Lv/L^0.8 up to 5 cd/m², 95 Lv/L^1.05 above. Empty for a
// road of 0.05 cd/m² or less, where there is no rule.
std::optional<double> threshold_increment(Nits veil, Nits road);

// The glare rating GR of a playing field (CIE 112:1994): 27 + 24 log₁₀(Lvl/Lve^0.9) with the veil of the lights and
// that of the field, Lve = 0.035 E ρ/π. −∞ without a veil, +∞ in the dark.
double field_glare_rating(Nits veil, Lux mean, double reflectance);

inline constexpr double field_reflectance = 0.25; // of grass, where it is not known

// The greatest GR of players: eyes 1.5 m above each point, that look all around in steps of 15°, 2° below the horizon.
double greatest_field_glare_rating(std::span<const Light> lights, std::span<const glm::dvec3> points, Lux mean,
                                   double reflectance = field_reflectance);

} // namespace gonio
#pragma GCC visibility pop
