// Images as masks: places and means, flux against sums over directions, colours.
#include <gonio/light/light_color.hpp>
#include <gonio/light/light_image.hpp>
#include <gonio/light/light_parts.hpp>
#include <gonio/light/lobe.hpp>
#include <gonio/media/image_file.hpp>

#include "light_images.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace gonio {
namespace {

using std::numbers::pi;

// Σ of the light's intensity over n by n parts of the square that covers ±slope one metre before the light.
double flux_before(const Light& light, double slope_x, double slope_y, int n) {
    double sum = 0.0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double x = slope_x * (2.0 * (i + 0.5) / n - 1.0);
            const double y = slope_y * (2.0 * (j + 0.5) / n - 1.0);
            const double square = 1.0 + x * x + y * y;
            const double solid_angle = 4.0 * slope_x * slope_y / (n * n) / (square * std::sqrt(square));
            sum += light.intensity_towards(light.frame.to_world({x, y, -1.0})).value * solid_angle;
        }
    return sum;
}

TEST(ImagePlane, InterpolatesBetweenCentres) {
    const ImagePlane plane(2, 2, {1.0F, 2.0F, 3.0F, 4.0F}); // the peak becomes 1
    EXPECT_EQ(plane.peak(), 4.0);
    EXPECT_DOUBLE_EQ(plane.mean(), 0.625);
    EXPECT_DOUBLE_EQ(plane.smooth({0.25, 0.25}), 0.25);
    EXPECT_DOUBLE_EQ(plane.smooth({0.5, 0.5}), 0.625);
    EXPECT_DOUBLE_EQ(plane.smooth({0.0, 0.0}), 0.25); // beyond the outermost centres
    EXPECT_DOUBLE_EQ(plane.smooth({1.0, 1.0}), 1.0);
    EXPECT_DOUBLE_EQ(plane.pixel({0.49, 0.51}), 0.75);
    EXPECT_DOUBLE_EQ(plane.pixel({-3.0, 7.0}), 0.75);
    const ImagePlane one(1, 1, {7.0F});
    EXPECT_EQ(one.smooth({0.2, 0.9}), 1.0);
}

TEST(ImagePlane, MeansAreThoseOfPartsOfPixels) {
    const Image image = test::grey_image(37, 11);
    const ImagePlane plane(37, 11, image.pixels);
    const auto brute = [&](glm::dvec2 low, glm::dvec2 high) {
        double sum = 0.0;
        double area = 0.0;
        for (int row = 0; row < 11; ++row)
            for (int column = 0; column < 37; ++column) {
                const double x = std::min(high.x * 37, column + 1.0) - std::max(low.x * 37, double(column));
                const double y = std::min(high.y * 11, row + 1.0) - std::max(low.y * 11, double(row));
                if (x <= 0.0 || y <= 0.0) continue;
                area += x * y;
                sum += x * y * plane.pixel({(column + 0.5) / 37, (row + 0.5) / 11});
            }
        return sum / area;
    };
    for (const auto& [low, high] :
         {std::pair(glm::dvec2(0.0), glm::dvec2(1.0)), std::pair(glm::dvec2(0.13, 0.2), glm::dvec2(0.14, 0.9)),
          std::pair(glm::dvec2(0.501, 0.3), glm::dvec2(0.503, 0.31))})
        EXPECT_NEAR(plane.mean(low, high), brute(low, high), 1e-10);
    EXPECT_NEAR(plane.mean({-1.0, -1.0}, {2.0, 2.0}), plane.mean(), 1e-12);
    EXPECT_EQ(plane.mean({0.3, 0.3}, {0.3, 0.3}), plane.pixel({0.3, 0.3}));
}

