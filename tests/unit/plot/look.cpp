#include <gonio/color/rgb_space.hpp>
#include <gonio/plot/contour.hpp>
#include <gonio/plot/legend.hpp>
#include <gonio/plot/look.hpp>
#include <gonio/plot/picture_contours.hpp>
#include <gonio/preview/exposure.hpp>
#include <gonio/preview/tone_map.hpp>
#include <gonio/scene/probe.hpp>

#include "../light/lights.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gonio {
namespace {

Image channel(int width, int height, const std::vector<float>& values) {
    Image image(width, height, 1);
    image.pixels = values;
    return image;
}

// The value that a palette's colour represents, found by searching the whole ramp.
double read_back(const float* color, const ValueScale& scale, const Palette& palette) {
    double best = 0.0;
    float least = std::numeric_limits<float>::max();
    for (int i = 0; i <= 20000; ++i) {
        const std::array<float, 3> at = palette.at(i / 20000.0);
        float distance = 0.0F;
        for (std::size_t c = 0; c < 3; ++c)
            distance += (at[c] - color[c]) * (at[c] - color[c]);
        if (distance < least) least = distance, best = scale.value(i / 20000.0);
    }
    return best;
}

// Every pixel's number is the value of a probe at the point shown, and its colour represents the same number.
TEST(ThreadsLook, ThePicturesNumbersAreThoseOfAProbe) {
    const Stage stage = make_stage("floor").value();
    const Light lights[] = {light_of("rect:w=60cm,h=30cm", "2000lm", {0.2, -0.4, 2.6}),
                            light_of("spot:outer=40deg", "900cd", {-0.5, 0.0, 2.2})};
    RenderOptions options;
    options.width = 48;
    options.height = 40;
    options.illuminance = true;
    options.shadows = Shadows::off; // a probe has none
    const Rendering rendering = render(stage, lights, stage.camera, options).value();
    const Image lux = quantity_image(rendering, PictureQuantity::illuminance);
    const auto seen = seen_surfaces(stage, lights, stage.camera, options.width, options.height, 0);
    const CameraRays rays(stage.camera, options.width, options.height);
    std::vector<Receiver> receivers;
    std::vector<std::size_t> pixels;
    for (int y = 0; y < options.height; ++y)
        for (int x = 0; x < options.width; ++x) {
            const std::size_t i = lux.index(x, y);
            if (seen[i] < 0 || seen[i] >= static_cast<int>(stage.surfaces.size())) continue;
            const Hit hit = first_hit(stage, rays.ray(x + 0.5, y + 0.5)).value();
            receivers.push_back({hit.position, hit.normal});
            pixels.push_back(i);
        }
    ASSERT_GT(pixels.size(), 1500U);
    const ProbeResult truth = probe(lights, receivers, {}).value();
    const ValueScale scale = round_scale(lux, true);
    const Palette& palette = palettes().front();
    const Image colored = false_color(lux, scale, palette);
    for (std::size_t k = 0; k < pixels.size(); ++k) {
        const double expected = truth.illuminance_lx[k];
        // The error bound of the float kernels, relative to the light and to what subtends little.
        EXPECT_NEAR(lux.pixels[pixels[k]], expected, 3e-5 * expected + 1e-4) << "pixel " << pixels[k];
        if (k % 37 != 0 || expected < scale.low || expected > scale.high) continue;
        // 1/20000 of three decades is 3.5e-4 of the value; the colour itself is a float.
        EXPECT_NEAR(read_back(&colored.pixels[3 * pixels[k]], scale, palette), expected, 1e-3 * expected);
    }
}

TEST(Look, LuminanceIsTheYOfTheColour) {
    Rendering rendering;
    rendering.luminance_nt = Image(1, 1, 3);
    rendering.luminance_nt.pixels = {10.0F, 20.0F, 30.0F};
    EXPECT_NEAR(quantity_image(rendering, PictureQuantity::luminance).pixels[0],
                10.0 * 0.2126390 + 20.0 * 0.7151687 + 30.0 * 0.0721923, 1e-5);
}

TEST(Look, NamesAreReadBack) {
    for (const LookName& known : looks()) {
        EXPECT_EQ(*parse_look(known.name), known.look);
        EXPECT_EQ(to_text(known.look), known.name);
    }
    EXPECT_EQ(*parse_look("falsecolor"), Look::false_color);
    EXPECT_FALSE(parse_look("isolines").has_value());
}

TEST(ValueScale, ShareAndValueAreInverse) {
    for (const ValueScale scale : {ValueScale{true, 0.1, 1000.0}, ValueScale{false, 0.0, 500.0}}) {
        EXPECT_NEAR(scale.share(scale.low), 0.0, 1e-15);
        EXPECT_NEAR(scale.share(scale.high), 1.0, 1e-15);
        for (double share = -0.2; share < 1.3; share += 0.1)
            EXPECT_NEAR(scale.share(scale.value(share)), share, 1e-12);
        EXPECT_LT(scale.share(0.0), 1e-15);
    }
}

TEST(ValueScale, AutomaticEndsAreRoundAndHoldThePicture) {
    std::vector<float> values;
    for (int i = 0; i < 1000; ++i)
        values.push_back(static_cast<float>(0.37 * std::pow(1.01, i))); // 0.37 to 7686
    const ValueScale scale = round_scale(channel(1000, 1, values), true);
    EXPECT_DOUBLE_EQ(scale.high, 10000.0);
    EXPECT_DOUBLE_EQ(scale.low, 10.0) << "three decades at most";
    EXPECT_DOUBLE_EQ(round_scale(channel(1000, 1, values), false).high, 10000.0);
    const double fc = 10.763910416709722;
    EXPECT_NEAR(round_scale(channel(1, 1, {300.0F}), false, fc).high, 50.0 * fc, 1e-9) << "27.9 fc";
    const ValueScale flat = round_scale(channel(2, 1, {100.0F, 100.0F}), true);
    EXPECT_DOUBLE_EQ(flat.high, 100.0);
    EXPECT_LT(flat.low, flat.high);
    const ValueScale dark = round_scale(channel(2, 1, {0.0F, 0.0F}), true);
    EXPECT_GT(dark.low, 0.0);
    EXPECT_LT(dark.low, dark.high);
}

TEST(ValueScale, NumbersLieWithinAndAreNotTooMany) {
    for (const ValueScale scale :
         {ValueScale{true, 0.1, 1000.0}, ValueScale{false, 0.0, 46.5}, ValueScale{true, 3.0, 4.0},
          ValueScale{false, 99.0, 101.0}, ValueScale{true, 1e-9, 1e9}})
        for (const int count : {2, 5, 14}) {
            const std::vector<double> numbers = scale_numbers(scale, 1.0, count);
            ASSERT_GE(numbers.size(), 2U);
            EXPECT_LE(numbers.size(), static_cast<std::size_t>(2 * count + 1));
            EXPECT_TRUE(std::is_sorted(numbers.begin(), numbers.end()));
            EXPECT_GE(numbers.front(), scale.low * (1.0 - 1e-6));
            EXPECT_LE(numbers.back(), scale.high * (1.0 + 1e-6));
        }
}

TEST(ValueScale, CountsWhatLiesBeyond) {
    const ScaleUse use = use_of(channel(5, 1, {0.0F, 0.5F, 5.0F, 50.0F, 60.0F}), {true, 1.0, 10.0});
    EXPECT_DOUBLE_EQ(use.below_share, 0.25);
    EXPECT_DOUBLE_EQ(use.above_share, 0.5);
    EXPECT_DOUBLE_EQ(use.greatest, 60.0);
}

// A picture of x² + y² with another surface in the right half: the line of 100 is two arcs that end at the border.
TEST(Look, LinesEndWhereTheSurfaceEnds) {
    Field field;
    for (int i = -20; i <= 20; ++i)
        field.xs.push_back(i);
    field.ys = field.xs;
    std::vector<std::int32_t> groups;
    for (const double y : field.ys)
        for (const double x : field.xs) {
            field.values.push_back(x * x + y * y);
            groups.push_back(x < 0.5 ? 0 : 1);
        }
    const auto whole = contour_lines(field, 100.0);
    ASSERT_EQ(whole.size(), 1U);
    EXPECT_TRUE(whole[0].closed);
    const auto parted = contour_lines(field, 100.0, groups);
    ASSERT_EQ(parted.size(), 2U);
    for (const ContourLine& line : parted) {
        EXPECT_FALSE(line.closed);
        for (const FieldPoint& point : line.points) {
            EXPECT_NEAR(std::hypot(point.x, point.y), 10.0, 0.02);
            EXPECT_TRUE(point.x <= 0.0 || point.x >= 1.0) << point.x;
        }
    }
    std::fill(groups.begin(), groups.end(), -1);
    EXPECT_TRUE(contour_lines(field, 100.0, groups).empty());
}

TEST(Look, ContoursAreLabelledWithTheirLevel) {
    Image values(200, 200, 1);
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x)
            *values.at(x, y) = static_cast<float>(1e6 / (400.0 + std::hypot(x - 100.0, y - 100.0) * 40.0));
    const std::vector<std::int32_t> surfaces(200 * 200, 0);
    const std::vector<double> levels{250.0, 500.0};
    const Drawing drawing = contour_drawing(values, surfaces, levels, contour_inks(2, palettes().front()), 10.0);
    std::vector<std::string> texts;
    for (const DrawingStep& step : drawing.steps())
        if (const auto* text = std::get_if<WrittenText>(&step)) {
            texts.push_back(text->text);
            // The number is on its line: 1e6/(400 + 40 r) = level.
            const double level = 10.0 * std::stod(text->text);
            const double y = text->at.y - 0.36 * text->style.size_px;
            EXPECT_NEAR(std::hypot(text->at.x - 100.5, y - 100.5), (1e6 / level - 400.0) / 40.0, 0.6);
        }
    EXPECT_NE(std::find(texts.begin(), texts.end(), "25"), texts.end());
    EXPECT_NE(std::find(texts.begin(), texts.end(), "50"), texts.end());
    EXPECT_EQ(contour_levels(0.0, 40.0, 1.0), (std::vector<double>{0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20}));
    EXPECT_EQ(contour_levels(9.0, 400.0, 10.0), (std::vector<double>{10, 15, 20, 30, 50, 70, 100, 150, 200, 300}));
    EXPECT_TRUE(contour_levels(0.0, 0.0, 1.0).empty());
}

