// The page of a rig in a room: its stage needs walls on four sides.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/plot/room_sheet.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../options/task_input.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace gonio::cli {

inline constexpr std::array rig_page_options{
    Option{"--plane", "HEIGHT", "height of the working plane (75cm)"},
    Option{"--wall-zone", "WIDTH", "along the walls, left out of the working plane (50cm)"},
    Option{"--eye", "HEIGHT", "height of the observers' eyes (1.2m)"},
    Option{"--allow-outside", "", "let a rig name pipes and files outside its folder"},
};

struct RigPageOptions {
    double plane_height_m = 0.75;
    double wall_zone_m = 0.5;
    double eye_height_m = 1.2;
    std::optional<TaskInput> task;
    unsigned threads = 0;
};

Result<RigPageOptions> rig_page_options_of(const Arguments& arguments);

struct RigPage {
    std::string title;
    RoomSheet sheet;
    bool has_failed = false;        // a requirement of the task
    std::vector<std::string> files; // all that were read
};

// Fails as read_rig_file() and place_on() do, and (usage) on a rig without a stage.
Result<RigPage> rig_page(const std::string& file, const Arguments& arguments, const RigPageOptions& options,
                         PaperSize paper, Diagnostics& diagnostics);

} // namespace gonio::cli
