#include <gonio/figures/room_plan.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/scene/primitives.hpp>
#include <gonio/scene/spatial_illuminance.hpp>
#include <gonio/transport/receiver_light.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>
#include <variant>

namespace gonio {

namespace {

constexpr std::size_t most_luminaires = 4096;
constexpr double most_reflectance = 0.95;
constexpr glm::dvec3 up{0.0, 0.0, 1.0};

Result<void> check(const RoomPlanRequest& request) {
    const glm::dvec3& size = request.size_m;
    const auto is_size = [](double length_m) { return length_m > 0.0 && length_m <= 1000.0; };
    if (!is_size(size.x) || !is_size(size.y) || !is_size(size.z))
        return fail("USE0106", "a room's length, width and height are above 0 and at most 1000 m");
    for (const double reflectance :
         {request.reflectances.ceiling, request.reflectances.walls, request.reflectances.floor})
        if (!(reflectance >= 0.0 && reflectance <= most_reflectance))
            return fail("USE0106",
                        fmt::format("a reflectance of {:.4g} %: a room's are from 0 to 95 %", 100.0 * reflectance));
    if (!(request.mounting_height_m >= 0.0 && request.mounting_height_m <= size.z))
        return fail("USE0106", fmt::format("luminaires at {:.4g} m are above the ceiling, which is at {:.4g} m",
                                           request.mounting_height_m, size.z));
    const double mounting_m = request.mounting_height_m > 0.0 ? request.mounting_height_m : size.z;
    if (!(request.plane_height_m >= 0.0 && request.plane_height_m < mounting_m))
        return fail("USE0106",
                    fmt::format("a working plane at {:.4g} m is not below the luminaires, which are at {:.4g} m",
                                request.plane_height_m, mounting_m));
    if (!(request.eye_height_m > 0.0 && request.eye_height_m < mounting_m))
        return fail("USE0106", fmt::format("eyes at {:.4g} m are not below the luminaires, which are at {:.4g} m",
                                           request.eye_height_m, mounting_m));
    if (!(request.wall_zone_m >= 0.0 && 2.0 * request.wall_zone_m < std::min(size.x, size.y)))
        return fail("USE0106", fmt::format("a wall zone of {:.4g} m leaves nothing of a room of {:.4g} m by {:.4g} m",
                                           request.wall_zone_m, size.x, size.y));
    if (!(request.maintenance_factor > 0.0 && request.maintenance_factor <= 1.0))
        return fail("USE0106", "a maintenance factor is above 0 and at most 1");
    if (request.mean.has_value() == request.layout.has_value())
        return fail("USE0107", "a room is planned for a mean illuminance or with a layout");
    if (request.mean && !(request.mean->value > 0.0 && request.mean->value <= 1e6))
        return fail("USE0106", "the mean illuminance of a room is above 0 and at most 1,000,000 lx");
    if (request.layout && (request.layout->count() == 0 || request.layout->columns > most_luminaires ||
                           request.layout->rows > most_luminaires || request.layout->count() > most_luminaires))
        return fail("USE0106", fmt::format("a room has 1 to {} luminaires", most_luminaires));
    return {};
}

// A layout for each count that fills the ceiling evenly: with cells that are at most twice as long as wide. Ascending.
std::vector<RoomLayout> regular_layouts(double length_m, double width_m) {
    std::vector<RoomLayout> best(most_luminaires + 1, RoomLayout{0, 0});
    const auto unevenness = [&](const RoomLayout& layout) {
        return std::abs(
            std::log((length_m / static_cast<double>(layout.columns)) / (width_m / static_cast<double>(layout.rows))));
    };
    for (std::size_t columns = 1; columns <= most_luminaires; ++columns)
        for (std::size_t rows = 1; rows <= most_luminaires / columns; ++rows) {
            RoomLayout& kept = best[columns * rows];
            const RoomLayout layout{columns, rows};
            if (kept.columns == 0 || unevenness(layout) < unevenness(kept)) kept = layout;
        }
    std::vector<RoomLayout> even;
    for (const RoomLayout& layout : best)
        if (layout.columns > 0 && (layout.count() == 1 || unevenness(layout) <= std::numbers::ln2 + 1e-12))
            even.push_back(layout);
    return even;
}

const Opening* declared_opening(const Shape& shape) {
    const auto* const profile = std::get_if<ProfileShape>(&shape);
    if (profile == nullptr) return nullptr;
    return profile->given != nullptr ? profile->given.get() : profile->declared.get();
}

// Extent of a luminaire along X and Y of the room [m].
glm::dvec3 extent_of(const Light& light) {
    const Opening* const opening = declared_opening(light.shape);
    if (opening == nullptr) return glm::dvec3(0.0);
    const glm::dvec3 x = light.frame.x * opening->size_m.x;
    const glm::dvec3 y = light.frame.y * opening->size_m.y;
    return {std::abs(x.x) + std::abs(y.x), std::abs(x.y) + std::abs(y.y), 0.0};
}

// Plans one room with several layouts.
class Planner {
public:
    Planner(LightDescription luminaire, const RoomPlanRequest& request)
        : luminaire_(std::move(luminaire)), request_(request), stage_(box_room(request.size_m, request.reflectances)) {
        // A luminaire at the ceiling shines from just below it, all of its opening.
        const double height_m = request.mounting_height_m > 0.0 ? request.mounting_height_m : request.size_m.z;
        const Opening* const opening = declared_opening(luminaire_.shape);
        const double half_m = opening != nullptr ? 0.5 * opening->size_m.z : 0.0;
        luminaire_.position.z = std::min(height_m, request.size_m.z - half_m - 1e-3);
    }

