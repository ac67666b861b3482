// What a Web looks like: peak, symmetry as its numbers show it, beam and field angle.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/web/web.hpp>

#include <optional>

namespace gonio {

// The greatest intensity and where it is; of equals, the first in the order of C, then γ. The interpolant is bilinear,
// so the greatest lies on a grid point. A web that is dark or negative everywhere has peak 0 or less.
struct Peak {
    Candelas intensity;
    double c_deg = 0.0;
    double gamma_deg = 0.0;
};

Peak peak(const Web& web);

// The highest symmetry that the interpolant has to within `tolerance` of its peak, whatever the file declared.
Symmetry detected_symmetry(const Web& web, double tolerance = 1e-9);

// Full angle, in the plane C–(C+180°), between the outermost directions whose intensity is at least `fraction` of the
// web's peak: 0.5 is the beam angle, 0.1 the field angle. It is looked for around the pole (nadir or zenith) on whose
// side the peak lies, and beyond 90° only where the light is still that bright there. Nothing when no direction of the
// plane is that bright.
std::optional<Radians> spread_angle(const Web& web, double c_deg, double fraction);

} // namespace gonio
