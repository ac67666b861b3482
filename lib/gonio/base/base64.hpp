// Bytes as text: base64 by RFC 4648, padded.
#pragma once

#include <string>
#include <string_view>

namespace gonio {

std::string base64(std::string_view bytes);

} // namespace gonio