    Result<RoomPlan> plan(const RoomLayout& layout) const {
        RoomPlan plan;
        plan.layout = layout;
        plan.stage = stage_;
        const glm::dvec3& size = request_.size_m;
        plan.spacing_m = {size.x / static_cast<double>(layout.columns), size.y / static_cast<double>(layout.rows), 0.0};
        Result<std::vector<Light>> lights = place(luminaire_, layout);
        if (!lights) return pass_on(lights);
        plan.lights = std::move(*lights);
        const glm::dvec3 extent = extent_of(plan.lights.front());
        if (extent.x > plan.spacing_m.x * (1.0 + 1e-9) || extent.y > plan.spacing_m.y * (1.0 + 1e-9))
            return fail(
                "USE0106",
                fmt::format("luminaires of {:.4g} m by {:.4g} m do not fit into {} by {} cells of {:.4g} m by {:.4g} m",
                            extent.x, extent.y, layout.columns, layout.rows, plan.spacing_m.x, plan.spacing_m.y),
                "turn them by 90°, plan for less, or take a brighter luminaire");
        if (Result<void> lit = add_light(plan); !lit) return pass_on(lit);
        return plan;
    }

    // On the working plane, without what is reflected; luminaires as points. Maintained.
    Result<double> direct_mean_lx(const RoomLayout& layout) const {
        LightDescription point = luminaire_;
        if (auto* profile = std::get_if<ProfileShape>(&point.shape)) profile->size = ProfileSize::point;
        Result<std::vector<Light>> lights = place(point, layout);
        if (!lights) return pass_on(lights);
        Result<ReceiverGrid> grid = working_plane();
        if (!grid) return pass_on(grid);
        ProbeOptions options;
        options.threads = request_.threads;
        Result<ProbeResult> direct = probe(*lights, grid->receivers, options);
        if (!direct) return pass_on(direct);
        return request_.maintenance_factor * spread(direct->illuminance_lx).mean;
    }

private:
    Result<std::vector<Light>> place(const LightDescription& luminaire, const RoomLayout& layout) const {
        const glm::dvec3& size = request_.size_m;
        const double step_x = size.x / static_cast<double>(layout.columns);
        const double step_y = size.y / static_cast<double>(layout.rows);
        std::vector<Light> lights;
        Diagnostics repeated; // what was said of the profile
        for (std::size_t row = 0; row < layout.rows; ++row)
            for (std::size_t column = 0; column < layout.columns; ++column) {
                LightDescription light = luminaire;
                light.name = fmt::format("{}[{},{}]", luminaire.name, column + 1, row + 1);
                light.position.x = -0.5 * size.x + (static_cast<double>(column) + 0.5) * step_x;
                light.position.y = -0.5 * size.y + (static_cast<double>(row) + 0.5) * step_y;
                Result<Light> resolved = resolve_light(std::move(light), repeated);
                if (!resolved) return pass_on(resolved);
                lights.push_back(std::move(*resolved));
            }
        return lights;
    }

