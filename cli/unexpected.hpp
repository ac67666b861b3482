// What an exception means that reaches the tool: nothing in gonio throws across its interface, so it is memory that ran
// out, or an internal error.
#pragma once

#include <gonio/base/result.hpp>

#include <string>

namespace gonio::cli {

// Of the exception at hand: to be called in a catch block. `input`: the file that was being worked on, if it was one.
// Out of memory is unsupported (5) and not internal (70): the input is fine, and it is more than this machine, or the
// limit that was set on it, can work on.
Error unexpected_error(std::string input = {});

} // namespace gonio::cli
