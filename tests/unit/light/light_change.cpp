#include <gonio/light/light_change.hpp>

#include "lights.hpp"
#include "luminaire.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <variant>
#include <vector>

namespace gonio {
namespace {

std::vector<Light> two_lights() {
    return {light_of("rect:w=60cm,h=30cm", "1500lm", {0.1, 0.8, 1.6}),
            light_of("spot:outer=35deg,inner=20deg", "900cd", {-0.8, 0.0, 2.2})};
}

std::vector<Light> times(std::vector<Light> lights, double amount, const glm::dvec3& color) {
    for (Light& light : lights) {
        light.luminance.value *= amount;
        light.intensity.value *= amount;
        light.color *= color;
    }
    return lights;
}

TEST(LightChange, IsTheFactorOfAllLights) {
    const std::vector<Light> before = two_lights();
    const auto change = common_change(before, times(before, 0.3, {1.2, 0.9, 0.5}));
    ASSERT_TRUE(change.has_value());
    EXPECT_DOUBLE_EQ(change->amount, 0.3);
    EXPECT_DOUBLE_EQ(change->rgb.x, 0.36);
    EXPECT_DOUBLE_EQ(change->rgb.z, 0.15);
    EXPECT_TRUE(change->is_of_color());
    EXPECT_FALSE(common_change(before, times(before, 7.0, glm::dvec3(1.0)))->is_of_color());
    std::vector<Light> one = before;
    one[1].intensity.value *= 2.0;
    EXPECT_FALSE(common_change(before, one));
    one = times(before, 0.0, glm::dvec3(1.0));
    EXPECT_TRUE(common_change(before, one));
    EXPECT_FALSE(common_change(one, before));
}

TEST(LightChange, SaysWhatElseDiffers) {
    const std::vector<Light> before = two_lights();
    EXPECT_TRUE(differ_in_amount_alone(before, times(before, 0.3, {1.2, 0.9, 0.5})));
    const auto differs = [&](const auto& change) {
        std::vector<Light> now = before;
        change(now);
        return !differ_in_amount_alone(before, now);
    };
    EXPECT_TRUE(differs([](auto& lights) { lights.pop_back(); }));
    EXPECT_TRUE(differs([](auto& lights) { lights[0].frame.origin.x += 0.1; }));
    EXPECT_TRUE(differs([](auto& lights) { std::swap(lights[0].frame.x, lights[0].frame.y); }));
    EXPECT_TRUE(differs([](auto& lights) { lights[0].range = Meters(3.0); }));
    EXPECT_TRUE(differs([](auto& lights) { lights[0].emitted_by = EmittingFace{2, 0}; }));
    EXPECT_TRUE(differs([](auto& lights) { std::get<RectShape>(lights[0].shape).width = Meters(0.61); }));
    EXPECT_TRUE(differs([](auto& lights) { std::get<SpotShape>(lights[1].shape).falloff = Falloff::linear_cos; }));
    EXPECT_TRUE(differs([](auto& lights) { lights[1].shape = PointShape(); }));
    EXPECT_TRUE(differs([](auto& lights) { lights[1].web_scale = 2.0; }));
}

// Their bodies and faces are made anew with the lights, from the same profile and opening.
TEST(LightChange, SeesTheOpeningsOfProfiles) {
    LightDescription description;
    description.shape = test::luminaire("batwing", "rect:w=60cm,h=30cm").shape;
    const auto resolved = [&](const char* intensity) {
        description.intensity = parse_photometric_value(intensity).value();
        Diagnostics diagnostics;
        return std::vector<Light>{resolve_light(description, diagnostics).value()};
    };
    const std::vector<Light> before = resolved("1000lm");
    const std::vector<Light> half = resolved("500lm");
    ASSERT_NE(before[0].body, nullptr);
    ASSERT_NE(before[0].body, half[0].body);
    EXPECT_TRUE(differ_in_amount_alone(before, half));
    EXPECT_NEAR(common_change(before, half)->amount, 0.5, 1e-15);

    auto& shape = std::get<ProfileShape>(description.shape);
    const std::shared_ptr<const Opening> opening = shape.given;
    shape.given = std::make_shared<const Opening>(parse_opening("rect:w=60cm,h=31cm").value());
    EXPECT_FALSE(differ_in_amount_alone(before, resolved("500lm")));
    shape.given = opening;
    shape.size = ProfileSize::point;
    EXPECT_FALSE(differ_in_amount_alone(before, resolved("500lm")));
    shape.size = ProfileSize::opening;
    EXPECT_TRUE(differ_in_amount_alone(before, resolved("500lm")));
}

} // namespace
} // namespace gonio
