#include <gonio/media/image/exr_zip.hpp>
#include <gonio/media/image/zlib_stream.hpp>

#include <cstddef>

namespace gonio::media::detail {

std::vector<unsigned char> exr_zip(std::span<const unsigned char> pixels) {
    const std::size_t size = pixels.size();
    const std::size_t evens = (size + 1) / 2;
    std::vector<unsigned char> parts(size);
    for (std::size_t i = 0; i < size / 2; ++i) {
        parts[i] = pixels[2 * i];
        parts[evens + i] = pixels[2 * i + 1];
    }
    if (evens > size / 2) parts[evens - 1] = pixels[size - 1];
    for (std::size_t i = size; i-- > 1;)
        parts[i] = static_cast<unsigned char>(parts[i] - parts[i - 1] + 128);
    constexpr int level = 1; // 6 makes pictures 0.2 % smaller and takes twice as long
    std::vector<unsigned char> packed = zlib_stream(parts, level);
    if (packed.size() >= size) packed.assign(pixels.begin(), pixels.end());
    return packed;
}

} // namespace gonio::media::detail
