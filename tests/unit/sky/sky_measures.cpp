#include <gonio/light/light_color.hpp>
#include <gonio/sky/sky_measures.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace gonio {
namespace {

using std::numbers::pi;

Sky sky(std::string_view text) {
    return resolve_sky(parse_sky_description(text).value()).value();
}

TEST(SkyMeasures, OfAUniformSky) {
    const SkyMeasures of = measure(sky("uniform:mean=100nt,color=3000K"));
    EXPECT_NEAR(of.horizontal.value, 100.0 * pi, 1e-9);
    for (const Lux wall : of.vertical)
        EXPECT_NEAR(wall.value, 100.0 * pi, 1e-9);
    EXPECT_NEAR(of.mean.value, 100.0, 1e-12);
    EXPECT_FALSE(of.spot);
    EXPECT_NEAR(glm::dot(of.color, rec709_luminance), 1.0, 1e-12);
    EXPECT_LT(glm::length(of.color - parse_light_color("3000K").value()), 1e-12);
}

// Walls that face the sun, stand across and turn away from it; the walls turn with the sun.
TEST(SkyMeasures, WallsAreInTheirOrder) {
    const SkyMeasures south = measure(sky("cie:12,sun=180/30,zenith=1nt"));
    EXPECT_NEAR(south.vertical[0].value, 2.535974, 6e-7);
    EXPECT_NEAR(south.vertical[1].value, 3.574549, 6e-7);
    EXPECT_NEAR(south.vertical[2].value, 7.893976, 6e-7);
    EXPECT_NEAR(south.vertical[3].value, 3.574549, 6e-7);
    const SkyMeasures east = measure(sky("cie:12,sun=90/30,zenith=1nt"));
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(east.vertical.at(i).value, south.vertical.at((i + 1) % 4).value, 1e-8);
}

TEST(SkyMeasures, FindTheBrightestSpot) {
    const auto spot = [](const char* text) { return *measure(sky(text)).spot; };
    // At the sun, where the indicatrix has its cusp.
    for (const char* text : {"cie:12,sun=200/40,zenith=1nt", "cie:15,sun=200/40,zenith=1nt"}) {
        const BrightestSpot found = spot(text);
        EXPECT_LT(glm::length(found.direction - direction_of({200.0, 40.0})), 1e-12) << text;
    }
    // At the zenith, with L/Lz = (1 + 2 cos Z)/3: the mean over a cap of height h is 1 − h/3.
    const BrightestSpot zenith = spot("cie:overcast,zenith=7nt");
    const double height = 1.0 - std::cos(degrees(spot_radius_deg).value);
    EXPECT_EQ(zenith.direction.z, 1.0);
    EXPECT_NEAR(zenith.luminance.value, 7.0, 1e-12);
    EXPECT_NEAR(zenith.share, height * (1.0 - height / 3.0) / (2.0 / 3.0), 1e-9);
    // Below a high sun, this sky is brightest somewhere near the horizon or the sun: no direction beats it.
    for (const char* text : {"cie:2,sun=0/10,zenith=1nt", "cie:9,sun=70/20,zenith=1nt", "cie:10,sun=70/5,zenith=1nt"}) {
        const Sky of = sky(text);
        const BrightestSpot found = *measure(of).spot;
        for (int i = 0; i < 20000; ++i) {
            const double z = (i + 0.5) / 20000;
            const double turn = 2.399963229728653 * i; // the golden angle
            const glm::dvec3 direction{std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z};
            ASSERT_LE(glm::dot(of.radiance(direction), rec709_luminance), found.luminance.value * (1 + 1e-9)) << text;
        }
    }
    EXPECT_FALSE(measure(sky("cie:5,mean=3nt")).spot);
}

// A sphere of radius r catches ∫ L dω π r², four times less per area; with the ground half of it comes from below.
TEST(SkyMeasures, AllLight) {
    const Sky above = sky("cie:5,mean=3nt");
    EXPECT_NEAR(glm::dot(above.light(), rec709_luminance), 6.0 * pi, 1e-9);
    const Sky both = sky("cie:5,mean=3nt,ground=1");
    EXPECT_NEAR(glm::dot(both.light(), rec709_luminance), 12.0 * pi, 1e-9);
}

} // namespace
} // namespace gonio
