// A stored table as a DDS file: a texture, or an array of one for each layer.
#pragma once

#include <gonio/table/stored_table.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace gonio {

// The format of a texel in a DDS file: all layers have the same, with 1, 2 or 4 channels; missing ones are 0.
struct DdsFormat {
    std::string_view name; // "R16G16B16A16_FLOAT"
    std::uint32_t number;  // DXGI_FORMAT
    std::size_t channels;
};

// Of the table's layers.
DdsFormat dds_format(const StoredTable& stored);

// With the extended header (DX10) and no mip levels.
std::string dds_file(const StoredTable& stored);

} // namespace gonio
