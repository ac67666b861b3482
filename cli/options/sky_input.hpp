// The sky of a command: --sky or that of a rig, and its sun as a light.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/sky/sky.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../sky/request.hpp"
#include "rig_input.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gonio::cli {

inline constexpr Option sky_option{
    "--sky", "SKY",
    "light from all around: 500lx on an open plane, 150nt, cie:12,sun=180/40,horizontal=20klx, an image; see "
    "'gonio list skies'",
    "skies"};

// What a sky was made from, for sidecars.
struct SkySourceText {
    std::string text;   // as the user named it; of a rig the rig
    std::string sha256; // of the bytes of an image
};

struct SkyInput {
    Sky sky;
    bool is_given = false;               // though it may be dark
    std::optional<LightDescription> sun; // of daylight; named "sun"
    std::vector<std::string> files;      // that were read for it
    SkySourceText source;
};

// The sky of a rig. Remarks go to `diagnostics`. Fails as load_sky().
Result<SkyInput> sky_of_rig(const Rig& rig, const SkyRequest& request, Diagnostics& diagnostics);

// That of --sky, else of the rig, else none. Remarks go to `diagnostics`. Fails as load_sky().
Result<SkyInput> sky_input(const Arguments& arguments, const Rig& rig, Diagnostics& diagnostics);

struct LightsAndSky {
    LightsInput lights; // the sun of the sky is among its others; none at all if only a sky or --emits is given
    SkyInput sky;
};

// The lights of lights_input() under the sky of sky_input(); profiles have the size of --profile-size, else, where they
// leave it unsaid, `usual`. Fails as these do.
Result<LightsAndSky> lights_and_sky(const Arguments& arguments, const LightPlacement& placement, ProfileSize usual,
                                    Diagnostics& diagnostics);

} // namespace gonio::cli
