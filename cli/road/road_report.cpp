#include "road_report.hpp"

#include <gonio/base/unit_text.hpp>
#include <gonio/scene/primitives.hpp>
#include <gonio/scene/stage.hpp>

#include "../facts_text.hpp"
#include "../rig_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

namespace gonio::cli {

namespace {

std::string line(std::string_view name, const std::string& value) {
    return fmt::format("  {:<12}{}\n", name, value);
}

std::string_view arrangement_name(RoadArrangement arrangement) {
    for (const RoadArrangementName& known : road_arrangements())
        if (known.arrangement == arrangement) return known.name;
    return {};
}

std::string surface_text(const RoadSurface& surface) {
    return surface.average ? fmt::format("{} with Q0 {}", surface.name, rounded(*surface.average, 3)) : surface.name;
}

// Of all luminaires, in watts per metre of road.
std::optional<double> watts_per_m(const RoadRequest& request, const RoadPlan& plan) {
    if (!request.luminaire.input_w) return std::nullopt;
    return *request.luminaire.input_w * plan.luminaires_per_km / 1000.0;
}

// EN 13201-5: watts per lux and square metre of the carriageway.
std::optional<double> power_density(const RoadRequest& request, const RoadPlan& plan) {
    const std::optional<double> watts = watts_per_m(request, plan);
    if (!watts || !(plan.illuminance.mean > 0.0)) return std::nullopt;
    return *watts / (request.plan.width_m * plan.illuminance.mean);
}

std::string lane_text(const RoadLane& lane) {
    return fmt::format("mean {:.2f} cd/m², U0 {:.2f}, Ul {:.2f}, TI {}", lane.luminance.mean,
                       lane.luminance.uniformity(), lane.longitudinal_uniformity,
                       lane.ti_percent ? fmt::format("{:.1f} %", *lane.ti_percent) : std::string("not defined"));
}

// Without what sines and cosines leave of a zero.
Json vector_json(const glm::dvec3& value) {
    const auto clean = [](double x) { return std::abs(x) < 1e-15 ? 0.0 : x; };
    return Json::array({clean(value.x), clean(value.y), clean(value.z)});
}

Json points_json(const ReceiverGrid& grid) {
    Json points = Json::array();
    for (const Receiver& receiver : grid.receivers)
        points.push_back(Json::array({receiver.position.x, receiver.position.y}));
    return points;
}

} // namespace

std::string road_text(const RoadRequest& request, const RoadPlan& plan) {
    const RoadPlanRequest& asked = request.plan;
    std::string text = fmt::format("road of {} m, {} {}{}, {}\n", rounded(asked.width_m), asked.lanes,
                                   asked.lanes == 1 ? "lane" : "lanes", asked.two_way ? " in two directions" : "",
                                   surface_text(asked.surface));
    std::string layout = fmt::format("{}, {} m apart, {} m high", arrangement_name(asked.arrangement),
                                     rounded(plan.spacing_m, 4), rounded(asked.height_m, 4));
    if (asked.overhang_m != 0.0) layout += fmt::format(", overhang {} m", rounded(asked.overhang_m, 4));
    if (asked.tilt.value != 0.0) layout += fmt::format(", tilt {}°", rounded(to_degrees(asked.tilt), 4));
    text += line("layout", layout);
    for (std::size_t i = 0; i < plan.lanes.size(); ++i)
        text += line(fmt::format("lane {}", i + 1), lane_text(plan.lanes[i]));
    const Spread& lux = plan.illuminance;
    text += line("illuminance", fmt::format("mean {} lx, {} to {} lx, U0 {:.2f}", rounded(lux.mean, 4),
                                            rounded(lux.least, 4), rounded(lux.greatest, 4), lux.uniformity()));
    text += line("edges", fmt::format("edge illuminance ratio {:.2f}", plan.edge_ratio));
    text +=
        line("points", fmt::format("{} × {} for luminance, {} × {} for illuminance, maintenance factor {}",
                                   plan.luminance_grid.columns, plan.luminance_grid.rows, plan.illuminance_grid.columns,
                                   plan.illuminance_grid.rows, rounded(asked.maintenance_factor, 4)));
    text += line("luminaires", fmt::format("{} per km", rounded(plan.luminaires_per_km, 3)));
    if (const auto density = power_density(request, plan))
        text += line("power", fmt::format("{} W/m, {} mW/(lx m²)", rounded(*watts_per_m(request, plan), 3),
                                          rounded(1000.0 * *density, 3)));
    if (request.task) text += verdicts_text(*request.task);
    return text;
}

Json road_json(const RoadRequest& request, const RoadPlan& plan, const Diagnostics& diagnostics) {
    const RoadPlanRequest& asked = request.plan;
    Json lanes = Json::array();
    for (const RoadLane& lane : plan.lanes)
        lanes.push_back({{"observer", vector_json(lane.observer.eye)},
                         {"view", vector_json(lane.observer.view)},
                         {"mean_nt", lane.luminance.mean},
                         {"min_nt", lane.luminance.least},
                         {"max_nt", lane.luminance.greatest},
                         {"uniformity", lane.luminance.uniformity()},
                         {"longitudinal_uniformity", lane.longitudinal_uniformity},
                         {"veil_nt", lane.veil.value},
                         {"ti_percent", number_or_null(lane.ti_percent)},
                         {"luminance_nt", lane.luminance_nt}});
    return {{"schema", "gonio.road/1"},
            {"width_m", asked.width_m},
            {"lane_count", asked.lanes},
            {"two_way", asked.two_way},
            {"surface", asked.surface.name},
            {"q0", number_or_null(asked.surface.average)},
            {"luminaire", request.luminaire.file},
            {"arrangement", arrangement_name(asked.arrangement)},
            {"spacing_m", plan.spacing_m},
            {"height_m", asked.height_m},
            {"overhang_m", asked.overhang_m},
            {"tilt_deg", to_degrees(asked.tilt)},
            {"maintenance_factor", asked.maintenance_factor},
            {"lanes", std::move(lanes)},
            {"luminance_points", points_json(plan.luminance_grid)},
            {"mean_lx", plan.illuminance.mean},
            {"min_lx", plan.illuminance.least},
            {"max_lx", plan.illuminance.greatest},
            {"uniformity", plan.illuminance.uniformity()},
            {"illuminance_points", points_json(plan.illuminance_grid)},
            {"illuminance_lx", plan.illuminance_lx},
            {"edge_ratio", plan.edge_ratio},
            {"luminaires_per_km", plan.luminaires_per_km},
            {"W_per_m", number_or_null(watts_per_m(request, plan))},
            {"W_per_lx_m2", number_or_null(power_density(request, plan))},
            {"verdict", request.task ? verdicts_json(*request.task) : Json(nullptr)},
            {"diagnostics", diagnostics_json(diagnostics)}};
}

std::string road_rig(const RoadRequest& request, const RoadPlan& plan, const std::string& file) {
    const RoadPlanRequest& asked = request.plan;
    constexpr std::size_t copies = 7; // of the field
    const double length_m = static_cast<double>(copies) * plan.spacing_m;
    Json lights = Json::array();
    // One of each row: the first of the field, and if they take turns the one half a spacing on.
    for (std::size_t i = 0; i < plan.lights.size(); ++i) {
        const Light& light = plan.lights[i];
        if (light.frame.origin.x >= plan.spacing_m * (1.0 - 1e-9)) continue;
        Json row{{"name", fmt::format("row {}", lights.size() + 1)}, {"shape", "ies:" + file}};
        if (!request.luminaire.flux.empty()) row["intensity"] = request.luminaire.flux;
        row["position"] = vector_json(light.frame.origin); // the middle of an array
        row["direction"] = vector_json(-light.frame.z);
        row["up"] = vector_json(light.frame.y);
        row["array"] = {{"count", Json::array({copies, 1})}, {"spacing", Json::array({plan.spacing_m, 1.0})}};
        lights.push_back(std::move(row));
    }
    const double strip_m = asked.width_m / static_cast<double>(asked.lanes);
    // The road is matte, of the same average luminance coefficient: it has no gloss along it.
    const double albedo = std::min(0.9, std::numbers::pi * asked.surface.average.value_or(0.07));
    constexpr double verge_albedo = 0.15;
    const auto strip = [&](const char* name, double low_m, double width_m, double reflectance) {
        return Surface{
            name, panel_facing({0.0, low_m + 0.5 * width_m, 0.0}, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, length_m, width_m),
            LambertMaterial{glm::dvec3(std::round(1e4 * reflectance) / 1e4)}};
    };
    Stage stage;
    stage.surfaces = {strip("road", 0.0, asked.width_m, albedo), strip("verge", -strip_m, strip_m, verge_albedo),
                      strip("verge", asked.width_m, strip_m, verge_albedo)};
    const Json rig{{"schema", "gonio.rig/1"},
                   {"maintenance", asked.maintenance_factor},
                   {"lights", std::move(lights)},
                   {"stage", {{"name", "road"}, {"surfaces", panels_json(stage)}}},
                   {"camera",
                    {{"position", vector_json({-0.9 * plan.spacing_m, 0.5 * strip_m, 1.5})},
                     {"target", vector_json({plan.spacing_m, 0.5 * asked.width_m, 0.5})}}}};
    return dump(rig, 2);
}

GridPlot road_plot(const RoadRequest& request, const RoadPlan& plan, bool luminance) {
    const ReceiverGrid& grid = luminance ? plan.luminance_grid : plan.illuminance_grid;
    const auto darkest = std::min_element(plan.lanes.begin(), plan.lanes.end(), [](const auto& a, const auto& b) {
        return a.luminance.mean < b.luminance.mean;
    });
    const Spread& spread = luminance ? darkest->luminance : plan.illuminance;
    GridPlot plot;
    plot.width_m = grid.u.x;
    plot.height_m = grid.v.y;
    plot.columns = grid.columns;
    plot.rows = grid.rows;
    plot.values = luminance ? darkest->luminance_nt : plan.illuminance_lx;
    plot.unit = luminance ? "cd/m²" : "lx";
    for (const Light& light : plan.lights)
        if (light.frame.origin.y >= 0.0 && light.frame.origin.y <= request.plan.width_m)
            plot.marks.push_back({light.frame.origin.x, light.frame.origin.y});
    plot.title = luminance ? fmt::format("luminance of the road from lane {}", darkest - plan.lanes.begin() + 1)
                           : std::string("illuminance of the road");
    plot.facts =
        fmt::format("min {0} {4}, mean {1} {4}, max {2} {4}, min/mean {3}", rounded(spread.least, 3),
                    rounded(spread.mean, 3), rounded(spread.greatest, 3), rounded(spread.uniformity(), 2), plot.unit);
    return plot;
}

} // namespace gonio::cli
