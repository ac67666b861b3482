// Stage: what a light is shown on. Z is up, lengths are metres.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/scene/camera.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/scene/primitives.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {

struct Surface {
    std::string name; // by which it is given a material; several may share one
    Primitive geometry;
    Material material;
    bool subject = false; // what the stage is there to show: a material without a surface's name is for these
};

// Where a light hangs and how it is turned unless that is said.
struct LightPlacement {
    glm::dvec3 position{0.0, 0.0, 2.5};
    glm::dvec3 direction{0.0, 0.0, -1.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    double room_along_c0_m = std::numeric_limits<double>::infinity(); // to what stands there
};

// Gives the light, whose shape is set, its position, direction and up. A tube or a rectangle that reaches as far along
// C0 as there is room is turned by 90°.
void hang(LightDescription& light, const LightPlacement& placement);

struct Stage {
    std::string name;
    std::vector<Surface> surfaces;
    Camera camera; // frames the stage well
    LightPlacement light;
    glm::dvec3 figure_position{0.0}; // where a scale figure stands [m]
};

struct StageKind {
    std::string_view name;
    std::string_view summary;
};

std::span<const StageKind> stage_kinds();

// Fails (usage) on a name that is not one of stage_kinds().
Result<Stage> make_stage(std::string_view name);

// The names of its surfaces, each once, in their order.
std::vector<std::string_view> surface_names(const Stage& stage);

// Fails (usage) on a camera that stands at its own target, in a solid or behind a plane of the stage, or that is told
// to hold upright the direction in which it looks.
Result<void> check_camera(const Stage& stage, const Camera& camera);

// Where a ray first meets a stage.
struct Hit {
    double distance = 0.0;
    std::size_t surface = 0;
    int face = 0; // of a box, which an edge divides from the next
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0}; // unit, towards the side that is lit
};

std::optional<Hit> first_hit(const Stage& stage, const Ray& ray);

} // namespace gonio
