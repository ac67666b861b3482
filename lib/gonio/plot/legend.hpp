// A legend beside a picture: colours and the numbers that they represent.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/plot/drawing.hpp>
#include <gonio/plot/value_scale.hpp>

#include <array>
#include <string>
#include <vector>

namespace gonio {

// Width of the column that a legend adds to the right of a picture.
inline constexpr int legend_width_px = 84;

struct LegendUnit {
    std::string symbol;  // "lx"
    double factor = 1.0; // one of it, in the unit of the values
};

// A ramp: three display-encoded channels at uniform steps of the scale, the lowest first.
struct RampLegend {
    ValueScale scale;
    LegendUnit unit;
    std::vector<std::array<float, 3>> ramp;
    ScaleUse use; // if values exceed an end, the ramp has a point there; the greatest value is written below
};

// Lines of equal value, the lowest first.
struct LineLegend {
    std::vector<double> levels; // in the unit of the values
    std::vector<Ink> inks;      // one per level
    LegendUnit unit;
    double greatest = 0.0;
};

// The picture (three display-encoded channels) with the legend on its right. Numbers that do not fit are left out.
Image with_legend(const Image& picture, const RampLegend& legend);
Image with_legend(const Image& picture, const LineLegend& legend);

} // namespace gonio
