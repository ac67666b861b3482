#include <gonio/color/rgb_space.hpp>
#include <gonio/light/shape.hpp>
#include <gonio/media/image_file.hpp>
#include <gonio/media/light_image_file.hpp>
#include <gonio/media/module.hpp>

#include "../folders.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace gonio::media {
namespace {

class LightImageFile : public ::testing::Test {
protected:
    void SetUp() override {
        set_module_folders({test::modules_folder});
        // Tests run side by side.
        const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
        folder_ = std::filesystem::path(::testing::TempDir()) / ("gonio-light-image-" + name);
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string write(const std::string& name, const std::string& bytes) const {
        const std::string path = (folder_ / name).string();
        std::ofstream(path, std::ios::binary) << bytes;
        return path;
    }
    std::string write(const std::string& name, const Image& image, const ImageWriteOptions& options = {}) const {
        return write(name, encode_image(image, *find_image_format(name), options).value());
    }

    std::filesystem::path folder_;
};

Image image_of(int channels, const std::vector<float>& pixels) {
    Image image(static_cast<int>(pixels.size()) / channels, 1, channels);
    image.pixels = pixels;
    return image;
}

LightImage read(const std::string& path) {
    Diagnostics diagnostics;
    return read_light_image_file(path, diagnostics).value();
}

std::string refusal(const std::string& path) {
    Diagnostics diagnostics;
    const Result<LightImage> image = read_light_image_file(path, diagnostics);
    return image ? std::string("read") : to_text(image.error().diagnostics.back());
}

TEST_F(LightImageFile, DecodesTheValuesOfDisplays) {
    const LightImage grey = read(write("grey.png", image_of(1, {1.0F, 128.0F / 255.0F})));
    EXPECT_FALSE(grey.is_colored());
    EXPECT_NEAR(grey.luminance()->pixel({0.75, 0.5}), decode_srgb(128.0 / 255.0), 1e-6);
    const LightImage same = read(write("same.png", image_of(3, {1.0F, 1.0F, 1.0F, 0.5F, 0.5F, 0.5F})));
    EXPECT_FALSE(same.is_colored());
    const LightImage transparent =
        read(write("alpha.png", image_of(4, {1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 0.2F})));
    EXPECT_NEAR(transparent.luminance()->pixel({0.75, 0.5}), 0.2, 1e-6);
}

TEST_F(LightImageFile, TakesFloatsAsTheyAre) {
    ImageWriteOptions options;
    options.pixel = Pixel::float32;
    const LightImage image = read(write("panel.exr", image_of(3, {4.0F, 4.0F, 4.0F, 1.0F, 1.0F, 1.0F}), options));
    EXPECT_NEAR(image.luminance()->pixel({0.75, 0.5}), 0.25, 1e-6);
    EXPECT_NEAR(image.luminance()->peak(), 4.0, 1e-6);
    const LightImage colored = read(write("red.exr", image_of(3, {1.0F, 0.0F, 0.0F, 1.0F, 1.0F, 1.0F}), options));
    EXPECT_TRUE(colored.is_colored());
    EXPECT_NEAR(colored.colors()[1].plane->mean(), 0.5, 1e-6);
}

TEST_F(LightImageFile, SaysWhatIsWrong) {
    EXPECT_NE(refusal((folder_ / "none.png").string()).find("cannot read"), std::string::npos);
    EXPECT_NE(refusal(write("text.png", "not a picture")).find("not a picture in a known format"), std::string::npos);
    EXPECT_NE(refusal(write("empty.exr", "")).find("empty.exr"), std::string::npos);
    const std::string whole =
        encode_image(image_of(3, std::vector<float>(30000, 0.5F)), *find_image_format("png")).value();
    EXPECT_NE(refusal(write("cut.png", whole.substr(0, whole.size() / 2))).find("cut.png"), std::string::npos);
    EXPECT_NE(refusal(write("black.png", image_of(1, {0.0F, 0.0F}))).find("the image is black"), std::string::npos);
    ImageWriteOptions options;
    options.pixel = Pixel::float32;
    EXPECT_NE(refusal(write("nan.exr", image_of(1, {1.0F, std::numeric_limits<float>::quiet_NaN()}), options))
                  .find("column 2, row 1"),
              std::string::npos);
}

TEST_F(LightImageFile, IsReadAsAMask) {
    enable_light_images();
    const std::string path = write("gobo.png", image_of(1, {1.0F, 0.0F}));
    Shape shape = parse_shape("frustum:h=60deg,v=40deg,mask=" + path).value();
    Diagnostics diagnostics;
    ASSERT_TRUE(load_profile(shape, diagnostics));
    EXPECT_NE(mask_of(shape).image, nullptr);
    EXPECT_EQ(mask_of(shape).web, nullptr);
    Shape sphere = parse_shape("sphere:r=3cm,mask=" + path).value();
    const Result<void> refused = load_profile(sphere, diagnostics);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().diagnostics.back().message, "a sphere does not take an image as a mask");
    Shape wide = parse_shape("spot:outer=90deg,mask=" + path).value();
    EXPECT_FALSE(load_profile(wide, diagnostics));
}

} // namespace
} // namespace gonio::media
