// The drawing of a grid's plan: where it goes, and how it is written.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/media/image_file.hpp>
#include <gonio/plot/grid_diagram.hpp>

#include "../arguments.hpp"

#include <string>

namespace gonio::cli {

struct GridDrawing {
    std::string output;
    const media::ImageFormat* format = nullptr; // nullptr: SVG
    std::string title;
    int width_px = 0; // 0: as the numbers need
    int height_px = 0;
};

// --output (which must be given), --size, --title and --to: SVG, or a picture format given by --to or by the output's
// name. Fails (usage) on a size that pictures cannot have, on other formats and on stdin's name for stdout.
Result<GridDrawing> grid_drawing(const Arguments& arguments);

// Sets the size of the plot, draws and writes it.
Result<void> write_grid_drawing(const GridDrawing& drawing, GridPlot plot, Diagnostics& diagnostics);

} // namespace gonio::cli
