#include <gonio/base/unit_text.hpp>
#include <gonio/plot/diagram.hpp>
#include <gonio/plot/diagram_page.hpp>
#include <gonio/plot/palette.hpp>
#include <gonio/web/metrics.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace gonio {

using namespace plot_detail;

namespace {

constexpr int distances = 5;
constexpr double widest_deg = 80.0; // from the nadir: at wider angles the cone cut by a plane is not worth drawing

// The outermost angles, left and right of the nadir, at which a plane's intensity is at least half the peak.
struct Beam {
    double left_deg = 0.0;
    double right_deg = 0.0;
};

// The curve is linear between its points, so this crossing is that of the interpolant.
std::optional<Beam> beam_of(const std::vector<CurvePoint>& curve, double threshold) {
    std::optional<Beam> beam;
    const auto crossing = [&](const CurvePoint& below, const CurvePoint& above) {
        const double weight = (threshold - below.intensity) / (above.intensity - below.intensity);
        return below.gamma_deg + weight * (above.gamma_deg - below.gamma_deg);
    };
    for (std::size_t i = 0; i < curve.size(); ++i) {
        if (std::fabs(curve[i].gamma_deg) > 90.0 || curve[i].intensity < threshold) continue;
        if (!beam) {
            const bool inner = i > 0 && curve[i - 1].intensity < threshold;
            beam = Beam{inner ? crossing(curve[i - 1], curve[i]) : curve[i].gamma_deg, 0.0};
        }
        const bool inner = i + 1 < curve.size() && curve[i + 1].intensity < threshold;
        beam->right_deg = inner ? crossing(curve[i + 1], curve[i]) : curve[i].gamma_deg;
    }
    return beam;
}

double tan_deg(double angle_deg) {
    return std::tan(angle_deg * (std::numbers::pi / 180.0));
}

double cos_deg(double angle_deg) {
    return std::cos(angle_deg * (std::numbers::pi / 180.0));
}

// E on a horizontal plane at distance d below, where the ray at γ meets it.
double illuminance_lx(const Web& web, double scale, double signed_gamma_deg, double c_deg, double distance_m) {
    const double candela = web.candela(signed_gamma_deg < 0.0 ? c_deg + 180.0 : c_deg, std::fabs(signed_gamma_deg));
    return scale * candela * std::pow(cos_deg(signed_gamma_deg), 3.0) / (distance_m * distance_m);
}

std::string angle_text(const std::optional<Beam>& beam) {
    return beam ? fmt::format("{:.1f}°", beam->right_deg - beam->left_deg) : std::string("none");
}

// Four digits or the whole number, without an exponent where a column has room for that.
std::string cell_text(double value) {
    if (value >= 1e4 && value < 1e6) return fmt::format("{:.0f}", value);
    return rounded(value, value >= 1e6 || value < 1e-4 ? 2 : 4);
}

} // namespace

