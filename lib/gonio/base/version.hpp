// The version of gonio; CMake reads it from here.
//
// Before 1.0 a minor version may change the interface, a patch may not: programs that compile against 0.1.x keep
// compiling without change. The library is static and its headers are its interface: there is no promise about the
// binary interface, and a program is compiled against the headers that it is linked with.
#pragma once

#define GONIO_VERSION_MAJOR 0
#define GONIO_VERSION_MINOR 1
#define GONIO_VERSION_PATCH 0
#define GONIO_VERSION_STRING "0.1.0"

// One number that grows with the version: #if GONIO_VERSION >= GONIO_VERSION_NUMBER(0, 2, 0).
#define GONIO_VERSION_NUMBER(major, minor, patch) ((major)*1000000 + (minor)*1000 + (patch))
#define GONIO_VERSION GONIO_VERSION_NUMBER(GONIO_VERSION_MAJOR, GONIO_VERSION_MINOR, GONIO_VERSION_PATCH)

namespace gonio {

inline constexpr const char* version = GONIO_VERSION_STRING;

} // namespace gonio