    Result<ReceiverGrid> working_plane() const {
        const glm::dvec3 corner(-0.5 * request_.size_m.x + request_.wall_zone_m,
                                -0.5 * request_.size_m.y + request_.wall_zone_m, request_.plane_height_m);
        return parallelogram_grid(corner, {-2.0 * corner.x, 0.0, 0.0}, {0.0, -2.0 * corner.y, 0.0}, {}, up, 1U << 16U);
    }

    Result<void> add_light(RoomPlan& plan) const {
        Result<ReceiverGrid> grid = working_plane();
        if (!grid) return pass_on(grid);
        plan.grid = std::move(*grid);

        LightingOptions lighting;
        lighting.bounces = all_bounces;
        lighting.threads = request_.threads;
        Result<ReceiverLight> on_stage = ReceiverLight::on(plan.stage, plan.lights, lighting);
        if (!on_stage) return pass_on(on_stage);
        ProbeOptions options;
        options.parts = true;
        options.threads = request_.threads;
        const std::span<const Receiver> receivers = plan.grid.receivers;
        Result<ProbeResult> direct = probe(plan.lights, receivers, options);
        if (!direct) return pass_on(direct);
        const ReceiverLight::Shares shares = on_stage->at(receivers);
        for (std::size_t i = 0; i < receivers.size(); ++i) {
            plan.direct_lx.push_back(request_.maintenance_factor * direct->illuminance_lx[i]);
            plan.illuminance_lx.push_back(plan.direct_lx.back() + request_.maintenance_factor * shares.indirect_lx[i]);
        }
        plan.spread = spread(plan.illuminance_lx);
        if (request_.surfaces)
            if (Result<void> added = add_surfaces(plan, *on_stage); !added) return added;
        return add_observers(plan, *on_stage);
    }

    // The mean of what reaches flat receivers, as new.
    Result<double> mean_lx(const RoomPlan& plan, const ReceiverLight& on_stage,
                           std::span<const Receiver> receivers) const {
        ProbeOptions options;
        options.threads = request_.threads;
        Result<ProbeResult> direct = probe(plan.lights, receivers, options);
        if (!direct) return pass_on(direct);
        return spread(direct->illuminance_lx).mean + spread(on_stage.at(receivers).indirect_lx).mean;
    }

    // Walls count by their areas: the cells of all have nearly the same size.
    Result<void> add_surfaces(RoomPlan& plan, const ReceiverLight& on_stage) const {
        const glm::dvec3& size = request_.size_m;
        const glm::dvec3 half = 0.5 * size;
        std::vector<Receiver> walls;
        std::vector<Receiver> ceiling;
        const auto add = [](const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v,
                            const glm::dvec3& normal, std::vector<Receiver>& to) -> Result<void> {
            Result<ReceiverGrid> made = parallelogram_grid(corner, u, v, {}, normal, 1U << 16U);
            if (!made) return pass_on(made);
            to.insert(to.end(), made->receivers.begin(), made->receivers.end());
            return {};
        };
        const glm::dvec3 along_x(size.x, 0.0, 0.0);
        const glm::dvec3 along_y(0.0, size.y, 0.0);
        const glm::dvec3 along_z(0.0, 0.0, size.z);
        for (const double side : {-1.0, 1.0}) {
            Result<void> added = add({side * half.x, -half.y, 0.0}, along_y, along_z, {-side, 0.0, 0.0}, walls);
            if (added) added = add({-half.x, side * half.y, 0.0}, along_x, along_z, {0.0, -side, 0.0}, walls);
            if (!added) return added;
        }
        if (Result<void> added = add({-half.x, -half.y, size.z}, along_x, along_y, -up, ceiling); !added) return added;
        Result<double> walls_lx = mean_lx(plan, on_stage, walls);
        if (!walls_lx) return pass_on(walls_lx);
        Result<double> ceiling_lx = mean_lx(plan, on_stage, ceiling);
        if (!ceiling_lx) return pass_on(ceiling_lx);
        const double maintained = request_.maintenance_factor;
        plan.surfaces = RoomSurfaces{maintained * *walls_lx, maintained * *ceiling_lx,
                                     maintained * cylindrical_mean_lx(plan, on_stage)};
        return {};
    }

