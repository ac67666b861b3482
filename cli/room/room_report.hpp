// What `gonio room` says about a planned room: in words, as JSON, as a rig, and as a plan.
#pragma once

#include <gonio/base/diagnostics.hpp>
#include <gonio/figures/room_plan.hpp>
#include <gonio/plot/grid_diagram.hpp>
#include <gonio/plot/room_sheet.hpp>

#include "../json_text.hpp"
#include "request.hpp"

#include <string>

namespace gonio::cli {

// Compares the plan with what the task requires, if there is one.
void judge(RoomRequest& request, const RoomPlan& plan);

std::string room_text(const RoomRequest& request, const RoomPlan& plan);

// What is unusual about the ratings of glare.
void add_remarks(const RoomPlan& plan, Diagnostics& diagnostics);

// Schema gonio.room/1.
Json room_json(const RoomRequest& request, const RoomPlan& plan, const Diagnostics& diagnostics);

// The rig of the plan: the room as its stage, the luminaires as an array. `file` is the name of the luminaire's profile
// as the rig's folder has it.
std::string room_rig(const RoomRequest& request, const RoomPlan& plan, const std::string& file);

GridPlot room_plot(const RoomRequest& request, const RoomPlan& plan);

// The sheet of the plan, with the walls around the working plane; `title` empty: the size of the room.
RoomSheetContent room_sheet_content(const RoomRequest& request, const RoomPlan& plan, const std::string& title);

} // namespace gonio::cli
