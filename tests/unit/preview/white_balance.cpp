#include <gonio/color/cct.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/preview/white_balance.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace gonio {
namespace {

constexpr Xy d65{0.3127, 0.3290};

glm::dvec3 light_of(double kelvin) {
    return to_space(exact_uv({Kelvin(kelvin)}).value(), *find_rgb_space("rec709")).rgb;
}

Image picture_of(const glm::dvec3& rgb, int pixels) {
    Image image(pixels, 1, 3);
    for (int x = 0; x < pixels; ++x)
        for (int c = 0; c < 3; ++c)
            image.at(x, 0)[c] = static_cast<float>(rgb[c]);
    return image;
}

TEST(WhiteBalance, MakesItsWhiteNeutralAtTheSameLuminance) {
    for (const double kelvin : {1500.0, 2700.0, 4000.0, 6500.0, 12000.0}) {
        const glm::dvec3 light = light_of(kelvin); // of luminance 1
        const glm::dvec3 balanced = white_balance(to_xy(exact_uv({Kelvin(kelvin)}).value())) * light;
        EXPECT_NEAR(glm::distance(balanced, glm::dvec3(1.0)), 0.0, 1e-12) << kelvin;
    }
    EXPECT_NEAR(glm::distance(white_balance(d65) * glm::dvec3(0.2, 0.5, 0.9), glm::dvec3(0.2, 0.5, 0.9)), 0.0, 1e-14);
}

TEST(WhiteBalance, TheMeanOfThePictureIsItsWhite) {
    Image image = picture_of(0.4 * light_of(2700.0), 8);
    balance(image, white_balance(gray_world_white(image)));
    for (const float value : image.pixels)
        EXPECT_NEAR(value, 0.4F, 1e-6F);
    // A lamp that is 1000 times as bright as white counts as one white pixel among a hundred.
    Image room = picture_of(0.5 * light_of(3000.0), 100);
    for (int c = 0; c < 3; ++c)
        room.at(0, 0)[c] = 1000.0F;
    const Xy white = gray_world_white(room);
    const Xy lit = to_xy(exact_uv({Kelvin(3000.0)}).value());
    EXPECT_NEAR(white.x, lit.x, 0.004); // it has one of 50.5 parts of the luminance, and its colour is 0.2 away
    EXPECT_NEAR(white.y, lit.y, 0.004);
    const Xy dark = gray_world_white(Image(4, 4, 3));
    EXPECT_EQ(dark.x, d65.x);
}

TEST(WhiteBalance, NothingIsNegative) {
    Image image = picture_of({0.0, 0.0, 1.0}, 1);
    balance(image, white_balance(to_xy(exact_uv({Kelvin(2000.0)}).value())));
    for (const float value : image.pixels)
        EXPECT_GE(value, 0.0F);
}

} // namespace
} // namespace gonio
