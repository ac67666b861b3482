// The request of `gonio road`: a road, rows of luminaires, and what it is planned for.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/figures/road_plan.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../options/luminaire_input.hpp"
#include "../options/task_input.hpp"

#include <array>
#include <optional>

namespace gonio::cli {

inline constexpr std::array road_options{
    luminaire_option,
    Option{"--lanes", "N", "lanes of equal width (2)"},
    Option{"--two-way", "", "the farther half of the lanes drives the other way"},
    Option{"--surface", "SURFACE", "what the road is made of: a name, or a file with an r-table (r3)", "road-surfaces"},
    Option{"--q0", "Q0", "average luminance coefficient of the surface (that of its table)"},
};

inline constexpr std::array road_luminaire_options{
    Option{"--arrangement", "NAME", "single, opposite, staggered or central (single)", "arrangements"},
    Option{"--spacing", "LENGTH", "between the luminaires of a row (with --task: the widest that passes)"},
    Option{"--height", "LENGTH", "of the luminaires above the road (8m)"},
    Option{"--overhang", "LENGTH", "of the luminaires over the road, from its edge; less than 0: beside it (0m)"},
    Option{"--tilt", "ANGLE", "of the luminaires, so that their light goes farther across (0deg)"},
    Option{"--rotate", "ANGLE", "turn the luminaires, C0 towards C90 (0deg: the street side faces across the road)"},
    Option{"--maintenance", "FACTOR", "maintenance factor of luminances and illuminances, 0.8 or 80% (0.8)"},
    flux_option,
};

struct RoadRequest {
    LuminaireInput luminaire;
    RoadPlanRequest plan;
    bool has_spacing = false; // else the widest that the task allows
    std::optional<TaskInput> task;
};

// Reads the luminaire. Fails as load_profile() and parse_road_surface() do, and (usage) on values of a wrong form and
// with neither a spacing nor a task.
Result<RoadRequest> parse_road(const Arguments& arguments, Diagnostics& diagnostics);

} // namespace gonio::cli
