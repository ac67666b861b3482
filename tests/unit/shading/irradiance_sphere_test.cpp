// The exact irradiance of a sphere: against stored values, quadrature, itself in other units, and in every precision.
#include <gonio/measure/sphere_cases.hpp>
#include <gonio/measure/sphere_truth.hpp>
#include <gonio/shading/irradiance_sphere.hpp>
#include <gonio/shading/irradiance_sphere_named.hpp>
#include <gonio/shading/kernels.hpp>

#include "../reference_rows.hpp"
#include "poses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace {

using gonio::measure::Random;
using gonio::measure::sphere_irradiance_by_quadrature;
using gonio::shading::dot;
using gonio::shading::irradiance_sphere;
using poses::Pose;
using poses::Vec;
constexpr double pi = std::numbers::pi;

double exact(const Pose& pose) {
    return irradiance_sphere(pose.center, pose.radius, pose.normal);
}

double subtended(const Pose& pose) {
    return 2.0 * std::asin(std::min(1.0, pose.radius / std::sqrt(dot(pose.center, pose.center))));
}

// The largest change of the result when one input moves to a neighbouring double: no code can be more accurate.
double conditioning(const Pose& pose) {
    const double base = exact(pose);
    double worst = 0.0;
    for (int k = 0; k < 7; ++k)
        for (const double direction : {-1e300, 1e300}) {
            Pose moved = pose;
            double* const inputs[7] = {&moved.center.x, &moved.center.y, &moved.center.z, &moved.radius,
                                       &moved.normal.x, &moved.normal.y, &moved.normal.z};
            *inputs[k] = std::nextafter(*inputs[k], direction);
            worst = std::max(worst, std::fabs(exact(moved) - base));
        }
    return worst;
}

TEST(SphereIrradiance, StoredReferenceValues) {
    int rows = 0;
    double worst_share = 0.0;
    for (const auto& [kind, v] : gonio::test::irradiance_rows("sphere")) {
        const Pose pose{{v[0], v[1], v[2]}, v[9], {v[11], v[12], v[13]}};
        const double bar = std::max(1e-10 * v[14] + 1e-15 * subtended(pose), 50.0 * conditioning(pose));
        const double error = std::fabs(exact(pose) - v[14]);
        EXPECT_LE(error, bar) << "row " << rows;
        worst_share = std::max(worst_share, error / bar);
        ++rows;
    }
    EXPECT_GE(rows, 200);
    RecordProperty("worst_share_of_bar", std::to_string(worst_share));
}

TEST(SphereIrradiance, Quadrature) {
    Random random(11);
    double worst_relative = 0.0;
    for (unsigned i = 0; i < 5000; ++i) {
        const Pose pose = poses::random_pose(i, random);
        const double center[3] = {pose.center.x, pose.center.y, pose.center.z};
        const double normal[3] = {pose.normal.x, pose.normal.y, pose.normal.z};
        const double truth = sphere_irradiance_by_quadrature(center, pose.radius, normal);
        const double plain_bar = 1e-10 * truth + 1e-15 * subtended(pose);
        const double error = std::fabs(exact(pose) - truth);
        if (error > plain_bar) {
            EXPECT_LE(error, 50.0 * conditioning(pose)) << i << " truth " << truth;
        }
        if (truth > 1e-9) worst_relative = std::max(worst_relative, error / truth);
    }
    RecordProperty("worst_relative", std::to_string(worst_relative * 1e12) + "e-12");
}