    // At the height of the eyes, as new. What is reflected comes from the surfaces that stand for a cylinder.
    double cylindrical_mean_lx(const RoomPlan& plan, const ReceiverLight& on_stage) const {
        std::vector<Receiver> heads = plan.grid.receivers;
        std::vector<Receiver> around;
        std::vector<double> weights;
        for (Receiver& head : heads) {
            head.position.z = request_.eye_height_m;
            for (const WeightedNormal& surface : surfaces_of(IlluminanceKind::cylindrical, up)) {
                around.push_back({head.position, surface.normal});
                weights.push_back(surface.weight);
            }
        }
        double sum = 0.0;
        for (const double lx : illuminance_parts(IlluminanceKind::cylindrical, plan.lights, heads, request_.threads))
            sum += lx;
        const std::vector<double> indirect = on_stage.at(around).indirect_lx;
        for (std::size_t i = 0; i < indirect.size(); ++i)
            sum += weights[i] * indirect[i];
        return sum / static_cast<double>(heads.size());
    }

    Result<void> add_observers(RoomPlan& plan, const ReceiverLight& on_stage) const {
        const glm::dvec3 half = 0.5 * request_.size_m;
        const std::array<Observer, 4> walls = wall_observers({-half, half}, request_.eye_height_m);
        std::vector<Receiver> eyes;
        for (const Observer& observer : walls)
            eyes.push_back({observer.eye, observer.view});
        const ReceiverLight::Shares shares = on_stage.at(eyes);
        for (std::size_t i = 0; i < walls.size(); ++i) {
            const std::span visible = std::span(shares.visible).subspan(i * plan.lights.size(), plan.lights.size());
            plan.observers.at(i) = {walls.at(i),
                                    glare_rating(plan.lights, walls.at(i), visible, shares.indirect_lx[i])};
        }
        return {};
    }

