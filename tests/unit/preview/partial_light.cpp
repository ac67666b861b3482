// Pixels that a light covers in part: their mean is taken behind the display's curve.
#include <gonio/color/rgb_space.hpp>
#include <gonio/preview/partial_light.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/scene/stage.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gonio {
namespace {

// A display's curve: clipped, and encoded by sRGB.
void show(Image& image) {
    for (float& value : image.pixels)
        value = static_cast<float>(encode_srgb(std::clamp(static_cast<double>(value), 0.0, 1.0)));
}

// A row of four pixels of 0.2: the second shows half of a light, the last a quarter of one and an eighth of another.
struct Row {
    Image picture{4, 1, 3};
    std::vector<PartialLight> lights;

    explicit Row(float light)
        : lights{{1, 0.5F, {light, light, 0.0F}}, {3, 0.25F, {light, 0.0F, 0.0F}}, {3, 0.125F, {0.4F, 0.4F, 0.4F}}} {
        std::fill(picture.pixels.begin(), picture.pixels.end(), 0.2F);
        for (const std::uint32_t pixel : {1U, 3U})
            for (std::size_t channel = 0; channel < 3; ++channel) {
                float left = 1.0F;
                float sum = 0.0F;
                for (const PartialLight& part : lights)
                    if (part.pixel == pixel) {
                        left -= part.share;
                        sum += part.share * part.rgb[channel];
                    }
                picture.pixels[3 * pixel + channel] = left * 0.2F + sum;
            }
    }
    Image shown() {
        Image parts = parts_of(picture, lights);
        show(picture);
        show(parts);
        merge_parts(parts, lights, picture);
        return picture;
    }
    double linear(std::size_t pixel, std::size_t channel) {
        return decode_srgb(static_cast<double>(picture.pixels[3 * pixel + channel]));
    }
};

TEST(PartialLight, PartsAreWhatRemainsAndTheLights) {
    const Row row(1000.0F);
    const Image parts = parts_of(row.picture, row.lights);
    ASSERT_EQ(parts.width, 5);
    for (const int rest : {0, 2})
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(parts.at(rest, 0)[channel], 0.2F, 1e-4F) << "a float of 500 has four digits behind the point";
    EXPECT_EQ(parts.at(1, 0)[0], 1000.0F);
    EXPECT_EQ(parts.at(4, 0)[2], 0.4F);
    EXPECT_TRUE(parts_of(row.picture, {}).pixels.empty());
}

TEST(PartialLight, ABrightLightCoversItsShareOfTheDisplay) {
    Row row(1000.0F);
    row.shown();
    EXPECT_NEAR(row.linear(1, 0), 0.5 * 1.0 + 0.5 * 0.2, 1e-4);
    EXPECT_NEAR(row.linear(1, 2), 0.5 * 0.2, 1e-6);
    EXPECT_NEAR(row.linear(3, 0), 0.25 * 1.0 + 0.125 * 0.4 + 0.625 * 0.2, 1e-4);
    EXPECT_NEAR(row.linear(3, 1), 0.125 * 0.4 + 0.625 * 0.2, 1e-6);
    EXPECT_NEAR(row.linear(0, 0), 0.2, 1e-6);
}

// Where nothing is clipped, the mean is the same before the curve and behind it.
TEST(PartialLight, WithoutClippingNothingChanges) {
    Row row(0.9F);
    const std::vector<float> before = row.picture.pixels;
    row.shown();
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_NEAR(row.linear(i / 3, i % 3), static_cast<double>(before[i]), 1e-6);
}

// A dot on a hundredth of its pixel is white if its light suffices for that, and never brighter than the mean.
TEST(PartialLight, DotsAreDrawnAsWideAsTheirLightSuffices) {
    for (const float light : {0.5F, 2.0F, 30.0F, 1e4F}) {
        std::vector<PartialLight> lights{{0, 0.01F, {light, 0.5F, 0.0F}, 100.0F}};
        Image picture(1, 1, 3);
        picture.pixels = {0.99F * 0.2F + 0.01F * light, 0.99F * 0.2F + 0.005F, 0.99F * 0.2F};
        Image parts = parts_of(picture, lights);
        show(picture);
        show(parts);
        merge_parts(parts, lights, picture);
        const double share = 0.01 * std::clamp(static_cast<double>(light), 1.0, 100.0);
        const double shown = std::min(static_cast<double>(light), 1.0);
        EXPECT_NEAR(decode_srgb(static_cast<double>(picture.pixels[0])), share * shown + (1.0 - share) * 0.2, 1e-4);
        EXPECT_NEAR(decode_srgb(static_cast<double>(picture.pixels[1])), 0.99 * 0.2 + 0.005, 1e-5) << "not white here";
    }
}

// Two of them in one pixel are not more than the pixel.
TEST(PartialLight, DotsShareTheirPixel) {
    const std::vector<PartialLight> lights{{0, 0.01F, {1e4F, 1e4F, 1e4F}, 100.0F},
                                           {0, 0.02F, {1e4F, 1e4F, 1e4F}, 50.0F}};
    Image picture(1, 1, 3);
    picture.pixels = {300.0F, 300.0F, 300.0F};
    Image parts = parts_of(picture, lights);
    show(picture);
    show(parts);
    merge_parts(parts, lights, picture);
    for (const float channel : picture.pixels)
        EXPECT_NEAR(channel, 1.0F, 1e-6F);
}

TEST(PartialLight, ExposureScalesThem) {
    std::vector<PartialLight> lights{{7, 0.5F, {2.4F, 1.2F, 0.0F}}};
    expose(lights, Ev100(1.0));
    EXPECT_FLOAT_EQ(lights[0].rgb[0], 1.0F);
    EXPECT_FLOAT_EQ(lights[0].rgb[1], 0.5F);
    EXPECT_EQ(lights[0].share, 0.5F);
}

// The outline of a round light: every listed pixel shows it, and its light is part of the pixel's mean.
TEST(PartialLight, OfARenderedOutline) {
    LightDescription description;
    description.name = "globe";
    description.shape = *parse_shape("sphere:r=20cm");
    description.intensity = *parse_photometric_value("5000nt");
    description.position = {0.0, 0.0, 1.5};
    Diagnostics ignored;
    const Light light = *resolve_light(std::move(description), ignored);
    const Stage stage = *make_stage("room");
    RenderOptions options;
    options.width = options.height = 96;
    const Rendering rendering = *render(stage, {&light, 1}, stage.camera, options);
    ASSERT_GT(rendering.partial_lights.size(), 20U);
    EXPECT_TRUE(std::is_sorted(rendering.partial_lights.begin(), rendering.partial_lights.end(),
                               [](const PartialLight& a, const PartialLight& b) { return a.pixel < b.pixel; }));
    for (const PartialLight& part : rendering.partial_lights) {
        EXPECT_EQ(rendering.shows_light[part.pixel], 1);
        EXPECT_GT(part.share, 0.0F);
        EXPECT_LE(part.share, 1.0F);
        EXPECT_FLOAT_EQ(part.rgb[1], 5000.0F);
        EXPECT_GE(rendering.luminance_nt.pixels[3 * part.pixel + 1], part.share * part.rgb[1] * 0.9999F);
    }
}

} // namespace
} // namespace gonio
