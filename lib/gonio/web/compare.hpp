// The difference of two webs.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/web/web.hpp>

namespace gonio {

struct WebDifference {
    Candelas greatest;      // greatest |a − b| over all directions that are not in a step
    double c_deg = 0.0;     // where it occurs; among equals, the first in the order of C, then γ
    double gamma_deg = 0.0; // "
    Candelas a;             // the intensities there, taken from the side of a jump with the greater difference
    Candelas b;
    double relative = 0.0; // greatest, over the greater of the two peaks; 0 if both webs are dark
    Candelas in_steps;     // greatest |a − b| in the steps; 0 if there are none
    Candelas rms;          // √(∬ (a − b)² dω / 4π), steps included
    Lumens flux_a;
    Lumens flux_b;
    bool exact = false; // `greatest` is that of the interpolants, not of samples
};

// The difference of two webs of the same goniometer type is bilinear in every cell of the union of their grids. Its
// greatest value is at a corner, taken from within each cell so that jumps at table ends count; so the comparison is
// exact for any two grids. Webs of different types are compared at every half degree of C and γ and at the points of
// both grids. Cost: 8 evaluations of each web per cell of the union.
//
// A step is a stretch of cells that together are narrower than `smallest_deg`: where one file jumps (at the end of its
// table, or between planes at 0° and 360°), another has to store a ramp. No receiver sees a difference that narrow.
// With 0 every direction counts.
WebDifference difference(const Web& a, const Web& b, double smallest_deg = 0.0);

} // namespace gonio
