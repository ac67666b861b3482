// RoomPlan: luminaires in a regular layout on the ceiling of an empty room, and the light they give, by exact sums and
// all bounces.
//
// The room is a box about the Z axis, with its floor at z = 0, and its three reflectances are Lambertian. Luminaires
// are at the middles of equal cells, so that the distance to a wall is half of that between them, and face down.
// Illuminances are maintained ones: times the maintenance factor.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/figures/box_room.hpp>
#include <gonio/figures/glare.hpp>
#include <gonio/light/light.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/scene/receiver_grid.hpp>
#include <gonio/scene/stage.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// How many luminaires along X and along Y.
struct RoomLayout {
    std::size_t columns = 1;
    std::size_t rows = 1;

    std::size_t count() const { return columns * rows; }
};

// What to plan for.
struct RoomPlanRequest {
    glm::dvec3 size_m{0.0}; // length along X, width along Y, height
    RoomReflectances reflectances{0.7, 0.5, 0.2};
    double mounting_height_m = 0.0; // of the luminaires' middles; 0: at the ceiling, all of them below it
    double plane_height_m = 0.75;   // of the working plane
    double wall_zone_m = 0.5;       // along the walls, left out of the working plane (EN 12464-1)
    double eye_height_m = 1.2;      // of the observers
    double maintenance_factor = 0.8;
    std::optional<Lux> mean{};          // the smallest layout that gives it
    std::optional<RoomLayout> layout{}; // or this one
    bool surfaces = false;              // requests RoomPlan::surfaces
    unsigned threads = 0;               // 0 = all hardware threads
};

// Maintained means of what EN 12464-1 asks for beside the working plane.
struct RoomSurfaces {
    double walls_lx = 0.0;
    double ceiling_lx = 0.0;
    double cylindrical_lx = 0.0; // at the height of the eyes, above the working plane's area
};

// UGR for an observer at the middle of a wall, who looks level at the opposite one.
struct RoomObserver {
    Observer observer;
    GlareRating glare;
};

// The observers at the middles of the walls −X, +X, −Y, +Y of a floor plan, who look level across it.
std::array<Observer, 4> wall_observers(const FloorArea& area, double eye_height_m);

// A planned room.
struct RoomPlan {
    Stage stage;
    RoomLayout layout;
    glm::dvec3 spacing_m{0.0};          // along X and Y
    std::vector<Light> lights;          // as new
    ReceiverGrid grid;                  // EN 12464-1
    std::vector<double> illuminance_lx; // maintained, at each point of the grid
    std::vector<double> direct_lx;
    Spread spread;                         // of illuminance_lx
    std::array<RoomObserver, 4> observers; // at the walls −X, +X, −Y, +Y
    std::optional<RoomSurfaces> surfaces;  // if requested
};

// The stage of such a room: surfaces "floor", "ceiling" and "wall".
Stage box_room(const glm::dvec3& size_m, const RoomReflectances& reflectances);

// `luminaire` is placed: its position is not read, it faces down as its rotation has it, and its profile is loaded. A
// profile emits from its luminous opening where its shape asks for that. Fails as resolve_light() does, and (usage) on
// a room without a size, on reflectances outside 0 to 0.95, on heights outside the room or below the working plane, on
// a working plane that the wall zone leaves nothing of, on luminaires larger than their share of the ceiling, and if
// more than 4096 luminaires would be needed.
Result<RoomPlan> plan_room(LightDescription luminaire, const RoomPlanRequest& request, Diagnostics& diagnostics);

} // namespace gonio
#pragma GCC visibility pop
