#include <gonio/light/light_color.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace gonio {
namespace {

TEST(LightColor, HasLuminanceOne) {
    for (const char* text : {"d65", "#ffd9a0", "rgb(1,0.5,0.25)", "rgb(0,0,3)"}) {
        const auto rgb = parse_light_color(text);
        ASSERT_TRUE(rgb) << text;
        EXPECT_NEAR(glm::dot(*rgb, rec709_luminance), 1.0, 1e-15);
    }
    for (const char* text : {"", "#fff", "#gggggg", "rgb(1,2)", "rgb(1,2,3,4)", "rgb(0,0,0)", "rgb(-1,1,1)", "white"})
        EXPECT_FALSE(parse_light_color(text)) << text;
}

} // namespace
} // namespace gonio
