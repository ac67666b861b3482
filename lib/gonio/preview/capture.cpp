#include <gonio/base/amount_range.hpp>
#include <gonio/ibl/prefilter.hpp>
#include <gonio/preview/capture.hpp>
#include <gonio/scene/camera.hpp>
#include <gonio/scene/primitives.hpp>
#include <gonio/sky/environment_resample.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace gonio {

namespace {

constexpr int probe_side = 128;
constexpr int probe_levels = 6;

// Looking along an axis, one after the other: x, −x, y, −y, z, −z.
Camera camera_along(const glm::dvec3& position, int axis) {
    glm::dvec3 ahead(0.0);
    ahead[axis / 2] = axis % 2 == 0 ? 1.0 : -1.0;
    Camera camera;
    camera.position = position;
    camera.target = position + ahead;
    camera.up = axis < 4 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);
    camera.vertical_fov_deg = 90.0;
    return camera;
}

int axis_of(const glm::dvec3& direction) {
    int axis = 0;
    for (int other = 1; other < 3; ++other)
        if (std::abs(direction[other]) > std::abs(direction[axis])) axis = other;
    return 2 * axis + (direction[axis] < 0.0 ? 1 : 0);
}

Result<void> check_place(const Stage& stage, const glm::dvec3& position) {
    const double farthest = std::max({std::abs(position.x), std::abs(position.y), std::abs(position.z)});
    if (!(farthest <= greatest_amount))
        return fail("USE0106",
                    fmt::format("the point {:.6g},{:.6g},{:.6g} is out of range", position.x, position.y, position.z),
                    fmt::format("coordinates reach to {} m", greatest_amount));
    for (const Surface& surface : stage.surfaces)
        if (hides(surface.geometry, position))
            return fail("USE0106",
                        fmt::format("the point {:.6g},{:.6g},{:.6g} is inside or behind '{}' of the stage '{}'",
                                    position.x, position.y, position.z, surface.name, stage.name),
                        "choose a point from which the stage can be seen");
    return {};
}

double distance_along(const Stage& stage, const glm::dvec3& position, const glm::dvec3& direction) {
    const std::optional<Hit> hit = first_hit(stage, {position, direction});
    return hit ? std::min(hit->distance, farthest_m) : farthest_m;
}

} // namespace

Result<EnvironmentMap> capture(const Stage& stage, std::span<const Light> lights, const glm::dvec3& position, int side,
                               const RenderOptions& options) {
    if (Result<void> free = check_place(stage, position); !free) return pass_on(free);
    Result<EnvironmentGrid> grid = environment_grid(EnvironmentLayout::cube_strip, side);
    if (!grid) return pass_on(grid);
    RenderOptions face_options = options;
    face_options.width = face_options.height = side;
    face_options.shows_sky = true;
    face_options.illuminance = false;
    std::array<Image, 6> faces;
    std::vector<CameraRays> rays;
    for (int axis = 0; axis < 6; ++axis) {
        const Camera camera = camera_along(position, axis);
        Result<Rendering> face = render(stage, lights, camera, face_options);
        if (!face) return pass_on(face);
        faces[static_cast<std::size_t>(axis)] = std::move(face->luminance_nt);
        face_options.known = std::move(face->indirect);
        // At the origin: far from it a direction is lost beside a position.
        rays.emplace_back(camera_along(glm::dvec3(0.0), axis), side, side);
    }
    Image picture(grid->width(), grid->height(), 3);
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column) {
            const glm::dvec3 direction = grid->direction({column + 0.5, row + 0.5});
            const auto axis = static_cast<std::size_t>(axis_of(direction));
            const glm::dvec2 place = rays[axis].place_of(direction).value_or(glm::dvec2(0.0));
            const auto pixel = [&](double along) { return std::clamp(static_cast<int>(along), 0, side - 1); };
            std::copy_n(faces[axis].at(pixel(place.x), pixel(place.y)), 3, picture.at(column, row));
        }
    return EnvironmentMap::of_valid(*grid, std::move(picture), 1.0);
}

Result<LocalProbe> local_probe(const Stage& stage, std::span<const Light> lights, const glm::dvec3& position,
                               const RenderOptions& options) {
    RenderOptions without_lights = options;
    without_lights.shows_lights = false;
    without_lights.surroundings = SurroundingsMethod::exact;
    Result<EnvironmentMap> map = capture(stage, lights, position, probe_side, without_lights);
    if (!map) return pass_on(map);
    PrefilterOptions prefiltering;
    prefiltering.side = probe_side;
    prefiltering.levels = probe_levels;
    prefiltering.tolerance = 1e-3; // of the mean, far below what the methods themselves are off
    prefiltering.threads = options.threads;
    Result<PrefilteredEnvironment> light = prefilter(*map, prefiltering);
    if (!light) return pass_on(light);
    ParallaxBox box;
    for (int axis = 0; axis < 6; ++axis) {
        glm::dvec3 ahead(0.0);
        ahead[axis / 2] = axis % 2 == 0 ? 1.0 : -1.0;
        const double wall = position[axis / 2] + ahead[axis / 2] * distance_along(stage, position, ahead);
        (axis % 2 == 0 ? box.high : box.low)[axis / 2] = wall;
    }
    double sum = 0.0;
    int count = 0;
    const EnvironmentGrid few = environment_grid(EnvironmentLayout::cube_strip, 16).value();
    for (int row = 0; row < few.height(); ++row)
        for (int column = 0; column < few.width(); ++column, ++count)
            sum += distance_along(stage, position, few.direction({column + 0.5, row + 0.5}));
    return LocalProbe{position, box, {position, sum / count}, std::move(*light)};
}

} // namespace gonio
