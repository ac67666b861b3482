// g++ 12.2 at -O2 and -O3 drops the rounding of two adjacent floats (its SLP pass merges the conversions and removes
// them). The build turns that pass off; this pair shows whether it is off.
#include <gtest/gtest.h>

#include <utility>

namespace {

[[gnu::noinline]] std::pair<double, double> round_to_float(double x, double y) {
    const auto a = static_cast<float>(x);
    const auto b = static_cast<float>(y);
    return {static_cast<double>(a), static_cast<double>(b)};
}

TEST(CompilerGuard, DoubleFloatDoubleRounds) {
    volatile double x = 0.1;
    volatile double y = 1.0 / 3.0;
    const auto [a, b] = round_to_float(x, y);
    EXPECT_NE(a, x);
    EXPECT_NE(b, y);
    EXPECT_EQ(a, static_cast<double>(0.1F));
    EXPECT_EQ(b, static_cast<double>(1.0F / 3.0F));
}

} // namespace
