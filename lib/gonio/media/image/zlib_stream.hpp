// Bytes compressed as a zlib stream (RFC 1950), as PNG and the ZIP of OpenEXR hold them. Private to media: by
// libdeflate in gonio-writers.so (zlib_stream.cpp), and by zlib in WebAssembly (zlib_stream_wasm.cpp). The streams of
// the two differ; what they hold does not.
#pragma once

#include <span>
#include <vector>

namespace gonio::media::detail {

// `level`: from 1, the fastest, to 9, the smallest; of either library. Throws std::runtime_error where it fails.
std::vector<unsigned char> zlib_stream(std::span<const unsigned char> bytes, int level);

} // namespace gonio::media::detail
