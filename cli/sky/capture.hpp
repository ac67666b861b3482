// `gonio sky capture`: a lit stage as it looks from one point, as an environment image.
#pragma once

#include <gonio/base/result.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../json_text.hpp"
#include "../options/emits_input.hpp"
#include "../options/rig_input.hpp"
#include "../options/sky_input.hpp"
#include "request.hpp"

#include <array>

namespace gonio::cli {

inline constexpr std::array sky_capture_options{
    rig_options[0],
    rig_options[1],
    Option{"--stage", "STAGE", "stage that is captured (that of the rig)", "stages"},
    Option{"--material", "[SURFACE=]MATERIAL", "material of a surface; without SURFACE, of what the stage shows",
           "materials", true},
    emits_option,
    sky_option,
    Option{"--at", "X,Y,Z", "the point in metres that the stage is seen from"},
    Option{"--bounces,--indirect", "N", "how often light bounces: a number, all (the default) or off"},
    Option{"--hide-lights", "", "leave the lights themselves out: for reflections beside their highlights"},
};

// Captures, writes the image and its sidecar as convert does, and returns the sidecar. Remarks go to `diagnostics`.
// Fails (usage) without --at and without a stage or light, and as capture() and convert_sky() do.
Result<Json> capture_sky(const SkyRequest& request, const Arguments& arguments, Diagnostics& diagnostics);

} // namespace gonio::cli
