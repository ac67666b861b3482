// The stage of `gonio preview`: by name or from a rig, with optional materials and an optional camera.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/scene/rig.hpp>
#include <gonio/scene/stage.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../options/emits_input.hpp"

#include <array>
#include <string>
#include <string_view>

namespace gonio::cli {

inline constexpr std::array preview_stage_options{
    Option{"--stage", "STAGE", "stage that the lights are shown on (that of the rig, else floor)", "stages"},
    Option{"--material", "[SURFACE=]MATERIAL", "material of a surface; without SURFACE, of what the stage shows",
           "materials", true},
    emits_option,
    Option{"--camera", "X,Y,Z", "position of the camera in metres (frames the stage)"},
    Option{"--target", "X,Y,Z", "point that the camera looks at (what the stage shows)"},
    Option{"--fov", "ANGLE", "full vertical field of view of the camera"},
    Option{"--figure", "", "add a 1.75 m figure for scale"},
    Option{"--ticks", "", "draw a thin dark line at every metre of floors and walls"},
};

// The full vertical angle. Fails (usage) unless it is an angle between 0 and 180 degrees.
Result<void> read_field_of_view(const std::string& text, Camera& camera);

// Whether a value of --material names the surface that it is for: "wall=lambert:albedo=0.7".
bool names_surface(std::string_view material);

// Those of the rig, then of --material. Remarks about materials go to `diagnostics`. Fails (usage) as give_material().
Result<void> give_materials(const Arguments& arguments, const Rig& rig, Stage& stage, Diagnostics& diagnostics);

// Gives the material to every surface of this name. Fails (usage) if the stage has none.
Result<void> give_material(Stage& stage, const SurfaceMaterial& named);

// The stage of --stage, by default floor. A light without a position is placed where this stage says.
Result<Stage> named_stage(const Arguments& arguments);

// The stage of --stage, or the rig's stage if --stage is not given, with the rig's camera and materials and then those
// of the options. Remarks about materials go to `diagnostics`. Fails (usage) on anything that the stage does not have
// and as check_camera does.
Result<Stage> stage_input(const Arguments& arguments, const Rig& rig, const Stage& named, Diagnostics& diagnostics);

} // namespace gonio::cli
