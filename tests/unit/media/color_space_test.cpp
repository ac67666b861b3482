// Spaces of OpenColorIO configurations against the built-in ones.
#include <gonio/color/cct.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/media/color_space.hpp>
#include <gonio/media/display.hpp>
#include <gonio/media/module.hpp>

#include "../folders.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <array>
#include <string>

namespace gonio::media {
namespace {

const std::string data = std::string(test::source_folder) + "/tests/unit/media/data/";

class MediaColorSpace : public ::testing::Test {
protected:
    void SetUp() override { set_module_folders({test::modules_folder}); }
};

RgbSpace of_config(const std::string& name, const std::string& config = {}) {
    const Result<SceneLinearSpace> space = scene_linear_space(name, config);
    EXPECT_TRUE(space) << (space ? "" : space.error().diagnostics.back().message);
    if (!space) return {};
    EXPECT_TRUE(space->exact) << name;
    return rgb_space_of_aces(space->name, space->from_aces2065_1).value();
}

// Its matrices are rounded to about ten digits, and the Bradford adaptation on the way in is ours.
TEST_F(MediaColorSpace, BuiltInOnesAreThoseOfTheColourRoom) {
    for (const auto& [ocio, own] :
         {std::pair{"ACEScg", "acescg"}, {"ACES2065-1", "aces2065-1"}, {"lin_rec709", "rec709"}}) {
        const RgbSpace theirs = of_config(ocio);
        const RgbSpace& ours = *find_rgb_space(own);
        for (int c = 0; c < 3; ++c)
            EXPECT_LT(glm::length(theirs.to_xyz[c] - ours.to_xyz[c]), 2e-7) << ocio;
        for (const double kelvin : {800.0, 2700.0, 6500.0, 40000.0}) {
            const SpaceColor color = to_space(exact_uv({Kelvin(kelvin), 0.0}).value(), theirs, Gamut::clip);
            EXPECT_NEAR(glm::dot(luminance_row(theirs), color.rgb), 1.0, 1e-12) << ocio << ' ' << kelvin;
        }
    }
}

// RGB of a space, through OpenColorIO's own processors (float32) into another space and back.
TEST_F(MediaColorSpace, RoundTripThroughOpenColorIo) {
    for (const double kelvin : {1000.0, 2700.0, 6500.0, 20000.0}) {
        const Uv at = exact_uv({Kelvin(kelvin), 0.0}).value();
        const glm::dvec3 acescg = to_space(at, *find_rgb_space("acescg")).rgb;
        const glm::dvec3 rec709 = to_space(at, *find_rgb_space("rec709")).rgb;
        std::array<float, 3> rgb{static_cast<float>(acescg.x), static_cast<float>(acescg.y),
                                 static_cast<float>(acescg.z)};
        ASSERT_TRUE(convert_space(rgb, "ACEScg", "lin_rec709"));
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(rgb.at(c), rec709[static_cast<int>(c)], 3e-6) << kelvin;
        EXPECT_NEAR(glm::dot(luminance_row(*find_rgb_space("rec709")), glm::dvec3(rgb[0], rgb[1], rgb[2])), 1.0, 1e-6);
        ASSERT_TRUE(convert_space(rgb, "lin_rec709", "ACEScg"));
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(rgb.at(c), acescg[static_cast<int>(c)], 2e-6) << kelvin;
    }
}

TEST_F(MediaColorSpace, AFileIsEnteredThroughItsInterchangeRole) {
    const RgbSpace working = of_config("scene_linear", data + "acescg.ocio");
    EXPECT_EQ(working.name, "working");
    EXPECT_LT(glm::length(working.to_xyz[0] - find_rgb_space("acescg")->to_xyz[0]), 2e-7);
    const RgbSpace rec709 = of_config("rec709", data + "acescg.ocio");
    EXPECT_LT(glm::length(rec709.to_xyz[2] - find_rgb_space("rec709")->to_xyz[2]), 2e-7);
}

TEST_F(MediaColorSpace, WhatIsNoSpaceForLightsIsRefused) {
    const auto failure = [](const char* name, const std::string& config) {
        const Result<SceneLinearSpace> space = scene_linear_space(name, config);
        EXPECT_FALSE(space) << name;
        return space ? Failure::internal : space.error().failure;
    };
    EXPECT_EQ(failure("ACESgc", {}), Failure::usage);
    EXPECT_EQ(failure("raw", {}), Failure::unsupported);
    EXPECT_EQ(failure("sRGB", {}), Failure::unsupported);
    EXPECT_EQ(failure("encoded", data + "encoded.ocio"), Failure::unsupported);
    EXPECT_EQ(failure("working", data + "no-interchange.ocio"), Failure::unsupported);
    EXPECT_EQ(failure("working", data + "no such file.ocio"), Failure::io);
    EXPECT_EQ(failure("working", data + "../display_test.cpp"), Failure::malformed);
    EXPECT_NE(scene_linear_space("working", data + "no-interchange.ocio")
                  .error()
                  .diagnostics.back()
                  .message.find("aces_interchange"),
              std::string::npos);
}

// A matrix with a range that clamps nothing relevant is not a single matrix, but still linear.
TEST_F(MediaColorSpace, LinearSpacesOfSeveralStepsAreMeasured) {
    const Result<SceneLinearSpace> space = scene_linear_space("stepped", data + "encoded.ocio");
    ASSERT_TRUE(space) << space.error().diagnostics.back().message;
    EXPECT_FALSE(space->exact);
    EXPECT_NEAR(space->from_aces2065_1[0][0], 2.0, 1e-5);
    EXPECT_NEAR(space->from_aces2065_1[1][0], 0.0, 1e-5);
}

} // namespace
} // namespace gonio::media