    LightDescription luminaire_;
    const RoomPlanRequest& request_;
    Stage stage_;
};

} // namespace

std::array<Observer, 4> wall_observers(const FloorArea& area, double eye_height_m) {
    const glm::dvec3 middle = 0.5 * (area.low + area.high);
    return {Observer{{area.low.x, middle.y, eye_height_m}, {1.0, 0.0, 0.0}},
            Observer{{area.high.x, middle.y, eye_height_m}, {-1.0, 0.0, 0.0}},
            Observer{{middle.x, area.low.y, eye_height_m}, {0.0, 1.0, 0.0}},
            Observer{{middle.x, area.high.y, eye_height_m}, {0.0, -1.0, 0.0}}};
}

Stage box_room(const glm::dvec3& size_m, const RoomReflectances& reflectances) {
    const auto matte = [](double albedo) { return LambertMaterial{glm::dvec3(albedo)}; };
    const glm::dvec3 half = 0.5 * size_m;
    Stage stage;
    stage.name = "room";
    stage.surfaces = {
        {"floor", panel_facing({0.0, 0.0, 0.0}, up, {0, 1, 0}, size_m.x, size_m.y), matte(reflectances.floor)},
        {"ceiling", panel_facing({0.0, 0.0, size_m.z}, -up, {0, 1, 0}, size_m.x, size_m.y),
         matte(reflectances.ceiling)},
        {"wall", panel_facing({-half.x, 0.0, half.z}, {1, 0, 0}, up, size_m.y, size_m.z), matte(reflectances.walls)},
        {"wall", panel_facing({half.x, 0.0, half.z}, {-1, 0, 0}, up, size_m.y, size_m.z), matte(reflectances.walls)},
        {"wall", panel_facing({0.0, half.y, half.z}, {0, -1, 0}, up, size_m.x, size_m.z), matte(reflectances.walls)},
        {"wall", panel_facing({0.0, -half.y, half.z}, {0, 1, 0}, up, size_m.x, size_m.z), matte(reflectances.walls)},
    };
    stage.camera.position = {0.0, -half.y + 0.1, std::min(1.6, half.z)};
    stage.camera.target = {0.0, half.y, std::min(1.2, half.z)};
    stage.light.position = {0.0, 0.0, size_m.z};
    return stage;
}

Result<RoomPlan> plan_room(LightDescription luminaire, const RoomPlanRequest& request, Diagnostics& diagnostics) {
    if (Result<void> checked = check(request); !checked) return pass_on(checked);
    // Once, for what there is to say about it; its profile stays loaded in the shape.
    if (Result<void> loaded = load_profile(luminaire.shape, diagnostics); !loaded) return pass_on(loaded);
    luminaire.direction = {0.0, 0.0, -1.0};
    if (request.layout) return Planner(std::move(luminaire), request).plan(*request.layout);
    // What is not searched for is added to what is found.
    RoomPlanRequest searched = request;
    searched.surfaces = false;
    const Planner planner(luminaire, searched);

    const std::vector<RoomLayout> layouts = regular_layouts(request.size_m.x, request.size_m.y);
    const double needed_lx = request.mean->value;
    const auto too_many = [&] {
        return fail("USE0106",
                    fmt::format("{:.4g} lx need more than {} of these luminaires", needed_lx, most_luminaires),
                    "take a brighter luminaire");
    };
    // Direct light of points is cheap, and all of the light is nearly the same multiple of it in every layout: that
    // finds the layout to plan in full, which corrects the multiple. The mean is taken to rise with the count.
    double all_over_direct = 1.2;
    std::ptrdiff_t low = -1; // does not reach it
    auto high = static_cast<std::ptrdiff_t>(layouts.size());
    std::optional<RoomPlan> found;
    const auto estimate = [&](std::ptrdiff_t index) -> Result<double> {
        Result<double> direct = planner.direct_mean_lx(layouts[static_cast<std::size_t>(index)]);
        if (direct) *direct *= all_over_direct;
        return direct;
    };
    while (high - low > 1) {
        std::ptrdiff_t below = low;
        std::ptrdiff_t guess = high;
        while (guess - below > 1) {
            const std::ptrdiff_t middle = below + (guess - below) / 2;
            const Result<double> lx = estimate(middle);
            if (!lx) return Unexpected(lx.error());
            (*lx >= needed_lx ? guess : below) = middle;
        }
        if (guess == high && found) guess = high - 1;
        if (guess == static_cast<std::ptrdiff_t>(layouts.size())) return too_many();
        if (found && guess == high - 1) {
            // Not worth a plan if it is clearly too dark.
            const Result<double> lx = estimate(guess);
            if (!lx) return Unexpected(lx.error());
            if (*lx < 0.98 * needed_lx) break;
        }
        const RoomLayout& layout = layouts[static_cast<std::size_t>(guess)];
        Result<RoomPlan> next = planner.plan(layout);
        if (!next) return next;
        const Result<double> direct = planner.direct_mean_lx(layout);
        if (!direct) return Unexpected(direct.error());
        if (*direct > 0.0) all_over_direct = next->spread.mean / *direct;
        if (next->spread.mean >= needed_lx) {
            high = guess;
            found = std::move(*next);
        } else {
            low = guess;
        }
    }
    if (!found) return too_many();
    if (request.surfaces) return Planner(std::move(luminaire), request).plan(found->layout);
    return std::move(*found);
}

} // namespace gonio
