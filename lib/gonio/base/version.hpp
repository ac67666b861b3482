// The version of gonio; CMake reads it from here.
//
// Before 1.0 a minor version may change the interface, a patch may not: programs that compile against 0.2.x keep
// compiling without change. The shared library has the minor version in its SONAME, so a program that was linked with
// 0.2.x does not load 0.3; within a minor version its binary interface stays the same.
#pragma once

// The version as numbers and as text.
#define GONIO_VERSION_MAJOR 0
#define GONIO_VERSION_MINOR 2
#define GONIO_VERSION_PATCH 0
#define GONIO_VERSION_STRING "0.2.0"
#define GONIO_VERSION_DATE "2026-11-25" // of the release; manual pages and packages have it

// One number that grows with the version: #if GONIO_VERSION >= GONIO_VERSION_NUMBER(0, 2, 0).
#define GONIO_VERSION_NUMBER(major, minor, patch) ((major)*1000000 + (minor)*1000 + (patch))
#define GONIO_VERSION GONIO_VERSION_NUMBER(GONIO_VERSION_MAJOR, GONIO_VERSION_MINOR, GONIO_VERSION_PATCH)

#pragma GCC visibility push(default)
namespace gonio {

// The version and its date, as text.
inline constexpr const char* version = GONIO_VERSION_STRING;
inline constexpr const char* version_date = GONIO_VERSION_DATE;

} // namespace gonio
#pragma GCC visibility pop
