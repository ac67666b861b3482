// Symmetry of a Web as its numbers show it, and webs stored with another symmetry.
#pragma once

#include <gonio/web/web.hpp>

#include <vector>

namespace gonio {

// The highest symmetry that the interpolant has to within `tolerance` of its peak, whatever the file declared. Webs of
// types A and B are never axial.
Symmetry detected_symmetry(const Web& web, double tolerance = 1e-9);

// The same light stored under the highest symmetry that it has to within `tolerance` of its peak: fewer planes, and no
// intensity further than `tolerance` · peak from where it was. The grid keeps its angles; planes are added where the
// light bends at the mirror image of one. A web that is stored so already, and one whose planes leave a gap, come back
// as they are.
Web compacted(const Web& web, double tolerance = 1e-9);

// The same light with every mirror written out: symmetry none, type C planes from 0° to 360°, H and V of types A and B
// on both sides. Exact. An axial web becomes two equal planes, 0° and 360°. A web whose stored planes do not reach the
// ends of their range, or whose mirrored H or V do not start at 0, comes back as it is: it has a gap.
Web expanded(const Web& web);

// Type C: every C in [0°, 360°) at which the interpolant may bend or end, mirrors written out; ascending.
std::vector<double> plane_bends_deg(const Web& web);

} // namespace gonio