TEST(SphereIrradiance, InsideAndTouching) {
    const Vec up{0.0, 0.0, 1.0};
    EXPECT_EQ(irradiance_sphere(Vec{0.0, 0.0, 0.0}, 1.0, up), pi);
    EXPECT_EQ(irradiance_sphere(Vec{0.3, -0.2, -0.9}, 1.0, up), pi);
    EXPECT_EQ(irradiance_sphere(Vec{0.0, 0.0, 0.0}, 0.0, up), 0.0);
    EXPECT_EQ(irradiance_sphere(Vec{1.0, 2.0, 3.0}, 0.0, up), 0.0);
    // (2, 3, 6)/7 is a unit vector with exact squares: the receiver is on the surface.
    for (const double cosine_sign : {1.0, -1.0}) {
        const Vec center{2.0, 3.0, 6.0 * cosine_sign};
        EXPECT_NEAR(irradiance_sphere(center, 7.0, up), pi * (1.0 + cosine_sign * 6.0 / 7.0) / 2.0, 4e-15);
    }
    EXPECT_NEAR(irradiance_sphere(Vec{0.0, 0.0, 5.0}, 5.0, up), pi, 1e-15);
    EXPECT_NEAR(irradiance_sphere(Vec{0.0, 0.0, -5.0}, 5.0, up), 0.0, 1e-15);
    EXPECT_NEAR(irradiance_sphere(Vec{5.0, 0.0, 0.0}, 5.0, up), pi / 2.0, 1e-15);
}

TEST(SphereIrradiance, HalfWayAtTheHorizonAndContinuousAcrossIt) {
    // c = 0 in closed form: σ − sinσ cosσ.
    const double sigma = std::asin(0.25);
    EXPECT_NEAR(irradiance_sphere(Vec{4.0, 0.0, 0.0}, 1.0, Vec{0.0, 0.0, 1.0}),
                sigma - std::sin(sigma) * std::cos(sigma), 1e-16);
    for (const double s : {0.9, 0.1, 1e-3}) {
        for (const double side : {1.0, -1.0}) {
            const auto at = [&](double c) {
                return irradiance_sphere(Vec{std::sqrt(1.0 - c * c), 0.0, c}, s, Vec{0.0, 0.0, 1.0});
            };
            const double inner = at(side * s * (1.0 - 1e-9));
            const double outer = at(side * s * (1.0 + 1e-9));
            EXPECT_NEAR(inner, outer, 1e-8 * s * s);
        }
    }
}

TEST(SphereIrradiance, DependsOnRatioAndAngleOnly) {
    Random random(12);
    for (unsigned i = 0; i < 2000; ++i) {
        const Pose pose = poses::random_pose(i, random);
        const double base = exact(pose);
        for (const double scale : {0x1p-300, 0x1p-40, 0x1p60, 0x1p300}) // powers of two: nothing is rounded
            EXPECT_EQ(irradiance_sphere(pose.center * scale, pose.radius * scale, pose.normal), base) << i;
        // A rotation by the orthonormal frame of a random pair.
        const Vec x = poses::random_direction(random);
        const Vec y = poses::unit(gonio::shading::cross(x, poses::random_direction(random)));
        const Vec z = gonio::shading::cross(x, y);
        const auto rotate = [&](Vec a) { return x * a.x + y * a.y + z * a.z; };
        const Pose turned{rotate(pose.center), pose.radius, rotate(pose.normal)};
        EXPECT_NEAR(exact(turned), base, 1e-12 * base + 100.0 * conditioning(pose) + 1e-15 * subtended(pose)) << i;
    }
}

TEST(SphereIrradiance, FarAwayItIsAPoint) {
    Random random(13);
    for (int i = 0; i < 200; ++i) {
        const Vec l = poses::random_direction(random);
        const Vec n = poses::tilted(l, random.uniform(0.01, 1.0), random);
        EXPECT_NEAR(irradiance_sphere(l * 1e6, 1.0, n), pi * 1e-12 * dot(n, l), 1e-26);
    }
}

// Every instruction set of this machine and the scalar float against double on the same float inputs.
class SphereKernels : public testing::TestWithParam<gonio::simd::InstructionSet> {};

INSTANTIATE_TEST_SUITE_P(Sets, SphereKernels,
                         testing::ValuesIn(gonio::simd::available_sets().begin(), gonio::simd::available_sets().end()),
                         [](const auto& each) { return std::string(gonio::simd::to_text(each.param)); });

