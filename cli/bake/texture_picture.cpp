#include "texture_picture.hpp"

#include <algorithm>

namespace gonio::cli {

TexelType texel_type(media::Pixel pixel) {
    switch (pixel) {
    case media::Pixel::uint8:
        return TexelType::uint8;
    case media::Pixel::uint16:
        return TexelType::uint16;
    case media::Pixel::half:
        return TexelType::half;
    case media::Pixel::float32:
        break;
    }
    return TexelType::float32;
}

media::Pixel pixel_of(TexelType type) {
    switch (type) {
    case TexelType::uint8:
        return media::Pixel::uint8;
    case TexelType::uint16:
        return media::Pixel::uint16;
    case TexelType::half:
        return media::Pixel::half;
    case TexelType::float32:
        break;
    }
    return media::Pixel::float32;
}

Image texture_picture(const Texture& texture, int x, int width, int channels) {
    Image image(width, texture.image.height, channels);
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < width; ++column) {
            const float value = *texture.image.at(x + column, row);
            const float stored = texture.transfer == Transfer::linear
                                     ? value
                                     : static_cast<float>(encoded(texture.transfer, static_cast<double>(value)));
            std::fill_n(image.at(column, row), channels, stored);
        }
    return image;
}

} // namespace gonio::cli
