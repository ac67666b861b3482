// Cylindrical, semi-cylindrical and hemispherical illuminance: the closed sums of points, and sums over the elements of
// lights with a size.
#include <gonio/light/light.hpp>
#include <gonio/scene/spatial_illuminance.hpp>

#include "../light/luminaire.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace gonio {
namespace {

constexpr double pi = std::numbers::pi;
const glm::dvec3 east(1, 0, 0);

Light light_of(const std::string& shape, const std::string& amount, const glm::dvec3& position,
               const glm::dvec3& direction = {0, 0, -1}) {
    LightDescription description;
    description.shape = parse_shape(shape).value();
    description.intensity = parse_photometric_value(amount).value();
    description.position = position;
    description.direction = direction;
    Diagnostics diagnostics;
    return resolve_light(description, diagnostics).value();
}

double of(IlluminanceKind kind, const Light& light, const glm::dvec3& at, const glm::dvec3& normal = east) {
    return illuminance_of_kind(kind, light, at, normal);
}

// An independent calculation: 1000 cd, 3 m up and 4 m away.
TEST(SpatialIlluminance, OfAPointAreSums) {
    const Light light = light_of("point", "1000cd", {4, 0, 3});
    EXPECT_NEAR(of(IlluminanceKind::horizontal, light, {}), 24.0, 1e-12);
    EXPECT_NEAR(of(IlluminanceKind::cylindrical, light, {}), 10.186, 5e-4);
    EXPECT_NEAR(of(IlluminanceKind::semi_cylindrical, light, {}), 20.372, 5e-4);
    EXPECT_NEAR(of(IlluminanceKind::semi_cylindrical, light, {}, -east), 0.0, 1e-12);
    EXPECT_NEAR(of(IlluminanceKind::hemispherical, light, {}), 1000.0 / 25.0 * 1.6 / 4.0, 1e-12);
    EXPECT_NEAR(of(IlluminanceKind::cylindrical, light, {}) / of(IlluminanceKind::horizontal, light, {}), 0.4244, 5e-5);
}

TEST(SpatialIlluminance, OfTheSunAreSums) {
    const Light sun = light_of("sun:angle=0.53deg", "1000lx", {}, {-3, 0, -4});
    EXPECT_NEAR(of(IlluminanceKind::cylindrical, sun, {}), 1000.0 * 0.6 / pi, 1e-9);
    EXPECT_NEAR(of(IlluminanceKind::hemispherical, sun, {}), 1000.0 * 1.8 / 4.0, 1e-9);
}

// The mean of Esc over all directions is Ez.
TEST(SpatialIlluminance, TheMeanOfHalfCylindersIsTheCylinder) {
    const Light light = light_of("rect:w=1.2m,h=0.3m", "4000lm", {0.7, 0.4, 2.2});
    double mean = 0.0;
    for (int i = 0; i < 12; ++i)
        mean +=
            of(IlluminanceKind::semi_cylindrical, light, {}, {std::cos(i * pi / 6), std::sin(i * pi / 6), 0.0}) / 12.0;
    EXPECT_NEAR(mean, of(IlluminanceKind::cylindrical, light, {}), 1e-9 * mean);
}

// A sky of uniform luminance, as a sphere around the point: E = πL, Ez = πL, Ehs = πL.
TEST(SpatialIlluminance, InsideASphereIsThatOfASurface) {
    const Light light = light_of("sphere:r=3m", "100nt", {0.5, 0, 0});
    for (const IlluminanceKind kind :
         {IlluminanceKind::cylindrical, IlluminanceKind::semi_cylindrical, IlluminanceKind::hemispherical})
        EXPECT_NEAR(of(kind, light, {}), 100.0 * pi, 1e-9 * 100.0 * pi);
}

// From the definitions, over the elements of a rectangle: the error is the sum's own, with the square of the step.
struct Sums {
    double cylindrical = 0.0;
    double semi_cylindrical = 0.0;
    double hemispherical = 0.0;
};

Sums sums_over(const Light& light, double width, double height, const glm::dvec3& at, const glm::dvec3& normal, int n) {
    Sums sums;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const glm::dvec3 element = light.frame.origin + ((i + 0.5) / n - 0.5) * width * light.frame.x +
                                       ((j + 0.5) / n - 0.5) * height * light.frame.y;
            const glm::dvec3 to = element - at;
            const double r = glm::length(to);
            const double beam = light.intensity_towards(-to).value / (n * n) / (r * r);
            const double flat = std::hypot(to.x, to.y) / r;
            sums.cylindrical += beam * flat / pi;
            sums.semi_cylindrical += beam * (flat + glm::dot(to, normal) / r) / pi;
            sums.hemispherical += beam * (1.0 + to.z / r) / 4.0;
        }
    return sums;
}

struct Case {
    std::string name;
    Light light;
    double width;
    double height;
};

