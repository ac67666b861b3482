#include <gonio/media/display.hpp>
#include <gonio/media/module.hpp>

#include "../folders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace gonio::media {
namespace {

const std::string data = std::string(test::source_folder) + "/tests/unit/media/data/";

class MediaDisplay : public ::testing::Test {
protected:
    void SetUp() override { set_module_folders({test::modules_folder}); }
};

std::string reason(const Error& error) {
    return error.diagnostics.back().message + " / " + error.diagnostics.back().hint;
}

// IEC 61966-2-1.
double srgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

Image ramp(int count) {
    Image image(count, 1, 3);
    for (int i = 0; i < count; ++i)
        for (int c = 0; c < 3; ++c)
            image.at(i, 0)[c] =
                std::pow(static_cast<float>((i + 17 * c) % count) / static_cast<float>(count - 1), 2.0F);
    return image;
}

TEST_F(MediaDisplay, StandardIsThePlainSrgbCurve) {
    Image image = ramp(1001);
    const Image linear = image;
    const auto used = apply_display(image);
    ASSERT_TRUE(used) << reason(used.error());
    EXPECT_EQ(used->display, "sRGB");
    EXPECT_EQ(used->view, "Standard");
    EXPECT_EQ(used->source, "lin_rec709");
    EXPECT_TRUE(used->diagnostics.empty());
    double largest = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        largest = std::max(
            largest, std::abs(static_cast<double>(image.pixels[i]) - srgb(static_cast<double>(linear.pixels[i]))));
    RecordProperty("largest_error", std::to_string(largest));
    EXPECT_LT(largest, 1e-4);
}

double linear_of(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

struct Perceived {
    double lightness, chroma, hue_deg;
};

// Oklab (B. Ottosson, 2020) of display values.
Perceived oklab(const float* pixel) {
    const auto channel = [&](int c) { return linear_of(std::clamp(static_cast<double>(pixel[c]), 0.0, 1.0)); };
    const double r = channel(0);
    const double g = channel(1);
    const double b = channel(2);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    const double x = 1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s;
    const double y = 0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s;
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s, std::hypot(x, y),
            std::atan2(y, x) * 180.0 / 3.14159265358979};
}

// The largest turn of the hue as a colour of luminance 1 becomes brighter than white in half stops, as long as it has
// a chroma that can be seen.
double turn_of_hue(const std::array<float, 3>& color, const char* view) {
    Image image(40, 1, 3);
    for (int i = 0; i < image.width; ++i)
        for (int c = 0; c < 3; ++c)
            image.at(i, 0)[c] = color[static_cast<std::size_t>(c)] * 0.05F * std::exp2(0.5F * static_cast<float>(i));
    DisplayOptions options;
    options.view = view;
    EXPECT_TRUE(apply_display(image, options));
    const double hue_deg = oklab(image.at(0, 0)).hue_deg;
    double largest = 0.0;
    for (int i = 0; i < image.width; ++i) {
        const Perceived seen = oklab(image.at(i, 0));
        if (seen.chroma > 0.02) largest = std::max(largest, std::abs(std::remainder(seen.hue_deg - hue_deg, 360.0)));
    }
    EXPECT_GT(oklab(image.at(image.width - 1, 0)).lightness, 0.999);
    return largest;
}

TEST_F(MediaDisplay, FilmicKeepsHuesAndMiddleGrey) {
    // 2700 K, red, blue, amber, 5000 K.
    for (const std::array<float, 3> color :
         {std::array{1.738F, 0.861F, 0.235F}, std::array{3.51F, 0.35F, 0.18F}, std::array{0.28F, 0.75F, 5.6F},
          std::array{2.29F, 0.72F, 0.05F}, std::array{1.13F, 0.97F, 0.84F}}) {
        EXPECT_LT(turn_of_hue(color, "Filmic"), 5.0) << color[0];
        if (color[2] != 0.84F) { // 5000 K has too little chroma
            EXPECT_GT(turn_of_hue(color, "Standard"), 30.0) << color[0];
        }
    }
    Image image = ramp(1001);
    for (float& value : image.pixels)
        value *= 0.18F;
    Image standard = image;
    DisplayOptions options;
    options.view = "Filmic";
    ASSERT_TRUE(apply_display(image, options));
    ASSERT_TRUE(apply_display(standard));
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        EXPECT_NEAR(image.pixels[i], standard.pixels[i], 2e-4) << i;
}

// Brighter light never looks darker, and no light is lost to infinities.
TEST_F(MediaDisplay, FilmicRises) {
    Image image(600, 1, 3);
    for (int i = 0; i < image.width; ++i)
        for (int c = 0; c < 3; ++c)
            image.at(i, 0)[c] = std::exp2(0.05F * static_cast<float>(i) - 12.0F);
    DisplayOptions options;
    options.view = "Filmic";
    ASSERT_TRUE(apply_display(image, options));
    for (int i = 1; i < image.width; ++i)
        EXPECT_GE(image.at(i, 0)[1], image.at(i - 1, 0)[1] - 1e-6F) << i;
    EXPECT_NEAR(image.at(image.width - 1, 0)[0], 1.0, 1e-3);
}

TEST_F(MediaDisplay, AlphaStays) {
    Image image(2, 2, 4);
    std::fill(image.pixels.begin(), image.pixels.end(), 0.25F);
    ASSERT_TRUE(apply_display(image));
    for (int pixel = 0; pixel < 4; ++pixel) {
        EXPECT_EQ(image.at(pixel % 2, pixel / 2)[3], 0.25F);
        EXPECT_NEAR(image.at(pixel % 2, pixel / 2)[0], srgb(0.25), 1e-4);
    }
}

TEST_F(MediaDisplay, RawLeavesTheNumbers) {
    Image image = ramp(50);
    image.pixels[0] = 7.5F;
    const Image before = image;
    DisplayOptions options;
    options.view = "Raw";
    ASSERT_TRUE(apply_display(image, options));
    EXPECT_EQ(image.pixels, before.pixels);
}

// ACES 1.0 SDR video: 18 % grey comes out near 10 nt of 100; bright light is compressed into [0, 1] and stays neutral.
TEST_F(MediaDisplay, AcesMapsTones) {
    Image image(3, 1, 3);
    const std::array<float, 3> levels{0.18F, 1.0F, 30.0F};
    for (int i = 0; i < 3; ++i)
        std::fill_n(image.at(i, 0), 3, levels.at(static_cast<std::size_t>(i)));
    DisplayOptions options;
    options.view = "aces"; // case does not matter
    const auto used = apply_display(image, options);
    ASSERT_TRUE(used) << reason(used.error());
    EXPECT_EQ(used->view, "ACES");
    EXPECT_NEAR(image.at(0, 0)[0], srgb(0.10), 0.02);
    EXPECT_GT(image.at(1, 0)[1], image.at(0, 0)[1] + 0.3F);
    EXPECT_LE(image.at(2, 0)[2], 1.01F); // its white is slightly off D65
    EXPECT_GT(image.at(2, 0)[2], 0.97F);
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(image.at(i, 0)[0], image.at(i, 0)[2], 2e-3);
}

TEST_F(MediaDisplay, TheThreadCountChangesNothing) {
    Image one(257, 63, 3);
    for (std::size_t i = 0; i < one.pixels.size(); ++i)
        one.pixels[i] = static_cast<float>((i * 2654435761U) % 4096U) / 2000.0F;
    Image four = one;
    DisplayOptions options;
    options.view = "ACES";
    options.threads = 1;
    ASSERT_TRUE(apply_display(one, options));
    options.threads = 4;
    ASSERT_TRUE(apply_display(four, options));
    EXPECT_EQ(one.pixels, four.pixels);
}

TEST_F(MediaDisplay, UnknownNamesAreAnsweredWithTheKnownOnes) {
    Image image = ramp(4);
    DisplayOptions options;
    options.view = "Standart";
    auto failed = apply_display(image, options);
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().failure, Failure::usage);
    EXPECT_EQ(reason(failed.error()),
              "unknown view 'Standart' / did you mean 'Standard'? there are: Standard, Filmic, ACES, Raw");

