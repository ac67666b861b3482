#include <gonio/base/unit_text.hpp>
#include <gonio/plot/axis.hpp>
#include <gonio/plot/diagram.hpp>
#include <gonio/plot/diagram_page.hpp>
#include <gonio/plot/page_font.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace gonio {

using namespace plot_detail;

namespace {

constexpr double label_room_px = 26.0;
constexpr TextStyle label_style{TextAnchor::middle, 11.0, ink(0x333333), false, 1.5};

// Whether no curve exceeds this share of the greatest intensity above (or below) the horizontal.
bool is_dark(std::span<const PlaneCurve> curves, double top, bool above) {
    for (const PlaneCurve& curve : curves)
        for (const CurvePoint& point : curve.points)
            if ((std::fabs(point.gamma_deg) > 90.0) == above && point.intensity > 0.005 * top) return false;
    return true;
}

// The circle of the diagram, or the half of it that has light.
struct Dial {
    PagePoint center;
    double radius = 0.0;
    double least_deg = 0.0; // γ of the part that is drawn
    double most_deg = 180.0;

    PagePoint at(double gamma_deg, double share) const {
        const double angle = gamma_deg * (std::numbers::pi / 180.0);
        return {center.x + radius * share * std::sin(angle), center.y + radius * share * std::cos(angle)};
    }
};

Dial place_dial(const Area& area, bool lower, bool upper) {
    Dial dial;
    const double width = area.width() - 2.0 * label_room_px;
    const double height = area.height() - 2.0 * label_room_px;
    const bool half = lower != upper;
    dial.radius = std::min(0.5 * width, half ? height : 0.5 * height);
    const double spare = half ? 0.5 * (height - dial.radius) : 0.5 * height;
    dial.center.x = 0.5 * (area.left + area.right);
    dial.center.y = half ? (lower ? area.top + label_room_px + spare : area.bottom - label_room_px - spare)
                         : area.top + label_room_px + spare;
    dial.least_deg = lower ? 0.0 : 90.0;
    dial.most_deg = upper ? 180.0 : 90.0;
    return dial;
}

void draw_arc(Drawing& page, const Dial& dial, double share, Ink ink) {
    PagePath path;
    for (const double side : {-1.0, 1.0}) {
        bool first = true;
        for (const double gamma : even_steps(dial.least_deg, dial.most_deg, 2.0)) {
            const PagePoint point = dial.at(side * gamma, share);
            first ? path.move_to(point) : path.line_to(point);
            first = false;
        }
    }
    page.stroke(std::move(path), {ink});
}

void draw_grid(Drawing& page, const Dial& dial, const std::vector<double>& rings, const PlotOptions& options) {
    for (const double ring : rings)
        if (ring > 0.0) draw_arc(page, dial, ring / rings.back(), ink(0xcccccc));
    for (const double gamma : even_steps(dial.least_deg, dial.most_deg, 30.0))
        for (const double side : {-1.0, 1.0}) {
            if (side < 0.0 && (gamma == 0.0 || gamma == 180.0)) continue;
            page.line(dial.center, dial.at(side * gamma, 1.0), {ink(0xdddddd)});
            const PagePoint at = dial.at(side * gamma, 1.0 + 16.0 / dial.radius);
            page.text({at.x, at.y + 4.0}, fmt::format("{:.0f}°", gamma), {TextAnchor::middle, 11.0, ink(0x555555)});
        }
    const double along = dial.least_deg == 0.0 ? 15.0 : 165.0;
    const std::string last = intensity_text(rings.back(), options);
    // On a small dial the unit would reach the number of the angle beside it: it has a corner of its own.
    const double last_right =
        dial.radius * std::sin(15.0 * std::numbers::pi / 180.0) + 0.5 * page_text_width(last, label_style.size_px);
    const bool has_room = last_right + 2.0 < 0.5 * (dial.radius + 16.0) - 0.5 * page_text_width("30°", 11.0);
    for (const double ring : rings) {
        if (ring <= 0.0) continue;
        const PagePoint at = dial.at(along, ring / rings.back());
        page.text({at.x, at.y + 4.0}, ring == rings.back() && has_room ? last : rounded(ring, 4), label_style);
    }
    if (!has_room)
        page.text(
            {dial.center.x - dial.radius - 20.0, dial.center.y - (dial.most_deg > 90.0 ? dial.radius + 4.0 : 12.0)},
            options.per_klm ? "cd/klm" : "cd", {TextAnchor::start, 11.0, ink(0x555555)});
}

} // namespace

Result<Drawing> polar_diagram(std::span<const PlottedWeb> webs, const PlotOptions& options) {
    Result<void> fine = check_request(webs, options, webs.size());
    if (!fine) return pass_on(fine);
    Result<std::vector<PlaneCurve>> curves = plane_curves(webs, options);
    if (!curves) return pass_on(curves);
    Result<double> top = greatest(*curves, webs);
    if (!top) return pass_on(top);

    std::vector<LegendEntry> legend;
    for (const PlaneCurve& curve : *curves)
        legend.push_back(curve.legend);
    const bool lower = !is_dark(*curves, *top, false);
    const bool upper = !is_dark(*curves, *top, true);
    PlotOptions page_options = options;
    if (options.lower_if_half && lower != upper) {
        const double radius = 0.5 * options.width_px - page_margin_px - label_room_px;
        const double height = radius + 2.0 * label_room_px + furniture_px(webs, options, legend);
        page_options.height_px = std::min(options.height_px, static_cast<int>(std::ceil(height)));
    }
    Area area;
    Drawing page = begin_page(webs, page_options, "polar diagram of the luminous intensity", legend, area);
    const Dial dial = place_dial(area, lower, upper);
    const std::vector<double> rings = ticks(0.0, *top, 5);
    draw_grid(page, dial, rings, options);
    for (const PlaneCurve& curve : *curves) {
        PagePath path;
        bool down = false; // whether the pen is down
        for (const CurvePoint& point : curve.points) {
            const double gamma = std::fabs(point.gamma_deg);
            const bool drawn = gamma >= dial.least_deg && gamma <= dial.most_deg;
            if (drawn) {
                const PagePoint at = dial.at(point.gamma_deg, point.intensity / rings.back());
                down ? path.line_to(at) : path.move_to(at);
            }
            down = drawn;
        }
        page.stroke(std::move(path), curve.legend.pen);
    }
    return page;
}

} // namespace gonio
