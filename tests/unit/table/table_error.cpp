#include <gonio/table/stored_table.hpp>
#include <gonio/table/table_error.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

namespace gonio {
namespace {

// Two quadratures that share only the BRDF: over visible normals on a lattice, and over half vectors in panels.
TEST(TableError, QuadraturesAgree) {
    for (const auto& [kind, first, second] :
         {std::tuple{TableKind::dfg, 3e-5, 3e-5}, {TableKind::kulla_conty, 3e-5, 7e-5}}) {
        const TableTruth truth(kind, 64);
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const TableValues values = table_values(kind, truth.n_dot_v(i), truth.roughness(i));
            EXPECT_NEAR(values[0], truth.values(i)[0], first) << truth.n_dot_v(i) << ' ' << truth.roughness(i);
            EXPECT_NEAR(values[1], truth.values(i)[1], second) << truth.n_dot_v(i) << ' ' << truth.roughness(i);
        }
    }
}

// What is stated of an error: a dark lobe lacks all light, and one that is nowhere below the true one has as much too
// much as it has more.
TEST(TableError, OfLobesIsAShareOfTheLight) {
    const TableTruth truth(TableKind::ltc_disney, 17);
    const auto lambert = [&](double albedo) {
        TransformedCosine lobe;
        lobe.scale = albedo;
        return truth.error_of_lobes([lobe](double, double) { return lobe; });
    };
    EXPECT_DOUBLE_EQ(lambert(0.0).median, 1.0);
    EXPECT_DOUBLE_EQ(lambert(0.0).max, 1.0);
    std::vector<double> expected;
    for (std::size_t i = 0; i < truth.size(); ++i)
        expected.push_back((10.0 - truth.values(i)[0]) / truth.values(i)[0]);
    std::sort(expected.begin(), expected.end());
    const TableError bright = lambert(10.0);
    EXPECT_NEAR(bright.median, expected[8], 2e-3 * expected[8]);
    EXPECT_NEAR(bright.max, expected[16], 2e-3 * expected[16]);
}

struct Row {
    TableKind kind;
    TableForm form;
    TableAxes axes;
    int size;
    TablePixel pixel;
    double median, p95;
};

// The figures of lib/gonio/table/MEASURED.md.
TEST(TableError, IsThatOfTheDocumentedFigures) {
    constexpr TableForm bilinear = TableForm::bilinear;
    constexpr TableForm chebyshev = TableForm::chebyshev;
    constexpr std::array rows{
        Row{TableKind::dfg, bilinear, TableAxes::linear, 16, TablePixel::half, 3.0e-4, 8.0e-3},
        Row{TableKind::dfg, bilinear, TableAxes::root, 16, TablePixel::half, 2.7e-4, 1.2e-3},
        Row{TableKind::dfg, bilinear, TableAxes::root, 16, TablePixel::uint8, 8.7e-4, 1.9e-3},
        Row{TableKind::dfg, chebyshev, TableAxes::root, 10, TablePixel::float32, 3.2e-4, 2.7e-3},
        Row{TableKind::kulla_conty, bilinear, TableAxes::root, 16, TablePixel::half, 2.7e-4, 9.8e-4},
        Row{TableKind::ltc_ggx, bilinear, TableAxes::root, 8, TablePixel::half, 4.4e-2, 2.2e-1},
        Row{TableKind::ltc_ggx, bilinear, TableAxes::root, 16, TablePixel::half, 4.0e-2, 1.9e-1},
        Row{TableKind::ltc_disney, bilinear, TableAxes::root, 8, TablePixel::half, 1.6e-2, 3.4e-2},
    };
    const TableKind none = TableKind::ltc_disney;
    std::optional<TableTruth> truth;
    TableKind of = none;
    for (const Row& row : rows) {
        if (!truth || of != row.kind) truth.emplace(row.kind);
        of = row.kind;
        ShadingTable table = make_shading_table(row.kind, row.form, row.axes, row.size, row.size).value();
        const TableError error = truth->error_of(store_table(std::move(table), row.pixel).value().table);
        EXPECT_NEAR(error.median, row.median, 0.06 * row.median) << info_of(row.kind).name << ' ' << row.size;
        EXPECT_NEAR(error.p95, row.p95, 0.06 * row.p95) << info_of(row.kind).name << ' ' << row.size;
        EXPECT_GE(error.max, error.p95);
    }
}

// What the table of E. Heitz and others errs by at most is 0.98; even 384 bytes of integers stay within half of that.
TEST(TableError, OfLobesInIntegersIsNeverGreat) {
    const TableTruth truth(TableKind::ltc_ggx);
    for (const int size : {8, 16, 32, 64})
        for (const TablePixel pixel : {TablePixel::uint16, TablePixel::uint8}) {
            ShadingTable table =
                make_shading_table(TableKind::ltc_ggx, TableForm::bilinear, TableAxes::root, size, size).value();
            const TableError error = truth.error_of(store_table(std::move(table), pixel).value().table);
            EXPECT_LT(error.max, 0.45) << size << ' ' << info_of(pixel).name;
        }
}

// In the layout of E. Heitz and others, with their lookup: nearer than their table in the same 65 536 bytes.
TEST(TableError, OfTheLayoutOfHeitzIsBelowThatOfItsAuthors) {
    const TableTruth truth(TableKind::ltc_heitz);
    ShadingTable table =
        make_shading_table(TableKind::ltc_heitz, TableForm::bilinear, TableAxes::heitz, 64, 64).value();
    const TableError error = truth.error_of(store_table(std::move(table), TablePixel::half).value().table);
    EXPECT_LT(error.median, 0.7 * 6.6e-2);
    EXPECT_LT(error.p95, 0.75 * 3.1e-1);
    EXPECT_LT(error.max, 0.98);
}

// Interpolation errs by the square of a step.
TEST(TableError, FallsWithTheSquareOfTheSize) {
    const TableTruth truth(TableKind::dfg, 128);
    const auto median = [&](int size) {
        return truth
            .error_of(make_shading_table(TableKind::dfg, TableForm::bilinear, TableAxes::root, size, size).value())
            .median;
    };
    EXPECT_NEAR(median(9) / median(17), 4.0, 1.2);
}

} // namespace
} // namespace gonio
