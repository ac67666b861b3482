// Guth's index: the table at points between its own, and the closed form near it.
#include <gonio/figures/position_index.hpp>

#include <gtest/gtest.h>

namespace gonio {
namespace {

TEST(PositionIndex, OfTheTableIsBilinear) {
    EXPECT_NEAR(table_position_index(0.0, 0.5).value(), 2.86, 0.005);
    EXPECT_NEAR(table_position_index(0.0, 1.0).value(), 7.00, 0.005);
    EXPECT_NEAR(table_position_index(0.5, 0.5).value(), 2.91, 0.005);
    EXPECT_NEAR(table_position_index(2.0, 0.25).value(), 4.70, 0.005);
    EXPECT_DOUBLE_EQ(table_position_index(0.0, 0.0).value(), 1.0);
    const double middle = 0.25 * (*table_position_index(1.0, 0.7) + *table_position_index(1.1, 0.7) +
                                  *table_position_index(1.0, 0.8) + *table_position_index(1.1, 0.8));
    EXPECT_NEAR(table_position_index(1.05, 0.75).value(), middle, 1e-12);
}

TEST(PositionIndex, OfTheTableEndsAtItsEdges) {
    EXPECT_TRUE(table_position_index(3.0, 1.6));
    EXPECT_FALSE(table_position_index(3.01, 1.0));
    EXPECT_FALSE(table_position_index(1.0, 1.61));
    EXPECT_FALSE(table_position_index(-0.1, 1.0));
}

TEST(PositionIndex, InClosedFormIsNearTheTable) {
    EXPECT_NEAR(closed_position_index(0.0, 1.0, 0.5), 2.860, 5e-4);
    EXPECT_NEAR(closed_position_index(0.0, 1.0, 1.0), 7.059, 5e-4);
    EXPECT_NEAR(closed_position_index(0.5, 1.0, 0.5), 2.918, 5e-4);
    EXPECT_NEAR(closed_position_index(2.0, 1.0, 0.25), 4.387, 5e-4);
    for (int i = 0; i <= 30; ++i)
        for (int j = 0; j <= 16; ++j) {
            const double table = table_position_index(0.1 * i, 0.1 * j).value();
            const double closed = closed_position_index(0.1 * i, 1.0, 0.1 * j);
            EXPECT_GT(closed, 0.90 * table) << i << ' ' << j;
            EXPECT_LT(closed, 1.12 * table) << i << ' ' << j;
        }
}

TEST(PositionIndex, BelowTheLineOfSight) {
    EXPECT_DOUBLE_EQ(closed_position_index(0.0, 10.0, -5.0), 1.4);
    EXPECT_DOUBLE_EQ(closed_position_index(6.0, 10.0, -8.0), 2.2);
}

} // namespace
} // namespace gonio
