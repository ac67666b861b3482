#include <gonio/base/unit_text.hpp>
#include <gonio/plot/axis.hpp>
#include <gonio/plot/chart.hpp>
#include <gonio/plot/contour.hpp>
#include <gonio/plot/diagram_page.hpp>
#include <gonio/plot/grid_diagram.hpp>
#include <gonio/plot/palette.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

namespace gonio {

using namespace plot_detail;

namespace {

constexpr double scale_room_px = 76.0;
constexpr double furniture_width_px = 2.0 * page_margin_px + scale_room_px + 64.0; // beside the cells
constexpr double furniture_height_px = 2.0 * page_margin_px + 58.0;                // above and below, without a title
constexpr double title_height_px = 26.0;
constexpr double facts_height_px = 22.0;
constexpr double letter_share = 0.62; // width of a digit over its height
constexpr double greatest_letters_px = 12.0;
constexpr double least_letters_px = 7.0;
constexpr double letters_of_marks_px = 11.0;
constexpr int least_px = 160;
constexpr int most_px = 16384;
constexpr int usual_most_px = 1600;
constexpr std::size_t lines_wanted = 5;

// All numbers of a grid have the decimals that its greatest needs for three digits.
std::string cell_text(double value, double greatest) {
    const int decimals = greatest >= 100.0 ? 0 : greatest >= 10.0 ? 1 : 2;
    return greatest >= 1e6 || greatest < 0.1 ? rounded(value, 3) : fmt::format("{:.{}f}", value, decimals);
}

struct Range {
    double least = std::numeric_limits<double>::infinity();
    double greatest = 0.0;
};

Range range_of(const std::vector<double>& values) {
    Range range;
    for (const double value : values) {
        if (std::isnan(value)) continue;
        range.least = std::fmin(range.least, value);
        range.greatest = std::fmax(range.greatest, value);
    }
    if (!(range.least <= range.greatest)) range.least = 0.0;
    return range;
}

std::size_t longest_text(const std::vector<double>& values, double greatest) {
    std::size_t longest = 1;
    for (const double value : values)
        if (!std::isnan(value)) longest = std::max(longest, cell_text(value, greatest).size());
    return longest;
}

// Both edges, and round numbers between them.
std::vector<double> axis_of(double low, double high) {
    std::vector<double> at{low};
    const double room = 0.04 * (high - low);
    for (const double tick : ticks(low, high, 8))
        if (tick > low + room && tick < high - room) at.push_back(tick);
    at.push_back(high);
    return at;
}

// The page that the plan needs for its numbers, between 480 and 1600 pixels wide.
std::pair<int, int> page_size(const GridPlot& plot, std::size_t letters, double above_px) {
    if (plot.width_px > 0) return {plot.width_px, plot.height_px};
    const double cell_width = plot.width_m / static_cast<double>(plot.columns);
    const double cell_height = plot.height_m / static_cast<double>(plot.rows);
    const double numbers_px = letter_share * greatest_letters_px * static_cast<double>(letters) + 8.0;
    const double wanted = std::max(numbers_px / cell_width, (greatest_letters_px + 6.0) / cell_height);
    const double most = std::min((usual_most_px - furniture_width_px) / plot.width_m,
                                 (usual_most_px - furniture_height_px - above_px) / plot.height_m);
    const double least = (480.0 - furniture_width_px) / std::max(plot.width_m, plot.height_m);
    const double px_per_m = std::min(std::max(wanted, least), most);
    const auto side = [](double px, double at_least_px) {
        return static_cast<int>(std::clamp(std::ceil(px), at_least_px, double{usual_most_px}));
    };
    return {side(px_per_m * plot.width_m + furniture_width_px, 320.0),
            side(px_per_m * plot.height_m + furniture_height_px + above_px, 200.0)};
}

PagePath path_of(const Chart& chart, const ContourLine& line) {
    PagePath path;
    for (const FieldPoint& point : line.points)
        path.empty() ? path.move_to(chart.at(point.x, point.y)) : path.line_to(chart.at(point.x, point.y));
    if (line.closed) path.close();
    return path;
}

// Rings, so that a number in the middle of one stays legible.
void draw_marks(Drawing& page, const Chart& chart, const GridPlot& plot, double radius_px) {
    constexpr int corners = 32;
    const double right_m = plot.left_m + plot.width_m + plot.margin_m;
    const double top_m = plot.low_m + plot.height_m + plot.margin_m;
    const double left_m = plot.left_m - plot.margin_m;
    const double low_m = plot.low_m - plot.margin_m;
    for (std::size_t m = 0; m < plot.marks.size(); ++m) {
        const PagePoint& mark = plot.marks[m];
        if (!(mark.x >= left_m && mark.x <= right_m && mark.y >= low_m && mark.y <= top_m)) continue;
        const PagePoint at = chart.at(mark.x, mark.y);
        PagePath ring;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / corners;
            const PagePoint point{at.x + radius_px * std::cos(angle), at.y + radius_px * std::sin(angle)};
            ring.empty() ? ring.move_to(point) : ring.line_to(point);
        }
        ring.close();
        page.stroke(ring, {ink(0x000000), 3.0});
        page.stroke(std::move(ring), {ink(0xff9d5c), 1.5});
        if (m < plot.mark_letters.size() && !plot.mark_letters[m].empty())
            page.text({at.x + 0.75 * radius_px, at.y - 0.75 * radius_px}, plot.mark_letters[m],
                      {TextAnchor::start, letters_of_marks_px, ink(0x000000), true, 2.0});
    }
}

} // namespace

