// gonio-writers.so against gonio-image.so: both write the same pixels and attributes, as OpenImageIO reads them.
#include <gonio/base/parallel.hpp>
#include <gonio/media/detail/open_module.hpp>
#include <gonio/media/image_file.hpp>
#include <gonio/media/module.hpp>

#include "../folders.hpp"
#include "../scaled.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace gonio::media {
namespace {

struct Written {
    int status = -1;
    std::string bytes;
    std::string message;
};

Written write(const abi::ImageModule& module, const abi::EncodeRequest& request) {
    abi::EncodeReply reply{};
    Written written;
    written.status = module.encode(&request, &reply);
    if (written.status == 0) {
        written.bytes.assign(reinterpret_cast<const char*>(reply.bytes), reply.size);
        module.release_encoded(reply.owner);
    } else {
        written.message = reply.message;
    }
    return written;
}

// Values that rounding, clipping and half find hard, and random ones.
std::vector<float> values(std::size_t count, bool integers) {
    const std::vector<float> hard{0.0F,
                                  -0.0F,
                                  1.0F,
                                  0.5F / 255.0F,
                                  1.5F / 255.0F,
                                  0.4999F / 65535.0F,
                                  -1.0F,
                                  2.0F,
                                  5.96e-8F,
                                  2.98e-8F,
                                  6.1e-5F,
                                  65504.0F,
                                  65519.0F,
                                  -65504.0F,
                                  0.33325195F,
                                  1.0F / 3.0F,
                                  std::numeric_limits<float>::infinity(),
                                  -std::numeric_limits<float>::infinity(),
                                  std::numeric_limits<float>::denorm_min()};
    std::mt19937 random(7);
    std::vector<float> all;
    for (std::size_t i = 0; i < count; ++i) {
        const auto draw = static_cast<float>(random()) / 4294967296.0F;
        const float any = integers ? draw : std::ldexp(draw - 0.5F, static_cast<int>(random() % 60) - 32);
        all.push_back(i % 3 == 0 ? hard[i / 3 % hard.size()] : std::abs(any) < 65000.0F ? any : 1.0F);
    }
    return all;
}

// OpenImageIO also stores the word "Linear" as a text of its own, and from the gamma alone it reads "linear".
bool same(const decltype(ImageAttribute::value)& mine, const decltype(ImageAttribute::value)& other) {
    return mine == other ||
           (mine == decltype(ImageAttribute::value)("linear") && other == decltype(ImageAttribute::value)("Linear"));
}

bool run_loop(void* threads, std::size_t count, void (*work)(void*, std::size_t), void* data) {
    parallel_for(count, *static_cast<const unsigned*>(threads), [&](std::size_t i) { work(data, i); });
    return true;
}

class WritersModule : public ::testing::Test {
protected:
    void SetUp() override { set_module_folders({test::modules_folder}); }

