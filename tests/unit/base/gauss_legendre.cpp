#include <gonio/base/gauss_legendre.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace gonio {
namespace {

// Exact for x^p up to p = 2n − 1 and not beyond; nodes ascend and are symmetric; the weights add up to 2.
template<std::size_t count>
void check() {
    constexpr auto rule = gauss_legendre<count>();
    for (std::size_t power = 0; power <= 2 * count; ++power) {
        double sum = 0.0;
        for (const QuadratureNode& node : rule)
            sum += node.weight * std::pow(node.at, static_cast<double>(power));
        const double exact = power % 2 == 0 ? 2.0 / (static_cast<double>(power) + 1.0) : 0.0;
        if (power < 2 * count) {
            EXPECT_NEAR(sum, exact, 1e-15) << count << ' ' << power;
        } else if (count <= 12) { // the error of x²ⁿ falls like 4⁻ⁿ
            EXPECT_GT(std::abs(sum - exact), 1e-14) << count;
        }
    }
    for (std::size_t i = 1; i < count; ++i)
        EXPECT_LT(rule[i - 1].at, rule[i].at);
}

TEST(GaussLegendre, IsExactForPolynomials) {
    check<1>();
    check<2>();
    check<3>();
    check<4>();
    check<6>();
    check<8>();
    check<12>();
    check<16>();
    check<20>();
}

// M. Abramowitz and I. A. Stegun, "Handbook of Mathematical Functions", table 25.4.
TEST(GaussLegendre, HasTheTablesDigits) {
    constexpr auto eight = gauss_legendre<8>();
    EXPECT_NEAR(eight[7].at, 0.960289856497536, 1e-15);
    EXPECT_NEAR(eight[7].weight, 0.101228536290376, 1e-15);
    constexpr auto sixteen = gauss_legendre<16>();
    EXPECT_NEAR(sixteen[8].at, 0.095012509837637440185, 2e-16);
    EXPECT_NEAR(sixteen[8].weight, 0.189450610455068496285, 4e-16);
    EXPECT_NEAR(sixteen[15].at, 0.989400934991649932596, 2e-16);
    EXPECT_NEAR(sixteen[15].weight, 0.027152459411754094852, 4e-16);
}

} // namespace
} // namespace gonio
