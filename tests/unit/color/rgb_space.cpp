#include <gonio/color/cct.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/light/light_color.hpp>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gonio {
namespace {

Uv black_body(double kelvin) {
    return exact_uv({Kelvin(kelvin), 0.0}).value();
}

TEST(RgbSpaceTest, LuminanceIsOneInEverySpace) {
    for (const RgbSpaceName& name : rgb_spaces()) {
        const RgbSpace& space = *find_rgb_space(name.name);
        for (const double kelvin : {500.0, 800.0, 1850.0, 2700.0, 6500.0, 40000.0, 1e6})
            for (const Gamut gamut : {Gamut::keep, Gamut::clip}) {
                const SpaceColor color = to_space(black_body(kelvin), space, gamut);
                EXPECT_NEAR(glm::dot(luminance_row(space), color.rgb), 1.0, 1e-12) << name.name << ' ' << kelvin;
                EXPECT_NEAR(color.luminance, 1.0, 1e-12);
                if (gamut == Gamut::keep)
                    EXPECT_LT(delta_uv_prime(to_uv(space.to_xyz * color.rgb), black_body(kelvin)), 1e-12);
                else
                    EXPECT_GE(std::min({color.rgb.x, color.rgb.y, color.rgb.z}), 0.0);
            }
    }
}

TEST(RgbSpaceTest, D65IsWhiteInEachOfThem) {
    for (const RgbSpaceName& name : rgb_spaces()) {
        if (name.name == "xyz") continue;
        const SpaceColor white = to_space(to_uv(d65_white), *find_rgb_space(name.name));
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(white.rgb[c], 1.0, 1e-12) << name.name;
    }
}

// Computed by another program (numpy), three decimals.
TEST(RgbSpaceTest, KnownColours) {
    const auto near = [](double kelvin, const char* space, glm::dvec3 expected, double tolerance) {
        const SpaceColor color = to_space(black_body(kelvin), *find_rgb_space(space));
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(color.rgb[c], expected[c], tolerance) << space << ' ' << kelvin;
    };
    near(2700, "rec709", {1.935, 0.804, 0.192}, 5.1e-4);
    near(2700, "acescg", {1.468, 0.875, 0.295}, 5.1e-4);
    near(6500, "rec709", {1.0434, 0.9836, 1.0350}, 5.1e-5);
    near(800, "rec709", {5.407, -0.201, -0.082}, 5.1e-4);
    near(1800, "rec709", {2.771, 0.576, -0.019}, 5.1e-4);
}

// The row of this space that gives luminance is the one that the rest of gonio uses.
TEST(RgbSpaceTest, TheWorkingSpaceIsRec709) {
    const glm::dvec3 row = luminance_row(*find_rgb_space("rec709"));
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(row[c], rec709_luminance[c], 1e-15);
    EXPECT_EQ(find_rgb_space("srgb-linear"), find_rgb_space("rec709"));
    EXPECT_EQ(find_rgb_space("srgb"), nullptr);
    EXPECT_EQ(find_rgb_space(""), nullptr);
}

TEST(RgbSpaceTest, MaxKeepsTheKnownShareOfTheLumens) {
    const auto share = [](double kelvin, const char* space) {
        return to_space(black_body(kelvin), *find_rgb_space(space), Gamut::clip, Normalize::max).luminance;
    };
    EXPECT_NEAR(share(2700, "rec709"), 0.517, 6e-4);
    EXPECT_NEAR(share(2700, "acescg"), 0.681, 6e-4);
    EXPECT_NEAR(share(6500, "rec2020"), 0.970, 6e-4);
    EXPECT_NEAR(share(10000, "rec2020"), 0.723, 6e-4);
}

TEST(RgbSpaceTest, BlackBodiesLeaveTheGamutsWhereTheyShould) {
    struct Edge {
        const char* space;
        double kelvin, slack;
    };
    for (const Edge& edge : {Edge{"rec709", 1900.4, 0.1}, Edge{"rec2020", 1062.8, 0.1}, Edge{"p3-d65", 1059.1, 0.1},
                             Edge{"acescg", 603.0, 1.5}, Edge{"aces2065-1", 758.0, 1.0}}) {
        const RgbSpace& space = *find_rgb_space(edge.space);
        EXPECT_TRUE(to_space(black_body(edge.kelvin + edge.slack), space).in_gamut) << edge.space;
        EXPECT_FALSE(to_space(black_body(edge.kelvin - edge.slack), space).in_gamut) << edge.space;
    }
}

TEST(RgbSpaceTest, ClippingSaysWhatItMoved) {
    const RgbSpace& rec709 = *find_rgb_space("rec709");
    for (const auto& [kelvin, moved] :
         {std::pair{800.0, 0.049}, {1000.0, 0.0099}, {1500.0, 0.0066}, {1800.0, 0.0019}}) {
        const SpaceColor color = to_space(black_body(kelvin), rec709, Gamut::clip);
        EXPECT_FALSE(color.in_gamut);
        EXPECT_NEAR(color.delta_uv_prime / moved, 1.0, 0.03) << kelvin;
        EXPECT_NEAR(delta_uv_prime(to_uv(rec709.to_xyz * color.rgb), black_body(kelvin)), color.delta_uv_prime, 1e-12);
    }
    const SpaceColor inside = to_space(black_body(2700), rec709, Gamut::clip);
    EXPECT_TRUE(inside.in_gamut);
    EXPECT_EQ(inside.delta_uv_prime, 0.0);
}

TEST(RgbSpaceTest, ChromaticitiesComeBackFromRgb) {
    for (const RgbSpaceName& name : rgb_spaces()) {
        const RgbSpace& space = *find_rgb_space(name.name);
        const Uv at = exact_uv({Kelvin(3000), -0.01}).value();
        const Uv back = uv_of_rgb(to_space(at, space).rgb * 1e-30, space).value();
        EXPECT_LT(delta_uv_prime(at, back), 1e-14) << name.name;
    }
    const RgbSpace& rec709 = *find_rgb_space("rec709");
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const glm::dvec3 bad : {glm::dvec3(0.0), glm::dvec3(-1.0), glm::dvec3(nan, 1, 1), glm::dvec3(1, -1, 0)})
        EXPECT_FALSE(uv_of_rgb(bad, rec709));
}

