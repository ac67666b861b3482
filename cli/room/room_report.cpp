#include "room_report.hpp"

#include <gonio/base/path.hpp>
#include <gonio/base/unit_text.hpp>

#include "../facts_text.hpp"
#include "../options/glare_text.hpp"
#include "../options/light_flux.hpp"
#include "../rig_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::array<std::string_view, 4> views{"+X", "-X", "+Y", "-Y"};

std::string line(std::string_view name, const std::string& value) {
    return fmt::format("  {:<12}{}\n", name, value);
}

// Of all luminaires [W/m²].
std::optional<double> power_density(const RoomRequest& request, const RoomPlan& plan) {
    if (!request.luminaire.input_w) return std::nullopt;
    return *request.luminaire.input_w * static_cast<double>(plan.layout.count()) /
           (request.plan.size_m.x * request.plan.size_m.y);
}

double mounting_height_m(const RoomPlanRequest& request) {
    return request.mounting_height_m > 0.0 ? request.mounting_height_m : request.size_m.z;
}

std::string observers_text(const RoomPlan& plan) {
    std::string text;
    for (std::size_t i = 0; i < views.size(); ++i) {
        text += fmt::format("{}{} towards {}", i == 0 ? "" : ", ", ugr_text(plan.observers.at(i).glare), views.at(i));
    }
    return text;
}

} // namespace

std::string room_text(const RoomRequest& request, const RoomPlan& plan) {
    const RoomPlanRequest& asked = request.plan;
    const Spread& lux = plan.spread;
    std::string text = fmt::format("{} m × {} m × {} m, reflectances {}\n", rounded(asked.size_m.x),
                                   rounded(asked.size_m.y), rounded(asked.size_m.z), to_text(asked.reflectances));
    text += line("layout", fmt::format("{} × {} = {} luminaires, {} m × {} m apart, at {} m", plan.layout.columns,
                                       plan.layout.rows, plan.layout.count(), rounded(plan.spacing_m.x, 4),
                                       rounded(plan.spacing_m.y, 4), rounded(mounting_height_m(asked), 4)));
    text += line("mean", fmt::format("{} lx{}, {} lx of it directly", rounded(lux.mean, 4),
                                     asked.mean ? fmt::format(" for {} lx", rounded(asked.mean->value)) : std::string(),
                                     rounded(spread(plan.direct_lx).mean, 4)));
    text += line("range", fmt::format("{} to {} lx, U0 {}, Ud {}", rounded(lux.least, 4), rounded(lux.greatest, 4),
                                      rounded(lux.uniformity(), 3), rounded(lux.diversity(), 3)));
    text += line("plane", fmt::format("{} m high, {} m off the walls, {} × {} points, maintenance factor {}",
                                      rounded(asked.plane_height_m, 4), rounded(asked.wall_zone_m, 4),
                                      plan.grid.columns, plan.grid.rows, rounded(asked.maintenance_factor, 4)));
    text += line("UGR", observers_text(plan));
    if (const std::optional<double> density = power_density(request, plan))
        text +=
            line("power", fmt::format("{} W, {} W/m², {} W/m² per 100 lx",
                                      rounded(*request.luminaire.input_w * static_cast<double>(plan.layout.count()), 4),
                                      rounded(*density, 3), rounded(100.0 * *density / lux.mean, 3)));
    if (request.task) text += verdicts_text(*request.task);
    return text;
}

void judge(RoomRequest& request, const RoomPlan& plan) {
    if (!request.task) return;
    ReachedLight reached;
    reached.mean_lx = plan.spread.mean;
    reached.least_lx = plan.spread.least;
    reached.uniformity = plan.spread.uniformity();
    reached.ra = request.luminaire.ra;
    if (plan.surfaces) {
        reached.cylindrical_lx = plan.surfaces->cylindrical_lx;
        reached.wall_lx = plan.surfaces->walls_lx;
        reached.ceiling_lx = plan.surfaces->ceiling_lx;
    }
    double worst = -std::numeric_limits<double>::infinity();
    bool is_rated = true;
    for (const RoomObserver& seen : plan.observers) {
        is_rated = is_rated && seen.glare.ugr;
        worst = std::max(worst, seen.glare.ugr.value_or(worst));
    }
    if (is_rated) reached.ugr = worst;
    request.task->verdicts = verdicts(request.task->task, reached, request.task->raised);
}

