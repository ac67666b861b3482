// The words after a command's name, told apart: by CLI11 in read_words.cpp, and in WebAssembly, where it would be a
// tenth of the page, in wasm/read_words.cpp, by the same rules.
#pragma once

#include <gonio/base/result.hpp>

#include "command.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::cli {

struct ReadWords {
    struct Given {
        bool present = false;
        std::vector<std::string> values;
    };
    std::vector<Given> options; // in the order of the command's
    std::vector<std::string> positional;
};

// `options`: those of the command.
Result<ReadWords> read_words(const Command& command, std::span<const Option* const> options,
                             std::span<char* const> words);

// What both refuse. `word` as it was given, with its "=VALUE".
Unexpected unknown_option(const Command& command, std::span<const Option* const> options, std::string_view word);
Unexpected needs_value(const Command& command, std::string_view option);
Unexpected takes_no_value(const Command& command, std::string_view option);
std::string see_help(const Command& command);

} // namespace gonio::cli
