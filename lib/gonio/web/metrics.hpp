// Key figures of a Web: peak, beam angle and field angle.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/web/web.hpp>

#include <optional>

#pragma GCC visibility push(default)
namespace gonio {

// The greatest intensity and its direction; among equals, the first in the order of the table. The interpolant is
// bilinear, so the greatest value is at a grid point. A web that is dark or negative everywhere has a peak of 0 or
// less.
struct Peak {
    Candelas intensity;
    double c_deg = 0.0;
    double gamma_deg = 0.0;
};

// The peak of a web.
Peak peak(const Web& web);

// Full angle, in the plane C–(C+180°), between the outermost directions with an intensity of at least `fraction` of the
// web's peak: 0.5 gives the beam angle, 0.1 the field angle. The search starts at the pole (nadir or zenith) on the
// side of the peak, and goes beyond 90° only if the light is still that bright there. Empty if no direction of the
// plane is that bright.
std::optional<Radians> spread_angle(const Web& web, double c_deg, double fraction);

// The same, between the outermost directions with at least `threshold` > 0.
std::optional<Radians> spread_angle(const Web& web, double c_deg, Candelas threshold);

// The intensity along the axis, at the pole on the side of the peak.
Candelas center_beam(const Web& web);

// The beam angle as CIE and IEC 62722 define it: the full angle at half of the intensity along the axis, while the IES
// uses half of the peak. The two differ for beams with a dim centre. Empty if the axis is dark.
std::optional<Radians> cie_beam_angle(const Web& web, double c_deg);

// NEMA type of a floodlight by the field angle in one plane: 1 up to 18°, 2 to 29°, 3 to 46°, 4 to 70°, 5 to 100°, 6 to
// 130°, 7 above.
int nema_type(Radians field_angle);

} // namespace gonio
#pragma GCC visibility pop