void add_remarks(const RoomPlan& plan, Diagnostics& diagnostics) {
    bool has_too_large = false;
    bool is_rated = true;
    for (const RoomObserver& seen : plan.observers) {
        has_too_large = has_too_large || seen.glare.has_too_large;
        is_rated = is_rated && seen.glare.ugr;
    }
    add_glare_remarks(!is_rated, has_too_large, diagnostics);
}

Json room_json(const RoomRequest& request, const RoomPlan& plan, const Diagnostics& diagnostics) {
    const RoomPlanRequest& asked = request.plan;
    const Spread& lux = plan.spread;
    const std::optional<double> density = power_density(request, plan);
    Json observers = Json::array();
    for (const RoomObserver& seen : plan.observers) {
        const auto vector = [](const glm::dvec3& value) { return Json::array({value.x, value.y, value.z}); };
        observers.push_back({{"position", vector(seen.observer.eye)},
                             {"view", vector(seen.observer.view)},
                             {"ugr", number_or_null(seen.glare.ugr)},
                             {"background_nt", seen.glare.background.value}});
    }
    Json points = Json::array();
    for (std::size_t i = 0; i < plan.grid.receivers.size(); ++i) {
        const glm::dvec3& at = plan.grid.receivers[i].position;
        points.push_back({{"position", Json::array({at.x, at.y, at.z})},
                          {"illuminance_lx", plan.illuminance_lx[i]},
                          {"direct_lx", plan.direct_lx[i]}});
    }
    return {{"schema", "gonio.room/1"},
            {"room_m", Json::array({asked.size_m.x, asked.size_m.y, asked.size_m.z})},
            {"reflectances", to_text(asked.reflectances)},
            {"luminaire", request.luminaire.file},
            {"layout", Json::array({plan.layout.columns, plan.layout.rows})},
            {"count", plan.layout.count()},
            {"spacing_m", Json::array({plan.spacing_m.x, plan.spacing_m.y})},
            {"mounting_height_m", mounting_height_m(asked)},
            {"plane_height_m", asked.plane_height_m},
            {"wall_zone_m", asked.wall_zone_m},
            {"maintenance_factor", asked.maintenance_factor},
            {"wanted_lx", asked.mean ? Json(asked.mean->value) : Json(nullptr)},
            {"mean_lx", lux.mean},
            {"direct_mean_lx", spread(plan.direct_lx).mean},
            {"min_lx", lux.least},
            {"max_lx", lux.greatest},
            {"uniformity", lux.uniformity()},
            {"diversity", lux.diversity()},
            {"observers", std::move(observers)},
            {"input_W", request.luminaire.input_w
                            ? Json(*request.luminaire.input_w * static_cast<double>(plan.layout.count()))
                            : Json(nullptr)},
            {"W_per_m2", number_or_null(density)},
            {"W_per_m2_100lx", density ? Json(100.0 * *density / lux.mean) : Json(nullptr)},
            {"surfaces", plan.surfaces ? Json{{"walls_lx", plan.surfaces->walls_lx},
                                              {"ceiling_lx", plan.surfaces->ceiling_lx},
                                              {"cylindrical_lx", plan.surfaces->cylindrical_lx}}
                                       : Json(nullptr)},
            {"verdict", request.task ? verdicts_json(*request.task) : Json(nullptr)},
            {"points", std::move(points)},
            {"diagnostics", diagnostics_json(diagnostics)}};
}

std::string room_rig(const RoomRequest& request, const RoomPlan& plan, const std::string& file) {
    const RoomPlanRequest& asked = request.plan;
    const glm::dvec3& size = asked.size_m;
    const bool has_opening = plan.lights.front().body != nullptr;
    Json light{{"name", "luminaire"}, {"shape", "ies:" + file + (has_opening ? ",opening" : "")}};
    if (!request.luminaire.flux.empty()) light["intensity"] = request.luminaire.flux;
    light["position"] = Json::array({0.0, 0.0, plan.lights.front().frame.origin.z});
    if (request.luminaire.light.rotation.value != 0.0)
        light["rotate"] = shortest(to_degrees(request.luminaire.light.rotation)) + "deg";
    light["array"] = {{"count", Json::array({plan.layout.columns, plan.layout.rows})},
                      {"room", Json::array({size.x, size.y})}};
    const Json rig{{"schema", "gonio.rig/1"},
                   {"maintenance", asked.maintenance_factor},
                   {"lights", Json::array({std::move(light)})},
                   {"stage", {{"name", "room"}, {"surfaces", panels_json(plan.stage)}}}};
    return dump(rig, 2);
}

