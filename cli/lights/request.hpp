// The options of `gonio lights`: how a scene is read.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/interchange/scene_format.hpp>

#include "../arguments.hpp"
#include "../command.hpp"

#include <array>
#include <optional>
#include <string>

namespace gonio::cli {

inline constexpr std::array scene_options{
    Option{"--from", "FORMAT", "the scene's format (recognised by its content)", "scene-formats"},
    Option{"--unit-scale", "UNIT", "length of the scene's unit: cm, in, 2.5cm (as the file says, else 1 m)"},
    Option{"--up", "AXIS", "the scene's upward axis, y or z (as the file or its format says)"},
    Option{"--variant", "NAME", "which variant of a GLDF, or mode of a GDTF (the first)"},
    Option{"--zoom", "ANGLE", "full beam angle of beams that zoom (GDTF; as they state)"},
    Option{"--time", "CODE", "when, of values that change, in the scene's time codes (USD)"},
    Option{"--lm-per-watt", "EFFICACY", "lumens per watt of formats that store watts, and for --fix: 180, khronos-177",
           "efficacies"},
    Option{"--allow-outside", "", "let the scene name files outside its folder"},
};

struct SceneRequest {
    std::string file; // "-" is stdin
    std::string bytes;
    const SceneFormat* format = nullptr; // nullptr: by its content
    SceneReadOptions options;
};

// Reads the scene's bytes; read_beside of the options reads files below the scene's folder. Fails (usage) without a
// scene and on values of the wrong form, (io) as read_file().
Result<SceneRequest> parse_scene(const Arguments& arguments);

} // namespace gonio::cli
