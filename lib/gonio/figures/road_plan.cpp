#include <gonio/figures/disability_glare.hpp>
#include <gonio/figures/road_plan.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <variant>

namespace gonio {

namespace {

constexpr double eye_height_m = 1.5;
constexpr double viewing_distance_m = 60.0;
constexpr double farthest_glare_m = 500.0;
constexpr double screen_angle = 20.0 * std::numbers::pi / 180.0;
constexpr double sight_angle = 1.0 * std::numbers::pi / 180.0; // below the horizon
constexpr std::size_t points_across_lane = 3;

constexpr std::array arrangements{
    RoadArrangementName{RoadArrangement::single, "single", "a row at one side"},
    RoadArrangementName{RoadArrangement::opposite, "opposite", "rows at both sides, in pairs"},
    RoadArrangementName{RoadArrangement::staggered, "staggered", "rows at both sides, in turn"},
    RoadArrangementName{RoadArrangement::central, "central", "a row above the middle"},
};

Result<void> check(const RoadPlanRequest& request) {
    if (!(request.width_m >= 1.0 && request.width_m <= 200.0))
        return fail("USE0106", fmt::format("a road of {:.4g} m: a road is 1 to 200 m wide", request.width_m));
    if (request.lanes == 0 || request.lanes > 32)
        return fail("USE0106", fmt::format("{} lanes: a road has 1 to 32", request.lanes));
    if (!(request.height_m >= 2.0 && request.height_m <= 100.0))
        return fail("USE0106", fmt::format("luminaires {:.4g} m high: they are 2 to 100 m above a road, and above the "
                                           "eyes of drivers at 1.5 m",
                                           request.height_m));
    if (!(request.spacing_m >= 1.0 && request.spacing_m <= 1000.0))
        return fail("USE0106", fmt::format("luminaires {:.4g} m apart: a spacing is 1 to 1000 m", request.spacing_m));
    if (!(std::abs(request.overhang_m) <= 50.0))
        return fail("USE0106", fmt::format("an overhang of {:.4g} m: it is from −50 to 50 m", request.overhang_m));
    if (!(std::abs(request.tilt.value) <= 0.5 * std::numbers::pi))
        return fail("USE0106", fmt::format("a tilt of {:.4g}°: it is from −90° to 90°", to_degrees(request.tilt)));
    if (!(request.maintenance_factor > 0.0 && request.maintenance_factor <= 1.0))
        return fail("USE0106", "a maintenance factor is above 0 and at most 1");
    return {};
}

// Points along the field: 10, or as many as are at most 3 m apart.
std::size_t points_along(double length_m) {
    return length_m <= 30.0 ? 10 : static_cast<std::size_t>(std::ceil(length_m / 3.0 - 1e-9));
}

// The centres of the cells of a rectangle on the road.
ReceiverGrid grid_on_road(double length_m, double low_m, double width_m, std::size_t columns, std::size_t rows) {
    ReceiverGrid grid;
    grid.corner = {0.0, low_m, 0.0};
    grid.u = {length_m, 0.0, 0.0};
    grid.v = {0.0, width_m, 0.0};
    grid.columns = columns;
    grid.rows = rows;
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column) {
            const double u = (static_cast<double>(column) + 0.5) / static_cast<double>(columns);
            const double v = (static_cast<double>(row) + 0.5) / static_cast<double>(rows);
            grid.receivers.push_back({grid.corner + u * grid.u + v * grid.v, {0.0, 0.0, 1.0}});
        }
    return grid;
}

// A row of luminaires: one of them, and where the first is along the road, as a part of the spacing.
struct Row {
    Light light;
    double offset = 0.0;
};

// Plans one road with several spacings.
class Planner {
public:
    static Result<Planner> make(LightDescription luminaire, const RoadPlanRequest& request, Diagnostics& diagnostics) {
        Planner planner(request);
        if (auto* profile = std::get_if<ProfileShape>(&luminaire.shape)) profile->size = ProfileSize::point;
        Result<Light> light = planner.place(luminaire, false, diagnostics);
        if (!light) return pass_on(light);
        planner.rows_.push_back({std::move(*light), 0.0});
        const bool is_staggered = request.arrangement == RoadArrangement::staggered;
        if (is_staggered || request.arrangement == RoadArrangement::opposite) {
            Diagnostics repeated;
            Result<Light> across = planner.place(luminaire, true, repeated);
            if (!across) return pass_on(across);
            planner.rows_.push_back({std::move(*across), is_staggered ? 0.5 : 0.0});
        }
        return planner;
    }

