#include <gonio/plot/axis.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gonio {
namespace {

TEST(Axis, TicksAreRoundAndCoverTheSpan) {
    EXPECT_EQ(ticks(0.0, 3535.8, 5), (std::vector<double>{0, 1000, 2000, 3000, 4000}));
    EXPECT_EQ(ticks(0.0, 1.0, 5), (std::vector<double>{0, 0.2, 0.4, 0.6000000000000001, 0.8, 1.0}));
    EXPECT_EQ(ticks(-6.0, 6.0, 8), (std::vector<double>{-6, -4, -2, 0, 2, 4, 6}));
}

TEST(Axis, AnySpanIsCoveredByAModestNumber) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> exponent(-290.0, 290.0);
    for (int i = 0; i < 20000; ++i) {
        const double low = (i % 3 - 1) * std::pow(10.0, exponent(random));
        const double high = low + std::pow(10.0, exponent(random));
        const std::vector<double> at = ticks(low, high, 6);
        ASSERT_FALSE(at.empty());
        if (!(high > low)) continue;
        EXPECT_LE(at.front(), low + 1e-6 * (high - low));
        EXPECT_GE(at.back(), high - 1e-6 * (high - low));
        EXPECT_LE(at.size(), 14U) << low << " to " << high;
    }
}

TEST(Axis, AnEmptySpanHasOneTick) {
    EXPECT_EQ(ticks(3.0, 3.0, 5), std::vector<double>{3.0});
    EXPECT_EQ(ticks(3.0, std::nan(""), 5), std::vector<double>{3.0});
}

TEST(Axis, LevelsStepBy125) {
    EXPECT_EQ(levels_1_2_5(3.0, 250.0), (std::vector<double>{5, 10, 20, 50, 100, 200}));
    EXPECT_TRUE(levels_1_2_5(0.0, 10.0).empty());
    EXPECT_TRUE(levels_1_2_5(10.0, 1.0).empty());
}

TEST(Axis, LevelsAreFinerWhereFewWouldFit) {
    EXPECT_EQ(fitting_levels(3.0, 250.0, 6), (std::vector<double>{5, 10, 20, 50, 100, 200}));
    EXPECT_EQ(fitting_levels(20.0, 120.0, 5), (std::vector<double>{20, 30, 50, 70, 100}));
    EXPECT_EQ(fitting_levels(20.0, 70.0, 6), (std::vector<double>{20, 25, 30, 40, 50, 60, 70}));
    EXPECT_EQ(fitting_levels(300.0, 330.0, 5), (std::vector<double>{305, 310, 315, 320, 325}));
    EXPECT_TRUE(fitting_levels(0.0, 330.0, 5).empty());
    EXPECT_TRUE(fitting_levels(7.0, 7.0, 5).empty());
}

} // namespace
} // namespace gonio
