// What `gonio bake` is asked: a layout or an engine, a size or an error, how texels are stored, and what goes where.
#pragma once

#include <gonio/bake/bake.hpp>
#include <gonio/bake/engine.hpp>
#include <gonio/base/result.hpp>
#include <gonio/media/image_file.hpp>

#include "../arguments.hpp"
#include "../catalogue.hpp"
#include "../command.hpp"
#include "../options/profile_input.hpp"

#include <array>
#include <optional>
#include <string>

namespace gonio::cli {

inline constexpr std::array bake_options{
    Option{"--layout", "LAYOUT", "how directions are laid out (latlong)", "layouts"},
    Option{"--engine", "NAME", "layout, size, frame and sampling as that engine reads them", "engines"},
    Option{"-s,--size", "WxH", "texels across and down (latlong: 512x256; cube: of a face); auto: see --max-error"},
    Option{"--max-error", "LIMIT",
           "with -s auto: the smallest size that is nowhere further off; 5cd, or 1% of the peak"},
    Option{"--cone", "ANGLE", "gnomonic: full angle across the middle (90deg)"},
    Option{"--border", "N", "gnomonic: dark texels around (0)"},
    Option{"--normalize", "HOW", "what a texel of 1 means: none (candela), peak, mean, flux (none)", "normalizations"},
    Option{"--pixel", "KIND", "float, half, uint16, uint8: what a texel is stored as (float where the format has it)"},
    Option{"--sidecar", "FILE", "where the JSON that describes the texture goes (OUTPUT.json)"},
    Option{"--no-sidecar", "", "write no such file"},
    Option{"--stats", "", "say how many texels were evaluated and how long it took"},
    Option{"--no-skip", "", "evaluate every texel, mirror images and darkness too; the texels are the same"},
};

// --max-error: candela, or a share of each profile's peak.
struct ErrorLimit {
    double value = 0.0;
    bool of_peak = false;
};

struct BakeRequest {
    BakeOptions bake;
    const Engine* engine = nullptr;
    std::optional<ErrorLimit> max_error; // --size auto
    std::optional<media::Pixel> pixel;
    ProfileInputOptions input;
    std::optional<std::string> sidecar;
    bool no_sidecar = false;
    bool stats = false;
    bool update = false;
    Catalogue catalogue;
};

Result<BakeRequest> parse_bake(const Arguments& arguments);

} // namespace gonio::cli
