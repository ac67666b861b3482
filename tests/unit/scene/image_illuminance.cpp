// The illuminance of rectangles with images, against sums over their pixels and over points.
#include <gonio/scene/image_illuminance.hpp>
#include <gonio/scene/probe.hpp>

#include "../light/light_images.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace gonio {
namespace {

using std::numbers::pi;

double lux(const Light& light, const Receiver& receiver, double relative_error = 1e-6) {
    ProbeOptions options;
    options.method = IrradianceMethod::reference;
    options.goal.relative_error = relative_error;
    options.threads = 1;
    return probe({&light, 1}, {&receiver, 1}, options).value().illuminance_lx.front();
}

// Σ L ⟨n·l⟩ cosθ/r² over n by n points of each pixel: independent of closed forms.
double sum_over_points(const Light& light, const Receiver& receiver, int n) {
    const auto& rect = std::get<RectShape>(light.shape);
    const ImagePlane& image = *light.image;
    const int columns = image.width() * n;
    const int rows = image.height() * n;
    double sum = 0.0;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const glm::dvec2 at((column + 0.5) / columns, (row + 0.5) / rows);
            const glm::dvec3 point = light.frame.origin + (0.5 - at.x) * rect.width.value * light.frame.x +
                                     (0.5 - at.y) * rect.height.value * light.frame.y;
            const glm::dvec3 to = point - receiver.position;
            const double r = glm::length(to);
            const double here = glm::dot(to, receiver.normal) / r;
            const double there =
                rect.two_sided ? std::abs(glm::dot(to, light.frame.z)) / r : glm::dot(to, light.frame.z) / r;
            if (here > 0.0 && there > 0.0) sum += image.pixel(at) * here * there / (r * r);
        }
    return light.luminance.value * sum * rect.width.value * rect.height.value / (static_cast<double>(columns) * rows);
}

const std::vector<Receiver> receivers{
    {{0.1, 0.05, -0.4}, {0.0, 0.0, 1.0}},
    {{0.7, -0.2, -0.3}, glm::normalize(glm::dvec3(-0.6, 0.2, 0.7))},
    {{-0.3, 0.4, -1.5}, glm::normalize(glm::dvec3(1.0, 0.1, 0.2))}, // the horizon cuts the light
    {{2.0, 3.0, -6.0}, glm::normalize(glm::dvec3(-0.2, -0.4, 1.0))},
};

TEST(ImageIlluminance, IsTheSumOverPoints) {
    for (const char* const shape : {"rect:w=1.2m,h=0.5m", "rect:w=0.4m,h=0.9m,two-sided"}) {
        const Light light = test::light_with_image(shape, test::grey_image(24, 17), "1000nt");
        for (const Receiver& receiver : receivers) {
            const double truth = sum_over_points(light, receiver, 12);
            // Points of pixels that the horizon cuts count wholly or not at all.
            EXPECT_NEAR(lux(light, receiver), truth, 3e-4 * truth) << shape;
        }
    }
}

TEST(ImageIlluminance, StopsEarlyWithinItsGoal) {
    const Light light = test::light_with_image("rect:w=1.2m,h=0.5m", test::grey_image(200, 128), "1000nt");
    for (const Receiver& receiver : receivers) {
        const ReferenceValue exact =
            detail::image_illuminance(light, receiver.position, receiver.normal, {1e-12, 100'000'000});
        EXPECT_TRUE(exact.converged);
        EXPECT_LT(exact.evaluations, 2U * 200U * 128U);
        for (const double goal : {1e-3, 1e-5}) {
            const ReferenceValue rough =
                detail::image_illuminance(light, receiver.position, receiver.normal, {goal, 4'000'000});
            EXPECT_NEAR(rough.value, exact.value, std::max(rough.error_estimate, 1e-9 * exact.value));
            EXPECT_LE(rough.error_estimate, goal * exact.value * 1.5);
        }
        const ReferenceValue cut = detail::image_illuminance(light, receiver.position, receiver.normal, {1e-9, 300});
        EXPECT_FALSE(cut.converged);
        EXPECT_GE(cut.error_estimate, std::abs(cut.value - exact.value));
    }
}

// White is the closed form; the light that crosses a closed box is the flux.
TEST(ImageIlluminance, OfWhiteIsThatOfTheRectangle) {
    Image white(3, 2, 1);
    white.pixels.assign(white.pixels.size(), 0.5F);
    const Light light = test::light_with_image("rect:w=1.2m,h=0.5m", white, "1000nt");
    Light bare = light;
    bare.image.reset();
    std::get<RectShape>(bare.shape).image.reset();
    for (const Receiver& receiver : receivers)
        EXPECT_NEAR(lux(light, receiver), lux(bare, receiver), 1e-6 * lux(bare, receiver));
}

TEST(ImageIlluminance, CrossesAClosedBoxAsTheFlux) {
    const Light light = test::light_with_image("rect:w=1m,h=0.6m", test::grey_image(9, 7), "1000lm");
    // A box of 2 m around the lower half of space; nothing leaves upwards.
    constexpr int n = 40;
    double flux = 0.0;
    const auto add_side = [&](const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v,
                              const glm::dvec3& normal) {
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const glm::dvec3 at = corner + (i + 0.5) / n * u + (j + 0.5) / n * v;
                flux += lux(light, {at, normal}, 1e-5) * glm::length(u) * glm::length(v) / (n * n);
            }
    };
    add_side({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1});
    add_side({-1, -1, -1}, {2, 0, 0}, {0, 0, 1}, {0, 1, 0});
    add_side({-1, 1, -1}, {2, 0, 0}, {0, 0, 1}, {0, -1, 0});
    add_side({-1, -1, -1}, {0, 2, 0}, {0, 0, 1}, {1, 0, 0});
    add_side({1, -1, -1}, {0, 2, 0}, {0, 0, 1}, {-1, 0, 0});
    EXPECT_NEAR(flux, 1000.0, 1.0);
}

// Colours share the illuminance.
TEST(ImageIlluminance, OfColoursIsThatOfTheWhole) {
    const Light light = test::light_with_image("rect:w=1m,h=0.6m", test::colored_image(20, 10), "1000lm");
    Light whole = light;
    whole.parts.reset();
    for (const Receiver& receiver : receivers)
        EXPECT_NEAR(lux(light, receiver), lux(whole, receiver), 1e-5 * lux(whole, receiver));
}

} // namespace
} // namespace gonio
