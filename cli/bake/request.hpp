// The request of `gonio bake`: a layout or an engine, a size or an error, how texels are stored, and the output files.
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
#include <vector>

namespace gonio::cli {

inline constexpr std::array bake_options{
    Option{"--layout", "LAYOUT", "layout of the directions (latlong)", "layouts"},
    Option{"--engine", "NAME,…",
           "use the layout, size, frame and sampling that an engine reads; several, or all: a folder for each in that "
           "of -O",
           "engines"},
    Option{"-s,--size", "WxH",
           "width and height in texels (latlong: 512x256; cube: of one face); auto: see --max-error"},
    Option{"--max-error", "LIMIT", "with -s auto: use the smallest size within this error: 5cd, or 1% of the peak"},
    Option{"--cone", "ANGLE", "gnomonic: full angle from edge to edge (90deg)"},
    Option{"--border", "N", "gnomonic: width of the dark border in texels (0)"},
    Option{"--normalize", "HOW", "meaning of a texel of 1: none (candela), peak, mean, flux (none)", "normalizations"},
    Option{"--pixel", "KIND",
           "pixel type: float, half, uint16, uint8; of a table also rgb9e5 (float if the format has it)"},
    Option{"--sidecar", "FILE", "write the JSON sidecar to this file (OUTPUT.json)"},
    Option{"--no-sidecar", "", "write no sidecar"},
    Option{"--stats", "", "print how many texels were evaluated, the time, and the modules opened"},
    Option{"--no-skip", "", "evaluate every texel, mirrored and dark ones too; the texture is the same"},
};

inline constexpr std::array bake_format_options{
    Option{"--to", "FORMAT", "format of the texture or table, if the file name does not show it", "bake-formats"},
};

// --max-error: in candela, or as a fraction of each profile's peak.
struct ErrorLimit {
    double value = 0.0;
    bool of_peak = false;
};

// Of one engine, or of none.
struct BakeRequest {
    BakeOptions bake;
    const Engine* engine = nullptr;
    std::string subfolder;               // of -O; empty: the folder itself
    std::optional<ErrorLimit> max_error; // for --size auto
    std::optional<media::Pixel> pixel;
    ProfileInputOptions input;
    std::optional<std::string> sidecar;
    bool no_sidecar = false;
    bool stats = false;
    bool update = false;
    Catalogue catalogue;
};

// A request for each engine, or one.
Result<std::vector<BakeRequest>> parse_bake(const Arguments& arguments);

} // namespace gonio::cli
