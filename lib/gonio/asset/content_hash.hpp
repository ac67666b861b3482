// SHA-256 of bytes (FIPS 180-4), as 64 lower-case hexadecimal digits: identifies the content that an asset was made
// from.
#pragma once

#include <string>
#include <string_view>

namespace gonio {

std::string sha256(std::string_view bytes);

} // namespace gonio