std::vector<Case> cases() {
    return {{"panel", light_of("rect:w=1.2m,h=0.3m", "4000lm", {0, 0, 2}), 1.2, 0.3},
            {"window", light_of("rect:w=1.5m,h=1.2m", "3000nt", {0, 2, 0.4}, {0, -1, 0}), 1.5, 1.2},
            {"luminaire", test::luminaire("batwing", "rect:w=1.2m,h=0.3m"), 1.2, 0.3}};
}

TEST(SpatialIlluminance, OfALightWithASizeIsTheSumOfItsElements) {
    double worst_far = 0.0;
    double worst_near = 0.0;
    double worst_of_luminaire = 0.0;
    for (const Case& each : cases())
        for (const glm::dvec3& offset :
             {glm::dvec3(0.1, 0.05, -1.2), glm::dvec3(0.5, 0.2, -1.5), glm::dvec3(0.9, -0.9, -0.8),
              glm::dvec3(2.5, -1.0, -1.1), glm::dvec3(0.3, -4.0, -2.0), glm::dvec3(-6.0, -1.0, -2.2)}) {
            const glm::dvec3 at = each.light.frame.origin + offset;
            const glm::dvec3 normal = glm::normalize(glm::dvec3(0.4, 0.9, 0.0));
            const Sums coarse = sums_over(each.light, each.width, each.height, at, normal, 100);
            const Sums fine = sums_over(each.light, each.width, each.height, at, normal, 200);
            const auto limit = [&](double Sums::*of) { return fine.*of + (fine.*of - coarse.*of) / 3.0; };
            for (const auto& [kind, member] : {std::pair(IlluminanceKind::cylindrical, &Sums::cylindrical),
                                               std::pair(IlluminanceKind::semi_cylindrical, &Sums::semi_cylindrical),
                                               std::pair(IlluminanceKind::hemispherical, &Sums::hemispherical)}) {
                const double truth = limit(member);
                const double got = of(kind, each.light, at, normal);
                const double scale = limit(&Sums::cylindrical);
                const bool is_around = glm::length(glm::dvec2(offset)) < 0.5 * std::hypot(each.width, each.height);
                double& worst = each.light.has_pattern() || each.light.parts != nullptr ? worst_of_luminaire
                                : is_around                                             ? worst_near
                                                                                        : worst_far;
                worst = std::max(worst, std::abs(got - truth) / std::max(truth, scale));
            }
        }
    EXPECT_LT(worst_far, 2e-5);
    EXPECT_LT(worst_near, 1e-3);
    EXPECT_LT(worst_of_luminaire, 3e-4);
}

// The rule for light from everywhere, against the closed sums of beams: exact for what is smooth, a few parts in a
// thousand for a single beam.
TEST(SpatialIlluminance, SurfacesThatStandForAKind) {
    const auto by_surfaces = [](IlluminanceKind kind, const std::function<double(const glm::dvec3&)>& lux) {
        double sum = 0.0;
        for (const WeightedNormal& surface : surfaces_of(kind, east))
            sum += surface.weight * lux(surface.normal);
        return sum;
    };
    const auto uniform = [](const glm::dvec3& /*normal*/) { return pi; };
    // L = 1 + z: E = π + (2/3) π n_z.
    const auto brighter_above = [](const glm::dvec3& normal) { return pi + 2.0 / 3.0 * pi * normal.z; };
    for (const IlluminanceKind kind :
         {IlluminanceKind::cylindrical, IlluminanceKind::semi_cylindrical, IlluminanceKind::hemispherical})
        EXPECT_NEAR(by_surfaces(kind, uniform), pi, 1e-12);
    EXPECT_NEAR(by_surfaces(IlluminanceKind::cylindrical, brighter_above), pi, 1e-12);
    EXPECT_NEAR(by_surfaces(IlluminanceKind::hemispherical, brighter_above), pi + pi / 3.0, 1e-12);
    const Light light = light_of("point", "1000cd", {4, 1, 3});
    const auto beam = [&](const glm::dvec3& normal) { return of(IlluminanceKind::planar, light, {}, normal); };
    for (const IlluminanceKind kind :
         {IlluminanceKind::cylindrical, IlluminanceKind::semi_cylindrical, IlluminanceKind::hemispherical})
        EXPECT_NEAR(by_surfaces(kind, beam) / of(kind, light, {}), 1.0, 6e-3);
}

TEST(SpatialIlluminance, KindsHaveNames) {
    EXPECT_EQ(parse_illuminance_kind("cylindrical").value(), IlluminanceKind::cylindrical);
    EXPECT_EQ(parse_illuminance_kind("semi-cylindrical").value(), IlluminanceKind::semi_cylindrical);
    EXPECT_NE(parse_illuminance_kind("cylindric").error().diagnostics.back().hint.find("cylindrical"),
              std::string::npos);
}

} // namespace
} // namespace gonio
