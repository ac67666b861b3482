// A grid of C-planes and γ adapted to a light: fine where the light bends, coarse elsewhere. Internal to the web room.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/web/resample_light.hpp>

#include <cstddef>
#include <vector>

namespace gonio::web_detail {

struct AngleGrid {
    std::vector<double> planes_deg;
    std::vector<double> gammas_deg;
};

// The greatest number of points of a refined grid, for a file of about a megabyte.
inline constexpr std::size_t most_refined_points = 65536;

// Steps of this width or less are not halved: single precision can still distinguish 360° from 359.999°.
inline constexpr double finest_step_deg = 0.001;

// Halves the steps of `grid`, starting with those where the light at the midpoint differs most from the mean of the
// ends, until no difference exceeds half of `limit` or the grid has most_refined_points. An interpolant differs by at
// most the sum of both axes, so `limit` then holds, except for features that the midpoints of the steps miss. Cost: at
// most 13 rounds of four evaluations per point; memory: four numbers per point.
AngleGrid refined_grid(const Light& light, AngleGrid grid, Candelas limit);

} // namespace gonio::web_detail
