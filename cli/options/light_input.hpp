// One light from the command line: a profile, or a shape, with its amount, colour and position.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/scene/stage.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "smooth_step.hpp"

#include <array>
#include <string>
#include <vector>

namespace gonio::cli {

inline constexpr Option shape_option{"--shape", "SHAPE", "shape of the light, if no FILE is given", "shapes"};
inline constexpr Option preset_option{"--preset", "NAME", "an everyday source: its shape and amount, if not given",
                                      "presets"};

inline constexpr std::array light_options{
    shape_option,
    preset_option,
    Option{"--intensity", "VALUE", "amount of light: 800lm, 1200cd, 5000nt, 300lx@2m (profile: as measured)"},
    Option{"--color", "COLOR",
           "colour of the light: 2700K, 2700K/0.003, d65, LED-B3, spectrum:FILE, #ffd9a0, rgb(1,0.8,0.6); or auto, "
           "always, never for messages"},
    Option{"--position", "X,Y,Z",
           "position of the light's centre in metres (from the stage; probe: 0,0,0); repeat it for more such lights",
           "", true},
    Option{"--direction", "X,Y,Z", "direction of the light (from the stage; probe: 0,0,-1)"},
    Option{"--up", "X,Y,Z", "direction of C90 of a profile (from the stage; probe: 0,1,0)"},
    Option{"--rotate", "ANGLE", "rotate the light about its direction, C0 towards C90: 90deg"},
    smooth_option,
    Option{"--range", "LENGTH", "distance at which the light fades to zero (none)"},
};

inline constexpr OptionGroup light_group{"light", light_options};

// Whether the value of --color says when diagnostics are coloured, and is not a light's colour.
bool is_about_messages(std::string_view color);

// The light of the positional FILE, --shape or --preset, with amount, colour and rotation: at the origin, aimed down.
// Reads a profile only to smooth it; remarks about the colour go to `diagnostics`. Fails (usage) if there is none or
// more than one, and on option values that make no sense.
Result<LightDescription> light_itself(const Arguments& arguments, Diagnostics& diagnostics);

// The same, placed, once for each --position: "sphere", or "sphere-1", "sphere-2",
// …. Reads a profile only to smooth it; remarks about the colour go to `diagnostics`. Fails (usage) if there is neither
// or both, and on option values that make no sense.
Result<std::vector<LightDescription>> light_input(const Arguments& arguments, const LightPlacement& placement,
                                                  Diagnostics& diagnostics);

// The files that a light's shape names: its profile or its mask.
std::vector<std::string> files_of(const Shape& shape);

// The file of a colour spectrum:FILE; empty for any other colour.
std::vector<std::string> files_of_color(const std::string& color);

// The first given option of light_options, except a --color about messages: "--shape"; empty for none.
std::string_view given_light_option(const Arguments& arguments);

} // namespace gonio::cli
