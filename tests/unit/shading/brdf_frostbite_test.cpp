// The Frostbite material: its mapping. Its albedo is tested in brdf_furnace_test.cpp.
#include <gonio/shading/brdf_frostbite.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace gonio::shading;
constexpr double pi = std::numbers::pi;

TEST(FrostbiteMaterial, MapsBaseSmoothnessMetalReflectance) {
    const Frostbite<double> plastic = frostbite_material<double>({0.5, 0.25, 0.125}, 0.5, 0.0, 0.5);
    EXPECT_DOUBLE_EQ(plastic.f0.x, 0.04);
    EXPECT_DOUBLE_EQ(plastic.f90, 1.0);
    EXPECT_DOUBLE_EQ(plastic.albedo.y, 0.25);
    EXPECT_DOUBLE_EQ(plastic.linear_roughness, 0.5);
    EXPECT_DOUBLE_EQ(plastic.alpha, 0.25);
    const Frostbite<double> gold = frostbite_material<double>({1.0, 0.77, 0.34}, 0.9, 1.0, 0.5);
    EXPECT_DOUBLE_EQ(gold.f0.y, 0.77);
    EXPECT_EQ(gold.albedo.x, 0.0);
    // f0 below 2 % is treated as occlusion: the grazing reflectance fades.
    EXPECT_DOUBLE_EQ(frostbite_material<double>({0, 0, 0}, 0.0, 0.0, 0.25).f90, 0.5);
    const Frostbite<double> mirror = frostbite_material<double>({2.0, -1.0, 0.5}, 1.5, -1.0, 9.0);
    EXPECT_EQ(mirror.alpha, minimum_alpha);
    EXPECT_EQ(mirror.albedo.x, 1.0);
    EXPECT_EQ(mirror.albedo.y, 0.0);
    EXPECT_DOUBLE_EQ(mirror.f0.x, 0.16);
}

// ∫ D n·h dω = 1 over the half vectors.
TEST(GgxDistribution, IsNormalised) {
    for (const double alpha : {0.01, 0.1, 0.5, 1.0}) {
        double sum = 0.0;
        constexpr int steps = 200'000;
        for (int i = 0; i < steps; ++i) {
            const double w = (i + 0.5) / steps; // θ = (π/2) w³: dense at the peak
            const double theta = pi / 2 * w * w * w;
            const double s = std::sin(theta);
            const double c = std::cos(theta);
            sum += distribution_ggx(c, s * s, alpha, alpha) * c * s * 2 * pi * (pi / 2 * 3 * w * w / steps);
        }
        EXPECT_NEAR(sum, 1.0, 1e-6) << alpha;
    }
}

} // namespace
