// The request of `gonio room`: a room, a luminaire, and what it is planned for.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/figures/room_plan.hpp>
#include <gonio/light/light.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../options/task_input.hpp"

#include <array>
#include <optional>
#include <string>

namespace gonio::cli {

inline constexpr std::array room_options{
    Option{"--luminaire", "FILE", "the luminaire: an IES, EULUMDAT or TM-33 profile"},
    Option{"--for", "LUX", "mean illuminance to reach on the working plane, maintained: 500lx (that of --task)"},
    Option{"--count", "NxM", "instead of --for: luminaires along the length and along the width, 4x3"},
    Option{"--reflectances", "C/W/F", "of ceiling, walls and floor in per cent (70/50/20)"},
    Option{"--maintenance", "FACTOR", "maintenance factor of all illuminances, 0.8 or 80% (0.8)"},
    Option{"--mount", "HEIGHT", "height of the luminaires above the floor (the ceiling's)"},
    Option{"--plane", "HEIGHT", "height of the working plane (75cm)"},
    Option{"--wall-zone", "WIDTH", "along the walls, left out of the working plane (50cm)"},
    Option{"--eye", "HEIGHT", "height of the observers' eyes (1.2m)"},
    Option{"--rotate", "ANGLE", "turn the luminaires: 90deg (0deg: C0 along the room's length)"},
    Option{"--flux", "LUMENS", "luminous flux of each luminaire (as measured)"},
};

struct RoomRequest {
    std::string size; // as given
    std::string file; // of the luminaire
    std::string name; // of the luminaire, as the profile states it
    LightDescription luminaire;
    RoomPlanRequest plan;
    std::string flux;              // as given; empty: as measured
    std::optional<double> input_w; // of each luminaire
    std::optional<double> ra;      // colour rendering, as the profile states it
    std::optional<TaskInput> task;
};

// Reads the luminaire. Fails as load_profile() does, and (usage) on values of a wrong form.
Result<RoomRequest> parse_room(const Arguments& arguments, Diagnostics& diagnostics);

} // namespace gonio::cli
