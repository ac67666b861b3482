// A chart with two axes, linear or logarithmic: where values lie on the page, grid lines, numbers and names of the
// axes. Internal to the room.
#pragma once

#include <gonio/plot/diagram_page.hpp>
#include <gonio/plot/drawing.hpp>

#include <string_view>
#include <vector>

namespace gonio::plot_detail {

struct Axis {
    std::string_view name;    // "gamma [°]"
    std::vector<double> at;   // where the lines stand: ascending, at least two; the first and last bound the axis
    bool logarithmic = false; // all of them above 0
};

class Chart {
public:
    // Takes what of `area` the numbers and names leave. `y_down`: values grow downwards. `square`: one unit is as long
    // in both directions.
    Chart(const Area& area, Axis x, Axis y, bool y_down = false, bool square = false);

    PagePoint at(double x, double y) const;
    const Area& inner() const { return inner_; }

    // Grid lines, numbers and names; to be drawn before or after what is charted.
    void draw_lines(Drawing& drawing, Ink ink) const;
    void draw_numbers(Drawing& drawing) const;

private:
    Area inner_;
    Axis x_;
    Axis y_;
    bool y_down_;
};

// Values by colour: a strip beside a chart, `levels` ascending, each colour holding from its level to the next one.
void draw_color_scale(Drawing& drawing, const Area& area, const std::vector<double>& levels,
                      const std::vector<Ink>& colors, std::string_view unit);

} // namespace gonio::plot_detail
