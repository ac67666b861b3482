// The stage of `gonio preview`: by name or from a rig, with materials and a camera of one's own.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/scene/rig.hpp>
#include <gonio/scene/stage.hpp>

#include "../arguments.hpp"
#include "../command.hpp"

#include <array>
#include <string>

namespace gonio::cli {

inline constexpr std::array preview_stage_options{
    Option{"--stage", "STAGE", "stage that the lights are shown on (that of the rig, else floor)", "stages"},
    Option{"--material", "[SURFACE=]MATERIAL",
           "material of a surface; without SURFACE, of what the stage shows; repeatable", "materials"},
    Option{"--camera", "X,Y,Z", "position of the camera in metres (frames the stage)"},
    Option{"--target", "X,Y,Z", "point that the camera looks at (what the stage shows)"},
    Option{"--fov", "ANGLE", "full vertical field of view of the camera"},
    Option{"--figure", "", "add a 1.75 m figure for scale"},
    Option{"--ticks", "", "draw a thin dark line at every metre of floors and walls"},
};

// The full vertical angle. Fails (usage) on what is no angle between 0 and 180 degrees.
Result<void> read_field_of_view(const std::string& text, Camera& camera);

// The stage that --stage names, floor where it is not given. A light that is not placed hangs where this stage says.
Result<Stage> named_stage(const Arguments& arguments);

// That stage, or the rig's where --stage is not given, with the rig's camera and materials and then those of the
// options. What there is to say of materials goes to `diagnostics`. Fails (usage) on what the stage has not and as
// check_camera does.
Result<Stage> stage_input(const Arguments& arguments, const Rig& rig, const Stage& named, Diagnostics& diagnostics);

} // namespace gonio::cli
