// PNG files of 8 or 16 bits: chunks by libpng, rows filtered here and compressed as a zlib stream (zlib_stream.hpp).
// Private to media.
//
// libpng reports a failure by a function that must not return: it throws, and the frames of libpng are unwound as those
// of any other code.
#pragma once

#include <gonio/media/detail/image_abi.hpp>

#include <vector>

namespace gonio::media::detail {

// Throws std::runtime_error with the words of libpng, or where the stream cannot be made.
std::vector<unsigned char> png_bytes(const abi::EncodeRequest& request);

} // namespace gonio::media::detail
