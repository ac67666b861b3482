#include <gonio/plot/axis.hpp>
#include <gonio/plot/bands.hpp>
#include <gonio/plot/chart.hpp>
#include <gonio/plot/diagram.hpp>
#include <gonio/plot/diagram_page.hpp>

#include <cmath>

namespace gonio {

using namespace plot_detail;

namespace {

constexpr double step_deg = 2.0;
constexpr int bands = 24;
constexpr double scale_room_px = 76.0;

Field field_of(const Web& web, double scale) {
    Field field;
    field.xs = even_steps(0.0, 360.0, step_deg);
    field.ys = even_steps(0.0, 180.0, step_deg);
    field.values.reserve(field.xs.size() * field.ys.size());
    for (const double gamma : field.ys)
        for (const double c : field.xs)
            field.values.push_back(scale * web.candela(c, gamma));
    return field;
}

} // namespace

Result<Drawing> heat_map_diagram(std::span<const PlottedWeb> webs, const PlotOptions& options) {
    Result<void> fine = check_request(webs, options, 1);
    if (!fine) return pass_on(fine);
    Result<double> scale = intensity_scale(webs[0], options);
    if (!scale) return pass_on(scale);
    const Field field = field_of(*webs[0].web, *scale);
    double top = 0.0;
    for (const double value : field.values)
        top = std::fmax(top, value);
    Result<void> bright = check_top(top, webs, "the profile is dark, so there is nothing to draw", {});
    if (!bright) return pass_on(bright);

    Area area;
    Drawing page = begin_page(webs, options, "luminous intensity over C and gamma", {}, area);
    const Area left{area.left, area.top, area.right - scale_room_px, area.bottom};
    const Chart chart(left, {"C [°]", {0, 45, 90, 135, 180, 225, 270, 315, 360}},
                      {"gamma [°]", {0, 30, 60, 90, 120, 150, 180}}, true);
    std::vector<double> levels = ticks(0.0, top, bands);
    while (levels.back() >= top)
        levels.pop_back();
    const std::vector<Ink> colors = band_colors(levels.size());
    page.rectangle({chart.inner().left, chart.inner().top}, chart.inner().width(), chart.inner().height(), colors[0]);
    draw_bands(page, chart, field, {levels.begin() + 1, levels.end()}, {colors.begin() + 1, colors.end()});
    chart.draw_lines(page, ink(0xffffff, 0.25));
    chart.draw_numbers(page);
    draw_color_scale(page, {left.right + 12.0, chart.inner().top, area.right, chart.inner().bottom}, levels, colors,
                     options.per_klm ? "cd/klm" : "cd");
    return page;
}

} // namespace gonio
