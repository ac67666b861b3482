#include "sky_report.hpp"

#include <gonio/base/codes/result.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/color/rgb_space.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::array<std::string_view, 4> wall_names{"north", "east", "south", "west"};

std::string degrees_text(double angle_deg) {
    // No "-0" and no digits of rounding.
    return rounded(std::abs(angle_deg) < 5e-5 ? 0.0 : std::round(angle_deg * 1e4) / 1e4, 7) + "°";
}

std::string place_text(const glm::dvec3& direction) {
    const SkyAngles at = sky_angles_of(direction);
    return fmt::format("azimuth {}, elevation {}", degrees_text(at.azimuth_deg), degrees_text(at.elevation_deg));
}

// The illuminance of a horizontal plane by the sun alone.
double horizontal_lx(const SunLight& sun) {
    return sun.illuminance.value * std::fmax(sun.direction.z, 0.0);
}

} // namespace

SkyReport report_of(const std::string& input, const LoadedSky& loaded, unsigned threads, Diagnostics& diagnostics) {
    SkyReport report{input, std::string(loaded.kind), measure(loaded.sky, threads), {}, loaded.sun, loaded.image};
    if (report.measures.color == glm::dvec3(0.0)) return report;
    Result<Uv> at = uv_of_rgb(report.measures.color, *find_rgb_space("rec709"));
    Result<Cct> cct = at ? exact_cct(*at) : Result<Cct>(pass_on(at));
    if (cct) {
        report.cct = *cct;
        for (Diagnostic& remark : remarks(*cct))
            diagnostics.push_back(std::move(remark));
    } else {
        diagnostics.push_back(
            result_diagnostic("RES0102", "the colour of the light has no correlated colour temperature", {}, input));
    }
    return report;
}

std::string to_text(const SkyReport& report) {
    const SkyMeasures& m = report.measures;
    std::string text = report.input + "\n";
    const auto line = [&](std::string_view name, const std::string& value) {
        text += fmt::format("  {:<12}{}\n", name, value);
    };
    if (report.image) {
        const EnvironmentMap& map = *report.image->map;
        line("image", fmt::format("{}x{}, {}, {}, {} cd/m2 per unit", map.grid().width(), map.grid().height(),
                                  info_of(map.grid().layout()).name, media::to_text(report.image->pixel),
                                  rounded(map.nits_per_unit())));
    }
    line("horizontal", rounded(m.horizontal.value) + " lx");
    std::string walls;
    for (std::size_t i = 0; i < wall_names.size(); ++i)
        walls += fmt::format("{}{} {} lx", i > 0 ? ", " : "", wall_names.at(i), rounded(m.vertical.at(i).value));
    line("vertical", walls);
    line("mean", rounded(m.mean.value) + " nt");
    line("zenith", rounded(m.zenith.value) + " nt");
    if (m.spot) {
        line("brightest", fmt::format("{} nt at {}", rounded(m.spot->luminance.value), place_text(m.spot->direction)));
        line("its share", fmt::format("{} % of the light comes from within {}° of it",
                                      rounded(100.0 * m.spot->share, 3), rounded(spot_radius_deg, 3)));
    }
    line("cct", report.cct ? fmt::format("{} K, Duv {:+.4f}", rounded(report.cct->temperature.value, 5),
                                         std::abs(report.cct->duv) < 5e-5 ? 0.0 : report.cct->duv)
                           : "none");
    if (report.sun) {
        const bool was_cut = report.image && report.image->sun_texels > 0;
        line("sun", place_text(report.sun->direction) +
                        (was_cut ? fmt::format(", cut out of {} texels, {} sr", report.image->sun_texels,
                                               rounded(report.image->sun_sr, 3))
                                 : ""));
        line("sunlight",
             fmt::format("{} lx facing it, {} lx on the horizontal, {}° wide", rounded(report.sun->illuminance.value),
                         rounded(horizontal_lx(*report.sun)), rounded(to_degrees(report.sun->diameter), 5)));
    }
    return text;
}

Json to_json(const SkyReport& report, const Diagnostics& diagnostics) {
    const SkyMeasures& m = report.measures;
    Json json{{"schema", "gonio.sky/1"}, {"sky", report.input}, {"kind", report.kind}};
    json["image"] = nullptr;
    if (report.image) {
        const EnvironmentMap& map = *report.image->map;
        json["image"] = {{"width", map.grid().width()},
                         {"height", map.grid().height()},
                         {"layout", info_of(map.grid().layout()).name},
                         {"pixel", media::to_text(report.image->pixel)},
                         {"nits_per_unit", map.nits_per_unit()},
                         {"sha256", report.image->sha256}};
    }
    json["horizontal_lx"] = m.horizontal.value;
    for (std::size_t i = 0; i < wall_names.size(); ++i)
        json["vertical_lx"][std::string(wall_names.at(i))] = m.vertical.at(i).value;
    json["mean_nt"] = m.mean.value;
    json["zenith_nt"] = m.zenith.value;
    json["brightest"] = nullptr;
    if (m.spot) {
        const SkyAngles at = sky_angles_of(m.spot->direction);
        json["brightest"] = {{"luminance_nt", m.spot->luminance.value},
                             {"azimuth_deg", at.azimuth_deg},
                             {"elevation_deg", at.elevation_deg},
                             {"radius_deg", spot_radius_deg},
                             {"share", m.spot->share}};
    }
    json["cct_K"] = number_or_null(report.cct ? std::optional(report.cct->temperature.value) : std::nullopt);
    json["duv"] = number_or_null(report.cct ? std::optional(report.cct->duv) : std::nullopt);
    json["sun"] = nullptr;
    if (report.sun) {
        const SkyAngles at = sky_angles_of(report.sun->direction);
        json["sun"] = {{"azimuth_deg", at.azimuth_deg},
                       {"elevation_deg", at.elevation_deg},
                       {"illuminance_lx", report.sun->illuminance.value},
                       {"horizontal_lx", horizontal_lx(*report.sun)},
                       {"diameter_deg", to_degrees(report.sun->diameter)},
                       {"color", Json::array({report.sun->color.x, report.sun->color.y, report.sun->color.z})}};
    }
    if (report.sun && report.image) {
        json["sun"]["texels"] = report.image->sun_texels;
        json["sun"]["solid_angle_sr"] = report.image->sun_sr;
    }
    json["diagnostics"] = diagnostics_json(diagnostics);
    return json;
}

} // namespace gonio::cli
