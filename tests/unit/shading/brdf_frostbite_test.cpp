// The Frostbite material: its mapping, reciprocity, and how much light it sends back.
#include <gonio/shading/brdf_frostbite.hpp>

#include "poses.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace {

using namespace gonio::shading;
using poses::Random;
using poses::Vec;
constexpr double pi = std::numbers::pi;

struct Albedo {
    double diffuse = 0.0;
    double specular = 0.0;
};

// ∫ f n·l dω for a view at cosine μ, by the substitution that fits GGX: half vectors h, dω_l = 4 v·h dω_h, with
// tan θ_h = α tan(t) spread evenly; the diffuse part over the hemisphere.
Albedo albedo_of(double mu, double linear_roughness, double f0) {
    const double alpha = std::max(linear_roughness * linear_roughness, 1e-4);
    const Vec v{std::sqrt(1.0 - mu * mu), 0, mu};
    Albedo sum;
    constexpr int rings = 600;
    constexpr int sectors = 600;
    for (int i = 0; i < rings; ++i) {
        // u in (0, 1): θ_h by inverting the GGX distribution, which makes D cosθ_h dω_h = du dφ/2π.
        const double u = (i + 0.5) / rings;
        const double cos2 = (1.0 - u) / (1.0 + (alpha * alpha - 1.0) * u);
        const double ch = std::sqrt(cos2);
        const double sh = std::sqrt(1.0 - cos2);
        const double cl = std::sqrt(u); // cosine-weighted direction for the diffuse part
        const double sl = std::sqrt(1.0 - u);
        for (int k = 0; k < sectors; ++k) {
            const double phi = 2.0 * pi * (k + 0.5) / sectors;
            const Vec h{sh * std::cos(phi), sh * std::sin(phi), ch};
            const double vh = dot(v, h);
            const Vec l = h * (2.0 * vh) - v;
            if (l.z > 0.0 && vh > 0.0) {
                const double fresnel = f0 + (1.0 - f0) * schlick_weight(vh);
                sum.specular += visibility_ggx(l.z, mu, alpha) * fresnel * l.z * 4.0 * vh / ch;
            }
            const Vec d{sl * std::cos(phi), sl * std::sin(phi), cl};
            const double dh = dot(d, normalized(d + v));
            sum.diffuse += pi * diffuse_frostbite(d.z, mu, dh, linear_roughness);
        }
    }
    const double count = double{rings} * sectors;
    return {sum.diffuse / count, sum.specular / count};
}

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
    // f0 below 2 % is taken as an occlusion: its grazing reflectance fades.
    EXPECT_DOUBLE_EQ(frostbite_material<double>({0, 0, 0}, 0.0, 0.0, 0.25).f90, 0.5);
    const Frostbite<double> mirror = frostbite_material<double>({2.0, -1.0, 0.5}, 1.5, -1.0, 9.0);
    EXPECT_EQ(mirror.alpha, minimum_alpha);
    EXPECT_EQ(mirror.albedo.x, 1.0);
    EXPECT_EQ(mirror.albedo.y, 0.0);
    EXPECT_DOUBLE_EQ(mirror.f0.x, 0.16);
}

TEST(FrostbiteBrdf, IsReciprocal) {
    Random random(41);
    for (int i = 0; i < 20'000; ++i) {
        const Vec n = poses::random_direction(random);
        const Vec l = poses::tilted(n, random.uniform(1e-3, 1.0), random);
        const Vec v = poses::tilted(n, random.uniform(1e-3, 1.0), random);
        const auto material =
            frostbite_material<double>({0.9, 0.5, 0.1}, random.uniform(), random.uniform(), random.uniform());
        const vec3<double> a = brdf(material, n, l, v);
        const vec3<double> b = brdf(material, n, v, l);
        ASSERT_NEAR(a.x, b.x, 1e-9 * a.x) << i;
        ASSERT_NEAR(a.z, b.z, 1e-9 * a.z) << i;
        ASSERT_GT(a.x, 0.0) << i;
    }
}

TEST(FrostbiteBrdf, IsZeroBelowTheHorizonOfEither) {
    const Vec n{0, 0, 1};
    const auto material = frostbite_material<double>({1, 1, 1}, 0.5, 0.0, 0.5);
    const Vec above{0.6, 0.0, 0.8};
    for (const Vec below : {Vec{0.6, 0.0, -0.8}, Vec{1.0, 0.0, 0.0}, Vec{0.0, 0.0, -1.0}, Vec{-0.6, 0.0, -0.8}}) {
        EXPECT_EQ(brdf(material, n, above, below).x, 0.0);
        EXPECT_EQ(brdf(material, n, below, above).x, 0.0);
    }
}

// ∫ D n·h dω = 1 over the half vectors.
TEST(FrostbiteBrdf, DistributionIsNormalised) {
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

// GGX with F = 1 at normal incidence, the values that the literature gives.
TEST(FrostbiteBrdf, WhiteSpecularAlbedo) {
    const std::pair<double, double> table[] = {{0.1, 0.9883}, {0.25, 0.916}, {0.5, 0.688}, {1.0, 0.307}};
    for (const auto& [alpha, expected] : table)
        EXPECT_NEAR(albedo_of(1.0, std::sqrt(alpha), 1.0).specular, expected, 6e-4) << alpha;
}

// It does not conserve energy, and these are the bounds within which it does not. Base colour 1, f0 = 0.04.
TEST(FrostbiteBrdf, FurnaceTable) {
    double most_diffuse = 0.0;
    double most = 0.0;
    double least = 2.0;
    for (const double r : {0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0}) {
        for (const double mu : {1e-4, 0.01, 0.05, 0.1, 0.3, 0.6, 1.0}) {
            const Albedo a = albedo_of(mu, r, 0.04);
            most_diffuse = std::max(most_diffuse, a.diffuse);
            most = std::max(most, a.diffuse + a.specular);
            least = std::min(least, a.diffuse + a.specular);
            EXPECT_LE(a.specular, 1.0 + 1e-3) << r << ' ' << mu;
        }
    }
    RecordProperty("most_diffuse", std::to_string(most_diffuse));
    RecordProperty("most", std::to_string(most));
    RecordProperty("least", std::to_string(least));
    EXPECT_LE(most_diffuse, 1.0320);
    EXPECT_GE(most_diffuse, 1.03);
    EXPECT_LE(most, 1.118);
    EXPECT_GE(most, 1.11);
    EXPECT_GE(least, 0.69);
    EXPECT_LE(least, 0.70);
}

} // namespace
