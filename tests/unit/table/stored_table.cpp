#include <gonio/bake/texture.hpp>
#include <gonio/table/dds.hpp>
#include <gonio/table/stored_table.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace gonio {
namespace {

ShadingTable table_of(TableKind kind) {
    const TableAxes axes = kind == TableKind::ltc_heitz ? TableAxes::heitz : TableAxes::root;
    return make_shading_table(kind, TableForm::bilinear, axes, 7, 5, 1).value();
}

std::uint32_t number_at(const std::string& bytes, std::size_t at, int count) {
    std::uint32_t number = 0;
    for (int k = count; k-- > 0;)
        number = (number << 8U) | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(k)]);
    return number;
}

TEST(StoredTable, HalvesReadBackBitForBit) {
    for (std::uint32_t bits = 0; bits < 0x10000U; ++bits) {
        if ((bits & 0x7c00U) == 0x7c00U) continue; // no number
        EXPECT_EQ(half_bits(half_value(bits)), bits);
    }
    for (const double value : {0.0, 1e-9, 3e-8, 6.1e-5, 0.1, 1.0 / 3.0, 2047.5, 65503.0, 65519.9})
        EXPECT_EQ(half_value(half_bits(value)),
                  as_stored(TexelType::half, static_cast<double>(static_cast<float>(value))));
    EXPECT_EQ(half_value(half_bits(1e6)), HUGE_VAL);
    EXPECT_EQ(half_bits(-0.0), 0x8000U);
}

// How far a number of each type may be from what it stands for, as a share of the channel's (rgb9e5: texel's) greatest.
double step_of(TablePixel pixel) {
    switch (pixel) {
    case TablePixel::float32:
        return 0.0;
    case TablePixel::half:
        return 0x1p-12 + 1e-9;
    case TablePixel::rgb9e5:
        return 0x1p-10 * 1.001; // half a step of 9 bits, as a share of at least 2^8 steps
    case TablePixel::uint16:
        return 0.5 / 65535.0 * 2.01; // of a range of up to twice the greatest
    case TablePixel::uint8:
        return 0.5 / 255.0 * 2.01;
    }
    return 0.0;
}

TEST(StoredTable, RawBytesReadBack) {
    int held = 0;
    for (const TableInfo& info : table_infos())
        for (const TablePixelInfo& pixel : table_pixels()) {
            const ShadingTable table = table_of(info.kind);
            const Result<StoredTable> stored = store_table(table, pixel.pixel);
            const bool only_numbers = info.kind == TableKind::ltc_heitz; // engines take its texels as they are
            EXPECT_EQ(stored.has_value(),
                      (pixel.pixel != TablePixel::rgb9e5 || !info.is_lobe()) && (pixel.steps == 0.0 || !only_numbers))
                << info.name;
            if (!stored) continue;
            ++held;
            const std::string bytes = raw_bytes(*stored);
            const int each = pixel.bits / 8;
            std::vector<std::uint32_t> numbers;
            for (std::size_t at = 0; at < bytes.size(); at += static_cast<std::size_t>(each))
                numbers.push_back(number_at(bytes, at, each));
            EXPECT_EQ(numbers, stored->stored);
            EXPECT_EQ(read_back(table, pixel.pixel, stored->ranges, numbers).values, stored->table.values);
            EXPECT_LE(stored->rounding, 2.0 * step_of(pixel.pixel)) << info.name << ' ' << pixel.name;
            EXPECT_EQ(stored->rounding > 0.0, pixel.pixel != TablePixel::float32) << info.name << ' ' << pixel.name;
            EXPECT_EQ(store_table(stored->table, pixel.pixel).value().table.values, stored->table.values)
                << info.name << ' ' << pixel.name << ": storing twice changes nothing";
        }
    EXPECT_EQ(held, 20);
}

// The number of a lobe that is almost nothing on smooth surfaces: by its root a small one has a finer step.
TEST(StoredTable, IntegersOfLobesHoldTheRootOfRaised) {
    constexpr std::size_t raised = 1;
    const ShadingTable table =
        make_shading_table(TableKind::ltc_ggx, TableForm::bilinear, TableAxes::root, 9, 9).value();
    const StoredTable stored = store_table(table, TablePixel::uint8).value();
    EXPECT_TRUE(stored.table.has_roots);
    EXPECT_FALSE(store_table(table, TablePixel::half).value().table.has_roots);
    EXPECT_FALSE(store_table(table_of(TableKind::ltc_disney), TablePixel::uint8).value().table.has_roots);
    const double half_step = 0.5 / 255.0 * stored.ranges[raised].scale * 1.001;
    for (int row = 0; row < 9; ++row)
        for (int column = 0; column < 9; ++column) {
            const double mu = std::pow(column / 8.0, 2);
            const double value = table.lookup(mu, row / 8.0)[raised];
            const double found = stored.table.lookup(mu, row / 8.0)[raised];
            EXPECT_LE(std::fabs(std::sqrt(found) - std::sqrt(value)), half_step) << column << ' ' << row;
        }
}

