#include "grid_drawing.hpp"

#include <gonio/base/codes/result.hpp>
#include <gonio/base/picture_size.hpp>

#include "output.hpp"
#include "values.hpp"

#include <utility>

namespace gonio::cli {

Result<GridDrawing> grid_drawing(const Arguments& arguments) {
    GridDrawing drawing;
    drawing.output = arguments.value("--output").value_or("-");
    if (drawing.output == "-") return both_to_standard_output("drawing");
    drawing.title = arguments.value("--title").value_or("");
    if (const auto text = arguments.value("--size")) {
        Result<PixelSize> size = parse_size(*text);
        if (!size) return pass_on(size);
        if (Result<void> fits = check_picture_size(size->width, size->height); !fits) return pass_on(fits);
        drawing.width_px = size->width;
        drawing.height_px = size->height;
    }
    Result<const media::ImageFormat*> format = diagram_format(arguments.value("--to"), drawing.output);
    if (!format) return pass_on(format);
    drawing.format = *format;
    return drawing;
}

Result<void> write_grid_drawing(const GridDrawing& drawing, GridPlot plot, Diagnostics& diagnostics) {
    plot.width_px = drawing.width_px;
    plot.height_px = drawing.height_px;
    bool left_out = false;
    Result<Drawing> page = grid_diagram(plot, left_out);
    if (!page) return pass_on(page);
    if (left_out)
        diagnostics.push_back(result_diagnostic("RES0409",
                                                "the cells are too small for their numbers, which are left out",
                                                "use a larger -s, or a wider spacing"));
    return write_diagram(*page, drawing.format, drawing.output);
}

} // namespace gonio::cli
