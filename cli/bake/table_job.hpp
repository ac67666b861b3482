// `gonio bake --table`: a table that renderers look up, instead of a profile's texture.
#pragma once

#include <gonio/base/result.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"

#include <array>

namespace gonio::cli {

inline constexpr std::array table_options{
    Option{"--table", "NAME", "write a table for shaders instead of a profile's texture: dfg, kulla-conty, ltc-ggx, …",
           "tables"},
    Option{"--axes", "AXES",
           "linear: u = n.v, v = roughness; root: u by the square root of n.v; heitz: those of ltc-heitz (the first "
           "that 'gonio list tables' has)",
           "table-axes"},
    Option{"--form", "FORM",
           "bilinear: texels; chebyshev: the coefficients of a polynomial, with -s TERMSxTERMS (bilinear)",
           "table-forms"},
};

// Computes, measures and writes the table. Fails (usage) on what the table, the pixel type or the format cannot do, and
// on options that are for profiles.
Result<int> bake_table(const Command& command, const Arguments& arguments, Console& console);

} // namespace gonio::cli