    // Both write, and their files are read alike. Returns the bytes of the writers' one.
    std::string compare(const char* format, std::int32_t pixel, std::int32_t width, std::int32_t height,
                        const std::vector<const char*>& channels, const std::vector<abi::Attribute>& attributes) {
        const std::vector<float> pixels =
            values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * channels.size(),
                   pixel == abi::pixel_uint8 || pixel == abi::pixel_uint16);
        unsigned threads = 1;
        const abi::EncodeRequest request{format,
                                         width,
                                         height,
                                         static_cast<std::int32_t>(channels.size()),
                                         pixels.data(),
                                         pixel,
                                         channels.data(),
                                         attributes.data(),
                                         attributes.size(),
                                         {&threads, run_loop}};
        const Written by_writers = write(*detail::writers_module().value(), request);
        const Written by_image = write(*detail::image_module().value(), request);
        EXPECT_EQ(by_writers.status, 0) << by_writers.message;
        EXPECT_EQ(by_image.status, 0) << by_image.message;
        const Result<DecodedImage> one = decode_image(by_writers.bytes);
        const Result<DecodedImage> other = decode_image(by_image.bytes);
        EXPECT_TRUE(one && other);
        if (!one || !other) return {};
        EXPECT_EQ(one->pixel, other->pixel);
        EXPECT_EQ(one->channel_names, other->channel_names);
        EXPECT_EQ(one->image.pixels.size(), other->image.pixels.size());
        std::size_t different = 0;
        for (std::size_t i = 0; i < one->image.pixels.size(); ++i)
            if (std::bit_cast<std::uint32_t>(one->image.pixels[i]) !=
                std::bit_cast<std::uint32_t>(other->image.pixels[i]))
                ++different;
        EXPECT_EQ(different, 0);
        EXPECT_EQ(one->attributes.size(), other->attributes.size());
        for (const ImageAttribute& attribute : other->attributes) {
            bool found = false;
            for (const ImageAttribute& mine : one->attributes)
                found = found || (mine.name == attribute.name && same(mine.value, attribute.value));
            EXPECT_TRUE(found) << attribute.name;
        }
        for (threads = 1; threads <= 3; ++threads)
            EXPECT_EQ(write(*detail::writers_module().value(), request).bytes, by_writers.bytes) << threads;
        return by_writers.bytes;
    }
};

constexpr float numbers[]{0.25F, -3.0F, 1e30F, 7.0F};
constexpr std::int32_t whole[]{-4, 5, 1 << 30};

abi::Attribute text(const char* name, const char* value) {
    return {name, abi::attribute_text, 0, value, nullptr, nullptr};
}

// Bands in which each of the five filters of a row is the best, and noise.
TEST_F(WritersModule, FilteredRowsOfPngAreReadBack) {
    constexpr std::int32_t width = 97;
    constexpr std::int32_t height = 120;
    std::mt19937 random(9);
    for (const std::int32_t pixel : {abi::pixel_uint8, abi::pixel_uint16})
        for (std::size_t channels = 1; channels <= 4; ++channels) {
            const double greatest = pixel == abi::pixel_uint8 ? 255.0 : 65535.0;
            std::vector<float> pixels;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    for (std::size_t c = 0; c < channels; ++c) {
                        const double ramps[]{0.0,
                                             x / 96.0,
                                             y % 20 / 19.0,
                                             std::fabs(std::sin(0.11 * x + 0.13 * y)),
                                             (x * 0.5 + 3.0 * (y % 20)) / 110.0,
                                             static_cast<double>(random()) / 4294967295.0};
                        const double shade = std::fmod(ramps[y / 20] + 0.07 * static_cast<double>(c), 1.0);
                        pixels.push_back(static_cast<float>(std::floor(shade * greatest) / greatest));
                    }
            const std::vector<const char*> names{"R", "G", "B", "A"};
            unsigned threads = 1;
            const abi::EncodeRequest request{"png",
                                             width,
                                             height,
                                             static_cast<std::int32_t>(channels),
                                             pixels.data(),
                                             pixel,
                                             names.data(),
                                             nullptr,
                                             0,
                                             {&threads, run_loop}};
            const Written written = write(*detail::writers_module().value(), request);
            ASSERT_EQ(written.status, 0) << written.message;
            const Result<DecodedImage> read = decode_image(written.bytes);
            ASSERT_TRUE(read.has_value());
            ASSERT_EQ(read->image.pixels.size(), pixels.size());
            for (std::size_t i = 0; i < pixels.size(); ++i)
                ASSERT_EQ(std::lround(read->image.pixels[i] * greatest), std::lround(pixels[i] * greatest)) << i;
        }
}

