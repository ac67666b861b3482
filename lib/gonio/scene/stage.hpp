// Stage: the surfaces that a light is shown on. Z is up, lengths are metres.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/scene/camera.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/scene/primitives.hpp>
#include <gonio/scene/surface_emission.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// A primitive with a name and a material.
struct Surface {
    std::string name; // materials refer to it; several surfaces may share one
    Primitive geometry;
    Material material;
    bool subject = false; // what the stage is meant to show: a material without a surface's name applies to these
    std::optional<SurfaceEmission> emits = {}; // beside what it reflects, from its lit side; absent: nothing
};

// The default position and orientation of a light.
struct LightPlacement {
    glm::dvec3 position{0.0, 0.0, 2.5};
    glm::dvec3 direction{0.0, 0.0, -1.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    double room_along_c0_m = std::numeric_limits<double>::infinity(); // to the nearest object there
};

// Sets position, direction and up of a light that already has its shape. A tube or a rectangle that reaches to the
// nearest object along C0 is turned by 90°.
void hang(LightDescription& light, const LightPlacement& placement);

// Surfaces to light, and the camera that shows them.
struct Stage {
    std::string name;
    std::vector<Surface> surfaces;
    Camera camera; // frames the stage well
    LightPlacement light;
    glm::dvec3 figure_position{0.0}; // position of a scale figure [m]
};

// A built-in stage by its name, as `gonio list stages` shows it.
struct StageKind {
    std::string_view name;
    std::string_view summary;
};

// All of them.
std::span<const StageKind> stage_kinds();

// Fails (usage) on a name that is not one of stage_kinds().
Result<Stage> make_stage(std::string_view name);

// The names of the stage's surfaces, each once, in their order.
std::vector<std::string_view> surface_names(const Stage& stage);

// Fails (usage) on a camera that is at its own target, in a solid or behind a plane of the stage, or with a chosen `up`
// parallel to its view.
Result<void> check_camera(const Stage& stage, const Camera& camera);

// The first point where a ray hits a stage.
struct Hit {
    double distance = 0.0;
    std::size_t surface = 0;
    int face = 0; // of a box; an edge separates it from the next
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0}; // unit, towards the lit side
};

// The nearest surface that the ray meets; nothing if there is none.
std::optional<Hit> first_hit(const Stage& stage, const Ray& ray);

} // namespace gonio
#pragma GCC visibility pop
