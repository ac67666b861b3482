// Measurements on two logarithmic axes, in panels side by side: error against time, time against size.
#pragma once

#include <gonio/base/result.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace gonio {

// The mark drawn at a point.
enum class Mark { circle, square, triangle, diamond };

struct MarkedPoint {
    double x = 0.0; // > 0
    double y = 0.0; // > 0; 0 is drawn on the panel's lowest line
    Mark mark = Mark::circle;
    bool filled = true;
    std::string label = {}; // beside the point, if there is room; may be empty
};

struct MarkedSeries {
    std::string name; // in the panel's legend
    std::vector<MarkedPoint> points;
    bool joined = false; // by a line, in the order of the points
};

struct LogLogPanel {
    std::string title;
    std::string x_name; // "time [ns]"
    std::string y_name;
    std::vector<MarkedSeries> series;
    std::vector<MarkedPoint> front = {}; // joined by a grey staircase line, ascending in x
};

struct LogLogOptions {
    std::string title;
    std::string note; // a line at the bottom: what the marks mean, and the machine
    int panel_width_px = 480;
    int panel_height_px = 360;
    int columns = 2;
};

// SVG. Points whose x or y is not a number above 0 are left out (y may also be 0). Fails (usage) if no points remain.
Result<std::string> log_log_panels(std::span<const LogLogPanel> panels, const LogLogOptions& options);

} // namespace gonio
