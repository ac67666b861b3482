// What the diagrams share: the page with its title and legend, curves along a plane, and the checks of a request.
// Internal to this room.
#pragma once

#include <gonio/plot/diagram.hpp>
#include <gonio/plot/drawing.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace gonio::plot_detail {

inline constexpr double page_margin_px = 16.0;

// The drawing area of a diagram, below the title and above the legend.
struct Area {
    double left = 0.0;
    double top = 0.0;
    double right = 0.0;
    double bottom = 0.0;

    double width() const { return right - left; }
    double height() const { return bottom - top; }
};

struct LegendEntry {
    std::string text;
    Pen pen;
};

// Fails unless there is at least one web and at most `most`, on a page with sides of 160 to 16384 pixels.
Result<void> check_request(std::span<const PlottedWeb> webs, const PlotOptions& options, std::size_t most);

// A page with the title and the facts of a single luminaire at the top and the legend at the bottom; `area` receives
// the remaining space. Small pages have no facts.
Drawing begin_page(std::span<const PlottedWeb> webs, const PlotOptions& options, std::string_view diagram,
                   std::span<const LegendEntry> legend, Area& area);

// Height that begin_page() takes from a page.
double furniture_px(std::span<const PlottedWeb> webs, const PlotOptions& options, std::span<const LegendEntry> legend);

// 1, or the factor from candela to candela per 1000 lm. Fails if the web has no flux to divide by.
Result<double> intensity_scale(const PlottedWeb& plotted, const PlotOptions& options);

struct CurvePoint {
    double gamma_deg = 0.0; // negative on the side of C + 180°
    double intensity = 0.0; // never negative
};

// The intensities in one plane and its opposite from γ = −180° to 180°, dense enough to be joined by straight lines,
// with both values at every end of the table.
std::vector<CurvePoint> plane_curve(const Web& web, double c_deg, double scale);

// The curves of a diagram of planes: one for each web and plane; a web's curves after its first are dashed. An axial
// web has one.
struct PlaneCurve {
    LegendEntry legend;
    std::vector<CurvePoint> points;
};

Result<std::vector<PlaneCurve>> plane_curves(std::span<const PlottedWeb> webs, const PlotOptions& options);

// The greatest intensity of all curves. Fails if all are dark, and as check_top does.
Result<double> greatest(std::span<const PlaneCurve> curves, std::span<const PlottedWeb> webs);

// Fails unless the greatest value of a diagram fits on an axis: 1e-200 to 1e200. `dark` and `hint` are the message for
// a web without light there.
Result<void> check_top(double top, std::span<const PlottedWeb> webs, std::string dark, std::string hint);

// "3535 cd", "2950 cd/klm"
std::string intensity_text(double intensity, const PlotOptions& options);

} // namespace gonio::plot_detail