    RoadPlan plan(double spacing_m) const {
        RoadPlan plan;
        plan.spacing_m = spacing_m;
        plan.luminaires_per_km = 1000.0 / spacing_m * static_cast<double>(rows_.size());
        const std::vector<Light> lights = all_lights(spacing_m);
        for (const Light& light : lights)
            if (light.frame.origin.x >= 0.0 && light.frame.origin.x <= spacing_m) plan.lights.push_back(light);
        add_illuminance(lights, plan);
        add_luminance(lights, plan);
        return plan;
    }

private:
    explicit Planner(RoadPlanRequest request) : request_(std::move(request)) {}

    // At x = 0; those of the farther side are turned by half a circle.
    Result<Light> place(LightDescription luminaire, bool farther, Diagnostics& diagnostics) const {
        const double side = farther ? -1.0 : 1.0;
        const double kerb_m = request_.arrangement == RoadArrangement::central ? 0.5 * request_.width_m
                              : farther                                        ? request_.width_m
                                                                               : 0.0;
        luminaire.position = {0.0, kerb_m + side * request_.overhang_m, request_.height_m};
        // The C that faces the street is turned to +Y: where C90 points then. Then tilt about X, and half a circle.
        const double turn = (180.0 - request_.street_side_c_deg) * std::numbers::pi / 180.0;
        const double cosine = std::cos(request_.tilt.value);
        const double sine = std::sin(request_.tilt.value);
        luminaire.direction = {0.0, side * sine, -cosine};
        luminaire.up = {side * std::cos(turn), side * std::sin(turn) * cosine, std::sin(turn) * sine};
        luminaire.rotation = Radians(0.0);
        return resolve_light(std::move(luminaire), diagnostics);
    }

    // Those that count for an eye or a point of the field, whichever way it looks; in ascending order along the road.
    std::vector<Light> all_lights(double spacing_m) const {
        const double reach_m = farthest_glare_m + 3.0 * request_.height_m;
        const auto count = static_cast<std::ptrdiff_t>(std::ceil(reach_m / spacing_m)) + 1;
        std::vector<Light> lights;
        for (std::ptrdiff_t i = -count; i <= count; ++i)
            for (const Row& row : rows_) {
                lights.push_back(row.light);
                lights.back().frame.origin.x = (static_cast<double>(i) + row.offset) * spacing_m;
            }
        return lights;
    }

    // On the road, as new, of the luminaires within five times their height.
    double illuminance_lx(std::span<const Light> lights, const glm::dvec3& point) const {
        double sum = 0.0;
        for (const Light& light : lights) {
            const glm::dvec3 path = point - light.frame.origin;
            const double beside_m = std::hypot(path.x, path.y);
            if (beside_m > 5.0 * request_.height_m) continue;
            const double squared_m2 = glm::dot(path, path);
            sum += light.intensity_towards(path).value * -path.z / (squared_m2 * std::sqrt(squared_m2));
        }
        return sum;
    }

    double mean_lx(std::span<const Light> lights, const ReceiverGrid& grid) const {
        double sum = 0.0;
        for (const Receiver& receiver : grid.receivers)
            sum += illuminance_lx(lights, receiver.position);
        return sum / static_cast<double>(grid.receivers.size());
    }

