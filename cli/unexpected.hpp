// The meaning of an exception that reaches the tool. Nothing in gonio throws across its interface, so the cause is lack
// of memory or an internal error.
#pragma once

#include <gonio/base/result.hpp>

#include <string>

namespace gonio::cli {

// For the current exception: call it in a catch block. `input`: the file that was being processed, if any. Out of
// memory is unsupported (5) and not internal (70): the input is valid, but needs more memory than this machine or its
// limits allow.
Error unexpected_error(std::string input = {});

} // namespace gonio::cli
