// The plan of a grid of receivers: each cell with its number, in colour, and lines of equal value over them.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/plot/drawing.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace gonio {

// Values of the cells of a rectangle, and where it lies on the axes of the page.
struct GridPlot {
    double left_m = 0.0; // of the first cell's edge
    double low_m = 0.0;
    double width_m = 1.0;
    double height_m = 1.0;
    std::size_t columns = 1;
    std::size_t rows = 1;                  // the first is the lowest
    std::vector<double> values;            // [row][column]; NaN: no such cell
    std::vector<PagePoint> outline;        // of a polygon [m]; empty: the rectangle
    std::vector<PagePoint> marks;          // lights [m], a ring where each lies in the plan
    std::vector<std::string> mark_letters; // beside each ring; empty: none
    double margin_m = 0.0;                 // around the rectangle, inside the axes: the zone along the walls
    std::string x_name = "x [m]";
    std::string y_name = "y [m]";
    std::string unit = "lx"; // empty: a ratio
    std::string title;
    std::string facts; // a line below it
    int width_px = 0;  // 0: as wide as the numbers need
    int height_px = 0;
};

// Fails (usage) on a page with sides other than 160 to 16384 pixels. Numbers are left out where they would not fit;
// `left_out` tells.
Result<Drawing> grid_diagram(const GridPlot& plot, bool& left_out);

} // namespace gonio