// By the layout of the specification, with nothing of the writer.
TEST(StoredTable, DdsFilesHaveTheirTexels) {
    for (const TableInfo& info : table_infos())
        for (const TablePixelInfo& pixel : table_pixels()) {
            const Result<StoredTable> stored = store_table(table_of(info.kind), pixel.pixel);
            if (!stored) continue;
            const std::string bytes = dds_file(*stored);
            EXPECT_EQ(bytes.substr(0, 4), "DDS ");
            EXPECT_EQ(number_at(bytes, 4, 4), 124U);
            EXPECT_EQ(number_at(bytes, 12, 4), 5U); // height
            EXPECT_EQ(number_at(bytes, 16, 4), 7U);
            EXPECT_EQ(number_at(bytes, 76, 4), 32U);
            EXPECT_EQ(bytes.substr(84, 4), "DX10");
            EXPECT_EQ(number_at(bytes, 132, 4), 3U);
            const std::uint32_t layers = number_at(bytes, 140, 4);
            EXPECT_EQ(layers, info.is_lobe() ? 2U : 1U);
            const std::size_t channels = pixel.pixel == TablePixel::rgb9e5 ? 1 : (info.is_lobe() ? 4 : 2);
            const auto each = static_cast<std::size_t>(pixel.bits / 8);
            EXPECT_EQ(number_at(bytes, 20, 4), 7 * channels * each); // pitch
            ASSERT_EQ(bytes.size(), 148 + layers * 35 * channels * each);
            std::vector<std::uint32_t> numbers;
            for (std::size_t i = 0; i < layers * 35 * channels; ++i) {
                const std::uint32_t number = number_at(bytes, 148 + i * each, static_cast<int>(each));
                const std::size_t layer = i / (35 * channels);
                const bool is_padding = pixel.pixel != TablePixel::rgb9e5 && i % channels >= stored->layers[layer];
                if (is_padding) {
                    EXPECT_EQ(number, 0U);
                } else {
                    numbers.push_back(number);
                }
            }
            EXPECT_EQ(numbers, stored->stored) << info.name << ' ' << pixel.name;
        }
}

TEST(StoredTable, SharedExponentsHoldWhatTheirSpecificationSays) {
    ShadingTable table{TableKind::dfg,
                       TableAxes::root,
                       TableForm::bilinear,
                       2,
                       2,
                       {1.0F, 0.5F, 0.0F, 0.0F, 511.5F / 512.0F, 1e-6F, 0.1F, 1.0F / 3.0F}};
    const StoredTable stored = store_table(table, TablePixel::rgb9e5).value();
    EXPECT_EQ(stored.stored[0], (16U << 27U) | (128U << 9U) | 256U); // 2^(16 − 24) · 256 = 1
    EXPECT_EQ(stored.stored[1], 0U);
    EXPECT_EQ(stored.stored[2], (16U << 27U) | 256U); // 511.5 would round to 512: the next exponent
    EXPECT_NEAR(stored.table.values[6], 0.1, 1.0 / 3.0 / 512.0);
    EXPECT_NEAR(stored.table.values[7], 1.0 / 3.0, 1.0 / 3.0 / 1024.0 * 2.0);
    table.values[3] = -1e-3F;
    EXPECT_FALSE(store_table(table, TablePixel::rgb9e5)); // below 0
}

TEST(StoredTable, PolynomialsAreFloatsOrHalves) {
    const ShadingTable table =
        make_shading_table(TableKind::dfg, TableForm::chebyshev, TableAxes::root, 6, 6, 1).value();
    EXPECT_TRUE(store_table(table, TablePixel::float32));
    EXPECT_TRUE(store_table(table, TablePixel::half));
    for (const TablePixel pixel : {TablePixel::rgb9e5, TablePixel::uint16, TablePixel::uint8})
        EXPECT_FALSE(store_table(table, pixel));
}

} // namespace
} // namespace gonio
