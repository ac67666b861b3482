// Direct ratios against values known in closed form.
#include <gonio/web/direct_ratios.hpp>

#include "webs.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace {

using namespace gonio;
using std::numbers::pi;

constexpr std::array room_indices{0.60, 0.80, 1.00, 1.25, 1.50, 2.00, 2.50, 3.00, 4.00, 5.00};

// A ceiling full of Lambertian luminaires is a Lambertian ceiling: the ratio is the form factor between two opposite
// squares with side x at distance 1.
double form_factor(double x) {
    const double one = 1.0 + x * x;
    return 2.0 / (pi * x * x) *
           (std::log(one / std::sqrt(1.0 + 2.0 * x * x)) + 2.0 * x * std::sqrt(one) * std::atan(x / std::sqrt(one)) -
            2.0 * x * std::atan(x));
}

TEST(DirectRatios, OfLambertianLuminairesAreFormFactors) {
    const std::vector<double> gammas = test::steps(0.0, 90.0, 181);
    std::vector<double> candela;
    for (const double gamma : gammas)
        candela.push_back(std::cos(gamma * pi / 180.0));
    const Web web = *Web::create(Symmetry::axial, {0.0}, gammas, candela);
    const std::array<double, 10> ratios = direct_ratios(web);
    for (std::size_t i = 0; i < ratios.size(); ++i)
        EXPECT_NEAR(ratios[i], form_factor(2.0 * room_indices[i]), 3e-4) << room_indices[i];
}

TEST(DirectRatios, OfNarrowAndOfUpwardLight) {
    const Web narrow = *Web::create(Symmetry::axial, {0.0}, {0.0, 2.0}, {1.0, 1.0});
    for (const double ratio : direct_ratios(narrow))
        EXPECT_GT(ratio, 0.97);
    const Web up = *Web::create(Symmetry::axial, {0.0}, {90.0, 180.0}, {1.0, 1.0});
    for (const double ratio : direct_ratios(up))
        EXPECT_EQ(ratio, 0.0);
}

} // namespace
