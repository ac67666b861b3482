// The type of a texel, and the file pixel that stores the same numbers.
#pragma once

#include <gonio/bake/texture.hpp>
#include <gonio/media/image_file.hpp>

namespace gonio::media {

TexelType texel_type(Pixel pixel);
Pixel pixel_of(TexelType type);

} // namespace gonio::media
