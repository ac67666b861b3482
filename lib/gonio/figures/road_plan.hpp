// RoadPlan: a straight road lit by rows of equal luminaires, and the figures that it is judged by (EN 13201-3:2015).
//
// The road lies in z = 0 and runs along X, from kerb to kerb over 0 ≤ y ≤ width; luminaires of the first row are at
// x = 0, ± spacing, …, and the field between the first two of them stands for all of the road. Lanes are equally wide
// and counted from y = 0. Luminaires are points with their measured intensities: no surface but the road reflects, and
// nothing hides a light.
//
// Luminance: an eye 1.5 m above the middle of each lane in turn, 60 m before the field; points in rows of three a lane,
// at most 3 m apart along the road (10 of them up to 30 m); I r/H² over all luminaires, with the road's r-table.
// Threshold increment: the same eye, from where a screen at 20° cuts off the first luminaire before the field and then
// as many steps on as there are points; luminaires above the screen or more than 500 m away are left out. Illuminance:
// points at most 1.5 m apart across, of luminaires within five times their height.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/figures/glare.hpp>
#include <gonio/figures/road_surface.hpp>
#include <gonio/figures/tasks.hpp>
#include <gonio/light/light.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/scene/receiver_grid.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// Where the rows of luminaires are.
enum class RoadArrangement {
    single,    // at the side of y = 0
    opposite,  // at both sides, in pairs
    staggered, // at both sides, in turn
    central    // above the middle of the road
};

// An arrangement by its name in text.
struct RoadArrangementName {
    RoadArrangement arrangement;
    std::string_view name;
    std::string_view summary;
};

// All of them.
std::span<const RoadArrangementName> road_arrangements();

// What to plan.
struct RoadPlanRequest {
    double width_m = 7.0;
    std::size_t lanes = 2;
    bool two_way = false; // the farther half of the lanes drives towards −X
    RoadSurface surface;
    RoadArrangement arrangement = RoadArrangement::single;
    double spacing_m = 30.0;        // within a row
    double height_m = 8.0;          // of the luminaires above the road
    double overhang_m = 0.0;        // of a luminaire beyond its kerb, towards the middle; < 0: before it
    Radians tilt;                   // of a luminaire: its light goes farther across the road
    double street_side_c_deg = 0.0; // the C of the profile that faces across the road (street_side_c_deg())
    double maintenance_factor = 0.8;
};

// What a driver in the middle of a lane sees.
struct RoadLane {
    Observer observer;                // of the luminances, at the middle of the lane
    std::vector<double> luminance_nt; // maintained, at each point of the grid
    Spread luminance;
    double longitudinal_uniformity = 0.0; // least/greatest of the points on the lane's middle
    Nits veil;                            // the greatest veiling luminance, as new
    std::optional<double> ti_percent;     // by it; empty: a road of at most 0.05 cd/m²
};

// A planned road.
struct RoadPlan {
    double spacing_m = 0.0;
    std::vector<Light> lights;   // of the field, as new: those at x from 0 to its end
    ReceiverGrid luminance_grid; // the field between two luminaires of a row
    std::vector<RoadLane> lanes;
    ReceiverGrid illuminance_grid;
    std::vector<double> illuminance_lx; // maintained
    Spread illuminance;
    double edge_ratio = 0.0;        // R_EI: the light beside the road over that within, strips as wide as a lane
    double luminaires_per_km = 0.0; // of all rows

    // The figures that a class of road is judged by: of each the worst lane.
    ReachedLight reached() const;
};

// `luminaire` is a profile whose amount and colour are read; its place and direction are not. Fails as resolve_light()
// does, and (usage) on widths, heights and spacings that no road has, on luminaires at the height of the eyes, on a
// tilt of more than 90° and on a maintenance factor outside 0 to 1.
Result<RoadPlan> plan_road(LightDescription luminaire, const RoadPlanRequest& request, Diagnostics& diagnostics);

// The widest spacing, in steps of half a metre, at which the road passes all that the task requires of it and that is
// known; `request.spacing_m` is not read. Fails as plan_road() does, and (usage) if there is none from 5 m to twelve
// times the height, at most 300 m: the message states what failed where the fewest did.
Result<RoadPlan> plan_road(LightDescription luminaire, RoadPlanRequest request, const Task& task,
                           Diagnostics& diagnostics);

} // namespace gonio
#pragma GCC visibility pop
