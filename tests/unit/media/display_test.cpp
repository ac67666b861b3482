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
              "unknown view 'Standart' / did you mean 'Standard'? there are: Standard, ACES, Raw");

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
    EXPECT_EQ(displays->front().views, (std::vector<std::string>{"Standard", "ACES", "Raw"}));
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
