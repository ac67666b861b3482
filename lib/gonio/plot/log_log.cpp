#include <gonio/plot/chart.hpp>
#include <gonio/plot/log_log.hpp>
#include <gonio/plot/palette.hpp>
#include <gonio/plot/stroke_font.hpp>
#include <gonio/plot/svg.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace gonio {

using plot_detail::Area;
using plot_detail::Chart;

namespace {

constexpr double margin_px = 16.0;
constexpr double headline_px = 30.0;
constexpr double legend_line_px = 16.0;
constexpr double letter_px = 6.4; // approximate width of a letter at 11 px

bool drawn(const MarkedPoint& point) {
    return point.x > 0.0 && std::isfinite(point.x) && point.y >= 0.0 && std::isfinite(point.y);
}

struct Bounds {
    double low = HUGE_VAL;
    double high = 0.0;

    void take(double value) {
        if (!(value > 0.0)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

// Powers of ten around [low, high], at least one decade; every n-th one if there would be more than eight lines.
std::vector<double> decades(const Bounds& bounds) {
    int first = static_cast<int>(std::floor(std::log10(bounds.low)));
    int last = static_cast<int>(std::ceil(std::log10(bounds.high)));
    if (first == last) ++last;
    const int step = (last - first + 7) / 8;
    last = first + (last - first + step - 1) / step * step;
    std::vector<double> at;
    for (int decade = first; decade <= last; decade += step)
        at.push_back(std::pow(10.0, decade));
    return at;
}

// Filled, or as an outline around white.
void draw_mark(Drawing& page, PagePoint at, const MarkedPoint& point, Ink color) {
    constexpr double r = 4.0;
    constexpr Ink paper = ink(0xffffff);
    if (point.mark == Mark::circle) {
        page.circle(at, r + 0.75, color);
        if (!point.filled) page.circle(at, r - 0.75, paper);
        return;
    }
    PagePath path;
    if (point.mark == Mark::square)
        path.move_to({at.x - r, at.y - r})
            .line_to({at.x + r, at.y - r})
            .line_to({at.x + r, at.y + r})
            .line_to({at.x - r, at.y + r});
    else if (point.mark == Mark::triangle)
        path.move_to({at.x, at.y - 1.2 * r}).line_to({at.x + 1.2 * r, at.y + r}).line_to({at.x - 1.2 * r, at.y + r});
    else
        path.move_to({at.x, at.y - 1.4 * r})
            .line_to({at.x + 1.4 * r, at.y})
            .line_to({at.x, at.y + 1.4 * r})
            .line_to({at.x - 1.4 * r, at.y});
    path.close();
    page.fill(path, point.filled ? color : paper);
    page.stroke(std::move(path), {color, 1.5});
}

// Names with their colours, side by side while they fit; returns the number of lines.
std::size_t draw_legend(Drawing* page, const LogLogPanel& panel, const Area& area, double top) {
    double x = area.left;
    std::size_t line = 0;
    for (std::size_t i = 0; i < panel.series.size(); ++i) {
        const std::string& name = panel.series[i].name;
        const double needed = 14.0 + letter_px * static_cast<double>(name.size()) + 10.0;
        if (x > area.left && x + needed > area.right) {
            x = area.left;
            ++line;
        }
        if (page != nullptr) {
            const double y = top + legend_line_px * static_cast<double>(line);
            page->circle({x + 5.0, y - 4.0}, 4.0, series_color(i));
            page->text({x + 14.0, y}, name, {TextAnchor::start, 11.0});
        }
        x += needed;
    }
    return line + 1;
}

bool overlap(const Area& a, const Area& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

// Labels beside their points, above or below, clear of the marks if possible and always clear of each other; labels
// that do not fit are left out.
void draw_labels(Drawing& page, const LogLogPanel& panel, const Area& inner,
                 const std::function<PagePoint(const MarkedPoint&)>& place) {
    constexpr double size_px = 10.0;
    std::vector<Area> marks;
    for (const MarkedSeries& series : panel.series)
        for (const MarkedPoint& point : series.points)
            if (const PagePoint at = place(point); drawn(point))
                marks.push_back({at.x - 4.0, at.y - 4.0, at.x + 4.0, at.y + 4.0});
    std::vector<Area> labels;
    for (const MarkedSeries& series : panel.series)
        for (const MarkedPoint& point : series.points) {
            if (!drawn(point) || point.label.empty()) continue;
            const PagePoint at = place(point);
            const bool left = at.x > 0.5 * (inner.left + inner.right);
            const double x = at.x + (left ? -8.0 : 8.0);
            const double width = text_width_px(point.label, size_px);
            const auto box = [&](double down) {
                return Area{left ? x - width : x, at.y + down - size_px, left ? x : x + width, at.y + down + 2.0};
            };
            const auto free = [&](const std::vector<Area>& others, const Area& own) {
                return std::none_of(others.begin(), others.end(),
                                    [&](const Area& other) { return overlap(own, other); });
            };
            constexpr std::array places{-5.0, 14.0, -17.0, 26.0};
            const auto fits = [&](double down) {
                const Area own = box(down);
                return own.top >= inner.top && own.bottom <= inner.bottom && free(labels, own);
            };
            const auto* found = std::find_if(places.begin(), places.end(),
                                             [&](double down) { return fits(down) && free(marks, box(down)); });
            if (found == places.end()) found = std::find_if(places.begin(), places.end(), fits);
            if (found == places.end()) continue;
            labels.push_back(box(*found));
            page.text({x, at.y + *found}, point.label,
                      {left ? TextAnchor::end : TextAnchor::start, size_px, ink(0x333333), false, 1.5});
        }
}

void draw_panel(Drawing& page, const LogLogPanel& panel, Area area) {
    page.text({area.left, area.top + 12.0}, panel.title, {TextAnchor::start, 13.0, {}, true});
    area.top += 20.0;
    const std::size_t lines = draw_legend(nullptr, panel, area, 0.0);
    const double legend_top = area.bottom - legend_line_px * (static_cast<double>(lines) - 1.0) - 6.0;
    (void)draw_legend(&page, panel, area, legend_top);
    area.bottom = legend_top - legend_line_px;

    Bounds x;
    Bounds y;
    bool zero = false;
    for (const MarkedSeries& series : panel.series)
        for (const MarkedPoint& point : series.points)
            if (drawn(point)) {
                x.take(point.x);
                y.take(point.y);
                zero = zero || point.y == 0.0;
            }
    if (y.high == 0.0) y = {1e-17, 1e-16};
    if (zero) y.low *= 0.1;
    // Keep marks off the frame.
    x = {x.low * 0.95, x.high * 1.05};
    y = {y.low * 0.75, y.high * 1.33};
    const Chart chart(area, {panel.x_name, decades(x), true}, {panel.y_name, decades(y), true});
    chart.draw_lines(page, ink(0xdddddd));
    chart.draw_numbers(page);
    const double lowest = decades(y).front();
    const auto place = [&](const MarkedPoint& point) { return chart.at(point.x, std::max(point.y, lowest)); };

    PagePath steps;
    for (std::size_t i = 0; i < panel.front.size(); ++i) {
        const PagePoint to = place(panel.front[i]);
        if (i > 0) steps.line_to({to.x, place(panel.front[i - 1]).y});
        i == 0 ? steps.move_to(to) : steps.line_to(to);
    }
    page.stroke(std::move(steps), {ink(0x999999), 1.0, {5.0, 3.0}});
    for (std::size_t i = 0; i < panel.series.size(); ++i) {
        const Ink color = series_color(i);
        PagePath line;
        for (const MarkedPoint& point : panel.series[i].points)
            if (panel.series[i].joined && drawn(point))
                line.empty() ? line.move_to(place(point)) : line.line_to(place(point));
        page.stroke(std::move(line), {color, 1.5});
        for (const MarkedPoint& point : panel.series[i].points)
            if (drawn(point)) draw_mark(page, place(point), point, color);
    }
    draw_labels(page, panel, chart.inner(), place);
}

bool has_points(const LogLogPanel& panel) {
    return std::any_of(panel.series.begin(), panel.series.end(), [](const MarkedSeries& series) {
        return std::any_of(series.points.begin(), series.points.end(), drawn);
    });
}

} // namespace

Result<std::string> log_log_panels(std::span<const LogLogPanel> panels, const LogLogOptions& options) {
    std::vector<const LogLogPanel*> shown;
    for (const LogLogPanel& panel : panels)
        if (has_points(panel)) shown.push_back(&panel);
    if (shown.empty()) return fail("USE0104", "there is nothing to draw");
    const int columns = std::clamp(static_cast<int>(shown.size()), 1, std::max(options.columns, 1));
    const int rows = (static_cast<int>(shown.size()) + columns - 1) / columns;
    const int width = columns * options.panel_width_px;
    const int height = rows * options.panel_height_px + static_cast<int>(2.0 * headline_px);
    Drawing page(width, height, options.title);
    page.text({margin_px, headline_px - 8.0}, options.title, {TextAnchor::start, 16.0, {}, true});
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const int column = static_cast<int>(i) % columns;
        const int row = static_cast<int>(i) / columns;
        const double left = column * options.panel_width_px;
        const double top = headline_px + row * options.panel_height_px;
        draw_panel(page, *shown[i],
                   {left + margin_px, top + margin_px, left + options.panel_width_px - margin_px,
                    top + options.panel_height_px - 4.0});
    }
    page.text({margin_px, height - 10.0}, options.note, {TextAnchor::start, 11.0, ink(0x555555)});
    return to_svg(page);
}

} // namespace gonio