TEST(Legend, LeavesThePictureAsItIsAtAnySize) {
    for (const int height : {1, 3, 40, 100, 160, 700}) {
        Image picture(7, height, 3);
        std::fill(picture.pixels.begin(), picture.pixels.end(), 0.25F);
        const std::vector<std::array<float, 3>> ramp(256, {0.0F, 1.0F, 0.0F});
        RampLegend ramp_legend;
        ramp_legend.scale = {true, 1.0, 1000.0};
        ramp_legend.unit.symbol = "lx";
        ramp_legend.ramp = ramp;
        ramp_legend.use = {0.1, 0.1, 2000.0};
        LineLegend line_legend;
        line_legend.levels = {1.0, 5.0};
        line_legend.inks = {ink(0xff0000), ink(0x00ff00)};
        const Image ramped = with_legend(picture, ramp_legend);
        const Image lined = with_legend(picture, line_legend);
        for (const Image* image : {&ramped, &lined}) {
            ASSERT_EQ(image->width, 7 + legend_width_px);
            ASSERT_EQ(image->height, height);
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < 7; ++x)
                    EXPECT_EQ(image->at(x, y)[1], 0.25F);
        }
    }
}

TEST(Exposure, ACardOf18PercentIsMiddleGrey) {
    for (const double lux : {0.3, 100.0, 80000.0}) {
        const Ev100 ev = exposure_of_card(Lux(lux));
        Image card(1, 1, 3);
        std::fill(card.pixels.begin(), card.pixels.end(), static_cast<float>(0.18 * lux / std::numbers::pi));
        expose(card, ev);
        EXPECT_NEAR(card.pixels[0], 0.18, 1e-6);
        EXPECT_NEAR(card_illuminance(ev).value, lux, 1e-12 * lux);
        // An incident-light meter of ISO 2720 with C = 250 reads more.
        EXPECT_NEAR(ev_lux(Lux(lux)).value - ev.value, std::log2(1.2 * std::numbers::pi / 2.5), 1e-12);
    }
}

