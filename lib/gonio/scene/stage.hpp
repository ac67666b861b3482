// Stage: what a light is shown on. Z is up, lengths are metres.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/scene/camera.hpp>
#include <gonio/scene/material.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gonio {

// An infinite plane that is lit and seen from the side its unit normal points to.
struct Plane {
    glm::dvec3 point{0.0};
    glm::dvec3 normal{0.0, 0.0, 1.0};
};

// A solid sphere.
struct Ball {
    glm::dvec3 center{0.0};
    double radius = 1.0;
};

struct Surface {
    std::string name;
    std::variant<Plane, Ball> geometry;
    Material material;
};

struct Stage {
    std::string name;
    std::vector<Surface> surfaces;
    Camera camera;                            // frames the stage well
    glm::dvec3 light_position{0.0, 0.0, 2.5}; // where a light hangs unless it is placed
};

struct StageKind {
    std::string_view name;
    std::string_view summary;
};

std::span<const StageKind> stage_kinds();

// Fails (usage) on a name that is not one of stage_kinds().
Result<Stage> make_stage(std::string_view name);

// Where a ray first meets a stage.
struct Hit {
    double distance = 0.0;
    std::size_t surface = 0;
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0}; // unit, towards the side that is lit
};

// Distance along a unit direction, nothing behind the origin; planes are met only from their lit side.
std::optional<double> distance_to(const Plane& plane, const Ray& ray);
std::optional<double> distance_to(const Ball& ball, const Ray& ray);

std::optional<Hit> first_hit(const Stage& stage, const Ray& ray);

} // namespace gonio
