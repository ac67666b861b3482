// The difference of two webs.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/web/web.hpp>

namespace gonio {

struct WebDifference {
    Candelas greatest;      // greatest |a − b| over all directions
    double c_deg = 0.0;     // where it occurs; among equals, the first in the order of C, then γ
    double gamma_deg = 0.0; // "
    Candelas a;             // the intensities there, taken from the side of a jump with the greater difference
    Candelas b;
    double relative = 0.0; // greatest, over the greater of the two peaks; 0 if both webs are dark
    Candelas rms;          // √(∬ (a − b)² dω / 4π)
    Lumens flux_a;
    Lumens flux_b;
    bool exact = false; // `greatest` is that of the interpolants, not of samples
};

// The difference of two webs of the same goniometer type is bilinear in every cell of the union of their grids. Its
// greatest value is at a corner, taken from within each cell so that jumps at table ends count; so the comparison is
// exact for any two grids. Webs of different types are compared at every half degree of C and γ and at the points of
// both grids. Cost: 8 evaluations of each web per cell of the union.
WebDifference difference(const Web& a, const Web& b);

} // namespace gonio
