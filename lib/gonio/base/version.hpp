// The version of gonio; CMake reads it from here.
#pragma once

#define GONIO_VERSION_STRING "0.1.0"

namespace gonio {

inline constexpr const char* version = GONIO_VERSION_STRING;

} // namespace gonio
