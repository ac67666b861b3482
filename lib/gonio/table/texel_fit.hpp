// Texels between which a lookup is nearest to a function: in the mean square over both axes, not exact at texels.
//
// A bilinear lookup is Σ texel · hat(x) · hat(y). Along one axis the normal equations of ∫ (lookup − f)² are
// tridiagonal, and the hats of both axes multiply: solving all rows and then all columns gives the least squares of the
// table. Of a parabola the greatest error falls to two thirds of that of exact texels, the root mean square to 0.41 of
// it.
//
// On linear axes a lookup is held beyond the outermost middles. No texel fits there, and at grazing views the functions
// change most: these two halves of a texel count a tenth, or the texels beside them would follow them.
#pragma once

#include <gonio/table/shading_table.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace gonio {

// Between which texels of an axis a coordinate lies.
struct Between {
    std::size_t first;
    std::size_t second;
    double share; // of the second
};

// For a coordinate in [0, 1]: n·v or roughness on linear axes, their coordinates on the others. `count` from 2.
Between between(TableAxes axes, double at, int count);

// Where the function is evaluated, in ascending order: Gauss' nodes between texels, four in the first interval, where a
// smooth surface at a grazing view changes within a fraction of it, and two in all others.
struct FitPlace {
    double at; // coordinate in [0, 1]
    double weight;
};
std::vector<FitPlace> fit_places(TableAxes axes, int count);

// The texels of one axis from the function's values at the places: O(places). Deterministic.
std::vector<double> fitted_texels(TableAxes axes, int count, std::span<const FitPlace> places,
                                  std::span<const double> values);

} // namespace gonio
