#include <gonio/base/unit_text.hpp>
#include <gonio/plot/axis.hpp>
#include <gonio/plot/bands.hpp>
#include <gonio/plot/chart.hpp>
#include <gonio/plot/diagram.hpp>
#include <gonio/plot/diagram_page.hpp>
#include <gonio/plot/page_font.hpp>
#include <gonio/plot/stroke_font.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace gonio {

using namespace plot_detail;

namespace {

constexpr int cells = 160;
constexpr double scale_room_px = 76.0;
constexpr double decades = 2.0; // range of the lines below the brightest point

// E = I cosγ / d² on the plane z = 0 from a point at height h that is aimed straight down.
Field field_of(const Web& web, double height_m, double extent_m) {
    Field field;
    for (int i = 0; i <= cells; ++i)
        field.xs.push_back(extent_m * (2.0 * i / cells - 1.0));
    field.ys = field.xs;
    for (const double y : field.ys)
        for (const double x : field.xs) {
            const glm::dvec3 ray(x, y, -height_m);
            const double square = x * x + y * y + height_m * height_m;
            field.values.push_back(web.candela(ray) * height_m / (square * std::sqrt(square)));
        }
    return field;
}

constexpr double number_px = 11.0;

// Numbers that were written, which no other covers.
class WrittenNumbers {
public:
    bool has_room(PagePoint at, double half_width) const {
        return std::none_of(written_.begin(), written_.end(), [&](const Number& other) {
            return std::fabs(at.x - other.at.x) < half_width + other.half_width + 2.0 &&
                   std::fabs(at.y - other.at.y) < number_px;
        });
    }
    void add(PagePoint at, double half_width) { written_.push_back({at, half_width}); }

private:
    struct Number {
        PagePoint at;
        double half_width;
    };
    std::vector<Number> written_;
};

// The lux of a line is written where the line is farthest along +X, so that the numbers of nested lines form a row;
// where the lines are too close for that, on another side, or not at all: colours say it as well.
void label_line(Drawing& page, const Chart& chart, const ContourLine& line, double level, WrittenNumbers& written) {
    double length = 0.0;
    std::array<PagePoint, 4> ends; // right, left, top, bottom of the page
    ends.fill(chart.at(line.points.front().x, line.points.front().y));
    PagePoint before = ends[0];
    for (const FieldPoint& point : line.points) {
        const PagePoint at = chart.at(point.x, point.y);
        length += std::hypot(at.x - before.x, at.y - before.y);
        before = at;
        if (at.x > ends[0].x) ends[0] = at;
        if (at.x < ends[1].x) ends[1] = at;
        if (at.y < ends[2].y) ends[2] = at;
        if (at.y > ends[3].y) ends[3] = at;
    }
    if (length < 60.0) return; // the number would hide the line
    const std::string text = rounded(level);
    const double half_width = 0.5 * std::max(text_width_px(text, number_px), page_text_width(text, number_px));
    const Area& inner = chart.inner();
    for (PagePoint at : ends) {
        at.x = std::clamp(at.x, inner.left + 14.0, inner.right - 14.0);
        at.y = std::clamp(at.y, inner.top + 8.0, inner.bottom - 8.0);
        if (!written.has_room(at, half_width)) continue;
        written.add(at, half_width);
        page.text({at.x, at.y + 4.0}, text, {TextAnchor::middle, number_px, ink(0x333333), false, 1.5});
        return;
    }
}

} // namespace

Result<Drawing> isolux_diagram(std::span<const PlottedWeb> webs, const PlotOptions& options) {
    Result<void> fine = check_request(webs, options, 1);
    if (!fine) return pass_on(fine);
    Result<double> scale = intensity_scale(webs[0], options);
    if (!scale) return pass_on(scale);
    const double height_m = options.mounting_height_m;
    const double extent_m = options.extent_m > 0.0 ? options.extent_m : 2.0 * height_m;
    Field field = field_of(*webs[0].web, height_m, extent_m);
    double top = 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (double& value : field.values) {
        value *= *scale;
        top = std::fmax(top, value);
        least = std::fmin(least, value);
    }
    Result<void> bright = check_top(top, webs, "no light reaches the plane below the luminaire",
                                    "it may shine upwards: try the polar diagram");
    if (!bright) return pass_on(bright);

    Area area;
    Drawing page = begin_page(webs, options, "illuminance on the plane below", {}, area);
    const Area left{area.left, area.top, area.right - (options.has_bands ? scale_room_px : 0.0), area.bottom - 18.0};
    const std::vector<double> meters = ticks(-extent_m, extent_m, 8);
    const std::vector<double> inside = [&] { // the ticks within the square, and its edges
        std::vector<double> at{-extent_m};
        for (const double meter : meters)
            if (meter > -0.92 * extent_m && meter < 0.92 * extent_m) at.push_back(meter); // room for the numbers
        at.push_back(extent_m);
        return at;
    }();
    const Chart chart(left, {"C0 → [m]", inside}, {"C90 ↑ [m]", inside}, false, true);
    constexpr std::size_t lines_wanted = 6;
    std::vector<double> levels = fitting_levels(std::fmax(least, top * std::pow(10.0, -decades)), top, lines_wanted);
    // Where all of the plane is bright, the lowest band begins at its least value, rounded down to three digits.
    if (least > top * std::pow(10.0, -decades)) {
        const double digit = std::pow(10.0, std::floor(std::log10(least)) - 2.0);
        levels.insert(levels.begin(), digit * std::floor(least / digit));
    }
    const std::vector<Ink> colors = band_colors(levels.size());
    if (options.has_bands) {
        page.begin_clip({chart.inner().left, chart.inner().top}, chart.inner().width(), chart.inner().height());
        page.rectangle({chart.inner().left, chart.inner().top}, chart.inner().width(), chart.inner().height(),
                       ink(0x2a0033));
        draw_bands(page, chart, field, levels, colors);
        page.end_clip();
    }
    chart.draw_lines(page, options.has_bands ? ink(0xffffff, 0.2) : ink(0xe3e3e3));
    std::vector<std::pair<double, std::vector<ContourLine>>> lines;
    for (const double level : levels)
        lines.emplace_back(level, contour_lines(field, level));
    for (const auto& [level, contours] : lines)
        for (const ContourLine& line : contours) {
            PagePath path;
            for (const FieldPoint& point : line.points)
                path.empty() ? path.move_to(chart.at(point.x, point.y)) : path.line_to(chart.at(point.x, point.y));
            if (line.closed) path.close();
            page.stroke(std::move(path), {ink(0x333333), 0.8});
        }
    WrittenNumbers written;
    for (const auto& [level, contours] : lines) // above all lines
        for (const ContourLine& line : contours)
            label_line(page, chart, line, level, written);
    chart.draw_numbers(page);
    if (options.has_bands)
        draw_color_scale(page, {left.right + 12.0, chart.inner().top, area.right, chart.inner().bottom}, levels, colors,
                         options.per_klm ? "lx/klm" : "lx");
    page.text({chart.inner().left, area.bottom}, fmt::format("height {} m, brightest {}", rounded(height_m),
                                                             rounded(top, 4) + (options.per_klm ? " lx/klm" : " lx")));
    return page;
}

} // namespace gonio