    void add_illuminance(std::span<const Light> lights, RoadPlan& plan) const {
        const std::size_t columns = points_along(plan.spacing_m);
        const auto rows = std::max<std::size_t>(3, static_cast<std::size_t>(std::ceil(request_.width_m / 1.5 - 1e-9)));
        plan.illuminance_grid = grid_on_road(plan.spacing_m, 0.0, request_.width_m, columns, rows);
        for (const Receiver& receiver : plan.illuminance_grid.receivers)
            plan.illuminance_lx.push_back(request_.maintenance_factor * illuminance_lx(lights, receiver.position));
        plan.illuminance = spread(plan.illuminance_lx);
        const double strip_m = lane_width_m();
        const auto strip_lx = [&](double low_m) {
            return mean_lx(lights, grid_on_road(plan.spacing_m, low_m, strip_m, columns, points_across_lane));
        };
        const auto ratio = [](double outside, double inside) { return inside > 0.0 ? outside / inside : 0.0; };
        plan.edge_ratio = std::min(ratio(strip_lx(-strip_m), strip_lx(0.0)),
                                   ratio(strip_lx(request_.width_m), strip_lx(request_.width_m - strip_m)));
    }

    void add_luminance(std::span<const Light> lights, RoadPlan& plan) const {
        const std::size_t columns = points_along(plan.spacing_m);
        plan.luminance_grid =
            grid_on_road(plan.spacing_m, 0.0, request_.width_m, columns, points_across_lane * request_.lanes);
        for (std::size_t i = 0; i < request_.lanes; ++i)
            plan.lanes.push_back(lane(lights, plan, i));
    }

    RoadLane lane(std::span<const Light> lights, const RoadPlan& plan, std::size_t index) const {
        RoadLane seen;
        const bool comes_back = request_.two_way && index >= (request_.lanes + 1) / 2;
        const double forward = comes_back ? -1.0 : 1.0;
        const double middle_m = (static_cast<double>(index) + 0.5) * lane_width_m();
        seen.observer = {
            {comes_back ? plan.spacing_m + viewing_distance_m : -viewing_distance_m, middle_m, eye_height_m},
            {forward * std::cos(sight_angle), 0.0, -std::sin(sight_angle)}};
        for (const Receiver& receiver : plan.luminance_grid.receivers)
            seen.luminance_nt.push_back(request_.maintenance_factor *
                                        luminance_nt(lights, receiver.position, seen.observer.eye));
        seen.luminance = spread(seen.luminance_nt);
        const std::size_t columns = plan.luminance_grid.columns;
        const std::size_t middle = (points_across_lane * index + points_across_lane / 2) * columns;
        seen.longitudinal_uniformity = spread(std::span(seen.luminance_nt).subspan(middle, columns)).diversity();

        // From where the screen cuts off the luminaire before the field, one step for each point along it.
        const double start_m = (request_.height_m - eye_height_m) / std::tan(screen_angle);
        Observer driver = seen.observer;
        for (std::size_t step = 0; step < columns; ++step) {
            const double on_m = static_cast<double>(step) * plan.spacing_m / static_cast<double>(columns) - start_m;
            driver.eye.x = comes_back ? plan.spacing_m - on_m : on_m;
            seen.veil.value = std::max(seen.veil.value, veil(lights, driver, forward).value);
        }
        seen.ti_percent = threshold_increment(seen.veil, Nits(seen.luminance.mean / request_.maintenance_factor));
        return seen;
    }

    // As new.
    double luminance_nt(std::span<const Light> lights, const glm::dvec3& point, const glm::dvec3& eye) const {
        const glm::dvec3 onward(point.x - eye.x, point.y - eye.y, 0.0);
        const double greatest_tan = request_.surface.tan_gamma.back();
        double sum = 0.0;
        for (const Light& light : lights) {
            const glm::dvec3 beside(light.frame.origin.x - point.x, light.frame.origin.y - point.y, 0.0);
            const double tan_gamma = glm::length(beside) / request_.height_m;
            if (tan_gamma > greatest_tan) continue;
            const double beta_deg =
                std::atan2(std::abs(onward.x * beside.y - onward.y * beside.x), glm::dot(onward, beside)) * 180.0 /
                std::numbers::pi;
            sum += light.intensity_towards(point - light.frame.origin).value *
                   request_.surface.reduced_coefficient(tan_gamma, beta_deg);
        }
        return sum / (request_.height_m * request_.height_m);
    }

