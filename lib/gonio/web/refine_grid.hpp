// A grid of C-planes and γ adapted to a light: fine where it bends, coarse elsewhere. Internal to the web
// room.
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

// The greatest number of points of a refined grid: a file of a megabyte.
inline constexpr std::size_t most_refined_points = 65536;

// Steps of this width or less are not halved: single precision still separates 360° from 359.999°.
inline constexpr double finest_step_deg = 0.001;

// Halves the steps of `grid`, those first in whose middle the light is furthest from what lies beside it, until none is
// off by more than half of `limit` or the grid has most_refined_points. An interpolant is off by no more than the two
// axes together, so that `limit` then holds but for what a step's middle does not show.
// Cost: at most 13 rounds of four evaluations a point; memory four numbers a point.
AngleGrid refined_grid(const Light& light, AngleGrid grid, Candelas limit);

} // namespace gonio::web_detail
