// The sky of a command: --sky, and its sun as a light.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/sky/sky.hpp>

#include "../arguments.hpp"
#include "../command.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gonio::cli {

inline constexpr Option sky_option{
    "--sky", "SKY",
    "light from all around: 500lx on an open plane, 150nt, cie:12,sun=180/40,horizontal=20klx, an image; see "
    "'gonio list skies'",
    "skies"};

struct SkyInput {
    Sky sky;
    std::optional<LightDescription> sun; // of daylight; named "sun"
    std::vector<std::string> files;      // that were read for it
};

// Without --sky: none. Remarks go to `diagnostics`. Fails as load_sky().
Result<SkyInput> sky_input(const Arguments& arguments, Diagnostics& diagnostics);

} // namespace gonio::cli
