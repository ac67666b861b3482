// Whether a PNG file is whole, asked before libpng sees it: libpng prints what it finds wrong to stderr, and jumps over
// OpenImageIO's destructors.
#pragma once

#include <string_view>

namespace gonio::media::detail {

// Every chunk is there to its end, its checksum holds, and the last one is IEND. Says nothing of what the chunks hold.
bool is_whole_png(std::string_view bytes);

} // namespace gonio::media::detail
