// A stored table in words of programs: its lookup in shading languages, and the table with its lookup as a C header.
//
// The lookups compute what ShadingTable::lookup() and lobe_of() do, in float. They need nothing but the texture, with
// bilinear filtering and coordinates clamped to its edge; of a polynomial nothing at all.
#pragma once

#include <gonio/table/stored_table.hpp>

#include <cstdint>
#include <string>

namespace gonio {

enum class TableLanguage : std::uint8_t { glsl, hlsl, msl, wgsl, c };

// The function NAME_lookup(…, n_dot_v, roughness), with the structure that it returns. In C the data is a part of
// table_header(), which the function reads.
std::string table_lookup(const StoredTable& stored, TableLanguage language);

// A header for C99 and C++: the components as stored, and the lookup.
std::string table_header(const StoredTable& stored);

// Where texels are, in a sentence for each axis: "n.v = (column + 0.5)/16, from the left".
std::string columns_in_words(const ShadingTable& table);
std::string rows_in_words(const ShadingTable& table);

} // namespace gonio