Result<Drawing> grid_diagram(const GridPlot& plot, bool& left_out) {
    const Range range = range_of(plot.values);
    const std::size_t letters = longest_text(plot.values, range.greatest);
    const double above_px = (plot.title.empty() ? 0.0 : title_height_px) + (plot.facts.empty() ? 0.0 : facts_height_px);
    const auto [width_px, height_px] = page_size(plot, letters, above_px);
    for (const int side : {width_px, height_px})
        if (side < least_px || side > most_px)
            return fail("USE0106", fmt::format("a diagram is {} to {} pixels wide and high, not {}x{}", least_px,
                                               most_px, width_px, height_px));
    Drawing page(width_px, height_px, fmt::format("{}: {}", plot.title.empty() ? "grid" : plot.title, plot.facts));
    Area area{page_margin_px, page_margin_px, width_px - page_margin_px, height_px - page_margin_px};
    if (!plot.title.empty()) {
        page.text({0.5 * width_px, area.top + 12.0}, plot.title, {TextAnchor::middle, 16.0, {}, true});
        area.top += title_height_px;
    }
    if (!plot.facts.empty()) {
        page.text({0.5 * width_px, area.top + 8.0}, plot.facts, {TextAnchor::middle, 12.0, ink(0x555555)});
        area.top += facts_height_px;
    }
    const Area left{area.left, area.top, area.right - scale_room_px, area.bottom};
    const double margin_m = plot.margin_m;
    const Chart chart(left, {plot.x_name, axis_of(plot.left_m - margin_m, plot.left_m + plot.width_m + margin_m)},
                      {plot.y_name, axis_of(plot.low_m - margin_m, plot.low_m + plot.height_m + margin_m)}, false,
                      true);
    const double cell_width = plot.width_m / static_cast<double>(plot.columns);
    const double cell_height = plot.height_m / static_cast<double>(plot.rows);
    const auto column_m = [&](double i) { return plot.left_m + cell_width * i; };
    const auto row_m = [&](double j) { return plot.low_m + cell_height * j; };

    // From the least value up, so that small differences show; white letters on dark cells.
    const Palette& palette = palettes().front();
    const double span = range.greatest - range.least;
    const auto share = [&](double value) { return span > 0.0 ? (value - range.least) / span : 0.5; };
    for (std::size_t j = 0; j < plot.rows; ++j)
        for (std::size_t i = 0; i < plot.columns; ++i) {
            const double value = plot.values[j * plot.columns + i];
            if (std::isnan(value)) continue;
            const PagePoint corner = chart.at(column_m(static_cast<double>(i)), row_m(static_cast<double>(j) + 1.0));
            const PagePoint end = chart.at(column_m(static_cast<double>(i) + 1.0), row_m(static_cast<double>(j)));
            page.rectangle(corner, end.x - corner.x, end.y - corner.y, palette.ink_at(share(value)));
        }

    Field field;
    for (std::size_t i = 0; i < plot.columns; ++i)
        field.xs.push_back(column_m(static_cast<double>(i) + 0.5));
    for (std::size_t j = 0; j < plot.rows; ++j)
        field.ys.push_back(row_m(static_cast<double>(j) + 0.5));
    field.values = plot.values;
    std::vector<std::int32_t> groups;
    for (const double value : plot.values)
        groups.push_back(std::isnan(value) ? -1 : 0);
    const bool has_lines = plot.columns > 1 && plot.rows > 1 && span > 0.0;
    const std::vector<double> levels =
        has_lines ? fitting_levels(std::fmax(range.least, 0.02 * range.greatest), range.greatest, lines_wanted)
                  : std::vector<double>();
    for (const double level : levels)
        for (const ContourLine& line : contour_lines(field, level, groups)) {
            page.stroke(path_of(chart, line), {ink(0x000000, 0.6), 2.6});
            page.stroke(path_of(chart, line), {ink(0xffffff), 1.2});
        }

    const double cell_px = chart.inner().width() * cell_width / (plot.width_m + 2.0 * margin_m);
    const double cell_high_px = chart.inner().height() * cell_height / (plot.height_m + 2.0 * margin_m);
    const double size_px = std::min(
        {greatest_letters_px, cell_high_px - 3.0, (cell_px - 3.0) / (letter_share * static_cast<double>(letters))});
    left_out = size_px < least_letters_px;
    draw_marks(page, chart, plot, std::clamp(0.44 * std::min(cell_px, cell_high_px), 4.0, 14.0));
    for (std::size_t j = 0; j < plot.rows && !left_out; ++j)
        for (std::size_t i = 0; i < plot.columns; ++i) {
            const double value = plot.values[j * plot.columns + i];
            if (std::isnan(value)) continue;
            const PagePoint at = chart.at(column_m(static_cast<double>(i) + 0.5), row_m(static_cast<double>(j) + 0.5));
            const bool is_dark = share(value) < 0.6;
            TextStyle style{TextAnchor::middle, size_px, is_dark ? ink(0xffffff) : ink(0x000000), false, 2.0};
            style.rim = palette.ink_at(share(value));
            page.text({at.x, at.y + 0.36 * size_px}, cell_text(value, range.greatest), style);
        }

    if (!plot.outline.empty()) {
        PagePath outline;
        for (const PagePoint& corner : plot.outline)
            outline.empty() ? outline.move_to(chart.at(corner.x, corner.y))
                            : outline.line_to(chart.at(corner.x, corner.y));
        outline.close();
        page.stroke(std::move(outline), {ink(0x333333), 1.5});
    }
    chart.draw_numbers(page);

    std::vector<double> scale = span > 0.0 ? ticks(range.least, range.greatest, 14) : std::vector{range.least};
    if (scale.size() > 1) scale.pop_back();
    std::vector<Ink> colors;
    for (std::size_t i = 0; i < scale.size(); ++i)
        colors.push_back(
            palette.ink_at(share(i + 1 < scale.size() ? 0.5 * (scale[i] + scale[i + 1]) : range.greatest)));
    draw_color_scale(page, {left.right + 12.0, chart.inner().top, area.right, chart.inner().bottom}, scale, colors,
                     plot.unit.empty() ? "ratio" : plot.unit);
    if (!levels.empty()) {
        std::string text = "lines";
        for (std::size_t i = 0; i < levels.size(); ++i)
            text += fmt::format("{} {}", i == 0 ? "" : ",", rounded(levels[i], levels[i] >= 1000.0 ? 6 : 3));
        page.text({chart.inner().right, chart.inner().top - 8.0},
                  plot.unit.empty() ? text : fmt::format("{} {}", text, plot.unit),
                  {TextAnchor::end, 11.0, ink(0x555555)});
    }
    return page;
}

} // namespace gonio
