// The lights of a command: those of a rig file, or one from the command line.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/scene/rig.hpp>
#include <gonio/scene/stage.hpp>

#include "../arguments.hpp"
#include "../command.hpp"

#include <glm/vec3.hpp>

#include <array>
#include <string>
#include <vector>

namespace gonio::cli {

inline constexpr std::array rig_options{
    Option{"--rig", "RIG", "lights from a rig file (JSON), '-' for stdin"},
    Option{"--allow-outside", "", "let the rig name pipes and files outside its folder"},
};

// What a rig may name. `arguments` must be of a command that has --allow-outside.
RigReadOptions rig_read_options(const Arguments& arguments);

struct LightsInput {
    std::string rig_file; // empty: one light by options
    Rig rig;
    std::vector<std::string> files; // that all this is read from
};

// Of --rig, or of the positional FILE or --shape, which then hangs at the placement. Reads the rig and its
// profiles, but not the profile of one light. Fails (usage) when a rig and a light are both given, and as
// read_rig_file and light_input do.
Result<LightsInput> lights_input(const Arguments& arguments, const LightPlacement& placement, Diagnostics& diagnostics);

// Resolved, in order; messages name the rig's JSON path where there is a rig.
Result<std::vector<Light>> resolve_input(LightsInput input, Diagnostics& diagnostics, unsigned threads);

} // namespace gonio::cli
