#include <gonio/base/unit_text.hpp>
#include <gonio/light/shape_traits.hpp>
#include <gonio/plot/axis.hpp>
#include <gonio/plot/chart.hpp>
#include <gonio/plot/diagram_page.hpp>
#include <gonio/plot/falloff_diagram.hpp>
#include <gonio/plot/palette.hpp>
#include <gonio/scene/probe.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace gonio {

using namespace plot_detail;

namespace {

constexpr double steps_per_decade = 80.0;
constexpr double shortest_m = 1e-3;
constexpr double longest_m = 1e5;

std::vector<double> distances(const FalloffOptions& options) {
    const double decades = std::log10(options.farthest_m / options.nearest_m);
    const int count = std::max(2, static_cast<int>(std::ceil(steps_per_decade * decades)));
    std::vector<double> at;
    for (int i = 0; i <= count; ++i)
        at.push_back(options.nearest_m *
                     std::pow(options.farthest_m / options.nearest_m, i / static_cast<double>(count)));
    return at;
}

// Lux at each distance.
Result<std::vector<double>> lux_along(const Light& light, const std::vector<double>& meters) {
    const glm::dvec3 direction = -light.frame.z;
    std::vector<Receiver> receivers;
    for (const double d : meters)
        receivers.push_back({light.frame.origin + d * direction, -direction});
    Result<ProbeResult> probed = probe({&light, 1}, receivers, {});
    if (!probed) return pass_on(probed);
    return std::move(probed->illuminance_lx);
}

// The extent of the light itself along its direction.
double own_reach_m(const Shape& shape) {
    return with_traits(shape, []<class Kind>(const Kind& kind, ShapeTraits<Kind>) {
        if constexpr (PunctualShape<Kind>)
            return 0.0;
        else
            return ShapeTraits<Kind>::nearest(kind);
    });
}

PagePath path_of(const Chart& chart, const std::vector<double>& meters, const std::vector<double>& lux,
                 double reach_m) {
    PagePath path;
    bool down = false; // whether the pen is down
    for (std::size_t i = 0; i < meters.size(); ++i) {
        const bool drawn = lux[i] > 0.0 && meters[i] > reach_m * (1.0 + 1e-9);
        if (drawn) {
            const PagePoint at = chart.at(meters[i], lux[i]);
            down ? path.line_to(at) : path.move_to(at);
        }
        down = drawn;
    }
    return path;
}

struct Curves {
    std::vector<double> lux;
    std::vector<double> without_window; // empty without a range
    std::vector<double> inverse_square;
    double reach_m = 0.0;
};

Result<Curves> curves_of(const PlottedLight& plotted, const std::vector<double>& meters) {
    if (class_of(plotted.light.shape) == ShapeClass::sun)
        return fail(Failure::usage, "a sun gives the same illuminance at every distance: it has no falloff to draw", {},
                    plotted.label);
    Curves curves;
    curves.reach_m = own_reach_m(plotted.light.shape);
    const double candela = plotted.light.intensity_towards(-plotted.light.frame.z).value;
    if (!(candela > 0.0))
        return fail(Failure::usage, "the light is dark along its direction", "the polar diagram shows where it shines",
                    plotted.label);
    for (const double d : meters)
        curves.inverse_square.push_back(candela / (d * d));
    Result<std::vector<double>> lux = lux_along(plotted.light, meters);
    if (!lux) return pass_on(lux);
    curves.lux = std::move(*lux);
    if (plotted.light.range) {
        Light unlimited = plotted.light;
        unlimited.range.reset();
        lux = lux_along(unlimited, meters);
        if (!lux) return pass_on(lux);
        curves.without_window = std::move(*lux);
    }
    return curves;
}

// 1, 2 and 5 times the powers of ten around a span; only the powers if there are many.
std::vector<double> log_lines(double low, double high) {
    const double first = std::floor(std::log10(low) + 1e-9);
    const double last = std::fmax(std::ceil(std::log10(high) - 1e-9), first + 1.0);
    std::vector<double> at;
    const double every = std::ceil((last - first) / 10.0);
    const int count = static_cast<int>((last + every - 1.0 - first) / every);
    for (int i = 0; i <= count; ++i)
        at.push_back(std::pow(10.0, first + i * every));
    if (last - first > 3.0) return at;
    return levels_1_2_5(at.front() * (1.0 - 1e-9), at.back() * (1.0 + 1e-9));
}

} // namespace

