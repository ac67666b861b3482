// The difference of two webs.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/web/web.hpp>

namespace gonio {

struct WebDifference {
    Candelas greatest;      // greatest |a − b| of any direction
    double c_deg = 0.0;     // where it is; of equals, the first in the order of C, then γ
    double gamma_deg = 0.0; // "
    Candelas a;             // the intensities there, taken from the side of the jump that differs more
    Candelas b;
    double relative = 0.0; // greatest over the greater of the two peaks; 0 when both webs are dark
    Candelas rms;          // √(∬ (a − b)² dω / 4π)
    Lumens flux_a;
    Lumens flux_b;
    bool exact = false; // greatest is that of the interpolants, not of samples
};

// Two webs of the same goniometer differ by a function that is bilinear in every cell of the union of their grids: its
// greatest value is at a corner, taken from within each cell, so that jumps where a table ends count, and the
// comparison is exact whatever the two grids. Webs of different goniometers are compared at every half degree of C and
// γ and at both grids' own points. Cost: 8 evaluations of each web a cell of the union.
WebDifference difference(const Web& a, const Web& b);

} // namespace gonio
