#include <gonio/plot/bands.hpp>
#include <gonio/plot/palette.hpp>

#include <fmt/format.h>

namespace gonio::plot_detail {

void draw_bands(Svg& svg, const Chart& chart, const Field& field, const std::vector<double>& levels,
                const std::vector<std::string>& colors) {
    for (std::size_t i = 0; i < levels.size(); ++i) {
        SvgPath path;
        for (const std::vector<FieldPoint>& polygon : region_at_least(field, levels[i])) {
            for (std::size_t k = 0; k < polygon.size(); ++k) {
                const SvgPoint at = chart.at(polygon[k].x, polygon[k].y);
                k == 0 ? path.move_to(at) : path.line_to(at);
            }
            path.close();
        }
        svg.path(path, fmt::format(R"(fill="{}")", colors[i]));
    }
}

std::vector<std::string> band_colors(std::size_t count) {
    std::vector<std::string> colors;
    for (std::size_t i = 0; i < count; ++i)
        colors.push_back(ramp_color(count < 2 ? 1.0 : static_cast<double>(i) / static_cast<double>(count - 1)));
    return colors;
}

} // namespace gonio::plot_detail
