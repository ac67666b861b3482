#include <gonio/plot/axis.hpp>
#include <gonio/plot/chart.hpp>
#include <gonio/plot/diagram.hpp>
#include <gonio/plot/diagram_page.hpp>

#include <cmath>
#include <utility>

namespace gonio {

using namespace plot_detail;

Result<Drawing> cartesian_diagram(std::span<const PlottedWeb> webs, const PlotOptions& options) {
    Result<void> fine = check_request(webs, options, webs.size());
    if (!fine) return pass_on(fine);
    Result<std::vector<PlaneCurve>> curves = plane_curves(webs, options);
    if (!curves) return pass_on(curves);
    Result<double> top = greatest(*curves, webs);
    if (!top) return pass_on(top);

    // The part of the axis that has light, rounded up to the next 30°.
    double reach_deg = 0.0;
    for (const PlaneCurve& curve : *curves)
        for (const CurvePoint& point : curve.points)
            if (point.intensity > 0.001 * *top) reach_deg = std::fmax(reach_deg, std::fabs(point.gamma_deg));
    reach_deg = std::fmax(30.0, 30.0 * std::ceil(reach_deg / 30.0 - 1e-6));
    // Numbers of angles need some 34 px each.
    const bool is_narrow = reach_deg > 60.0 && (options.width_px - 96.0) * 15.0 / reach_deg < 34.0;
    if (is_narrow) reach_deg = 60.0 * std::ceil(reach_deg / 60.0 - 1e-6);
    const std::vector<double> angles = even_steps(-reach_deg, reach_deg,
                                                  is_narrow          ? 60.0
                                                  : reach_deg > 60.0 ? 30.0
                                                                     : 10.0);

    std::vector<LegendEntry> legend;
    for (const PlaneCurve& curve : *curves)
        legend.push_back(curve.legend);
    Area area;
    Drawing page = begin_page(webs, options, "luminous intensity against the angle from the nadir", legend, area);
    const std::vector<double> intensities = ticks(0.0, *top, 6);
    const Chart chart(area, {"gamma [°], C + 180° to the left", angles},
                      {options.per_klm ? "intensity [cd/klm]" : "intensity [cd]", intensities});
    chart.draw_lines(page, ink(0xdddddd));
    chart.draw_numbers(page);
    page.begin_clip({chart.inner().left, chart.inner().top - 2.0}, chart.inner().width(), chart.inner().height() + 4.0);
    for (const PlaneCurve& curve : *curves) {
        PagePath path;
        for (const CurvePoint& point : curve.points) {
            if (std::fabs(point.gamma_deg) > reach_deg) continue;
            const PagePoint at = chart.at(point.gamma_deg, point.intensity);
            path.empty() ? path.move_to(at) : path.line_to(at);
        }
        page.stroke(std::move(path), curve.legend.pen);
    }
    page.end_clip();
    return page;
}

} // namespace gonio
