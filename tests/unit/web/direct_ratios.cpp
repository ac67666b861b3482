// Direct ratios against values known in closed form.
#include <gonio/web/direct_ratios.hpp>
#include <gonio/web/resample.hpp>
#include <gonio/web/symmetry.hpp>
#include <gonio/web/transform.hpp>

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

void expect_near(const std::array<double, 10>& found, const std::array<double, 10>& expected, double tolerance) {
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], tolerance) << room_indices[i];
}

// A square room looks the same turned by 90°, and to a light whose mirror images are written out.
TEST(DirectRatios, AreThoseOfTheLightHoweverItIsStored) {
    for (const Symmetry stored : {Symmetry::quadrant, Symmetry::bilateral_0_180, Symmetry::bilateral_90_270}) {
        const double first = stored == Symmetry::bilateral_90_270 ? 90.0 : 0.0;
        const double range = stored == Symmetry::quadrant ? 90.0 : 180.0;
        const Web web = test::random_web(stored, test::steps(first, first + range, 7), test::steps(0.0, 90.0, 10), 1);
        expect_near(direct_ratios(expanded(web)), direct_ratios(web), 1e-12);
    }
    const Web half =
        test::random_web(Symmetry::bilateral_0_180, test::steps(0.0, 180.0, 13), test::steps(0.0, 90.0, 10), 2);
    const Web web = rotated(half, 11.0).web; // no mirror image of itself in any wall
    expect_near(direct_ratios(rotated(web, 90.0).web), direct_ratios(web), 1e-12);
    expect_near(direct_ratios(mirrored(web, MirrorPlane::c0_180)), direct_ratios(web), 1e-12);
    EXPECT_GT(std::abs(direct_ratios(rotated(web, 45.0).web)[5] - direct_ratios(web)[5]), 1e-6);
}

// Type B against the same light on a fine grid of type C, whose error is that of linear steps of half a degree.
TEST(DirectRatios, OfAnotherGoniometer) {
    std::vector<double> candela;
    const std::vector<double> h = test::steps(-90.0, 90.0, 19);
    const std::vector<double> v = test::steps(-60.0, 60.0, 13);
    for (const double x : h)
        for (const double y : v)
            candela.push_back((2.0 + std::sin(x * pi / 60.0)) * std::cos(x * pi / 180.0) * std::cos(y * pi / 120.0));
    const Web web = *Web::create(Photometry::b, Symmetry::none, h, v, candela);
    const Web type_c = *sampled_on_grid(web, even_angles(0.0, 360.0, 720), even_angles(0.0, 90.0, 180));
    expect_near(direct_ratios(type_c), direct_ratios(web), 1e-4);
}

} // namespace