TEST_F(WritersModule, WritesOpenExrAsOpenImageIoDoes) {
    const std::array<std::vector<const char*>, 4> names{{
        {"a name of a channel with more than thirty-one letters", "B", "A"},
        {"Y"},
        {"R", "G", "B"},
        {"R", "G", "B", "A"},
    }};
    for (const char* const compression : {"", "none", "rle", "zip", "zips", "piz"})
        for (const std::int32_t pixel : {abi::pixel_half, abi::pixel_float})
            for (const std::vector<const char*>& channels : test::scaled(names)) {
                SCOPED_TRACE(std::string(compression) + ' ' + std::to_string(pixel) + ' ' + channels.front());
                std::vector<abi::Attribute> attributes{
                    text("Software", "gonio"),
                    text("DateTime", "1970:01:01 00:00:00"),
                    text("ImageDescription", "une lumière"),
                    text("Copyright", "nobody"),
                    text("oiio:ColorSpace", "Linear"),
                    text("gonio:text", ""),
                    {"gonio:number", abi::attribute_floats, 1, nullptr, numbers, nullptr},
                    {"gonio:numbers", abi::attribute_floats, 4, nullptr, numbers, nullptr},
                    {"gonio:integer", abi::attribute_ints, 1, nullptr, nullptr, whole},
                    {"gonio:pair", abi::attribute_ints, 2, nullptr, nullptr, whole},
                    {"gonio:triple", abi::attribute_ints, 3, nullptr, nullptr, whole}};
                if (*compression != 0) attributes.push_back(text("compression", compression));
                for (const auto& [width, height] :
                     {std::pair{1, 1}, std::pair{37, 35}, std::pair{64, 32}, std::pair{3, 4500}})
                    compare("openexr", pixel, width, height, channels, attributes);
            }
}

TEST_F(WritersModule, WritesPngAsOpenImageIoDoes) {
    const std::vector<const char*> all{"R", "G", "B", "A"};
    for (const std::int32_t pixel : {abi::pixel_uint8, abi::pixel_uint16})
        for (std::size_t channels = 1; channels <= 4; ++channels)
            for (const char* const space : {"sRGB", "Linear"}) {
                SCOPED_TRACE(std::to_string(pixel) + ' ' + std::to_string(channels) + ' ' + space);
                const std::vector<abi::Attribute> attributes{text("Software", "gonio"), text("oiio:ColorSpace", space),
                                                             text("ImageDescription", "a lamp"),
                                                             text("Artist", "somebody"), text("Copyright", "nobody")};
                const std::vector<const char*> names =
                    channels <= 2 ? std::vector<const char*>{"Y", "A"} : std::vector<const char*>(all);
                for (const auto& [width, height] : {std::pair{1, 1}, std::pair{37, 35}})
                    compare("png", pixel, width, height,
                            {names.begin(), names.begin() + static_cast<std::ptrdiff_t>(channels)}, attributes);
            }
}

TEST_F(WritersModule, RefusesWhatItDoesNotHave) {
    const abi::ImageModule& module = *detail::writers_module().value();
    const float pixel = 0.5F;
    const char* const name = "Y";
    const abi::Attribute dwaa = text("compression", "dwaa");
    unsigned threads = 1;
    const abi::ParallelLoop loop{&threads, run_loop};
    EXPECT_EQ(write(module, {"tiff", 1, 1, 1, &pixel, abi::pixel_float, &name, nullptr, 0, loop}).status,
              abi::unsupported);
    const Written lossy = write(module, {"openexr", 1, 1, 1, &pixel, abi::pixel_float, &name, &dwaa, 1, loop});
    EXPECT_EQ(lossy.status, abi::unsupported);
    EXPECT_EQ(lossy.message, "no compression 'dwaa'");
    abi::DecodeReply reply{};
    const abi::DecodeRequest request{"png", nullptr, 0, 0};
    EXPECT_EQ(module.decode(&request, &reply), abi::unsupported);
    // The format's own writer takes over.
    Image image(2, 2, 1);
    ImageWriteOptions options;
    options.compression = "dwaa";
    EXPECT_TRUE(encode_image(image, *find_image_format("exr"), options));
}

} // namespace
} // namespace gonio::media