Result<Drawing> falloff_diagram(std::span<const PlottedLight> lights, const FalloffOptions& options) {
    PlotOptions page_options;
    page_options.width_px = options.width_px;
    page_options.height_px = options.height_px;
    page_options.title = options.title;
    std::vector<PlottedWeb> names;
    for (const PlottedLight& plotted : lights)
        names.push_back({plotted.label, nullptr});
    Result<void> fine = check_request(names, page_options, names.size());
    if (!fine) return pass_on(fine);
    if (!(options.nearest_m >= shortest_m && options.farthest_m <= longest_m &&
          options.farthest_m >= 1.5 * options.nearest_m))
        return fail("USE0106",
                    fmt::format("the distances {} m to {} m are not a valid range", rounded(options.nearest_m),
                                rounded(options.farthest_m)),
                    "they must lie from 1 mm to 100 km, the farther one at least 1.5 times the nearer");

    const std::vector<double> meters = distances(options);
    std::vector<Curves> all;
    std::vector<LegendEntry> legend;
    double low = HUGE_VAL;
    double high = 0.0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        Result<Curves> curves = curves_of(lights[i], meters);
        if (!curves) return pass_on(curves);
        // The inverse square sets the lower end of the axis: a window ends at 0, which a logarithmic axis cannot show.
        low = std::fmin(low, curves->inverse_square.back());
        for (std::size_t k = 0; k < meters.size(); ++k)
            if (meters[k] > curves->reach_m) high = std::fmax(high, curves->lux[k]);
        all.push_back(std::move(*curves));
        legend.push_back({lights[i].label, {series_color(i), 2.0}});
    }
    legend.push_back({"inverse square", {ink(0x888888), 1.0, {6.0, 4.0}}});
    if (std::any_of(all.begin(), all.end(), [](const Curves& curves) { return !curves.without_window.empty(); }))
        legend.push_back({"without the window", {ink(0x888888), 1.5, {1.5, 3.0}}});
    fine = check_top(high, names, "no light reaches these distances", "choose others with --distance");
    if (!fine) return pass_on(fine);

    Area area;
    Drawing page = begin_page(names, page_options, "illuminance on the axis against the distance", legend, area);
    const bool few = std::log10(options.farthest_m / options.nearest_m) <= 3.2;
    std::vector<double> x_lines =
        few ? levels_1_2_5(options.nearest_m, options.farthest_m) : log_lines(options.nearest_m, options.farthest_m);
    std::erase_if(x_lines, [&](double at) { return at <= options.nearest_m * 1.2 || at >= options.farthest_m / 1.2; });
    x_lines.insert(x_lines.begin(), options.nearest_m);
    x_lines.push_back(options.farthest_m);
    const Chart chart(area, {"distance [m]", x_lines, true}, {"illuminance [lx]", log_lines(low, high), true});
    chart.draw_lines(page, ink(0xdddddd));
    chart.draw_numbers(page);
    const Area& inner = chart.inner();
    page.begin_clip({inner.left, inner.top}, inner.width(), inner.height());
    for (std::size_t i = 0; i < all.size(); ++i) {
        Ink pale = series_color(i);
        pale.opacity = 0.75;
        page.stroke(path_of(chart, meters, all[i].inverse_square, 0.0), {pale, 1.0, {6.0, 4.0}});
        if (!all[i].without_window.empty())
            page.stroke(path_of(chart, meters, all[i].without_window, all[i].reach_m), {pale, 1.5, {1.5, 3.0}});
        page.stroke(path_of(chart, meters, all[i].lux, all[i].reach_m), {series_color(i), 2.0});
    }
    page.end_clip();
    return page;
}

} // namespace gonio
