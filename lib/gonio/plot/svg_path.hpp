// Paths of SVG in few bytes: points on a grid of a tenth of a pixel, each relative to the one before. Internal to this
// room.
#pragma once

#include <gonio/plot/drawing.hpp>

#include <string>

namespace gonio::plot_detail {

// The attribute `d` of a line.
std::string short_line(const PagePath& path);

// The attribute `d` of an area, whose parts are closed: edges between parts that touch are left out, so that an area of
// thousands of small parts becomes its outline. The winding number of every point is kept: it is what SVG's fill rule
// "nonzero" goes by, if the parts run around in one direction.
std::string short_outline(const PagePath& path);

} // namespace gonio::plot_detail
