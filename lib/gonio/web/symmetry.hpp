// Symmetry of a Web, detected from its numbers, and webs stored with another symmetry.
#pragma once

#include <gonio/web/web.hpp>

#include <vector>

namespace gonio {

// The highest symmetry that the interpolant has to within `tolerance` of its peak, whatever the file declares. Webs of
// types A and B are never axial.
Symmetry detected_symmetry(const Web& web, double tolerance = 1e-9);

// The same light stored under the highest symmetry that it has to within `tolerance` of its peak: fewer planes, and
// every intensity within `tolerance` · peak of its former value. The grid keeps its angles; planes are added where the
// light bends at the mirror image of one. A web that is already stored this way, and one with a gap between its planes,
// are returned unchanged.
Web compacted(const Web& web, double tolerance = 1e-9);

// The same light with every mirror written out: symmetry none, type C planes from 0° to 360°, H and V of types A and B
// on both sides. Exact. An axial web becomes two equal planes, 0° and 360°. A web with stored planes that do not reach
// the ends of their range, or with mirrored H or V that do not start at 0, is returned unchanged: it has a gap.
Web expanded(const Web& web);

// Type C: every C in [0°, 360°) at which the interpolant may bend or end, mirrors written out; ascending.
std::vector<double> plane_bends_deg(const Web& web);

} // namespace gonio
