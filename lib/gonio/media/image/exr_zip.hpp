// OpenEXR's compression ZIP ("OpenEXR File Layout"). Private to media.
#pragma once

#include <span>
#include <vector>

namespace gonio::media::detail {

// The bytes of a chunk's pixels: first the even bytes and then the odd ones, each as its difference from the one before
// plus 128; all that as a zlib stream. As they are where that does not shrink them: readers take a chunk that is as
// long as its pixels for one that is not compressed.
std::vector<unsigned char> exr_zip(std::span<const unsigned char> pixels);

} // namespace gonio::media::detail