TEST_P(SphereKernels, FloatWithinItsBarOfDouble) {
    const auto cases = gonio::measure::sphere_cases(200'000, 21);
    const auto light = gonio::measure::SphereCases::light();
    std::vector<float> lx(cases.size());
    gonio::shading::kernels(GetParam()).irradiance(cases.surfaces(), light, lx.data());
    double worst_share = 0.0;
    double worst_relative = 0.0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto at = [i](const auto& v) {
            return Vec{static_cast<double>(v[0][i]), static_cast<double>(v[1][i]), static_cast<double>(v[2][i])};
        };
        const Pose pose{at(cases.position) * -1.0, 1.0, at(cases.normal)};
        const double truth = exact(pose);
        const double error = std::fabs(static_cast<double>(lx[i]) - truth);
        const double share = error / (1e-5 * truth + 1e-6 * subtended(pose));
        EXPECT_LE(share, 1.0) << i << ' ' << gonio::measure::to_text(cases.stratum[i]) << " truth " << truth;
        worst_share = std::max(worst_share, share);
        if (cases.stratum[i] != gonio::measure::Stratum::far && truth > 1e-6)
            worst_relative = std::max(worst_relative, error / truth);
    }
    RecordProperty("worst_share_of_bar", std::to_string(worst_share));
    RecordProperty("worst_relative_not_far", std::to_string(worst_relative * 1e6) + "e-6");
}

// Very large and very small scenes: scaling by a power of two is exact, so nothing may change.
TEST_P(SphereKernels, SameAtAnyScale) {
    const auto cases = gonio::measure::sphere_cases(2000, 23);
    const auto& kernels = gonio::shading::kernels(GetParam());
    std::vector<float> base(cases.size());
    kernels.irradiance(cases.surfaces(), gonio::measure::SphereCases::light(), base.data());
    for (const float scale : {0x1p-100F, 0x1p-20F, 0x1p30F, 0x1p100F}) {
        auto scaled = cases;
        for (auto& component : scaled.position)
            for (float& p : component)
                p *= scale;
        auto light = gonio::measure::SphereCases::light();
        light.radius = scale;
        std::vector<float> lx(cases.size());
        kernels.irradiance(scaled.surfaces(), light, lx.data());
        EXPECT_EQ(lx, base) << scale;
    }
}

TEST_P(SphereKernels, AgreeWithScalar) {
    const auto cases = gonio::measure::sphere_cases(100'000, 22);
    const auto light = gonio::measure::SphereCases::light();
    std::vector<float> here(cases.size());
    std::vector<float> scalar(cases.size());
    gonio::shading::kernels(GetParam()).irradiance(cases.surfaces(), light, here.data());
    gonio::shading::kernels(gonio::simd::InstructionSet::scalar).irradiance(cases.surfaces(), light, scalar.data());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const double p[3] = {static_cast<double>(cases.position[0][i]), static_cast<double>(cases.position[1][i]),
                             static_cast<double>(cases.position[2][i])};
        const double s = 1.0 / std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        // The cosine of the centre differs by a few roundings of the dot product, the rest by a few ulp.
        ASSERT_NEAR(here[i], scalar[i], 2e-6 * static_cast<double>(scalar[i]) + 1e-6 * s * s) << i;
    }
}

TEST(SphereNamedMethods, AreWhatTheyAreKnownFor) {
    using gonio::shading::irradiance_sphere_frostbite;
    using gonio::shading::irradiance_sphere_point;
    Random random(14);
    for (unsigned i = 0; i < 5000; ++i) {
        const Pose pose = poses::random_pose(i, random);
        const double truth = exact(pose);
        const double s = pose.radius / std::sqrt(dot(pose.center, pose.center));
        const double c = dot(pose.normal, poses::unit(pose.center));
        const double frostbite = irradiance_sphere_frostbite(pose.center, pose.radius, pose.normal);
        ASSERT_TRUE(frostbite >= 0.0 && frostbite <= pi) << i;
        // Exact in double except for its clamps.
        if (std::fabs(c) < 0.999 && s * s < 0.9999 && s > 1e-3) {
            EXPECT_NEAR(frostbite, truth, 1e-9 + 1e-7 * truth) << i;
        }
        const double point = irradiance_sphere_point(pose.center, pose.radius, pose.normal);
        if (c >= s * 1.000001) {
            EXPECT_NEAR(point, truth, 1e-14 * truth) << i;
        } else {
            EXPECT_LE(point, truth * (1.0 + 1e-12) + 1e-20) << "a point sees less than a sphere that the horizon cuts";
        }
    }
}

} // namespace
