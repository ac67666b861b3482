#include <gonio/color/rgb_space.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/media/environment_file.hpp>
#include <gonio/media/module.hpp>
#include <gonio/sky/environment_resample.hpp>

#include "../folders.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace gonio::media {
namespace {

class EnvironmentFile : public ::testing::Test {
protected:
    void SetUp() override { set_module_folders({test::modules_folder}); }
};

const ImageFormat& format(std::string_view name) {
    return *find_image_format(name);
}

EnvironmentMap sky_map(EnvironmentLayout layout, int side) {
    const Sky sky = resolve_sky(parse_sky_description("cie:12,sun=200/40,horizontal=10klx,ground=0.2").value()).value();
    return rendered(sky, environment_grid(layout, side).value());
}

std::string bytes_of(const Image& image, std::string_view name, Pixel pixel) {
    ImageWriteOptions options;
    options.pixel = pixel;
    return encode_image(image, format(name), options).value();
}

Result<EnvironmentImage> decoded(std::string_view bytes, const EnvironmentReadOptions& options = {}) {
    Diagnostics said;
    return decode_environment(bytes, options, said);
}

std::string reason(const Result<EnvironmentImage>& result) {
    return result ? "" : result.error().diagnostics.back().message;
}

TEST_F(EnvironmentFile, ComesBack) {
    for (const EnvironmentLayoutInfo& info : environment_layouts()) {
        EnvironmentMap map = sky_map(info.layout, 32);
        map.set_nits_per_unit(3.5);
        const auto bytes = encode_environment(map, format("exr"), Pixel::float32, {});
        ASSERT_TRUE(bytes);
        const auto back = decoded(*bytes);
        ASSERT_TRUE(back) << reason(back);
        EXPECT_EQ(back->map.image().pixels, map.image().pixels);
        EXPECT_EQ(back->map.nits_per_unit(), 3.5);
        EXPECT_EQ(back->map.grid().layout(), info.layout);
        EXPECT_EQ(back->pixel, Pixel::float32);
    }
}

// A scale goes into the pixels and out of the image: the light stays. What as_stored() says is what comes back.
TEST_F(EnvironmentFile, HoldsWhatItIsSaidToHold) {
    const EnvironmentMap map = sky_map(EnvironmentLayout::latlong, 32);
    const double before = glm::dot(map.light(), rec709_luminance);
    struct Case {
        const char* name;
        Pixel pixel;
        double nits_per_unit;
        double tolerance;
    };
    for (const Case& of : {Case{"exr", Pixel::float32, 64.0, 1e-7}, Case{"exr", Pixel::half, 64.0, 3e-5},
                           Case{"exr", Pixel::half, 1e7, 3e-4}, Case{"hdr", Pixel::float32, 1.0, 3e-4},
                           Case{"tiff", Pixel::float32, 1.0, 1e-7}}) {
        const EnvironmentMap stored = as_stored(map, of.nits_per_unit, format(of.name), of.pixel);
        const auto bytes = encode_environment(stored, format(of.name), of.pixel, {});
        ASSERT_TRUE(bytes);
        const auto back = decoded(*bytes);
        ASSERT_TRUE(back) << reason(back);
        EXPECT_EQ(back->map.image().pixels, stored.image().pixels) << of.name << to_text(of.pixel);
        EXPECT_EQ(back->map.nits_per_unit(), of.name == std::string("exr") ? of.nits_per_unit : 1.0);
        EXPECT_NEAR(glm::dot(back->map.light(), rec709_luminance) / before, 1.0, of.tolerance) << of.name;
    }
    // Values next to a power of two, and small channels beside a large one.
    Image image(16, 8, 3);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = std::ldexp(1.0F - 0.0005F * static_cast<float>(i % 7), static_cast<int>(i % 19) - 9);
    const EnvironmentMap edges = EnvironmentMap::of_valid(
        EnvironmentGrid::create(EnvironmentLayout::latlong, 16, 8).value(), std::move(image), 1.0);
    for (const auto& [name, pixel] : {std::pair{"hdr", Pixel::float32}, std::pair{"exr", Pixel::half}}) {
        const EnvironmentMap stored = as_stored(edges, 1.0, format(name), pixel);
        const auto back = decoded(encode_environment(stored, format(name), pixel, {}).value());
        ASSERT_TRUE(back) << reason(back);
        EXPECT_EQ(back->map.image().pixels, stored.image().pixels) << name;
    }
}

TEST_F(EnvironmentFile, ColorsBecomeRec709) {
    Image image(16, 8, 3);
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
        image.pixels[i] = 0.9F;
        image.pixels[i + 1] = 1.0F;
        image.pixels[i + 2] = 0.8F;
    }
    image.at(3, 3)[0] = 0.0F; // a green that Rec.709 does not have
    image.at(3, 3)[2] = 0.0F;
    const std::string bytes = bytes_of(image, "exr", Pixel::float32);
    EnvironmentReadOptions options;
    options.space = "acescg";
    Diagnostics said;
    const auto read = decode_environment(bytes, options, said);
    ASSERT_TRUE(read) << reason(read);
    const RgbSpace& acescg = *find_rgb_space("acescg");
    const glm::dvec3 expected = find_rgb_space("rec709")->from_xyz * (acescg.to_xyz * glm::dvec3(0.9F, 1.0F, 0.8F));
    EXPECT_LT(glm::length(read->map.texel({0, 0}) - expected), 1e-6);
    ASSERT_EQ(said.size(), 1U);
    EXPECT_EQ(said[0].code, "RES0104");
    EXPECT_EQ(said[0].message, "1 of 128 pixels lie outside Rec.709: moved into it at the same luminance");
    EXPECT_NEAR(glm::dot(read->map.texel({3, 3}), rec709_luminance), luminance_row(acescg).y, 1e-6);
    options.space = "acescgg";
    const auto unknown = decoded(bytes, options);
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().failure, Failure::usage);
    EXPECT_EQ(unknown.error().diagnostics.back().hint, "did you mean 'acescg'?");
}