TEST(RgbSpaceTest, PrimariesMakeTheSameSpace) {
    const RgbSpace& rec709 = *find_rgb_space("rec709");
    const RgbSpace made = rgb_space_of("mine", {0.64, 0.33}, {0.3, 0.6}, {0.15, 0.06}, d65_white).value();
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(glm::length(made.to_xyz[c] - rec709.to_xyz[c]), 0.0, 1e-15);
    EXPECT_FALSE(rgb_space_of("line", {0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}, d65_white));
    EXPECT_FALSE(rgb_space_of("dark", {0.64, 0.33}, {0.3, 0.6}, {0.15, 0.06}, {0.3, 0.0}));
    const RgbSpace& aces = *find_rgb_space("aces2065-1");
    const RgbSpace again = rgb_space_of_aces("x", glm::dmat3(1.0)).value();
    EXPECT_NEAR(glm::length(again.to_xyz[2] - aces.to_xyz[2]), 0.0, 1e-14);
    EXPECT_FALSE(rgb_space_of_aces("flat", glm::dmat3(0.0)));
}

TEST(RgbSpaceTest, SrgbGoesBothWays) {
    for (const double linear : {0.0, 0.001, 0.0031308, 0.18, 1.0})
        EXPECT_NEAR(decode_srgb(encode_srgb(linear)), linear, 1e-7);
    EXPECT_NEAR(encode_srgb(0.5), 0.7353569830524495, 1e-12);
}

} // namespace
} // namespace gonio
