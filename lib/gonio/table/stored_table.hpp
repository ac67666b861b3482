// A table as it is stored: the components of its texels, and the numbers that a lookup of them gives.
//
// Up to four channels make a layer: a texture of R, RG, RGB or RGBA texels. A table with more channels has several
// layers, one after another. Bytes are little-endian, rows from the top, without padding.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/table/shading_table.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {

enum class TablePixel : std::uint8_t {
    float32,
    half,
    rgb9e5, // three channels of 9 bits that share an exponent of 5 bits, in 32 bits; not below 0
    uint16, // 0 … 65535 over the range of each channel
    uint8   // 0 … 255 over the range of each channel
};

struct TablePixelInfo {
    std::string_view name; // "rgb9e5"
    TablePixel pixel;
    int bits;     // of a component; rgb9e5: of a texel
    double steps; // of integers: the stored number of 1; else 0
};

// All of them, and the one of a type.
std::span<const TablePixelInfo> table_pixels();
const TablePixelInfo& info_of(TablePixel pixel);

// Integers mean offset + scale · n/steps; other types are the numbers themselves (0 and 1).
struct ChannelRange {
    double offset = 0.0;
    double scale = 1.0;
};

struct StoredTable {
    ShadingTable table; // as read back; of integers with square roots where a channel has them
    TablePixel pixel = TablePixel::float32;
    std::vector<ChannelRange> ranges;  // of each channel
    std::vector<std::size_t> layers;   // their numbers of channels
    std::vector<std::uint32_t> stored; // components, or texels of rgb9e5, in the order of the bytes
    double rounding = 0.0; // greatest |as read back − number|, as a share of the channel's greatest number
};

// Rounds to nearest. Fails (unsupported) where the type cannot hold the table, and says which can.
Result<StoredTable> store_table(ShadingTable table, TablePixel pixel);

// The bytes of a file without a header.
std::string raw_bytes(const StoredTable& stored);

// The table of such components: what store_table() keeps as `table`. The sizes must fit.
ShadingTable read_back(const ShadingTable& shape, TablePixel pixel, std::span<const ChannelRange> ranges,
                       std::span<const std::uint32_t> stored);

// The lowest `count` bytes of a number, the least significant one first.
void append_bytes(std::string& bytes, std::uint32_t number, int count);

// A half by its bits, and the bits of the nearest one; ±infinity beyond 65504, NaN of NaN.
double half_value(std::uint32_t bits);
std::uint32_t half_bits(double value);

} // namespace gonio
