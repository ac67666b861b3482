// A legend beside a picture: colours with the numbers they stand for.
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
    double factor = 1.0; // one of it in the unit of the values
};

// A ramp: three display-encoded channels for evenly spaced shares of the scale, the lowest first.
struct RampLegend {
    ValueScale scale;
    LegendUnit unit;
    std::vector<std::array<float, 3>> ramp;
    ScaleUse use; // values beyond an end give it a point; the greatest is written below
};

// Lines of equal value, the lowest first.
struct LineLegend {
    std::vector<double> levels; // in the unit of the values
    std::vector<Ink> inks;      // as many
    LegendUnit unit;
    double greatest = 0.0;
};

// The picture (three display-encoded channels) with the legend to its right. Numbers that have no room are left out.
Image with_legend(const Image& picture, const RampLegend& legend);
Image with_legend(const Image& picture, const LineLegend& legend);

} // namespace gonio
