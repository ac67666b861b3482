#include <gonio/base/limits.hpp>
#include <gonio/base/sort_unique.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/plot/axis.hpp>
#include <gonio/plot/diagram_page.hpp>
#include <gonio/plot/palette.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace gonio::plot_detail {

namespace {

constexpr int least_px = 160;
constexpr int most_px = static_cast<int>(limit("picture-side").value);
constexpr double line_px = 20.0; // of the legend
constexpr double swatch_px = 28.0;
constexpr double letter_px = 7.4; // approximate width of a letter at 12 px
constexpr double title_letter_px = 9.4;
constexpr double title_px = 28.0;
constexpr double facts_px = 22.0;
constexpr double curve_step_deg = 0.5;

// The γ at which a curve is evaluated on one side of the nadir.
std::vector<double> curve_gammas(const Web& web) {
    std::vector<double> gammas = even_steps(0.0, 180.0, curve_step_deg);
    if (web.photometry() != Photometry::c) return gammas; // the angles of its grid do not run along C-planes
    for (const double own : web.gammas_deg())
        if (own >= 0.0 && own <= 180.0) gammas.push_back(own);
    // At the ends of the table the intensity drops to 0 at once: the curve needs both values.
    constexpr double hair_deg = 1e-9;
    const double ends[] = {web.gammas_deg().front() - hair_deg, web.gammas_deg().back() + hair_deg};
    for (const double end : ends)
        if (end > 0.0 && end < 180.0) gammas.push_back(end);
    sort_unique(gammas);
    return gammas;
}

// About as many letters as fit, with an ellipsis if some are left out. UTF-8.
std::string shortened(const std::string& text, double width, double letter) {
    const auto most = static_cast<std::size_t>(std::max(width / letter, 4.0));
    std::size_t letters = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if ((static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U) continue; // within a letter
        if (++letters == most && text.size() - i > 1) return text.substr(0, i) + "…";
    }
    return text;
}

std::string title_of(std::span<const PlottedWeb> webs, const PlotOptions& options) {
    if (!options.title.empty() || webs.size() != 1) return options.title;
    return shortened(webs[0].name, options.width_px - 2.0 * page_margin_px, title_letter_px);
}

// Not of falloffs, which have no web, nor on a small page.
bool has_facts(std::span<const PlottedWeb> webs, const PlotOptions& options) {
    return options.has_facts && webs.size() == 1 && webs[0].web != nullptr && options.width_px >= 400 &&
           options.height_px >= 320;
}

// "street.ies: 6000 lm, peak 4078 cd at C 160°, γ 60°"
std::string facts_of(const PlottedWeb& plotted) {
    const Web& web = *plotted.web;
    const Peak top = peak(web);
    const std::string plane =
        web.stored_symmetry() == Symmetry::axial ? std::string() : fmt::format("C {}°, ", rounded(top.c_deg, 4));
    return fmt::format("{}: {} lm, peak {} cd at {}γ {}°", plotted.label, rounded(flux(web).value, 4),
                       rounded(top.intensity.value, 4), plane, rounded(top.gamma_deg, 4));
}

// Lines that the legend needs when entries are placed side by side while they fit.
struct LegendPlace {
    double x = 0.0;
    std::size_t line = 0;
};

std::vector<LegendPlace> place_legend(std::span<const LegendEntry> legend, double width) {
    std::vector<LegendPlace> places;
    LegendPlace at;
    for (const LegendEntry& entry : legend) {
        const double needed = swatch_px + 8.0 + letter_px * static_cast<double>(entry.text.size()) + 16.0;
        if (at.x > 0.0 && at.x + needed > width) at = {0.0, at.line + 1};
        places.push_back(at);
        at.x += needed;
    }
    return places;
}

} // namespace

Result<void> check_request(std::span<const PlottedWeb> webs, const PlotOptions& options, std::size_t most) {
    for (const int side : {options.width_px, options.height_px})
        if (side < least_px || side > most_px)
            return fail("USE0106", fmt::format("a diagram is {} to {} pixels wide and high, not {}x{}", least_px,
                                               most_px, options.width_px, options.height_px));
    if (webs.empty()) return fail("USE0104", "there is nothing to draw");
    if (webs.size() > most)
        return fail("USE0107", fmt::format("this diagram shows one profile, but {} are given", webs.size()),
                    "draw them one by one with -O DIR, or together as polar or cartesian");
    return {};
}

Drawing begin_page(std::span<const PlottedWeb> webs, const PlotOptions& options, std::string_view diagram,
                   std::span<const LegendEntry> legend, Area& area) {
    std::string name = options.title;
    if (name.empty())
        for (const PlottedWeb& plotted : webs)
            name += (name.empty() ? "" : ", ") + plotted.label;
    Drawing page(options.width_px, options.height_px, fmt::format("{}: {}", name, diagram));
    area = {page_margin_px, page_margin_px, options.width_px - page_margin_px, options.height_px - page_margin_px};
    if (const std::string title = title_of(webs, options); !title.empty()) {
        page.text({0.5 * options.width_px, area.top + 12.0}, title, {TextAnchor::middle, 16.0, {}, true});
        area.top += title_px;
    }
    if (has_facts(webs, options)) {
        page.text({0.5 * options.width_px, area.top + 8.0}, facts_of(webs[0]),
                  {TextAnchor::middle, 12.0, ink(0x555555)});
        area.top += facts_px;
    }
    const std::vector<LegendPlace> places = place_legend(legend, area.width());
    if (!places.empty()) area.bottom -= line_px * static_cast<double>(places.back().line + 1) + 4.0;
    for (std::size_t i = 0; i < legend.size(); ++i) {
        const double x = area.left + places[i].x;
        const double y = area.bottom + 16.0 + line_px * static_cast<double>(places[i].line);
        page.line({x, y - 4.0}, {x + swatch_px, y - 4.0}, legend[i].pen);
        page.text({x + swatch_px + 8.0, y}, legend[i].text);
    }
    return page;
}