TEST(ToneMap, Ue3AndItsInverseAreInverse) {
    for (double x = 1e-6; x < 1e6; x *= 1.3)
        EXPECT_NEAR(ue3_linear(ue3_encoded(x)), x, 1e-15 * x * (1.0 + 100.0 * x)) << x; // 1.0275 − y cancels
    for (double y = 0.0; y <= 1.0; y += 0.001)
        EXPECT_NEAR(ue3_encoded(ue3_linear(y)), y, 1e-15);
    EXPECT_DOUBLE_EQ(ue3_encoded(0.0), 0.0);
    EXPECT_NEAR(ue3_linear(1.0), 8.0, 1e-12);
    EXPECT_NEAR(ue3_encoded(8.0), 1.0, 1e-15);
}

TEST(ToneMap, TheInversesPictureLooksPlainThroughTheCurve) {
    Image picture(256, 1, 3);
    for (int x = 0; x < 256; ++x)
        std::fill_n(picture.at(x, 0), 3, static_cast<float>(x) / 200.0F);
    Image through = picture;
    apply_ue3_inverse(through);
    apply_ue3(through);
    for (int x = 0; x < 256; ++x)
        EXPECT_NEAR(through.at(x, 0)[1], encode_srgb(std::min(static_cast<double>(x) / 200.0, 1.0)), 1e-6);
    for (const ToneMapName& known : tone_maps())
        EXPECT_EQ(*parse_tone_map(known.name), known.map);
    EXPECT_FALSE(parse_tone_map("ue4").has_value());
}

} // namespace
} // namespace gonio
