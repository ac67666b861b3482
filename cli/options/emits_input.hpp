// The surfaces that emit: those of a rig and of --emits.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/scene/rig.hpp>
#include <gonio/scene/stage.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "rig_input.hpp"

namespace gonio::cli {

inline constexpr Option emits_option{
    "--emits", "SURFACE=AMOUNT[,color=COLOR]",
    "let a surface of the stage emit light, beside what it reflects: sphere=500nt, box=800lm,color=3000K", "", true};

// Lets the surfaces of the stage emit what "emits" of the input's rig and then --emits say, and adds the lights of all
// surfaces that emit to the input's others, and the files that were read for them. Remarks about colours go to
// `diagnostics`. Fails (usage) on a surface that the stage does not have or that is given twice, and as
// parse_surface_emission() and let_emit() do.
Result<void> read_emits(const Arguments& arguments, Stage& stage, LightsInput& input, Diagnostics& diagnostics);

// Fails if nothing gives light: no light, no surface of the stage in use that emits, no sky. Call it after
// read_emits().
Result<void> require_any_light(const LightsInput& input, const Stage& stage, bool has_sky);

} // namespace gonio::cli
