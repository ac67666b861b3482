// `gonio sky prefilter`: what engines need to light with a sky, as images, a table and a sidecar.
#pragma once

#include <gonio/base/result.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../json_text.hpp"
#include "environment_output.hpp"
#include "request.hpp"

#include <array>
#include <string>

namespace gonio::cli {

inline constexpr std::array sky_prefilter_options{
    Option{"--for", "PREFILTER", "prefilter: the program that looks it up (linear)", "prefilters"},
    Option{"--levels", "N", "prefilter: how many levels of roughness (as --for says)"},
    Option{"--irradiance", "N", "prefilter: side of the irradiance image (32)"},
    Option{"--table", "N", "prefilter: side of the split-sum table (128)"},
};

// Writes the levels, the irradiance, the table and the sidecar, all or none; returns the sidecar. Fails (usage) on a
// sky without light.
Result<Json> prefilter_sky(const SkySource& from, const LoadedSky& loaded, const SkyRequest& request,
                           const Arguments& arguments);

} // namespace gonio::cli
