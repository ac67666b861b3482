#include <gonio/ibl/split_sum.hpp>
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
        const ShadingTable table = made(info.kind, TableForm::bilinear, info.axes.front(), 5, 4);
        const bool heitz = info.axes.front() == TableAxes::heitz;
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 5; ++column) {
                const double mu = heitz ? 1.0 - std::pow(row / 3.0, 2) : std::pow(column / 4.0, 2);
                const double roughness = heitz ? column / 4.0 : row / 3.0;
                const TableValues values = table_values(info.kind, mu, roughness);
                const TableValues found = table.lookup(mu, roughness);
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

// The same lobe in the frame of E. Heitz and others, whose x is towards the eye, divided by the middle number.
TEST(ShadingTable, OfHeitzHasTheSameLobes) {
    for (const double mu : {0.01, 0.3, 0.8, 1.0})
        for (const double roughness : {0.03, 0.35, 0.7, 1.0}) {
            const TransformedCosine ours =
                lobe_of(TableKind::ltc_ggx, table_values(TableKind::ltc_ggx, mu, roughness), mu, roughness);
            const TableValues values = table_values(TableKind::ltc_heitz, mu, roughness);
            EXPECT_NEAR(values[0] * ours.m11, ours.m00, 1e-14);
            EXPECT_NEAR(values[1] * ours.m11, -ours.m20, 1e-14);
            EXPECT_NEAR(values[2] * ours.m11, -ours.m02, 1e-14);
            EXPECT_NEAR(values[3] * ours.m11, ours.m22, 1e-14);
            const SplitSum sum = split_sum(mu, roughness);
            EXPECT_DOUBLE_EQ(values[4], sum.albedo());
            EXPECT_DOUBLE_EQ(values[5], sum.bias);
            EXPECT_EQ(values[6], 0.0);
        }
    // The normal is along the mirrored direction there, and the lobe is round.
    const TableValues down = table_values(TableKind::ltc_heitz, 1.0, 0.4);
    EXPECT_NEAR(down[0], 1.0, 1e-4); // fitted at n·v = 1 − 1e-5
    EXPECT_NEAR(down[1], 0.0, 1e-12);
    EXPECT_NEAR(down[2], 0.0, 1e-12);
}

// The last channel, by column and row: a point has its cosine, half a hemisphere (1 + cosine)/2 of its form factor, and
// a sphere above the horizon is a point.
TEST(ShadingTable, OfHeitzHasSpheresThatTheHorizonCuts) {
    constexpr int size = 9;
    const ShadingTable table = made(TableKind::ltc_heitz, TableForm::bilinear, TableAxes::heitz, size, size);
    const auto at = [&](int column, int row) {
        return static_cast<double>(table.values[static_cast<std::size_t>(row * size + column) * 8 + 7]);
    };
    for (int column = 0; column < size; ++column) {
        const double cosine = 2.0 * column / (size - 1) - 1.0;
        EXPECT_NEAR(at(column, 0), std::fmax(cosine, 0.0), 1e-7);
        EXPECT_NEAR(at(column, size - 1), (1.0 + cosine) / 2.0, 1e-7);
        for (int row = 1; row < size - 1; ++row) {
            const double sine = std::sqrt(row / (size - 1.0)); // of its angular radius
            if (cosine >= sine) {
                EXPECT_NEAR(at(column, row), cosine, 1e-7);
            } else if (cosine <= -sine) {
                EXPECT_NEAR(at(column, row), 0.0, 1e-7);
            } else {
                EXPECT_GT(at(column, row), std::fmax(cosine, 0.0));
            }
        }
    }
}

TEST(ShadingTable, IsTheSameForAnyNumberOfThreads) {
    for (const TableInfo& info : table_infos())
        for (const TableAxes axes : info.axes)
            EXPECT_EQ(made(info.kind, TableForm::bilinear, axes, 9, 7, 1).values,
                      made(info.kind, TableForm::bilinear, axes, 9, 7, 4).values);
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
    EXPECT_FALSE(make_shading_table(TableKind::dfg, TableForm::bilinear, TableAxes::heitz, 8, 8));
    EXPECT_FALSE(make_shading_table(TableKind::dfg, TableForm::chebyshev, TableAxes::heitz, 8, 8));
    EXPECT_FALSE(make_shading_table(TableKind::ltc_heitz, TableForm::bilinear, TableAxes::root, 8, 8));
    EXPECT_FALSE(make_shading_table(TableKind::ltc_heitz, TableForm::chebyshev, TableAxes::heitz, 8, 8));
}

} // namespace
} // namespace gonio
