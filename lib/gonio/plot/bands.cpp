#include <gonio/plot/bands.hpp>
#include <gonio/plot/palette.hpp>

#include <utility>

namespace gonio::plot_detail {

void draw_bands(Drawing& drawing, const Chart& chart, const Field& field, const std::vector<double>& levels,
                const std::vector<Ink>& colors) {
    for (std::size_t i = 0; i < levels.size(); ++i) {
        PagePath path;
        for (const std::vector<FieldPoint>& polygon : region_at_least(field, levels[i])) {
            for (std::size_t k = 0; k < polygon.size(); ++k) {
                const PagePoint at = chart.at(polygon[k].x, polygon[k].y);
                k == 0 ? path.move_to(at) : path.line_to(at);
            }
            path.close();
        }
        drawing.fill(std::move(path), colors[i]);
    }
}

std::vector<Ink> band_colors(std::size_t count) {
    std::vector<Ink> colors;
    for (std::size_t i = 0; i < count; ++i)
        colors.push_back(
            palettes().front().ink_at(count < 2 ? 1.0 : static_cast<double>(i) / static_cast<double>(count - 1)));
    return colors;
}

} // namespace gonio::plot_detail
