#include <gonio/scene/rays_from.hpp>
#include <gonio/scene/stage.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <variant>

namespace gonio {

namespace {

// The default `up` is replaced where it is parallel to the view (aimed_frame); a chosen one in that direction must be a
// mistake.
bool is_chosen(const glm::dvec3& up) {
    return up != Camera().up;
}

// How far a shape with a long side extends along it from its middle [m]; 0 for round shapes.
double reach_along_c0(const Shape& shape) {
    return std::visit(
        [](const auto& kind) {
            if constexpr (requires { kind.width; }) return 0.5 * kind.width.value;
            if constexpr (requires { kind.length; }) return 0.5 * kind.length.value + kind.radius.value;
            return 0.0;
        },
        shape);
}

} // namespace

void hang(LightDescription& light, const LightPlacement& placement) {
    light.position = placement.position;
    light.direction = placement.direction;
    light.up = placement.up;
    if (reach_along_c0(light.shape) >= placement.room_along_c0_m)
        light.up = glm::cross(placement.direction, placement.up);
}

std::vector<std::string_view> surface_names(const Stage& stage) {
    std::vector<std::string_view> names;
    for (const Surface& surface : stage.surfaces)
        if (std::find(names.begin(), names.end(), surface.name) == names.end()) names.push_back(surface.name);
    return names;
}

Result<void> check_camera(const Stage& stage, const Camera& camera) {
    const glm::dvec3 view = camera.target - camera.position;
    if (view == glm::dvec3(0.0)) return fail("USE0106", "the camera must not be at its own target");
    const glm::dvec3 across = glm::cross(glm::normalize(view), glm::normalize(camera.up));
    if (is_chosen(camera.up) && glm::length(across) < 1e-6)
        return fail("USE0106", "the camera looks along its own up direction");
    for (const Surface& surface : stage.surfaces) {
        if (!hides(surface.geometry, camera.position)) continue;
        const glm::dvec3& at = camera.position;
        const bool is_plane = std::holds_alternative<Plane>(surface.geometry);
        return fail("USE0106",
                    fmt::format("the camera at {:g},{:g},{:g} is {} '{}'", at.x, at.y, at.z, is_plane ? "behind" : "in",
                                surface.name),
                    is_plane ? "a plane is seen from its lit side only" : "a solid is seen from outside only");
    }
    return {};
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
    return detail::hit_on(stage, surface, *nearest, ray);
}

Hit detail::hit_on(const Stage& stage, std::size_t surface, double distance, const Ray& ray) {
    const glm::dvec3 position = ray.origin + distance * ray.direction;
    const Primitive& met = stage.surfaces[surface].geometry;
    return {distance, surface, face_at(met, position), position, normal_at(met, position)};
}

} // namespace gonio
