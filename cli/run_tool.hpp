// The tool as a function: finds the command, parses only its options, runs it and writes its output.
#pragma once

#include "console.hpp"

#include <span>

namespace gonio::cli {

// `words`: those after the tool's name. Returns the exit status. Throws nothing.
int run_tool(std::span<char* const> words, Console& console);

} // namespace gonio::cli
