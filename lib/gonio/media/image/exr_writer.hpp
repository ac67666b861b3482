// OpenEXR files of scan lines, half or float, compressed by ZIP or not at all: what WebAssembly writes without
// OpenEXR's library, by the format's own description ("OpenEXR File Layout"). Private to media.
#pragma once

#include <gonio/media/detail/image_abi.hpp>

#include <vector>

namespace gonio::media::detail {

// Throws std::runtime_error for another compression than none and zip, and where zlib fails.
std::vector<unsigned char> exr_bytes(const abi::EncodeRequest& request);

} // namespace gonio::media::detail
