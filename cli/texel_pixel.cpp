#include "texel_pixel.hpp"

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

} // namespace gonio::cli