    static Nits veil(std::span<const Light> lights, const Observer& driver, double forward) {
        Nits sum;
        for (const Light& light : lights) {
            const glm::dvec3& place = light.frame.origin;
            const double ahead_m = forward * (place.x - driver.eye.x);
            // At the screen's edge a luminaire is still seen.
            const bool is_screened = (place.z - driver.eye.z) > ahead_m * std::tan(screen_angle) * (1.0 + 1e-9);
            if (ahead_m <= 0.0 || ahead_m > farthest_glare_m || is_screened) continue;
            sum = sum + veiling_luminance(light, driver);
        }
        return sum;
    }

    double lane_width_m() const { return request_.width_m / static_cast<double>(request_.lanes); }

    RoadPlanRequest request_;
    std::vector<Row> rows_;
};

// "mean luminance 0.71 cd/m² (at least 1)"
std::string failed_text(std::span<const Verdict> verdicts) {
    std::string text;
    for (const Verdict& verdict : verdicts)
        if (verdict.passes() == std::optional(false))
            text += fmt::format("{}{} {:.{}f}{}{} ({} {:.4g})", text.empty() ? "" : ", ", verdict.what,
                                *verdict.reached, verdict.decimals, verdict.unit.empty() ? "" : " ", verdict.unit,
                                verdict.is_limit ? "at most" : "at least", verdict.required);
    return text;
}

} // namespace

std::span<const RoadArrangementName> road_arrangements() {
    return arrangements;
}

ReachedLight RoadPlan::reached() const {
    ReachedLight worst;
    worst.mean_lx = illuminance.mean;
    worst.least_lx = illuminance.least;
    worst.uniformity = illuminance.uniformity();
    worst.edge_ratio = edge_ratio;
    const auto least = [](std::optional<double>& of, double value) { of = std::min(of.value_or(value), value); };
    bool has_increment = true;
    for (const RoadLane& lane : lanes) {
        least(worst.mean_nt, lane.luminance.mean);
        least(worst.luminance_uniformity, lane.luminance.uniformity());
        least(worst.longitudinal_uniformity, lane.longitudinal_uniformity);
        has_increment = has_increment && lane.ti_percent;
        worst.ti_percent = std::max(worst.ti_percent.value_or(0.0), lane.ti_percent.value_or(0.0));
    }
    if (!has_increment) worst.ti_percent.reset();
    return worst;
}

Result<RoadPlan> plan_road(LightDescription luminaire, const RoadPlanRequest& request, Diagnostics& diagnostics) {
    if (Result<void> checked = check(request); !checked) return pass_on(checked);
    Result<Planner> planner = Planner::make(std::move(luminaire), request, diagnostics);
    if (!planner) return pass_on(planner);
    return planner->plan(request.spacing_m);
}

Result<RoadPlan> plan_road(LightDescription luminaire, RoadPlanRequest request, const Task& task,
                           Diagnostics& diagnostics) {
    constexpr double step_m = 0.5;
    constexpr double least_m = 5.0;
    request.spacing_m = least_m;
    if (Result<void> checked = check(request); !checked) return pass_on(checked);
    Result<Planner> planner = Planner::make(std::move(luminaire), request, diagnostics);
    if (!planner) return pass_on(planner);
    const double most_m = std::min(12.0 * request.height_m, 300.0);
    // Uniformities rise and fall with the spacing, so that nothing but a look at each will do.
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    std::string closest;
    for (double spacing_m = std::floor(most_m / step_m) * step_m; spacing_m >= least_m; spacing_m -= step_m) {
        RoadPlan plan = planner->plan(spacing_m);
        const std::vector<Verdict> all = verdicts(task, plan.reached());
        const auto failed = static_cast<std::size_t>(std::count_if(
            all.begin(), all.end(), [](const Verdict& verdict) { return verdict.passes() == std::optional(false); }));
        if (failed == 0) return plan;
        if (failed >= fewest) continue;
        fewest = failed;
        closest = fmt::format("at {:.4g} m: {}", spacing_m, failed_text(all));
    }
    return fail("USE0106",
                fmt::format("no spacing from {:.4g} to {:.4g} m passes '{}'; {}", least_m, most_m, task.name, closest),
                "try another arrangement, height, overhang or tilt, or another luminaire");
}

} // namespace gonio