double furniture_px(std::span<const PlottedWeb> webs, const PlotOptions& options, std::span<const LegendEntry> legend) {
    const std::vector<LegendPlace> places = place_legend(legend, options.width_px - 2.0 * page_margin_px);
    return 2.0 * page_margin_px + (title_of(webs, options).empty() ? 0.0 : title_px) +
           (has_facts(webs, options) ? facts_px : 0.0) +
           (places.empty() ? 0.0 : line_px * static_cast<double>(places.back().line + 1) + 4.0);
}

Result<double> intensity_scale(const PlottedWeb& plotted, const PlotOptions& options) {
    if (!options.per_klm) return 1.0;
    const double flux_lm = flux(*plotted.web).value;
    if (!(flux_lm > 0.0))
        return fail(Failure::usage, "the profile has no flux, so candela per 1000 lm are not defined", {},
                    plotted.label);
    return 1000.0 / flux_lm;
}

std::vector<CurvePoint> plane_curve(const Web& web, double c_deg, double scale) {
    const std::vector<double> gammas = curve_gammas(web);
    const auto at = [&](double c, double gamma) { return std::fmax(0.0, scale * web.candela(c, gamma)); };
    std::vector<CurvePoint> points;
    points.reserve(2 * gammas.size());
    for (std::size_t i = gammas.size(); i-- > 0;)
        points.push_back({-gammas[i], at(c_deg + 180.0, gammas[i])});
    for (const double gamma : gammas)
        points.push_back({gamma, at(c_deg, gamma)});
    return points;
}

namespace {

// "street.ies, 6000 lm, C0–C180, beam 139°": `text` is that of the luminaire, where there are several; the plane is
// added unless all are alike.
std::string legend_of(const PlottedWeb& plotted, std::string text, double c_deg) {
    const Web& web = *plotted.web;
    const auto add = [&](const std::string& part) {
        if (!text.empty()) text += ", ";
        text += part;
    };
    if (web.stored_symmetry() != Symmetry::axial)
        add(fmt::format("C{}–C{}", rounded(c_deg), rounded(std::fmod(c_deg + 180.0, 360.0))));
    if (const std::optional<Radians> beam = spread_angle(web, c_deg, 0.5))
        add(fmt::format("beam {}°", rounded(to_degrees(*beam), 3)));
    return text.empty() ? plotted.label : text;
}

} // namespace

Result<std::vector<PlaneCurve>> plane_curves(std::span<const PlottedWeb> webs, const PlotOptions& options) {
    std::vector<PlaneCurve> curves;
    for (std::size_t w = 0; w < webs.size(); ++w) {
        Result<double> scale = intensity_scale(webs[w], options);
        if (!scale) return pass_on(scale);
        const Web& web = *webs[w].web;
        const bool axial = web.stored_symmetry() == Symmetry::axial;
        const std::string luminaire =
            webs.size() == 1 ? std::string() : fmt::format("{}, {} lm", webs[w].label, rounded(flux(web).value, 4));
        for (std::size_t p = 0; p < options.planes_deg.size() && (p == 0 || !axial); ++p) {
            const double c_deg = options.planes_deg[p];
            PlaneCurve curve;
            curve.legend.text = legend_of(webs[w], luminaire, c_deg);
            curve.legend.pen = {series_color(webs.size() == 1 ? p : w), 2.0};
            if (p > 0) curve.legend.pen.dash_px = {6.0, 4.0};
            curve.points = plane_curve(web, c_deg, *scale);
            curves.push_back(std::move(curve));
        }
    }
    return curves;
}

Result<double> greatest(std::span<const PlaneCurve> curves, std::span<const PlottedWeb> webs) {
    double top = 0.0;
    for (const PlaneCurve& curve : curves)
        for (const CurvePoint& point : curve.points)
            top = std::fmax(top, point.intensity);
    Result<void> fine = check_top(top, webs, "the profile is dark in the planes that are drawn",
                                  "choose others with --plane, for example --plane 45deg");
    if (!fine) return pass_on(fine);
    return top;
}

Result<void> check_top(double top, std::span<const PlottedWeb> webs, std::string dark, std::string hint) {
    if (top >= 1e-200 && top <= 1e200) return {};
    const std::string file = webs.size() == 1 ? webs[0].label : std::string();
    if (!(top > 0.0)) return fail(Failure::usage, std::move(dark), std::move(hint), file);
    return fail(Failure::usage, fmt::format("the profile reaches {}, which no diagram can show", rounded(top, 3)), {},
                file);
}

std::string intensity_text(double intensity, const PlotOptions& options) {
    return rounded(intensity, 4) + (options.per_klm ? " cd/klm" : " cd");
}

} // namespace gonio::plot_detail
