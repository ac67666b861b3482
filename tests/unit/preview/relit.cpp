#include <gonio/preview/relit.hpp>

#include "../light/lights.hpp"
#include "../scaled.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gonio {
namespace {

RenderOptions small() {
    RenderOptions options;
    options.width = 40;
    options.height = 30;
    options.illuminance = true;
    return options;
}

// Lights of several kinds, two of which are visible.
std::vector<Light> lights(double amount, const glm::dvec3& color) {
    std::vector<Light> all{light_of("sphere:r=15cm", "900lm", {0.0, -0.6, 1.5}),
                           light_of("rect:w=60cm,h=30cm", "1500lm", {0.1, 0.8, 1.6}),
                           light_of("spot:outer=35deg,inner=20deg", "900cd", {-0.8, 0.0, 2.2}),
                           light_of("sun:angle=0.53deg", "200lx", {}, {0.3, 0.4, -1.0})};
    for (Light& light : all) {
        light.luminance.value *= amount;
        light.intensity.value *= amount;
        light.illuminance.value *= amount;
        light.color = color;
    }
    return all;
}

// Relative to the value, or to a thousandth of the greatest where that is more. Amounts enter a chain of some thirty
// float operations for each light, of 6e-8 each.
void expect_near(const std::vector<float>& found, const std::vector<float>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_FALSE(found.empty());
    const float greatest = *std::max_element(expected.begin(), expected.end());
    ASSERT_GT(greatest, 0.0F);
    for (std::size_t i = 0; i < found.size(); ++i)
        ASSERT_NEAR(found[i], expected[i], 2e-6F * std::max(expected[i], 1e-3F * greatest)) << i;
}

const glm::dvec3 warm{1.3, 0.95, 0.6};
const glm::dvec3 cool{0.8, 1.02, 1.4};

TEST(Relit, EqualsWhatIsRendered) {
    for (const char* name : {"floor", "room"}) {
        const Stage stage = make_stage(name).value();
        for (const int bounces : {0, all_bounces})
            for (const glm::dvec3& color : {warm, cool}) {
                if (test::is_sanitized && bounces != 0 && color == cool) continue;
                RenderOptions options = small();
                options.bounces = bounces;
                options.illuminance = bounces == 0 || color == warm;
                const Rendering before = render(stage, lights(1.0, warm), stage.camera, options).value();
                for (const double amount : {0.37, 12.0}) {
                    const std::vector<Light> now = lights(amount, color);
                    const auto found = relit(before, lights(1.0, warm), now);
                    ASSERT_TRUE(found.has_value());
                    const Rendering expected = render(stage, now, stage.camera, options).value();
                    expect_near(found->luminance_nt.pixels, expected.luminance_nt.pixels);
                    if (options.illuminance) expect_near(found->illuminance_lx.pixels, expected.illuminance_lx.pixels);
                    EXPECT_EQ(found->shows_light, expected.shows_light);
                    ASSERT_EQ(found->partial_lights.size(), expected.partial_lights.size());
                    for (std::size_t i = 0; i < expected.partial_lights.size(); ++i)
                        for (std::size_t channel = 0; channel < 3; ++channel)
                            EXPECT_NEAR(found->partial_lights[i].rgb[channel], expected.partial_lights[i].rgb[channel],
                                        3e-7F * expected.partial_lights[i].rgb[channel]);
                }
            }
    }
}

TEST(Relit, SaysWhereItCannot) {
    const Stage stage = make_stage("room").value();
    RenderOptions options = small();
    options.bounces = all_bounces;
    const std::vector<Light> before = lights(1.0, warm);
    const Rendering picture = render(stage, before, stage.camera, options).value();
    EXPECT_FALSE(relit(picture, before, lights(2.0, cool))); // lux of light that bounced in colour
    std::vector<Light> one = before;
    one[1].luminance.value *= 2.0;
    EXPECT_FALSE(relit(picture, before, one));
    one.pop_back();
    EXPECT_FALSE(relit(picture, before, one));
    std::vector<Light> off = lights(0.0, warm);
    EXPECT_TRUE(relit(picture, before, off));
    EXPECT_FALSE(relit(picture, off, before));
    EXPECT_FALSE(relit(picture, lights(1.0, {1.4, 0.98, 0.0}), before));
    EXPECT_FALSE(relit(picture, lights(1e-300, warm), lights(1e300, warm)));
    EXPECT_FALSE(relit(picture, {}, {}));
}

} // namespace
} // namespace gonio