TEST(LightImage, RefusesWhatCannotBeLight) {
    const auto refusal = [](const Image& image) {
        const Result<LightImage> made = LightImage::create(image);
        return made ? std::string("made") : made.error().diagnostics.back().message;
    };
    Image image(4, 3, 1);
    EXPECT_EQ(refusal(image), "the image is black: no light passes it");
    *image.at(0, 0) = 1.0F;
    EXPECT_EQ(refusal(image), "made");
    for (const float bad : {-1e-3F, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        *image.at(2, 1) = bad;
        EXPECT_EQ(refusal(image), "the pixel in column 3, row 2 cannot be light: it is negative or not finite");
    }
}

TEST(LightImage, IsUprightAsTheLightSeesIt) {
    Image image(2, 2, 1);
    *image.at(1, 0) = 1.0F; // top right
    const Light light = test::light_with_image("frustum:h=60deg,v=40deg", image, "100lm");
    const glm::dvec3 right = light.frame.x;
    const glm::dvec3 up = light.frame.y;
    const glm::dvec3 ahead = -light.frame.z;
    EXPECT_GT(light.intensity_towards(ahead + 0.4 * right + 0.3 * up).value, 0.0);
    EXPECT_EQ(light.intensity_towards(ahead - 0.4 * right + 0.3 * up).value, 0.0);
    EXPECT_EQ(light.intensity_towards(ahead + 0.4 * right - 0.3 * up).value, 0.0);
    EXPECT_EQ(light.intensity_towards(ahead + 0.6 * right + 0.3 * up).value, 0.0); // beyond the frustum
    EXPECT_EQ(light.intensity_towards(-ahead).value, 0.0);
    // A panel is upright for those in front of it: what is right for them is −X.
    const Light panel = test::light_with_image("rect:w=2m,h=1m", image, "100nt");
    const glm::dvec3 viewer = panel.frame.origin + 3.0 * ahead;
    const auto seen = [&](double x, double y) {
        return panel.luminance_share_at(viewer, panel.frame.origin + x * right + y * up - viewer);
    };
    EXPECT_EQ(seen(-0.5, 0.25), 1.0);
    EXPECT_EQ(seen(0.5, 0.25), 0.0);
    EXPECT_EQ(seen(-0.5, -0.25), 0.0);
}

TEST(LightImage, WhiteChangesNothing) {
    Image white(5, 4, 3);
    white.pixels.assign(white.pixels.size(), 0.25F);
    for (const char* const shape : {"spot:outer=40deg,inner=25deg", "spot:outer=30deg,falloff=hard",
                                    "frustum:h=60deg,v=40deg", "frustum:h=150deg,v=10deg", "rect:w=2m,h=1m"}) {
        const double flux = test::convert(test::with_image(shape, white), "1cd", "lm");
        const double plain = test::convert(test::shape(shape), "1cd", "lm");
        EXPECT_NEAR(flux, plain, 3e-6 * plain) << shape;
    }
}

TEST(LightImage, KeepsTheFlux) {
    struct Case {
        const char* shape;
        double slope_x, slope_y;
        double tolerance;
    };
    const double wide = std::tan(75.0 / 180.0 * pi);
    const double cone = std::tan(40.0 / 180.0 * pi);
    for (const Case& c :
         {Case{"frustum:h=60deg,v=40deg", std::tan(pi / 6.0), std::tan(pi / 9.0), 3e-6},
          Case{"frustum:h=150deg,v=150deg", wide, wide, 3e-5},
          Case{"spot:outer=40deg,inner=25deg", cone, cone, 3e-5}}) // the sum here cuts the edge in steps
        for (const Image& image : {test::grey_image(61, 43), test::grey_image(3, 2), test::colored_image(20, 10)}) {
            const Light light = test::light_with_image(c.shape, image, "1000lm");
            EXPECT_NEAR(flux_before(light, c.slope_x, c.slope_y, 1500), 1000.0, 1000.0 * c.tolerance) << c.shape;
        }
}

TEST(LightImage, HardEdgesCutTheImage) {
    const Light light = test::light_with_image("spot:outer=30deg,falloff=hard", test::grey_image(61, 43), "1000lm");
    const double slope = std::tan(pi / 6.0);
    EXPECT_NEAR(flux_before(light, slope, slope, 4000), 1000.0, 0.05);
}

TEST(LightImage, ColoursAddUpToTheLight) {
    const Image image = test::colored_image(20, 10);
    for (const char* const shape : {"frustum:h=60deg,v=40deg", "spot:outer=40deg", "rect:w=2m,h=1m"}) {
        const Light light = test::light_with_image(shape, image, "1000lm");
        ASSERT_NE(light.parts, nullptr) << shape;
        const LightImage& of = *mask_of(light.shape).image;
        const glm::dvec3 towards = light.frame.to_world({0.21, 0.13, -1.0});
        double sum = 0.0;
        for (const Light& part : *light.parts)
            sum += part.intensity_towards(towards).value;
        Light whole = light;
        whole.parts.reset();
        EXPECT_NEAR(sum, whole.intensity_towards(towards).value, 1e-6 * sum) << shape;
        EXPECT_NEAR(of.colors()[0].share * of.colors()[0].plane->mean() +
                        of.colors()[1].share * of.colors()[1].plane->mean() +
                        of.colors()[2].share * of.colors()[2].plane->mean(),
                    of.luminance()->mean(), 1e-6);
    }
}

// A red light through an image keeps its flux, and shows nothing of green and blue.
TEST(LightImage, KeepsTheFluxOfAColouredLight) {
    const glm::dvec3 orange = glm::dvec3(1.0, 0.5, 0.0) / glm::dot(glm::dvec3(1.0, 0.5, 0.0), rec709_luminance);
    const Light light =
        test::light_with_image("frustum:h=60deg,v=40deg", test::colored_image(20, 10), "1000lm", orange);
    EXPECT_EQ(light.parts->size(), 2U);
    EXPECT_NEAR(flux_before(light, std::tan(pi / 6.0), std::tan(pi / 9.0), 1000), 1000.0, 0.01);
    LightDescription description;
    Image blue(2, 2, 3);
    blue.pixels[2] = 1.0F;
    description.shape = test::with_image("spot:outer=30deg", blue);
    description.intensity = parse_photometric_value("100lm").value();
    description.color = glm::dvec3(1.0 / rec709_luminance.x, 0.0, 0.0);
    Diagnostics ignored;
    const Result<Light> dark = resolve_light(description, ignored);
    ASSERT_FALSE(dark);
    EXPECT_EQ(dark.error().failure, Failure::usage);
}

TEST(LightImage, IsKnownByItsExtension) {
    std::size_t count = 0;
    for (const media::ImageFormat& format : media::image_formats())
        for (const std::string_view extension : format.extensions) {
            EXPECT_TRUE(names_image("a.b/c." + std::string(extension))) << extension;
            ++count;
        }
    EXPECT_EQ(count, 7U); // as many as names_image() knows
    for (const char* const other : {"lamp.ies", "lamp.LDT", "lamp.xml", "png", "", ".", "a.pngx"})
        EXPECT_FALSE(names_image(other)) << other;
    EXPECT_TRUE(names_image("GOBO.PNG"));
}

} // namespace
} // namespace gonio
