// Environment images as the actions of `gonio sky` write them: their size, their format and the scale of their pixels.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/media/image_file.hpp>
#include <gonio/sky/environment_map.hpp>

#include "../arguments.hpp"
#include "request.hpp"

#include <string>

namespace gonio::cli {

// "1024" as the side of the layout (the width of a latlong), or "1024x512".
Result<EnvironmentGrid> environment_size(EnvironmentLayout layout, const std::string& size);

struct EnvironmentStorage {
    const media::ImageFormat* format;
    media::Pixel pixel;
};

// --to or the output's ending, and --pixel. Fails (usage) on formats that hold values for a display.
Result<EnvironmentStorage> environment_storage(const Arguments& arguments, const std::string& output);

// The sky's pixels on this grid, without the sun beside it.
EnvironmentMap environment_image(const LoadedSky& loaded, const EnvironmentGrid& grid, unsigned threads);

// cd/m² of a pixel of 1 in the file: 1, or for half floats the power of two that makes all pixels fit.
double nits_per_unit(const EnvironmentMap& map, media::Pixel pixel);

} // namespace gonio::cli
