// The one place where gonio's version stands; CMake reads it from here.
#pragma once

#define GONIO_VERSION_STRING "0.1.0"

namespace gonio {

inline constexpr const char* version = GONIO_VERSION_STRING;

} // namespace gonio
