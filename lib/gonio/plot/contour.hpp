// Level sets of a sampled field: regions at or above a level, and lines at exactly that level.
//
// The field is interpolated only along the edges between samples. Inside a cell a line is straight (marching squares);
// if two opposite corners are above the level and the other two below, the mean of the four decides whether they
// connect.
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

// The region of values ≥ level as polygons without overlap, all with the same orientation. Cells that are wholly inside
// are merged along the rows.
std::vector<std::vector<FieldPoint>> region_at_least(const Field& field, double level);

struct ContourLine {
    std::vector<FieldPoint> points;
    bool closed = false; // the last point is joined to the first
};

// The lines of value = level. NaN counts as below. The lines are in the order of the cells. If `groups` is given (one
// for each value), a cell has no line if its corners belong to several groups, or to a group below 0.
std::vector<ContourLine> contour_lines(const Field& field, double level, std::span<const std::int32_t> groups = {});

} // namespace gonio
