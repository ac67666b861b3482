// The pixels of picture files as linear Rec.709.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/result.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/media/image_file.hpp>

#include <optional>
#include <string_view>

namespace gonio::media::detail {

// Of a picture, read without its pixels. Fails as picture_dimensions() does and, with the hint, (unsupported) on more
// values than the limit.
Result<PictureDimensions> dimensions_within(std::string_view bytes, const Limit& most, const char* hint);

// Three channels of the picture: R, G and B by their names, else Y or a single channel three times, else the first
// ones. Fails (unsupported) on other channels alone.
Result<Image> three_channels(const DecodedImage& file);

// Of three channels; colours outside Rec.709 are moved to its border at their luminance, with a remark.
void to_rec709(Image& image, const RgbSpace& from, Diagnostics& diagnostics);

// The space that an OpenEXR file states by its chromaticities, if it is not Rec.709. Fails (malformed) on points that
// span none.
Result<std::optional<RgbSpace>> stated_space(const DecodedImage& file);

// What the pixels of a Radiance picture were multiplied by: the product of the lines EXPOSURE= of its header, which
// ends at an empty line. Nothing without such a line. Fails (malformed) on values that are not numbers above 0.
Result<std::optional<double>> exposure_of(std::string_view bytes);

} // namespace gonio::media::detail
