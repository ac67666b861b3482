// Environment images as files: OpenEXR and Radiance HDR, and 32-bit float TIFF.
//
// What is read becomes linear Rec.709; what is written is linear Rec.709 too, with the factor to cd/m² and the layout
// beside the pixels (OpenEXR: attributes gonio:nits_per_unit and gonio:layout; a file that has the first is
// calibrated). What the lines EXPOSURE= of a Radiance picture multiplied its pixels by is divided out. Needs the
// modules as image_file.hpp and color_space.hpp do.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/media/image_file.hpp>
#include <gonio/sky/environment_map.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio::media {

// How an environment is read.
struct EnvironmentReadOptions {
    std::optional<EnvironmentLayout> layout; // nothing: by the ratio of the sides
    std::string space;  // of the pixels: built in or of the configuration; empty: as the chromaticities of
                        // an OpenEXR file state it, else linear Rec.709
    std::string config; // OpenColorIO configuration; empty: the built-in one
    BadPixels bad_pixels = BadPixels::error;
};

// An environment as read from a file.
struct EnvironmentImage {
    EnvironmentMap map;
    PictureDimensions dimensions;
    Pixel pixel = Pixel::float32; // as stored
};

// Remarks are appended to `diagnostics`: those of EnvironmentMap::create, and on colours outside Rec.709, which are
// moved into it at the same luminance. Fails (malformed) on incomplete files, on sizes that the layout does not have
// and on bad pixels; (unsupported) on integer pixels, which hold display values, and, before the pixels are read, on
// more values than the limit environment-values; (usage) on an unknown colour space.
Result<EnvironmentImage> decode_environment(std::string_view bytes, const EnvironmentReadOptions& options,
                                            Diagnostics& diagnostics);

// The image with a pixel of 1 at `nits_per_unit` cd/m², rounded to what a file of the format holds: its light is then
// that of the file. Radiance HDR has eight bits for a channel and one exponent for three.
EnvironmentMap as_stored(const EnvironmentMap& map, double nits_per_unit, const ImageFormat& format, Pixel pixel);

// As a file of the format. Attributes are added to those above; `threads` as in ImageWriteOptions. Fails as
// encode_image does.
Result<std::string> encode_environment(const EnvironmentMap& map, const ImageFormat& format, Pixel pixel,
                                       std::vector<ImageAttribute> attributes, unsigned threads = 1);

} // namespace gonio::media
#pragma GCC visibility pop
