#include <gonio/media/dither.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace gonio::media {
namespace {

Image flat(int side, float value) {
    Image image(side, side, 3);
    for (float& of : image.pixels)
        of = value;
    return image;
}

double mean_of_rounded(const std::vector<float>& values, int greatest) {
    double sum = 0.0;
    for (const float value : values)
        sum += std::round(static_cast<double>(value) * greatest) / greatest;
    return sum / static_cast<double>(values.size());
}

TEST(Dither, KeepsTheMeanBetweenTwoSteps) {
    for (const int greatest : {255, 65535})
        for (const double within : {0.1, 0.25, 0.5, 0.77}) {
            const double value = (100.0 + within) / greatest;
            const std::vector<float> values = dithered(flat(64, static_cast<float>(value)), greatest);
            EXPECT_NEAR((mean_of_rounded(values, greatest) - value) * greatest, 0.0, 5e-3) << within;
        }
}

TEST(Dither, LeavesWholeSteps) {
    for (int step = 0; step <= 255; ++step)
        for (const float value : dithered(flat(32, static_cast<float>(step) / 255.0F), 255))
            ASSERT_EQ(std::round(value * 255.0F), static_cast<float>(step));
}

TEST(Dither, MovesAllChannelsOfAPixelAlike) {
    const std::vector<float> values = dithered(flat(16, 0.3F), 255);
    for (std::size_t i = 0; i < values.size(); i += 3) {
        EXPECT_EQ(values[i], values[i + 1]);
        EXPECT_EQ(values[i], values[i + 2]);
    }
}

} // namespace
} // namespace gonio::media
