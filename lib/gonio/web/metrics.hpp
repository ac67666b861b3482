// Key figures of a Web: peak, beam and field angle.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/web/web.hpp>

#include <optional>

namespace gonio {

// The greatest intensity and where it is; of equals, the first in the order of the table. The interpolant is bilinear,
// so the greatest lies on a grid point. A web that is dark or negative everywhere has peak 0 or less.
struct Peak {
    Candelas intensity;
    double c_deg = 0.0;
    double gamma_deg = 0.0;
};

Peak peak(const Web& web);

// Full angle, in the plane C–(C+180°), between the outermost directions whose intensity is at least `fraction` of the
// web's peak: 0.5 is the beam angle, 0.1 the field angle. It is looked for around the pole (nadir or zenith) on whose
// side the peak lies, and beyond 90° only if the light is still that bright there. Nothing if no direction of the
// plane is that bright.
std::optional<Radians> spread_angle(const Web& web, double c_deg, double fraction);

// The same between the outermost directions of at least `threshold` > 0.
std::optional<Radians> spread_angle(const Web& web, double c_deg, Candelas threshold);

// The intensity along the axis, at the pole on whose side the peak lies.
Candelas center_beam(const Web& web);

// The beam angle as CIE and IEC 62722 define it: the full angle at half of the intensity along the axis, where the IES
// uses half of the peak. The two differ for beams that are dim in their middle. Nothing if the axis is dark.
std::optional<Radians> cie_beam_angle(const Web& web, double c_deg);

// NEMA type of a floodlight by the field angle in one plane: 1 to 18°, 2 to 29°, 3 to 46°, 4 to 70°, 5 to 100°, 6 to
// 130°, 7 above.
int nema_type(Radians field_angle);

} // namespace gonio