    options.view.clear();
    options.display = "projector";
    failed = apply_display(image, options);
    ASSERT_FALSE(failed);
    EXPECT_EQ(reason(failed.error()), "unknown display 'projector' / there are: sRGB");

    options.display.clear();
    options.source = "lin_rec2020";
    failed = apply_display(image, options);
    ASSERT_FALSE(failed);
    EXPECT_NE(reason(failed.error()).find("unknown colour space 'lin_rec2020'"), std::string::npos);

    Image grey(2, 2, 1);
    EXPECT_EQ(apply_display(grey).error().failure, Failure::usage);
}

TEST_F(MediaDisplay, ListsWhatThereIs) {
    const auto displays = list_displays();
    ASSERT_TRUE(displays);
    ASSERT_EQ(displays->size(), 1U);
    EXPECT_EQ(displays->front().name, "sRGB");
    EXPECT_EQ(displays->front().views, (std::vector<std::string>{"Standard", "Filmic", "ACES", "Raw"}));
    const auto spaces = list_spaces();
    ASSERT_TRUE(spaces);
    for (const char* const name : {"ACES2065-1", "ACEScg", "lin_rec709", "raw"})
        EXPECT_NE(std::find(spaces->begin(), spaces->end(), name), spaces->end()) << name;
}

// D65 of Rec.709 is the white of both ACES spaces (Bradford), and red keeps the published matrix' first column.
TEST_F(MediaDisplay, SpacesConvertByTheirMatrices) {
    std::array<float, 6> rgb{1, 1, 1, 1, 0, 0};
    ASSERT_TRUE(convert_space(rgb, "lin_rec709", "ACEScg"));
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(rgb.at(i), 1.0, 1e-5);
    EXPECT_NEAR(rgb[3], 0.61310, 2e-4);
    EXPECT_NEAR(rgb[4], 0.07019, 2e-4);
    EXPECT_NEAR(rgb[5], 0.02062, 2e-4);
    ASSERT_TRUE(convert_space(rgb, "scene_linear", "aces_interchange"));
    EXPECT_NEAR(rgb[0], 1.0, 1e-5);

    std::array<float, 4> four{};
    EXPECT_EQ(convert_space(four, "ACEScg", "raw").error().failure, Failure::usage);
    std::array<float, 3> three{};
    EXPECT_EQ(convert_space(three, "ACEScg", "ACESgc").error().failure, Failure::usage);
}

