// Environment images as the actions of `gonio sky` write them: their size, their format and the scale of their pixels.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/media/asset_bytes.hpp>
#include <gonio/media/image_file.hpp>
#include <gonio/sky/environment_map.hpp>

#include "../arguments.hpp"
#include "request.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gonio::cli {

// "1024" as the side of the layout (the width of a latlong), or "1024x512".
Result<EnvironmentGrid> environment_size(EnvironmentLayout layout, const std::string& size);

// A grid whose side an option gives, "--irradiance 33", which a refusal names. Fails (usage) as environment_grid().
Result<EnvironmentGrid> environment_of_side(EnvironmentLayout layout, int side, const std::string& option);

using media::environment_files;
using media::EnvironmentFiles;
using media::EnvironmentStorage;

// --to or the output's ending, and --pixel. Fails (usage) on formats that hold values for a display.
Result<EnvironmentStorage> environment_storage(const Arguments& arguments, const std::string& output);

// What files are made from.
struct SkySource {
    std::string text;               // as the user named it
    std::vector<std::string> files; // that were read, which no output may replace
};

// That of --layout, else `otherwise`. Fails (usage) on an unknown name.
Result<EnvironmentLayout> output_layout(const Arguments& arguments, EnvironmentLayout otherwise);

// The file of --sidecar, else `usual`; nothing with --no-sidecar or if `usual` is empty. Fails (usage) on both options.
Result<std::optional<std::string>> sidecar_file(const Arguments& arguments, const std::string& usual);

// Whether --with-sun puts the sun beside the sky into its pixels. Fails (usage) if there is none.
Result<bool> with_sun_in_pixels(const Arguments& arguments, const LoadedSky& loaded, const SkyRequest& request);

// cd/m² of a pixel of 1 in the file: 1, or for half floats the power of two that makes all pixels fit.
double nits_per_unit(const EnvironmentMap& map, media::Pixel pixel);

} // namespace gonio::cli