Result<Drawing> cone_diagram(std::span<const PlottedWeb> webs, const PlotOptions& options) {
    Result<void> fine = check_request(webs, options, 1);
    if (!fine) return pass_on(fine);
    Result<double> scale = intensity_scale(webs[0], options);
    if (!scale) return pass_on(scale);
    const Web& web = *webs[0].web;
    const double c_deg = options.planes_deg.empty() ? 0.0 : options.planes_deg.front();
    const double threshold = 0.5 * peak(web).intensity.value * *scale;
    Result<void> bright = check_top(2.0 * threshold, webs, "the profile is dark, so there is no beam to draw", {});
    if (!bright) return pass_on(bright);
    const std::optional<Beam> beam = beam_of(plane_curve(web, c_deg, *scale), threshold);
    if (!beam)
        return fail(
            Failure::usage,
            fmt::format("the plane C{} has no direction below the horizontal that is half as bright as the peak",
                        rounded(c_deg)),
            "choose another with --plane, for example --plane 90deg", webs[0].label);
    if (beam->left_deg < -widest_deg || beam->right_deg > widest_deg)
        return fail(Failure::usage,
                    fmt::format("the beam reaches {:.1f}° from the nadir, too wide for a cone diagram",
                                std::fmax(-beam->left_deg, beam->right_deg)),
                    "draw it as polar or isolux", webs[0].label);

    Area area;
    Drawing page = begin_page(webs, options, "beam cone", {}, area);
    const double height_m = options.mounting_height_m;
    // A cone on the left half, numbers on the right; one row for each distance.
    const double split = area.left + 0.46 * area.width();
    const double top = area.top + 42.0;
    const double row_px = (area.bottom - 34.0 - top) / distances;
    const double reach_m = height_m * std::fmax(std::fmax(tan_deg(beam->right_deg), -tan_deg(beam->left_deg)), 0.02);
    const double px_per_m = std::fmin(0.5 * (split - area.left) - 8.0, row_px * distances * 1.2) / reach_m;
    const double axis = 0.5 * (area.left + split);
    const auto x_at = [&](double gamma_deg, double distance_m) {
        return axis + px_per_m * distance_m * tan_deg(gamma_deg);
    };
    const double foot = top + row_px * distances;
    PagePath cone;
    cone.move_to({axis, top}).line_to({x_at(beam->left_deg, height_m), foot});
    cone.line_to({x_at(beam->right_deg, height_m), foot}).close();
    Ink light = series_color(0);
    light.opacity = 0.18;
    page.fill(cone, light);
    page.stroke(std::move(cone), {series_color(0), 1.5});

    const std::array<double, 4> columns{split + 0.10 * area.width(), split + 0.25 * area.width(),
                                        split + 0.40 * area.width(), split + 0.53 * area.width()};
    const std::string lux = options.per_klm ? "[lx/klm]" : "[lx]";
    constexpr std::array<std::string_view, 4> names{"distance", "width", "E axis", "E edge"};
    const std::array<std::string, 4> units{"[m]", "[m]", lux, lux};
    const TextStyle heading{TextAnchor::end, 12.0, {}, true};
    const bool narrow = columns[1] - columns[0] < 80.0; // no room for the unit beside the name
    for (std::size_t i = 0; i < columns.size(); ++i) {
        page.text({columns[i], top - 14.0}, narrow ? units[i] : fmt::format("{} {}", names[i], units[i]), heading);
        if (narrow) page.text({columns[i], top - 28.0}, names[i], heading);
    }
    for (int i = 1; i <= distances; ++i) {
        const double distance_m = height_m * i / distances;
        const double y = top + row_px * i;
        page.line({area.left, y}, {columns.back(), y}, {ink(0xcccccc), 1.0, {2.0, 3.0}});
        page.line({x_at(beam->left_deg, distance_m), y}, {x_at(beam->right_deg, distance_m), y},
                  {series_color(0), 1.5});
        const double width_m = distance_m * (tan_deg(beam->right_deg) - tan_deg(beam->left_deg));
        const double edge_lx = std::fmax(illuminance_lx(web, *scale, beam->left_deg, c_deg, distance_m),
                                         illuminance_lx(web, *scale, beam->right_deg, c_deg, distance_m));
        const std::array<double, 4> values{distance_m, width_m, illuminance_lx(web, *scale, 0.0, c_deg, distance_m),
                                           edge_lx};
        for (std::size_t k = 0; k < columns.size(); ++k)
            page.text({columns[k], y - 5.0}, cell_text(values[k]), {TextAnchor::end});
    }
    page.circle({axis, top}, 3.5, ink(0x333333));
    const auto plane_text = [](double c) {
        return fmt::format("C{}–C{}", rounded(std::fmod(c, 360.0)), rounded(std::fmod(c + 180.0, 360.0)));
    };
    const std::optional<Beam> across = beam_of(plane_curve(web, c_deg + 90.0, *scale), threshold);
    page.text({area.left, area.bottom - 6.0},
              fmt::format("beam angle {} in {}, {} in {}", angle_text(beam), plane_text(c_deg), angle_text(across),
                          plane_text(c_deg + 90.0)));
    return page;
}

} // namespace gonio
