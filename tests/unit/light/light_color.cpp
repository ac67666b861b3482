#include <gonio/light/light_color.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace gonio {
namespace {

TEST(LightColor, HasLuminanceOne) {
    for (const char* text : {"d65", "#ffd9a0", "rgb(1,0.5,0.25)", "rgb(0,0,3)", "2700K", "2700K/0.003", "1000K", "500K",
                             "LED-B3", "spectrum:blackbody:3000K", "e"}) {
        const auto rgb = parse_light_color(text);
        ASSERT_TRUE(rgb) << text;
        EXPECT_NEAR(glm::dot(*rgb, rec709_luminance), 1.0, 1e-15);
    }
    // A ratio works for any numbers, however large or small.
    for (const char* text : {"rgb(1.7e308,1.7e308,1.7e308)", "rgb(5e-324,5e-324,5e-324)"}) {
        const auto rgb = parse_light_color(text);
        ASSERT_TRUE(rgb) << text;
        EXPECT_NEAR(glm::length(*rgb - glm::dvec3(1.0)), 0.0, 1e-14) << text;
    }
    for (const char* text :
         {"", "#fff", "#gggggg", "rgb(1,2)", "rgb(1,2,3,4)", "rgb(0,0,0)", "rgb(-1,1,1)", "white", "2700", "499K",
          "2700K/0.2", "2700K/", "spectrum:", "spectrum:none.csv", "led-b9", "2700lm"})
        EXPECT_FALSE(parse_light_color(text)) << text;
}

TEST(LightColor, OfATemperatureIsTheBlackBody) {
    const glm::dvec3 rgb = parse_light_color("2700K").value();
    EXPECT_NEAR(rgb.x, 1.935, 6e-4);
    EXPECT_NEAR(rgb.y, 0.804, 6e-4);
    EXPECT_NEAR(rgb.z, 0.192, 6e-4);
    EXPECT_GT(parse_light_color("2700K/0.005")->y, rgb.y) << "a positive Duv is greener";
    EXPECT_EQ(parse_light_color("d65").value(), glm::dvec3(1.0));
}

TEST(LightColor, OutsideTheWorkingSpaceIsClippedAndSaid) {
    Diagnostics said;
    const glm::dvec3 candle = parse_light_color("1850K", &said).value();
    EXPECT_EQ(candle.z, 0.0);
    ASSERT_EQ(said.size(), 1U);
    EXPECT_EQ(said[0].severity, Severity::warning);
    said.clear();
    EXPECT_TRUE(parse_light_color("2700K", &said));
    EXPECT_TRUE(said.empty());
}

} // namespace
} // namespace gonio
