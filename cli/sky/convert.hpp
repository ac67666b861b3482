// `gonio sky convert`: a sky as an image file with a sidecar.
#pragma once

#include <gonio/base/result.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../json_text.hpp"
#include "../options/output.hpp"
#include "environment_output.hpp"
#include "request.hpp"

#include <array>

namespace gonio::cli {

inline constexpr std::array sky_output_options{
    Option{"-o,--output", "FILE",
           "the image to write, .exr, .hdr or .tif, of prefilter what its files are named after; '-' is stdout (with "
           "--to)"},
    Option{"--to", "FORMAT", "format of the image, if the file name does not show it", "images"},
    Option{"--layout", "LAYOUT", "layout of the directions (that of the input, else latlong; prefilter: cube-strip)",
           "sky-layouts"},
    Option{"-s,--size", "N|WxH", "width of a latlong, side of a cube's face or of an octahedral; or the whole size"},
    Option{"--with-sun", "", "put the sun of daylight into the image; else it is a light in the sidecar"},
    Option{"--pixel", "KIND", "pixel type: float or half (float)"},
    Option{"--sidecar", "FILE", "write the JSON sidecar to this file (OUTPUT.json; prefilter: STEM.json)"},
    Option{"--no-sidecar", "", "write no sidecar"},
    durable_option,
};

// Writes the image and its sidecar, both or neither; returns the sidecar.
Result<Json> convert_sky(const SkySource& source, const LoadedSky& loaded, const SkyRequest& request,
                         const Arguments& arguments);

} // namespace gonio::cli
