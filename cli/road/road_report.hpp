// What `gonio road` says about a planned road: in words, as JSON, as a rig, and as a plan.
#pragma once

#include <gonio/base/diagnostics.hpp>
#include <gonio/figures/road_plan.hpp>
#include <gonio/plot/grid_diagram.hpp>

#include "../json_text.hpp"
#include "request.hpp"

#include <string>

namespace gonio::cli {

std::string road_text(const RoadRequest& request, const RoadPlan& plan);

// Schema gonio.road/1.
Json road_json(const RoadRequest& request, const RoadPlan& plan, const Diagnostics& diagnostics);

// A rig of some hundred metres of the road with its luminaires. `file` is the name of the luminaire's profile as the
// rig's folder has it.
std::string road_rig(const RoadRequest& request, const RoadPlan& plan, const std::string& file);

// The plan of the field: luminance as the lane sees it that has the least, or illuminance.
GridPlot road_plot(const RoadRequest& request, const RoadPlan& plan, bool luminance);

} // namespace gonio::cli
