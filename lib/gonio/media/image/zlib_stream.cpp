#include <gonio/media/image/zlib_stream.hpp>

#include <libdeflate.h>
#include <memory>
#include <new>
#include <stdexcept>

namespace gonio::media::detail {

std::vector<unsigned char> zlib_stream(std::span<const unsigned char> bytes, int level) {
    const auto release = [](libdeflate_compressor* each) { libdeflate_free_compressor(each); };
    const std::unique_ptr<libdeflate_compressor, decltype(release)> compressor(libdeflate_alloc_compressor(level));
    if (compressor == nullptr) throw std::bad_alloc();
    std::vector<unsigned char> packed(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()));
    packed.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), packed.data(), packed.size()));
    if (packed.empty()) throw std::runtime_error("libdeflate failed");
    return packed;
}

} // namespace gonio::media::detail
