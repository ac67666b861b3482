// The request of `gonio preview`: lights on a stage, seen by a camera, as a picture.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/media/display.hpp>
#include <gonio/media/image_file.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/scene/stage.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../options/output.hpp"
#include "../options/profile_size.hpp"
#include "../options/rig_input.hpp"
#include "../options/sky_input.hpp"
#include "look_options.hpp"
#include "picture_method.hpp"
#include "refine.hpp"
#include "stage_input.hpp"

#include <array>
#include <string>
#include <vector>

namespace gonio::cli {

inline constexpr std::array preview_profile_options{profile_size_option};
inline constexpr std::array preview_picture_options{
    Option{"-s,--size", "WxH", "width and height in pixels (512x512)"},
    Option{"--shadows", "KIND",
           "off, hard (from the centre of each light) or soft (from its size and shape; the default)"},
    sky_option,
    Option{"--show-sky", "", "show the sky where the camera sees nothing else"},
    Option{"--no-shadows", "", "let light pass through objects on the stage: the same as --shadows off"},
    Option{"--display", "NAME", "display of the OpenColorIO configuration"},
    Option{"--view", "NAME", "view of that display; built in: Standard, Filmic, ACES, Raw"},
    Option{"--ocio", "FILE", "OpenColorIO configuration ($OCIO, else built in)"},
    Option{"--simd", "SET", "instruction set (the widest available)", "simd"},
    Option{"-j,--jobs", "N", "number of threads (all processors)"},
};

inline constexpr std::array preview_method_options{
    Option{"--method", "METHOD", "method for the light of each shape, or of the sky and for reflections (exact)",
           "picture-methods"},
    Option{"--compare", "M1,M2",
           "show methods side by side, with their differences from the first in numbers and colours",
           "picture-methods"},
    Option{"--probe-at", "X,Y,Z",
           "where the methods parallax-box and parallax-sphere take their picture of the stage (halfway between the "
           "camera and what it looks at)"},
    Option{
        "--error", "E",
        "relative tolerance of the method reference (1% for a picture; with --compare, --sweep and --aov 1e-6 for "
        "each value); with the method exact, off unless given: far luminaires are points at their centres, as long as "
        "the direct light of each pixel stays within E, for example 0.1%"},
    Option{"--time", "T", "time limit of the method reference for one picture, for example 30s; Ctrl-C stops it"},
    Option{"--bounces,--indirect", "N",
           "how often light bounces between the surfaces of the stage: a number, all (the default) or off; also in "
           "exported scenes"},
    Option{"--stats", "", "print what was skipped because no light reaches it, the time, and the modules opened"},
    Option{"--no-skip", "", "evaluate every light at every point; the picture is the same"},
};

inline constexpr std::array preview_output_options{
    Option{"-o,--output", "FILE",
           "the picture: .png and other integer formats through the display transform, .exr as linear Rec.709 in cd/m2 "
           "or as the values of another display mode; '-' is stdout (with --to)"},
    Option{"--to", "FORMAT", "picture format, if the file name does not show it", "images"},
    Option{"-n,--dry-run", "", "check everything, render nothing"},
    durable_option,
};

// Options that make more than one picture.
inline constexpr std::array several_pictures{std::string_view("--aov"), std::string_view("--sweep"),
                                             std::string_view("--sheet"), std::string_view("--compare")};

struct PreviewRequest {
    LightsInput lights;
    Stage stage;
    RenderOptions render;
    SkySourceText sky_source;
    ReferenceBudget budget; // of the method reference
    LookRequest look;
    ExposureRequest exposure;
    media::DisplayOptions display;
    std::vector<PictureMethod> compared; // of --compare, with the baseline first; else empty
    std::optional<glm::dvec3> probe_at;  // of --probe-at
    std::string output;                  // empty: no picture, only an exported scene
    std::string export_file;             // empty: none
    bool bounces_given = false;          // by an option, not by default
    const media::ImageFormat* format = nullptr;
    Diagnostics diagnostics;
};

// Everything except the lights: a picture on a stage.
Result<PreviewRequest> parse_without_lights(const Arguments& arguments);

// Checks everything except the files first: a mistake is reported before a large rig is read.
Result<PreviewRequest> parse_preview(const Arguments& arguments);

} // namespace gonio::cli
