#include <gonio/base/unit_text.hpp>
#include <gonio/plot/chart.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gonio::plot_detail {

namespace {

constexpr double numbers_left_px = 56.0;
constexpr double numbers_below_px = 40.0;
constexpr double scale_width_px = 14.0;
constexpr Ink numbers_ink = ink(0x555555);

double share(const Axis& axis, double value) {
    if (axis.logarithmic) return std::log(value / axis.at.front()) / std::log(axis.at.back() / axis.at.front());
    return (value - axis.at.front()) / (axis.at.back() - axis.at.front());
}

} // namespace

Chart::Chart(const Area& area, Axis x, Axis y, bool y_down, bool square)
    : inner_{area.left + numbers_left_px, area.top + 18.0, area.right - 8.0, area.bottom - numbers_below_px},
      x_(std::move(x)),
      y_(std::move(y)),
      y_down_(y_down) {
    if (!square) return;
    const double span_x = x_.at.back() - x_.at.front();
    const double span_y = y_.at.back() - y_.at.front();
    const double px_per_unit = std::min(inner_.width() / span_x, inner_.height() / span_y);
    inner_.right = inner_.left + px_per_unit * span_x;
    inner_.bottom = inner_.top + px_per_unit * span_y;
}

PagePoint Chart::at(double x, double y) const {
    const double down = y_down_ ? share(y_, y) : 1.0 - share(y_, y);
    return {inner_.left + inner_.width() * share(x_, x), inner_.top + inner_.height() * down};
}

void Chart::draw_lines(Drawing& drawing, Ink ink) const {
    for (const double x : x_.at)
        drawing.line(at(x, y_.at.front()), at(x, y_.at.back()), {ink});
    for (const double y : y_.at)
        drawing.line(at(x_.at.front(), y), at(x_.at.back(), y), {ink});
}

void Chart::draw_numbers(Drawing& drawing) const {
    for (const double x : x_.at)
        drawing.text({at(x, y_.at.front()).x, inner_.bottom + 16.0}, rounded(x),
                     {TextAnchor::middle, 11.0, numbers_ink});
    for (const double y : y_.at)
        drawing.text({inner_.left - 6.0, at(x_.at.front(), y).y + 4.0}, rounded(y),
                     {TextAnchor::end, 11.0, numbers_ink});
    drawing.text({0.5 * (inner_.left + inner_.right), inner_.bottom + 34.0}, x_.name, {TextAnchor::middle});
    drawing.text({inner_.left - 6.0, inner_.top - 8.0}, y_.name);
}

void draw_color_scale(Drawing& drawing, const Area& area, const std::vector<double>& levels,
                      const std::vector<Ink>& colors, std::string_view unit) {
    const double step = area.height() / static_cast<double>(levels.size());
    // Numbers need about 14 px; where the steps are smaller, only every n-th step gets a number.
    const auto every = static_cast<std::size_t>(std::max(1.0, 14.0 / step + 0.999));
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const double bottom = area.bottom - step * static_cast<double>(i);
        drawing.rectangle({area.left, bottom - step}, scale_width_px, step, colors[i]);
        if (i % every == 0)
            drawing.text({area.left + scale_width_px + 6.0, bottom + 4.0}, rounded(levels[i]),
                         {TextAnchor::start, 11.0, numbers_ink});
    }
    drawing.text({area.left, area.top - 8.0}, unit);
}

} // namespace gonio::plot_detail
