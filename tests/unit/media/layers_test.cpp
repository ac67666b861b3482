#include <gonio/media/layers.hpp>
#include <gonio/media/module.hpp>

#include "../folders.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace gonio::media {
namespace {

class Layers : public ::testing::Test {
protected:
    void SetUp() override { set_module_folders({test::modules_folder}); }
};

Image numbered(int channels, float first) {
    Image image(5, 3, channels);
    for (float& value : image.pixels)
        value = first++;
    return image;
}

TEST_F(Layers, ComeBackFromAFileAsTheyWere) {
    LayeredImage layered = LayeredImage::create(5, 3, 7).value();
    const std::array pictures{numbered(3, 1.0F), numbered(3, 70000.0F), numbered(1, -4.5F)};
    layered.add("", pictures[0]);
    layered.add("key", pictures[1]);
    layered.add("lux", pictures[2]);
    const std::string bytes = layered.encode({{"gonio:unit", std::string("cd/m2")}}).value();
    EXPECT_EQ(bytes, layered.encode({{"gonio:unit", std::string("cd/m2")}}).value());
    const DecodedImage file = decode_image(bytes).value();
    EXPECT_EQ(file.image.channels, 7);
    EXPECT_EQ(find_layer(file, "").value().pixels, pictures[0].pixels);
    EXPECT_EQ(find_layer(file, "key").value().pixels, pictures[1].pixels);
    EXPECT_EQ(find_layer(file, "lux").value().pixels, pictures[2].pixels);
    EXPECT_FALSE(find_layer(file, "fill").has_value());
}

TEST_F(Layers, AreRefusedBeforeMemoryIsTaken) {
    EXPECT_FALSE(LayeredImage::create(16384, 16384, 3).has_value());
    EXPECT_FALSE(LayeredImage::create(512, 512, 3003).has_value());
    EXPECT_FALSE(LayeredImage::create(0, 5, 3).has_value());
    EXPECT_TRUE(LayeredImage::create(512, 512, 3).has_value());
}

TEST(LayerNames, ArePlainAndUnlike) {
    const std::vector<std::string> names{"key", "fill light", "key", "a.b.c", "", "déjà", "sum", std::string(300, 'x')};
    constexpr std::array<std::string_view, 1> reserved{"sum"};
    Diagnostics notes;
    const std::vector<std::string> given = layer_names(names, reserved, notes);
    EXPECT_EQ(given, (std::vector<std::string>{"key", "fill_light", "key_2", "a_b_c", "_", "d_j_", "sum_2",
                                               std::string(64, 'x')}));
    EXPECT_EQ(notes.size(), 7U);
    EXPECT_EQ(notes[0].message, "the layer of 'fill light' is called fill_light");
}

} // namespace
} // namespace gonio::media
