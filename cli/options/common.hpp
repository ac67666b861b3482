// Options of every command, and options of every command that reports or works on several threads.
#pragma once

#include "../command.hpp"

#include <array>

namespace gonio::cli {

inline constexpr std::array common_options{
    Option{"-q,--quiet", "", "print no warnings, notes or progress"},
    Option{"-v,--verbose", "", "print the steps and how long they take"},
    Option{"--color", "WHEN", "colour diagnostics: auto, always, never"},
    Option{"-h,--help", "", "show this help"},
};

inline constexpr OptionGroup common_group{"common options", common_options};

// For commands that use --color for a light's colour.
inline constexpr std::array light_common_options{
    Option{"-q,--quiet", "", "print no warnings, notes or progress"},
    Option{"-v,--verbose", "", "print the steps and how long they take"},
    Option{"-h,--help", "", "show this help"},
};

inline constexpr OptionGroup light_common_group{"common options", light_common_options};

inline constexpr std::array json_options{
    Option{"--json", "", "one JSON object; an array for several inputs"},
    Option{"--jsonl", "", "one JSON object a line"},
};

inline constexpr OptionGroup json_group{"report", json_options};

inline constexpr std::array threads_options{
    Option{"-j,--jobs", "N", "number of threads (all processors)"},
};

inline constexpr OptionGroup threads_group{"speed", threads_options};

} // namespace gonio::cli
