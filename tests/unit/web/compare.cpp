#include <gonio/web/compare.hpp>
#include <gonio/web/goniometer.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/resample.hpp>
#include <gonio/web/symmetry.hpp>

#include "webs.hpp"

#include <gtest/gtest.h>

namespace gonio {
namespace {

using test::random_web;
using test::steps;

TEST(Compare, AWebEqualsItselfAndItsExpansion) {
    const Web web = random_web(Symmetry::quadrant, {0, 20, 50, 90}, steps(0, 90, 10), 1);
    const WebDifference same = difference(web, web);
    EXPECT_EQ(same.greatest.value, 0.0);
    EXPECT_EQ(same.rms.value, 0.0);
    EXPECT_TRUE(same.exact);
    EXPECT_LE(difference(web, expanded(web)).relative, 1e-14);
}

TEST(Compare, TwoGridsDifferMostAtACornerOfTheirUnion) {
    // a bends at 30°, b at 40°: |a − b| is greatest at one of these angles, and at no angle between them.
    const Web a = *Web::create(Symmetry::axial, {0}, {0, 30, 90}, {100, 40, 0});
    const Web b = *Web::create(Symmetry::axial, {0}, {0, 40, 90}, {100, 10, 0});
    const WebDifference d = difference(a, b);
    EXPECT_NEAR(d.greatest.value, 40.0 * (1.0 - 10.0 / 60.0) - 10.0, 1e-9); // at 40°: 33⅓ − 10; at 30°: 40 − 32.5
    EXPECT_EQ(d.gamma_deg, 40.0);
    EXPECT_NEAR(d.a.value, 33.333333333333333, 1e-9);
    EXPECT_NEAR(d.b.value, 10.0, 1e-9);
    EXPECT_NEAR(d.relative, d.greatest.value / 100.0, 1e-12);
}

TEST(Compare, IsTheGreatestOfEveryDirection) {
    const Web a = random_web(Symmetry::bilateral_90_270, {90, 100, 200, 270}, {0, 10, 33, 90}, 2);
    const Web b = random_web(Symmetry::none, steps(0, 360, 9), {0, 40, 75}, 3);
    const WebDifference d = difference(a, b);
    double sampled = 0.0;
    double squares = 0.0;
    const int n = 1200;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double c = (i + 0.5) * 360.0 / n;
            const double gamma = (j + 0.5) * 90.0 / n;
            const double here = a.candela(c, gamma) - b.candela(c, gamma);
            sampled = std::max(sampled, std::abs(here));
            squares += here * here * std::sin(gamma * std::numbers::pi / 180.0);
        }
    squares *= 2.0 * std::numbers::pi / n * 0.5 * std::numbers::pi / n;
    EXPECT_GE(d.greatest.value, sampled);
    EXPECT_LE(d.greatest.value, 1.02 * sampled);
    EXPECT_NEAR(d.rms.value, std::sqrt(squares / (4.0 * std::numbers::pi)), 1e-3 * d.rms.value);
    EXPECT_EQ(d.flux_a.value, flux(a).value);
    EXPECT_EQ(d.flux_b.value, flux(b).value);
}

TEST(Compare, AJumpAtTheEndOfATableCounts) {
    const Web whole = *Web::create(Symmetry::axial, {0}, {0, 90, 180}, {5, 5, 5});
    const Web half = *Web::create(Symmetry::axial, {0}, {0, 90}, {5, 5});
    const WebDifference d = difference(whole, half);
    EXPECT_NEAR(d.greatest.value, 5.0, 1e-12);
    EXPECT_EQ(d.gamma_deg, 90.0);
    EXPECT_NEAR(d.rms.value, 5.0 / std::sqrt(2.0), 1e-8);
    // A gap in C, dark on one side only.
    const Web sector = *Web::create(Symmetry::none, {0, 300}, {0, 90}, {5, 5, 5, 5});
    EXPECT_NEAR(difference(half, sector).greatest.value, 5.0, 1e-12);
}

TEST(Compare, NativeWebsOnTheirOwnGrids) {
    std::vector<double> candela(9, 1.0);
    const Web a = *Web::create(Photometry::b, Symmetry::none, {-60, 0, 60}, {-60, 0, 60}, candela);
    candela[4] = 3.0;
    const Web b = *Web::create(Photometry::b, Symmetry::none, {-60, 0, 60}, {-60, 0, 60}, candela);
    const WebDifference d = difference(a, b);
    EXPECT_TRUE(d.exact);
    EXPECT_NEAR(d.greatest.value, 2.0, 1e-12);
    EXPECT_NEAR(d.gamma_deg, 0.0, 1e-9);
    const WebDifference folded = difference(b, compacted(b));
    EXPECT_LE(folded.greatest.value, 1e-12);
}

TEST(Compare, AcrossGoniometersItIsSampled) {
    std::vector<double> candela(9, 1.0);
    candela[4] = 3.0;
    const Web b = *Web::create(Photometry::b, Symmetry::none, {-60, 0, 60}, {-60, 0, 60}, candela);
    const ResampledWeb c = *resampled_to_c(b, even_angles(0, 360, 72), even_angles(0, 90, 36));
    const WebDifference d = difference(b, c.web);
    EXPECT_FALSE(d.exact);
    EXPECT_NEAR(d.greatest.value, c.max_error.value, 0.3 * c.max_error.value);
    EXPECT_NEAR(d.flux_b.value - d.flux_a.value, c.flux_error.value, 1e-12);
}

// The end of a table is a jump, which another format stores as a ramp.
TEST(Compare, StepsNarrowerThanTheSmallestAngleDoNotCount) {
    const Web jump = *Web::create(Symmetry::axial, {0}, {0, 80}, {100, 100});
    const Web ramp = *Web::create(Symmetry::axial, {0}, {0, 80, 80.0001, 90}, {100, 100, 0, 0});
    constexpr double rounding = 1e-6; // 80.0001 − 80 keeps nine digits
    EXPECT_NEAR(difference(jump, ramp).greatest.value, 100.0, rounding);
    const WebDifference seen = difference(jump, ramp, 1e-3);
    EXPECT_NEAR(seen.greatest.value, 0.0, 1e-9);
    EXPECT_NEAR(seen.in_steps.value, 100.0, rounding);
    EXPECT_NEAR(difference(jump, ramp, 5e-5).greatest.value, 100.0, rounding) << "the ramp is wider than that";
    // Between planes at 0° and 360°.
    const Web parted = *Web::create(Symmetry::none, {0, 180, 360}, {0, 90}, {9, 1, 5, 1, 7, 1});
    const Web joined = *Web::create(Symmetry::none, {0, 180, 359.9999, 360}, {0, 90}, {9, 1, 5, 1, 7, 1, 9, 1});
    EXPECT_LE(difference(parted, joined, 1e-3).greatest.value, 1e-5);
    EXPECT_GE(difference(parted, joined).greatest.value, 1.0);
    // Many narrow cells in a row are not a step: what they hold is seen.
    std::vector<double> gammas{0.0};
    std::vector<double> candela{100.0};
    for (int i = 0; i < 100; ++i) {
        gammas.push_back(40.0 + 5e-4 * i);
        candela.push_back(i % 2 == 0 ? 100.0 : 50.0);
    }
    gammas.push_back(90.0);
    candela.push_back(100.0);
    const Web dense = *Web::create(Symmetry::axial, {0}, gammas, candela);
    const Web plain = *Web::create(Symmetry::axial, {0}, {0, 90}, {100, 100});
    EXPECT_NEAR(difference(dense, plain, 1e-3).greatest.value, 50.0, 1e-6);
}

} // namespace
} // namespace gonio
