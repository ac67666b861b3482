// Unified glare rating for an observer anywhere: UGR = 8 log₁₀(0.25/Lb Σ L²ω/p²) (CIE 117:1995).
//
// The luminance of a luminaire is its intensity over the projected area of its luminous opening, of a light with a size
// its own; p is Guth's index in closed form, for any direction of view. Luminaires of less than 0.005 m² projected area
// count as small sources (CIE 147:2002), L²ω = 200 I²/d², which does not depend on their size. The rule holds for solid
// angles of 0.0003 to 0.1 sr.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/light/light.hpp>

#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// An eye, and where it looks.
struct Observer {
    glm::dvec3 eye{0.0, 0.0, 1.2};  // [m]
    glm::dvec3 view{0.0, 1.0, 0.0}; // horizontal or not, any length > 0, not straight up or down
};

// What one light contributes.
struct GlareShare {
    Nits luminance;
    double solid_angle_sr = 0.0;
    double position_index = 1.0;
    double sum = 0.0;          // L²ω/p² [cd²/m⁴]
    bool is_small = false;     // CIE 147: its luminance is that of 0.005 m²
    bool is_too_large = false; // above 0.1 sr, where the rule does not hold
};

// That of a light; of one behind the eye, of the sun and of one that does not shine there, a sum of 0. Empty for a
// light without a size: a point, or a profile that states no luminous opening.
std::optional<GlareShare> glare_share(const Light& light, const Observer& observer);

// What an observer sees of all lights.
struct GlareRating {
    std::optional<double> ugr; // empty: nothing glares, no background, or a light without a size
    Nits background;
    std::vector<GlareShare> lights; // times what reaches the eye of each
    bool has_too_large = false;     // one of them is above 0.1 sr
};

// `visible` has the share of each light that reaches the eye, `background_lx` what arrives there from all else.
GlareRating glare_rating(std::span<const Light> lights, const Observer& observer, std::span<const double> visible,
                         double background_lx);

// UGR of the sum of all shares and the background's luminance Lb = E/π, with the vertical illuminance E at the eye
// without what comes from the lights directly. −∞ without glare, +∞ without a background.
double unified_glare_rating(double sum_of_shares, Nits background);

} // namespace gonio
#pragma GCC visibility pop
