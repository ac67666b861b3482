// A chart with two axes, linear or logarithmic: the position of values on the page, grid lines, numbers and names of
// the axes. Internal to this room.
#pragma once

#include <gonio/plot/diagram_page.hpp>
#include <gonio/plot/drawing.hpp>

#include <string_view>
#include <vector>

namespace gonio::plot_detail {

struct Axis {
    std::string_view name;    // "gamma [°]"
    std::vector<double> at;   // positions of the lines: ascending, at least two; the first and last bound the axis
    bool logarithmic = false; // if true, all of `at` must be above 0
};

class Chart {
public:
    // Uses what the numbers and names leave of `area`. `y_down`: values grow downwards. `square`: one unit has the same
    // length in both directions.
    Chart(const Area& area, Axis x, Axis y, bool y_down = false, bool square = false);

    PagePoint at(double x, double y) const;
    const Area& inner() const { return inner_; }

    // Grid lines, numbers and names; call before or after drawing the chart's content.
    void draw_lines(Drawing& drawing, Ink ink) const;
    void draw_numbers(Drawing& drawing) const;

private:
    Area inner_;
    Axis x_;
    Axis y_;
    bool y_down_;
};

// A colour scale: a strip beside a chart, `levels` ascending; each colour applies from its level to the next one.
void draw_color_scale(Drawing& drawing, const Area& area, const std::vector<double>& levels,
                      const std::vector<Ink>& colors, std::string_view unit);

} // namespace gonio::plot_detail
