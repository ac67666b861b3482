#include <gonio/base/kind_text.hpp>
#include <gonio/scene/stage.hpp>

#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace gonio {

namespace {

constexpr std::array kinds{
    StageKind{"floor", "a floor with a sphere on it and a wall behind"},
};

// A room's corner: the light hangs 2.6 m high and 0.9 m before the wall, where a downlight draws its scallop.
Stage floor_stage() {
    Stage stage;
    stage.name = "floor";
    stage.surfaces.push_back(
        {"floor", Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}, FrostbiteMaterial{glm::dvec3(0.35), 0.45, 0.0, 0.5}});
    stage.surfaces.push_back({"wall", Plane{{0.0, 0.9, 0.0}, {0.0, -1.0, 0.0}}, LambertMaterial{glm::dvec3(0.55)}});
    stage.surfaces.push_back(
        {"sphere", Ball{{0.42, -0.28, 0.32}, 0.32}, FrostbiteMaterial{glm::dvec3(0.55, 0.16, 0.08), 0.72, 0.0, 0.5}});
    stage.camera = {{0.0, -4.7, 1.5}, {0.0, 0.4, 1.08}, {0.0, 0.0, 1.0}, 36.0};
    stage.light_position = {0.0, 0.0, 2.6};
    return stage;
}

} // namespace

std::span<const StageKind> stage_kinds() {
    return kinds;
}

Result<Stage> make_stage(std::string_view name) {
    if (name == "floor") return floor_stage();
    std::vector<std::string_view> names;
    for (const StageKind& kind : kinds)
        names.push_back(kind.name);
    return unknown_name("stage", name, names);
}

std::optional<double> distance_to(const Plane& plane, const Ray& ray) {
    const double facing = glm::dot(ray.direction, plane.normal);
    if (!(facing < 0.0)) return std::nullopt;
    const double t = glm::dot(plane.point - ray.origin, plane.normal) / facing;
    return t > 0.0 ? std::optional(t) : std::nullopt;
}

std::optional<double> distance_to(const Ball& ball, const Ray& ray) {
    const glm::dvec3 to_center = ball.center - ray.origin;
    const double along = glm::dot(to_center, ray.direction);
    // From the closest approach, not from b²−4ac: far spheres keep their outline.
    const glm::dvec3 miss = to_center - along * ray.direction;
    const double half_chord2 = ball.radius * ball.radius - glm::dot(miss, miss);
    if (!(half_chord2 >= 0.0)) return std::nullopt;
    const double t = along - std::sqrt(half_chord2);
    return t > 0.0 ? std::optional(t) : std::nullopt;
}

std::optional<Hit> first_hit(const Stage& stage, const Ray& ray) {
    std::optional<double> nearest;
    std::size_t surface = 0;
    for (std::size_t i = 0; i < stage.surfaces.size(); ++i) {
        const auto t =
            std::visit([&](const auto& shape) { return distance_to(shape, ray); }, stage.surfaces[i].geometry);
        if (!t || (nearest && *nearest <= *t)) continue;
        nearest = t;
        surface = i;
    }
    if (!nearest) return std::nullopt;
    Hit hit{*nearest, surface, ray.origin + *nearest * ray.direction, {}};
    if (const auto* ball = std::get_if<Ball>(&stage.surfaces[surface].geometry))
        hit.normal = (hit.position - ball->center) / ball->radius;
    else
        hit.normal = std::get<Plane>(stage.surfaces[surface].geometry).normal;
    return hit;
}

} // namespace gonio
