// OpenEXR files of scan lines by OpenEXR's library in C, which needs nothing but zlib. Private to media.
#pragma once

#include <gonio/media/detail/image_abi.hpp>

#include <vector>

namespace gonio::media::detail {

// The compression is ZIP, or none, rle, zips or piz. Throws std::runtime_error with the words of the library and for
// other compressions, and std::bad_alloc.
std::vector<unsigned char> exr_core_bytes(const abi::EncodeRequest& request);

} // namespace gonio::media::detail
