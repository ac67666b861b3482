// Checks that a PNG file is complete before libpng reads it: libpng prints errors to stderr, and jumps over
// OpenImageIO's destructors.
#pragma once

#include <string_view>

namespace gonio::media::detail {

// Every chunk is complete, its checksum is correct, and the last one is IEND. The content of the chunks is not checked.
bool is_whole_png(std::string_view bytes);

} // namespace gonio::media::detail