GridPlot room_plot(const RoomRequest& request, const RoomPlan& plan) {
    GridPlot plot;
    plot.left_m = plan.grid.corner.x;
    plot.low_m = plan.grid.corner.y;
    plot.width_m = plan.grid.u.x;
    plot.height_m = plan.grid.v.y;
    plot.columns = plan.grid.columns;
    plot.rows = plan.grid.rows;
    plot.values = plan.illuminance_lx;
    for (const Light& light : plan.lights)
        plot.marks.push_back({light.frame.origin.x, light.frame.origin.y});
    plot.title = fmt::format("illuminance at {} m", rounded(request.plan.plane_height_m, 4));
    plot.facts = fmt::format("min {} lx, mean {} lx, max {} lx, min/mean {}", amount_text(plan.spread.least),
                             amount_text(plan.spread.mean), amount_text(plan.spread.greatest),
                             rounded(plan.spread.uniformity(), 2));
    return plot;
}

RoomSheetContent room_sheet_content(const RoomRequest& request, const RoomPlan& plan, const std::string& title) {
    const RoomPlanRequest& asked = request.plan;
    const Spread& lux = plan.spread;
    const std::string size = fmt::format("{} m × {} m × {} m", rounded(asked.size_m.x, 4), rounded(asked.size_m.y, 4),
                                         rounded(asked.size_m.z, 4));
    RoomSheetContent content;
    content.title = title.empty() ? "Room " + size : title;
    content.source = file_name(request.luminaire.file);
    auto& facts = content.facts;
    facts.emplace_back("Size", size);
    facts.emplace_back("Reflectances", to_text(asked.reflectances) + " % of ceiling, walls, floor");
    facts.emplace_back("Layout",
                       fmt::format("{} × {} luminaires, {} m × {} m apart", plan.layout.columns, plan.layout.rows,
                                   rounded(plan.spacing_m.x, 4), rounded(plan.spacing_m.y, 4)));
    facts.emplace_back("Mean illuminance",
                       fmt::format("{} lx{}", amount_text(lux.mean),
                                   asked.mean ? fmt::format(" for {} lx", rounded(asked.mean->value)) : std::string()));
    facts.emplace_back("of it directly", fmt::format("{} lx", amount_text(spread(plan.direct_lx).mean)));
    facts.emplace_back("Range", fmt::format("{} to {} lx", amount_text(lux.least), amount_text(lux.greatest)));
    facts.emplace_back("Uniformity",
                       fmt::format("U0 {}, Ud {}", rounded(lux.uniformity(), 2), rounded(lux.diversity(), 2)));
    facts.emplace_back("Working plane",
                       fmt::format("{} m high, {} m off the walls, {} × {} points", rounded(asked.plane_height_m, 4),
                                   rounded(asked.wall_zone_m, 4), plan.grid.columns, plan.grid.rows));
    facts.emplace_back("Maintenance factor", rounded(asked.maintenance_factor, 4));
    if (const std::optional<double> density = power_density(request, plan))
        facts.emplace_back(
            "Power", fmt::format("{} W, {} W/m², {} W/m² per 100 lx",
                                 rounded(*request.luminaire.input_w * static_cast<double>(plan.layout.count()), 4),
                                 rounded(*density, 3), rounded(100.0 * *density / lux.mean, 3)));
    for (std::size_t i = 0; i < views.size(); ++i)
        content.glare.emplace_back(fmt::format("Towards {}", views.at(i)), ugr_text(plan.observers.at(i).glare));
    if (request.task) {
        content.task = fmt::format("{}, {}", request.task->task.name, request.task->task.rule);
        content.verdicts = request.task->verdicts;
    }
    RoomSheetLuminaire luminaire;
    luminaire.name = request.luminaire.name.empty()
                         ? file_name(request.luminaire.file)
                         : fmt::format("{} ({})", request.luminaire.name, file_name(request.luminaire.file));
    luminaire.count = plan.layout.count();
    luminaire.input_w = request.luminaire.input_w;
    luminaire.flux_lm = flux_lm(plan.lights.front());
    luminaire.mounting = fmt::format("at {} m", rounded(mounting_height_m(asked), 4));
    content.luminaires.push_back(std::move(luminaire));
    content.plot = room_plot(request, plan);
    content.plot.title = fmt::format("Maintained illuminance at {} m in lx", rounded(asked.plane_height_m, 4));
    content.plot.margin_m = asked.wall_zone_m;
    const double x = 0.5 * asked.size_m.x;
    const double y = 0.5 * asked.size_m.y;
    content.plot.outline = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
    return content;
}

} // namespace gonio::cli
