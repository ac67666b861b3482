// File formats of `gonio bake --table`, and what each of them holds.
#pragma once

#include <array>
#include <string_view>

namespace gonio::cli {

struct TableFormat {
    std::string_view name; // of --to
    std::string_view title;
    std::array<std::string_view, 2> extensions; // lower case, without the dot
    bool holds_integers;                        // and rgb9e5
    bool holds_polynomials;
    bool has_values; // the sidecar is the file itself
};

inline constexpr std::array table_formats{
    TableFormat{"exr", "OpenEXR, a channel for each number", {"exr", {}}, false, false, false},
    TableFormat{"dds", "DDS, a texture array", {"dds", {}}, true, false, false},
    TableFormat{"raw", "the numbers alone", {"raw", "bin"}, true, true, false},
    TableFormat{"header", "a C header with the lookup", {"h", "hpp"}, true, true, false},
    TableFormat{"json", "the numbers and what they mean", {"json", {}}, true, true, true},
};

} // namespace gonio::cli
