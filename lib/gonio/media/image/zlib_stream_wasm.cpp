#include <gonio/media/image/zlib_stream.hpp>

#include <stdexcept>
#include <zlib.h>

namespace gonio::media::detail {

std::vector<unsigned char> zlib_stream(std::span<const unsigned char> bytes, int level) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::vector<unsigned char> packed(size);
    if (compress2(packed.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), level) != Z_OK)
        throw std::runtime_error("zlib failed");
    packed.resize(size);
    return packed;
}

} // namespace gonio::media::detail
