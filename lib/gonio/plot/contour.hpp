// Level sets of a sampled field: where it is at least so much, and the lines where it is exactly so much.
//
// The field is bilinear between the samples only at their edges: inside a cell a line is straight (marching squares),
// and where two opposite corners lie above the level and two below, the mean of the four says whether they connect.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gonio {

struct FieldPoint {
    double x = 0.0;
    double y = 0.0;
};

// Values [row][column] at the crossings of `xs` and `ys`, both strictly ascending.
struct Field {
    std::vector<double> xs;
    std::vector<double> ys;
    std::vector<double> values;

    double value(std::size_t column, std::size_t row) const { return values[row * xs.size() + column]; }
};

// The region of values ≥ level as polygons without overlap, all turning the same way. Cells that lie wholly in it are
// joined along the rows.
std::vector<std::vector<FieldPoint>> region_at_least(const Field& field, double level);

struct ContourLine {
    std::vector<FieldPoint> points;
    bool closed = false; // the last point is joined to the first
};

// The lines of value = level. NaN counts as below. The order is that of the cells. Where there are `groups` (one for
// each value), cells whose corners are of several, or of one below 0, carry no line.
std::vector<ContourLine> contour_lines(const Field& field, double level, std::span<const std::int32_t> groups = {});

} // namespace gonio
