#include "asset_bytes.hpp"

#include <gonio/media/image_file.hpp>

#include "texel_pixel.hpp"

namespace gonio::cli {

Result<std::string> bytes_of(const AssetFile& file) {
    if (!file.picture) return file.bytes;
    media::ImageWriteOptions options;
    options.pixel = pixel_of(file.picture->texel_type);
    if (file.picture->image.channels == 1) options.channel_names = {"Y"};
    return media::encode_image(file.picture->image, *media::find_image_format(file.name), options);
}

} // namespace gonio::cli
