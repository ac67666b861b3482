// `gonio plot --diagram falloff`: which lights it shows, and over what distances.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/plot/falloff_diagram.hpp>

#include "../arguments.hpp"
#include "../command.hpp"

#include <array>
#include <vector>

namespace gonio::cli {

inline constexpr std::array falloff_options{
    Option{"--shape", "SHAPE", "a light of this shape, in addition to the profiles", "shapes", true},
    Option{"--intensity",
           "VALUE",
           "amount of light: 800lm, 1200cd, 5000nt; one for all shapes, or one for each",
           {},
           true},
    Option{"--range", "LENGTH", "distance at which the lights fade to zero (none)"},
    Option{"--distance", "FROM:TO", "range of the distance axis (0.1m:20m)"},
};

// Only falloff takes these options. Fails (usage) and names the first one given.
Result<void> no_falloff_options(const Arguments& arguments);

Result<FalloffOptions> read_falloff(const Arguments& arguments);

// The given profiles, then the shapes, resolved.
Result<std::vector<PlottedLight>> falloff_lights(const Arguments& arguments, Diagnostics& diagnostics);

} // namespace gonio::cli
