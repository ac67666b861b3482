#include <gonio/media/texel_pixel.hpp>

namespace gonio::media {

TexelType texel_type(Pixel pixel) {
    switch (pixel) {
    case Pixel::uint8:
        return TexelType::uint8;
    case Pixel::uint16:
        return TexelType::uint16;
    case Pixel::half:
        return TexelType::half;
    case Pixel::float32:
        break;
    }
    return TexelType::float32;
}

Pixel pixel_of(TexelType type) {
    switch (type) {
    case TexelType::uint8:
        return Pixel::uint8;
    case TexelType::uint16:
        return Pixel::uint16;
    case TexelType::half:
        return Pixel::half;
    case TexelType::float32:
        break;
    }
    return Pixel::float32;
}

} // namespace gonio::media