// The file's scene_linear is ACEScg, so Rec.709 pixels must be converted: red must come out as red on its linear
// Rec.709 display.
TEST_F(MediaDisplay, AFileIsEnteredThroughAcesInterchange) {
    Image image(1, 1, 3);
    image.pixels = {0.5F, 0.0F, 0.25F};
    DisplayOptions options;
    options.config = data + "acescg.ocio";
    const auto used = apply_display(image, options);
    ASSERT_TRUE(used) << reason(used.error());
    EXPECT_EQ(used->source, "aces_interchange");
    EXPECT_EQ(used->display, "monitor");
    EXPECT_EQ(used->view, "linear");
    EXPECT_NEAR(image.pixels[0], 0.5, 1e-4);
    EXPECT_NEAR(image.pixels[1], 0.0, 1e-4);
    EXPECT_NEAR(image.pixels[2], 0.25, 1e-4);

    image.pixels = {0.5F, 0.0F, 0.25F};
    options.source = "scene_linear";
    ASSERT_TRUE(apply_display(image, options));
    EXPECT_GT(image.pixels[0], 0.8F); // ACEScg's red is outside Rec.709
}

TEST_F(MediaDisplay, AFileWithoutInterchangeWarns) {
    Image image(1, 1, 3);
    image.pixels = {0.5F, 0.125F, 0.25F};
    DisplayOptions options;
    options.config = data + "no-interchange.ocio";
    const auto used = apply_display(image, options);
    ASSERT_TRUE(used) << reason(used.error());
    EXPECT_EQ(used->source, "scene_linear");
    ASSERT_EQ(used->diagnostics.size(), 1U);
    EXPECT_EQ(used->diagnostics.front().severity, Severity::warning);
    EXPECT_NEAR(image.pixels[1], 0.25, 1e-5); // the file's view doubles values
}

TEST_F(MediaDisplay, UnreadableFilesFailAndNothingIsPrinted) {
    ::testing::internal::CaptureStderr();
    ::testing::internal::CaptureStdout();
    const auto missing = list_displays(data + "no such file.ocio");
    const auto broken = list_displays(data + "../display_test.cpp");
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().failure, Failure::io);
    EXPECT_EQ(missing.error().diagnostics.back().location.file, data + "no such file.ocio");
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().failure, Failure::malformed);
    EXPECT_EQ(broken.error().diagnostics.back().message.find('\n'), std::string::npos);
}

} // namespace
} // namespace gonio::media
