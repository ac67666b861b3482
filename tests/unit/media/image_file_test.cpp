#include <gonio/media/image_file.hpp>
#include <gonio/media/module.hpp>

#include "../folders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>

namespace gonio::media {
namespace {

class ImageFile : public ::testing::Test {
protected:
    void SetUp() override { set_module_folders({test::modules_folder}); }
};

// Values in [0, 1] that differ by row, column and channel.
Image gradient(int width, int height, int channels) {
    Image image(width, height, channels);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            for (int c = 0; c < channels; ++c)
                image.at(column, row)[c] = (static_cast<float>(row * width + column) + 0.1F * static_cast<float>(c)) /
                                           static_cast<float>(width * height);
    return image;
}

const ImageFormat& format(std::string_view name) {
    const ImageFormat* const found = find_image_format(name);
    EXPECT_NE(found, nullptr) << name;
    return *found;
}

float largest_difference(const Image& a, const Image& b) {
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    float largest = 0.0F;
    for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i)
        largest = std::max(largest, std::abs(a.pixels[i] - b.pixels[i]));
    return largest;
}

const ImageAttribute* find(const DecodedImage& decoded, std::string_view name) {
    for (const ImageAttribute& attribute : decoded.attributes)
        if (attribute.name == name) return &attribute;
    return nullptr;
}

std::string reason(const Error& error) {
    return error.diagnostics.back().message + " / " + error.diagnostics.back().hint;
}

TEST(ImageFormats, FoundByNameExtensionAndPath) {
    EXPECT_EQ(find_image_format("exr")->name, "exr");
    EXPECT_EQ(find_image_format("out/lamp.1.PNG")->name, "png");
    EXPECT_EQ(find_image_format(".tif")->name, "tiff");
    EXPECT_EQ(find_image_format("a.jpg")->name, "jpeg");
    EXPECT_EQ(find_image_format("lamp.svg"), nullptr);
    EXPECT_EQ(find_image_format("out.exr/lamp"), nullptr);
    EXPECT_EQ(find_image_format("exr/png"), nullptr);
    EXPECT_EQ(find_image_format(""), nullptr);
}

struct Stored {
    const char* format;
    Pixel pixel;
    int channels;
    float tolerance;
};

// ctest shows this beside the test's name; gtest would print the bytes of the pointer.
void PrintTo(const Stored& stored, std::ostream* out) {
    *out << stored.format << ' ' << to_text(stored.pixel) << " x " << stored.channels;
}

class ImageFileStored : public ImageFile, public ::testing::WithParamInterface<Stored> {};

TEST_P(ImageFileStored, ComesBackAsWritten) {
    const Stored stored = GetParam();
    const Image image = gradient(9, 5, stored.channels);
    ImageWriteOptions options;
    options.pixel = stored.pixel;
    const auto bytes = encode_image(image, format(stored.format), options);
    ASSERT_TRUE(bytes) << reason(bytes.error());
    ASSERT_NE(sniff_image_format(*bytes), nullptr);
    EXPECT_EQ(sniff_image_format(*bytes)->name, stored.format);
    const auto decoded = decode_image(*bytes);
    ASSERT_TRUE(decoded) << reason(decoded.error());
    EXPECT_EQ(decoded->image.width, 9);
    EXPECT_EQ(decoded->image.height, 5);
    ASSERT_EQ(decoded->image.channels, stored.channels);
    EXPECT_LE(largest_difference(image, decoded->image), stored.tolerance);
}

// Half a step of each kind; half floats below 1 have 11 bits; RGBE shares 8 bits of mantissa between its channels.
INSTANTIATE_TEST_SUITE_P(
    Formats, ImageFileStored,
    ::testing::Values(Stored{"exr", Pixel::float32, 3, 0.0F}, Stored{"exr", Pixel::half, 4, 2.5e-4F},
                      Stored{"exr", Pixel::float32, 1, 0.0F}, Stored{"exr", Pixel::float32, 7, 0.0F},
                      Stored{"png", Pixel::uint8, 1, 0.502F / 255}, Stored{"png", Pixel::uint8, 2, 0.502F / 255},
                      Stored{"png", Pixel::uint8, 3, 0.502F / 255}, Stored{"png", Pixel::uint8, 4, 0.502F / 255},
                      Stored{"png", Pixel::uint16, 3, 0.51F / 65535}, Stored{"tiff", Pixel::float32, 3, 0.0F},
                      Stored{"tiff", Pixel::uint16, 4, 0.51F / 65535}, Stored{"tiff", Pixel::uint8, 1, 0.502F / 255},
                      Stored{"hdr", Pixel::float32, 3, 1.0F / 128}, Stored{"jpeg", Pixel::uint8, 1, 0.05F}),
    [](const auto& instance) {
        return std::string(instance.param.format) + "_" + std::string(to_text(instance.param.pixel)) + "_" +
               std::to_string(instance.param.channels);
    });

TEST_F(ImageFile, FormatsDefaultToTheirOwnPixels) {
    for (const ImageFormat& f : image_formats()) {
        const auto decoded =
            encode_image(gradient(8, 8, 3), f).and_then([](const std::string& bytes) { return decode_image(bytes); });
        ASSERT_TRUE(decoded) << f.name << ": " << reason(decoded.error());
        EXPECT_EQ(to_text(decoded->pixel), to_text(f.pixels.front())) << f.name;
    }
}

TEST_F(ImageFile, EqualInputGivesEqualBytesWithoutClockOrHost) {
    for (const ImageFormat& f : image_formats()) {
        const Image image = gradient(40, 30, 3);
        const auto first = encode_image(image, f);
        const auto second = encode_image(image, f);
        ASSERT_TRUE(first && second) << f.name;
        EXPECT_EQ(*first, *second) << f.name;
        const auto decoded = decode_image(*first);
        ASSERT_TRUE(decoded) << f.name;
        const ImageAttribute* const date = find(*decoded, "DateTime");
        if (date != nullptr) {
            EXPECT_EQ(std::get<std::string>(date->value), "1970:01:01 00:00:00") << f.name;
        }
        EXPECT_EQ(find(*decoded, "HostComputer"), nullptr) << f.name;
    }
}

TEST_F(ImageFile, OpenExrKeepsEveryAttribute) {
    ImageWriteOptions options;
    options.attributes = {{"gonio:cd_per_unit", std::vector<float>{1234.5F}},
                          {"gonio:table", std::vector<float>{1, 2, 3, 4, 5}},
                          {"gonio:size", std::vector<int>{64, 32}},
                          {"gonio:layout", std::string("latlong")},
                          {"Software", std::string("something else")}};
    options.channel_names = {"peak"};
    const auto decoded = encode_image(gradient(4, 4, 1), format("exr"), options).and_then([](const std::string& bytes) {
        return decode_image(bytes);
    });
    ASSERT_TRUE(decoded) << reason(decoded.error());
    for (const ImageAttribute& wanted : options.attributes) {
        const ImageAttribute* const found = find(*decoded, wanted.name);
        ASSERT_NE(found, nullptr) << wanted.name;
        EXPECT_EQ(found->value, wanted.value) << wanted.name;
    }
    EXPECT_EQ(decoded->channel_names, std::vector<std::string>{"peak"});
}

TEST_F(ImageFile, SoftwareNamesGonioAndDescriptionsSurvive) {
    for (const char* const name : {"exr", "png", "tiff"}) {
        ImageWriteOptions options;
        options.attributes = {{"ImageDescription", std::string("a downlight")},
                              {"gonio:unheard-of", std::vector<float>{1.0F, 2.0F}}};
        const auto decoded =
            encode_image(gradient(4, 4, 3), format(name), options).and_then([](const std::string& bytes) {
                return decode_image(bytes);
            });
        ASSERT_TRUE(decoded) << name << ": " << reason(decoded.error());
        const ImageAttribute* const software = find(*decoded, "Software");
        ASSERT_NE(software, nullptr) << name;
        EXPECT_EQ(std::get<std::string>(software->value).rfind("gonio ", 0), 0U) << name;
        const ImageAttribute* const description = find(*decoded, "ImageDescription");
        ASSERT_NE(description, nullptr) << name;
        EXPECT_EQ(std::get<std::string>(description->value), "a downlight") << name;
    }
}

TEST_F(ImageFile, IntegersRoundAndCut) {
    Image image(4, 1, 1);
    image.pixels = {-0.5F, 2.0F, 0.5F, 127.4F / 255.0F};
    ImageWriteOptions options;
    options.pixel = Pixel::uint8;
    const auto decoded = encode_image(image, format("png"), options).and_then([](const std::string& bytes) {
        return decode_image(bytes);
    });
    ASSERT_TRUE(decoded);
    EXPECT_FLOAT_EQ(decoded->image.pixels[0], 0.0F);
    EXPECT_FLOAT_EQ(decoded->image.pixels[1], 1.0F);
    EXPECT_FLOAT_EQ(decoded->image.pixels[2], 128.0F / 255.0F);
    EXPECT_FLOAT_EQ(decoded->image.pixels[3], 127.0F / 255.0F);
}

TEST_F(ImageFile, ColourIsNotDividedByAlpha) {
    Image image(1, 1, 4);
    image.pixels = {0.4F, 0.6F, 1.0F, 0.2F};
    for (const char* const name : {"png", "tiff"}) {
        ImageWriteOptions options;
        options.pixel = Pixel::uint16;
        const auto decoded = encode_image(image, format(name), options).and_then([](const std::string& bytes) {
            return decode_image(bytes);
        });
        ASSERT_TRUE(decoded) << name;
        EXPECT_LE(largest_difference(image, decoded->image), 1e-5F) << name;
    }
}

TEST_F(ImageFile, HalfRefusesWhatItCannotHoldOrSaturates) {
    Image image(3, 1, 1);
    image.pixels = {65504.0F, -1e6F, std::numeric_limits<float>::infinity()};
    ImageWriteOptions options;
    options.pixel = Pixel::half;
    const auto refused = encode_image(image, format("exr"), options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().failure, Failure::unsupported);
    EXPECT_NE(reason(refused.error()).find("65504"), std::string::npos);

    options.saturate = true;
    const auto decoded = encode_image(image, format("exr"), options).and_then([](const std::string& bytes) {
        return decode_image(bytes);
    });
    ASSERT_TRUE(decoded) << reason(decoded.error());
    EXPECT_EQ(decoded->image.pixels[0], 65504.0F);
    EXPECT_EQ(decoded->image.pixels[1], -65504.0F);
    EXPECT_TRUE(std::isinf(decoded->image.pixels[2]));
}

TEST_F(ImageFile, WhatAFormatCannotHoldIsSaid) {
    const auto hdr = encode_image(gradient(4, 4, 1), format("hdr"));
    ASSERT_FALSE(hdr);
    EXPECT_EQ(hdr.error().failure, Failure::unsupported);
    EXPECT_NE(reason(hdr.error()).find("Radiance HDR holds 3 channels, not 1"), std::string::npos);

    ImageWriteOptions half;
    half.pixel = Pixel::half;
    const auto png = encode_image(gradient(4, 4, 3), format("png"), half);
    ASSERT_FALSE(png);
    EXPECT_EQ(png.error().failure, Failure::unsupported);

    ImageWriteOptions packed;
    packed.compression = "zib";
    const auto exr = encode_image(gradient(4, 4, 3), format("exr"), packed);
    ASSERT_FALSE(exr);
    EXPECT_EQ(exr.error().failure, Failure::usage);
    EXPECT_NE(reason(exr.error()).find("did you mean 'zip'"), std::string::npos);

    EXPECT_EQ(encode_image(Image{}, format("exr")).error().failure, Failure::usage);
    Image torn = gradient(4, 4, 3);
    torn.pixels.pop_back();
    EXPECT_EQ(encode_image(torn, format("exr")).error().failure, Failure::internal);
    ImageWriteOptions names;
    names.channel_names = {"R", "G"};
    EXPECT_EQ(encode_image(gradient(4, 4, 3), format("exr"), names).error().failure, Failure::usage);
}

TEST_F(ImageFile, CompressionReachesTheFile) {
    for (const char* const compression : {"none", "piz", "zip"}) {
        ImageWriteOptions options;
        options.compression = compression;
        const auto decoded =
            encode_image(gradient(16, 16, 3), format("exr"), options).and_then([](const std::string& bytes) {
                return decode_image(bytes);
            });
        ASSERT_TRUE(decoded) << compression;
        const ImageAttribute* const found = find(*decoded, "compression");
        ASSERT_NE(found, nullptr);
        EXPECT_EQ(std::get<std::string>(found->value), compression);
    }
}

TEST_F(ImageFile, SrgbTagReachesThePng) {
    ImageWriteOptions options;
    options.color_space = "sRGB";
    const auto tagged = encode_image(gradient(4, 4, 3), format("png"), options);
    ASSERT_TRUE(tagged);
    EXPECT_NE(tagged->find("sRGB"), std::string::npos);
    const auto plain = encode_image(gradient(4, 4, 3), format("png"));
    ASSERT_TRUE(plain);
    EXPECT_EQ(plain->find("sRGB"), std::string::npos);
}

TEST_F(ImageFile, TornFilesAreMalformedAndSilent) {
    EXPECT_EQ(decode_image("no picture at all").error().failure, Failure::malformed);
    EXPECT_EQ(decode_image("").error().failure, Failure::malformed);
    for (const ImageFormat& f : image_formats()) {
        const auto bytes = encode_image(gradient(64, 64, 3), f);
        ASSERT_TRUE(bytes) << f.name;
        ::testing::internal::CaptureStderr();
        ::testing::internal::CaptureStdout();
        // JPEG readers fill a truncated tail with grey, by design of the format; a truncated head must fail.
        const auto torn = decode_image(std::string_view(*bytes).substr(0, f.name == "jpeg" ? 30 : bytes->size() / 2));
        const std::string out = ::testing::internal::GetCapturedStdout();
        const std::string err = ::testing::internal::GetCapturedStderr();
        EXPECT_EQ(out, "") << f.name;
        EXPECT_EQ(err, "") << f.name;
        ASSERT_FALSE(torn) << f.name;
        EXPECT_EQ(torn.error().failure, Failure::malformed) << f.name;
    }
}

// No changed bit and no missing byte of a PNG may go unnoticed.
TEST_F(ImageFile, DamagedPngsAreMalformedAndSilent) {
    const auto bytes = encode_image(gradient(3, 2, 3), format("png"));
    ASSERT_TRUE(bytes);
    ::testing::internal::CaptureStderr();
    for (std::size_t i = 8; i < bytes->size(); ++i) {
        std::string damaged = *bytes;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
        EXPECT_FALSE(decode_image(damaged)) << i;
        EXPECT_FALSE(decode_image(std::string_view(*bytes).substr(0, i))) << i;
    }
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST_F(ImageFile, TooLargeAPictureIsRefused) {
    const auto bytes = encode_image(gradient(64, 64, 3), format("png"));
    ASSERT_TRUE(bytes);
    EXPECT_TRUE(decode_image(*bytes, 64 * 64 * 3));
    const auto refused = decode_image(*bytes, 64 * 64 * 3 - 1);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().failure, Failure::malformed);
}

} // namespace
} // namespace gonio::media
