#include <gonio/ibl/split_sum_table.hpp>
#include <gonio/shading/ltc_lobe.hpp>
#include <gonio/table/shading_table.hpp>
#include <gonio/table/table_error.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace gonio {
namespace {

ShadingTable made(TableKind kind, TableForm form, TableAxes axes, int width, int height, unsigned threads = 1) {
    return make_shading_table(kind, form, axes, width, height, threads).value();
}

// The split sum's own table has the same axes, and the exact values at the middles of texels: lookups elsewhere are
// farther off.
TEST(ShadingTable, OnLinearAxesIsNearerThanExactTexels) {
    const ShadingTable table = made(TableKind::dfg, TableForm::bilinear, TableAxes::linear, 8, 8);
    const SplitSumTable exact = SplitSumTable::create(8).value();
    double of_fit = 0.0;
    double of_exact = 0.0;
    constexpr int count = 40;
    // Between the outermost middles; beyond them both are held.
    const auto inside = [](int k) { return 0.0625 + 0.875 * (k + 0.5) / count; };
    for (int j = 0; j < count; ++j)
        for (int i = 0; i < count; ++i) {
            const SplitSum sum = split_sum(inside(i), inside(j));
            const TableValues found = table.lookup(inside(i), inside(j));
            const SplitSum other = exact.lookup(inside(i), inside(j));
            of_fit += std::pow(found[0] - sum.scale, 2) + std::pow(found[1] - sum.bias, 2);
            of_exact += std::pow(other.scale - sum.scale, 2) + std::pow(other.bias - sum.bias, 2);
        }
    EXPECT_LT(std::sqrt(of_fit), 0.65 * std::sqrt(of_exact));
}

// Shares of light, although a fit swings over where a function has a bend.
TEST(ShadingTable, OfSharesStaysWithinThem) {
    for (const TableKind kind : {TableKind::dfg, TableKind::kulla_conty})
        for (const TableAxes axes : {TableAxes::linear, TableAxes::root})
            for (const float value : made(kind, TableForm::bilinear, axes, 12, 12).values) {
                EXPECT_GE(value, 0.0F);
                EXPECT_LE(value, 1.0F);
            }
}

TEST(ShadingTable, OfLobesHoldsItsValuesAtTexels) {
    for (const TableInfo& info : table_infos()) {
        if (!info.is_lobe()) continue;
        const ShadingTable table = made(info.kind, TableForm::bilinear, TableAxes::root, 5, 4);
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 5; ++column) {
                const double mu = std::pow(column / 4.0, 2);
                const TableValues values = table_values(info.kind, mu, row / 3.0);
                const TableValues found = table.lookup(mu, row / 3.0);
                for (std::size_t c = 0; c < most_table_channels; ++c)
                    EXPECT_NEAR(found[c], values[c], 2e-7 * (1.0 + std::fabs(values[c]))) << info.name;
            }
    }
}

// With as many columns and rows as were fitted, the entries themselves.
TEST(ShadingTable, OfLobesHasTheFittedMatrices) {
    constexpr int size = static_cast<int>(shading::ltc_ggx_size);
    const ShadingTable table = made(TableKind::ltc_ggx, TableForm::bilinear, TableAxes::root, size, size);
    for (const double mu : {0.01, 0.3, 0.8, 1.0})
        for (const double roughness : {0.03, 0.35, 0.7, 1.0}) {
            const TransformedCosine lobe = lobe_of(TableKind::ltc_ggx, table.lookup(mu, roughness), mu, roughness);
            const shading::LtcLobe<double> core = shading::ltc_ggx(roughness * roughness, mu);
            EXPECT_NEAR(lobe.m00, core.m00, 1e-6);
            EXPECT_NEAR(lobe.m02, core.m02, 1e-6);
            EXPECT_NEAR(lobe.m11, core.m11, 1e-6);
            EXPECT_NEAR(lobe.m20, core.m20, 1e-6);
            EXPECT_NEAR(lobe.m22, core.m22, 1e-12);
            // The core's albedos are from the fit's own lattice.
            EXPECT_NEAR(lobe.scale * core.horizon_z, core.albedo, 2e-4);
        }
}

TEST(ShadingTable, IsTheSameForAnyNumberOfThreads) {
    for (const TableInfo& info : table_infos())
        EXPECT_EQ(made(info.kind, TableForm::bilinear, TableAxes::root, 9, 7, 1).values,
                  made(info.kind, TableForm::bilinear, TableAxes::root, 9, 7, 4).values);
}

// A polynomial of as many terms as nodes goes through its nodes.
TEST(ShadingTable, AsAPolynomialGoesThroughItsNodes) {
    for (const TableKind kind : {TableKind::dfg, TableKind::kulla_conty, TableKind::ltc_disney}) {
        const ShadingTable table = made(kind, TableForm::chebyshev, TableAxes::root, 6, 5);
        for (int row = 0; row < 5; ++row)
            for (int column = 0; column < 6; ++column) {
                const auto node = [](int k, int count) {
                    return 0.5 - 0.5 * std::cos(std::acos(-1.0) * (k + 0.5) / count);
                };
                const double mu = std::pow(node(column, 6), 2);
                const TableValues values = table_values(kind, mu, node(row, 5));
                const TableValues found = table.lookup(mu, node(row, 5));
                for (std::size_t c = 0; c < table.channels(); ++c)
                    EXPECT_NEAR(found[c], values[c], 3e-6) << info_of(kind).name << ' ' << column << ' ' << row;
            }
    }
}

TEST(ShadingTable, RefusesWhatThereIsNot) {
    for (const int size : {-1, 0, 1, 257})
        EXPECT_FALSE(make_shading_table(TableKind::dfg, TableForm::bilinear, TableAxes::linear, size, 8));
    EXPECT_FALSE(make_shading_table(TableKind::dfg, TableForm::bilinear, TableAxes::linear, 8, 1));
    EXPECT_FALSE(make_shading_table(TableKind::ltc_ggx, TableForm::bilinear, TableAxes::linear, 8, 8));
    EXPECT_FALSE(make_shading_table(TableKind::ltc_ggx, TableForm::chebyshev, TableAxes::root, 8, 8));
    EXPECT_FALSE(make_shading_table(TableKind::dfg, TableForm::chebyshev, TableAxes::linear, 8, 8));
}

} // namespace
} // namespace gonio