// OpenEXR files state their space by chromaticities; a space that is named wins.
TEST_F(EnvironmentFile, StatedChromaticitiesAreItsSpace) {
    Image image(16, 8, 3);
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
        image.pixels[i] = 0.9F;
        image.pixels[i + 1] = 1.0F;
        image.pixels[i + 2] = 0.8F;
    }
    ImageWriteOptions write;
    write.pixel = Pixel::float32;
    const auto read_with = [&](std::vector<float> xy, const std::string& space) {
        write.attributes = {{"chromaticities", std::move(xy)}};
        EnvironmentReadOptions options;
        options.space = space;
        return decoded(encode_image(image, format("exr"), write).value(), options);
    };
    const std::vector<float> rec2020{0.708F, 0.292F, 0.170F, 0.797F, 0.131F, 0.046F, 0.3127F, 0.3290F};
    const auto stated = read_with(rec2020, "");
    ASSERT_TRUE(stated) << reason(stated);
    const glm::dvec3 expected =
        find_rgb_space("rec709")->from_xyz * (find_rgb_space("rec2020")->to_xyz * glm::dvec3(0.9F, 1.0F, 0.8F));
    EXPECT_LT(glm::length(stated->map.texel({2, 2}) - expected), 1e-5);
    EXPECT_EQ(read_with(rec2020, "rec709")->map.image().pixels, image.pixels);
    EXPECT_EQ(read_with({0.64F, 0.33F, 0.3F, 0.6F, 0.15F, 0.06F, 0.3127F, 0.329F}, "")->map.image().pixels,
              image.pixels);
    EXPECT_FALSE(read_with({0.3F, 0.3F, 0.3F, 0.3F, 0.3F, 0.3F, 0.3F, 0.3F}, ""));
    EXPECT_FALSE(read_with({0.3F, 0.0F, NAN, 0.3F, 0.3F, -0.3F, 0.3F, 1e30F}, ""));
}

TEST_F(EnvironmentFile, GreyIsWhiteLight) {
    Image image(16, 8, 1);
    std::fill(image.pixels.begin(), image.pixels.end(), 2.0F);
    const auto read = decoded(bytes_of(image, "exr", Pixel::half));
    ASSERT_TRUE(read) << reason(read);
    EXPECT_EQ(read->map.texel({5, 5}), glm::dvec3(2.0));
    EXPECT_EQ(read->pixel, Pixel::half);
    Image with_alpha(16, 8, 4);
    std::fill(with_alpha.pixels.begin(), with_alpha.pixels.end(), 0.5F);
    const auto rgb = decoded(bytes_of(with_alpha, "exr", Pixel::float32));
    ASSERT_TRUE(rgb) << reason(rgb);
    EXPECT_EQ(rgb->map.texel({5, 5}), glm::dvec3(0.5));
}

TEST_F(EnvironmentFile, HostileFilesAreRefused) {
    EXPECT_EQ(decoded("").error().failure, Failure::malformed);
    EXPECT_EQ(decoded("no picture").error().failure, Failure::malformed);
    const EnvironmentMap map = sky_map(EnvironmentLayout::latlong, 32);
    for (const char* name : {"exr", "hdr"}) {
        const std::string bytes = encode_environment(map, format(name), Pixel::float32, {}).value();
        // Nothing of a file that is cut off is taken for light.
        for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 97)
            EXPECT_FALSE(decoded(std::string_view(bytes).substr(0, size))) << name << " " << size;
    }
    EXPECT_EQ(reason(decoded(bytes_of(Image(30, 16, 3), "exr", Pixel::half))),
              "30x16 pixels are not an environment of any layout");
    EnvironmentReadOptions cross;
    cross.layout = EnvironmentLayout::cube_cross;
    EXPECT_EQ(reason(decoded(bytes_of(Image(32, 16, 3), "exr", Pixel::half), cross)),
              "an environment in the layout cube-cross is 4:3, not 32x16 pixels");
    EXPECT_EQ(decoded(bytes_of(Image(32, 16, 3), "png", Pixel::uint8)).error().failure, Failure::unsupported);
    Image bad(32, 16, 3);
    bad.at(7, 2)[1] = std::nanf("");
    EXPECT_EQ(reason(decoded(bytes_of(bad, "exr", Pixel::float32))),
              "1 pixel cannot be light (1 not a number), the first in column 7, row 2");
    EnvironmentReadOptions black;
    black.bad_pixels = BadPixels::black;
    EXPECT_TRUE(decoded(bytes_of(bad, "exr", Pixel::float32), black));
}

// A head that announces 16384 x 8192 pixels, and nothing behind it: refused for its size, before memory is taken.
TEST_F(EnvironmentFile, HugeImagesAreRefusedByTheirHead) {
    const std::string head = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8192 +X 16384\n" + std::string(64, '\x02');
    const auto refused = decoded(head);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().failure, Failure::unsupported);
    EXPECT_EQ(reason(refused), "the image has 16384x8192 pixels with 3 channels: more than 134217728 values, the limit "
                               "'environment-values'");
    const auto size = picture_dimensions(head);
    ASSERT_TRUE(size);
    EXPECT_EQ(size->width, 16384);
    EXPECT_EQ(size->values(), 3.0 * 16384 * 8192);
}

} // namespace
} // namespace gonio::media
