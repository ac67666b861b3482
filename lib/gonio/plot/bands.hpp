// A field as coloured bands in a chart. Internal to this room.
#pragma once

#include <gonio/plot/chart.hpp>
#include <gonio/plot/contour.hpp>

#include <vector>

namespace gonio::plot_detail {

// Paints the region at or above each level in its colour, from the lowest to the highest; paints nothing below the
// first.
void draw_bands(Drawing& drawing, const Chart& chart, const Field& field, const std::vector<double>& levels,
                const std::vector<Ink>& colors);

// A colour for each of `count` bands, from dark to light.
std::vector<Ink> band_colors(std::size_t count);

} // namespace gonio::plot_detail
