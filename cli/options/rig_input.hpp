// The lights of a command: those of a rig file, or of the command line.
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

// The files that a rig may name. `arguments` must be those of a command that has --allow-outside.
RigReadOptions rig_read_options(const Arguments& arguments);

struct LightsInput {
    std::string rig_file; // empty: the lights of options, alike but for their positions
    Rig rig;
    std::vector<LightDescription> others; // beside them: surfaces that emit, the sun of a sky
    std::vector<std::string> files;       // every file that was read for the lights
};

// Those of a rig file, with the files that were read for them. Fails as read_rig_file() does.
Result<LightsInput> rig_input(const std::string& rig_file, const Arguments& arguments);

// The lights of --rig, or the positional FILE or --shape at `placement` or at each --position. Reads the rig
// and its profiles, but not the profile of a single light. Fails (usage) if a rig and a light are both given, and as
// read_rig_file and light_input do.
Result<LightsInput> lights_input(const Arguments& arguments, const LightPlacement& placement, Diagnostics& diagnostics);

// The resolved lights, in order, and then the others; messages name the rig's JSON path if there is a rig.
Result<std::vector<Light>> resolve_input(LightsInput input, Diagnostics& diagnostics, unsigned threads);

} // namespace gonio::cli
