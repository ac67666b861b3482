// Road surfaces: how much of the light that falls on a road is sent to a driver who looks at it 1° below the horizon.
//
// An r-table has the reduced luminance coefficients r = q cos³γ, times 10⁴, by tan γ, with γ the angle of incidence
// from the vertical, and by β, the angle in the plan between the planes of incidence and of observation: 0 where the
// luminaire is straight ahead, beyond the point (CIE 144:2001). L = I r 10⁻⁴/H².
#pragma once

#include <gonio/base/result.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// The r-table of a surface.
struct RoadSurface {
    std::string name;                // "r3", or that of a file
    std::string title;               // "asphalt, rather glossy"
    std::string rule;                // where the numbers come from; empty: a file
    std::vector<double> tan_gamma;   // strictly ascending, from 0
    std::vector<double> beta_deg;    // strictly ascending, from 0 to 180
    std::vector<double> r;           // [tan_gamma][beta], times 10⁴, not negative
    std::optional<double> average{}; // the average luminance coefficient Q0, if it is stated

    // r without the 10⁴, linear between the table's angles; 0 beyond its greatest tan γ. tan γ ≥ 0, 0 ≤ β ≤ 180.
    double reduced_coefficient(double tan_gamma, double beta_deg) const;

    // S1 = r(tan γ 2, β 0)/r(0, 0), how much it shines like a mirror.
    double specular_factor() const;
};

// The tables of the library.
std::span<const RoadSurface> known_road_surfaces();

// A table as text: a line of β in degrees, then for each tan γ a line that begins with it; or the numbers alone, 29
// lines of 20 in the angles of CIE 144. Fields are separated by commas, semicolons (then a comma is a decimal mark),
// tabs or spaces; "q0 0.07" on a line of its own states the average luminance coefficient; # begins a comment. Messages
// call the text `source`. Fails (malformed, with line and column) on anything else.
Result<RoadSurface> parse_road_surface(std::string_view text, const std::string& source);

// The same table for another average luminance coefficient, in proportion. Fails (usage) if the table states none, and
// on one that is not above 0 and below 1.
Result<RoadSurface> with_average(RoadSurface surface, double average);

} // namespace gonio
#pragma GCC visibility pop
