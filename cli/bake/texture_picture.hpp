// A texture as the picture that a file holds.
#pragma once

#include <gonio/bake/texture.hpp>
#include <gonio/base/image.hpp>
#include <gonio/media/image_file.hpp>

namespace gonio::cli {

// What a texel is, and a file's pixel of the same numbers.
TexelType texel_type(media::Pixel pixel);
media::Pixel pixel_of(TexelType type);

// `width` columns from `x` on, each texel repeated in `channels`, encoded as the texture's transfer says.
Image texture_picture(const Texture& texture, int x, int width, int channels);

} // namespace gonio::cli
