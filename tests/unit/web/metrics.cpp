#include <gonio/web/metrics.hpp>

#include "webs.hpp"

#include <gtest/gtest.h>

namespace gonio {
namespace {

using test::random_web;
using test::steps;

double spread_deg(const Web& web, double c, double fraction) {
    return to_degrees(spread_angle(web, c, fraction).value());
}

TEST(Spread, OfALinearBeam) {
    // 100 cd falling linearly to 0 at 40°: half at 20°, a tenth at 36°, on both sides.
    const Web web = *Web::create(Symmetry::axial, {0}, {0, 40, 90}, {100, 0, 0});
    EXPECT_NEAR(spread_deg(web, 0, 0.5), 40.0, 1e-9);
    EXPECT_NEAR(spread_deg(web, 90, 0.5), 40.0, 1e-9);
    EXPECT_NEAR(spread_deg(web, 0, 0.1), 72.0, 1e-9);
}

TEST(Spread, OfABatwingReachesOverTheDip) {
    const Web web = *Web::create(Symmetry::axial, {0}, {0, 30, 50, 60, 90}, {20, 100, 100, 0, 0});
    EXPECT_NEAR(spread_deg(web, 0, 0.5), 110.0, 1e-9);
}

TEST(Spread, OfALeaningLobeCountsItsOwnSideOnly) {
    // Bright from 30° to 50° on the C0 side only: the half points are 10° in on each of the flanks between 20° and 60°.
    const Web web = *Web::create(Symmetry::bilateral_0_180, {0, 180}, {0, 20, 30, 50, 60, 90},
                                 {0, 0, 100, 100, 0, 0, 0, 0, 0, 0, 0, 0});
    EXPECT_NEAR(spread_deg(web, 0, 0.5), 30.0, 1e-6);
}

TEST(Spread, OfAnUplightIsAroundTheZenith) {
    const Web web = *Web::create(Symmetry::axial, {0}, {0, 90, 140, 180}, {0, 0, 0, 100});
    EXPECT_NEAR(spread_deg(web, 0, 0.5), 40.0, 1e-9);
}

TEST(Spread, OfABareLampIsTheWholeCircle) {
    const Web web = *Web::create(Symmetry::axial, {0}, {0, 180}, {100, 100});
    EXPECT_NEAR(spread_deg(web, 0, 0.5), 360.0, 1e-9);
}

TEST(Spread, OfATableThatEndsBrightEndsThere) {
    const Web web = *Web::create(Symmetry::axial, {0}, {0, 90}, {100, 100});
    EXPECT_NEAR(spread_deg(web, 0, 0.5), 180.0, 1e-6);
}

TEST(Spread, OfADarkPlaneOrWebIsNone) {
    const Web dark = *Web::create(Symmetry::axial, {0}, {0, 90}, {0, 0});
    EXPECT_FALSE(spread_angle(dark, 0, 0.5));
    const Web side =
        *Web::create(Symmetry::bilateral_90_270, {90, 180, 270}, {0, 45, 90}, {0, 100, 0, 0, 0, 0, 0, 0, 0});
    EXPECT_FALSE(spread_angle(side, 0, 0.5));
    EXPECT_TRUE(spread_angle(side, 90, 0.5));
}

TEST(Peak, IsTheGreatestAndTheFirstOfEquals) {
    const Web web = *Web::create(Symmetry::none, {0, 90, 180, 270, 360}, {0, 45, 90},
                                 {5, 1, 1, 5, 9, 1, 5, 9, 1, 5, 1, 1, 5, 1, 1});
    const Peak top = peak(web);
    EXPECT_EQ(top.intensity.value, 9.0);
    EXPECT_EQ(top.c_deg, 90.0);
    EXPECT_EQ(top.gamma_deg, 45.0);
}

} // namespace
} // namespace gonio
