// Spot lobes: their flux against the closed forms, narrow cones in float, frusta; named methods with bad input.
#include <gonio/shading/falloff.hpp>
#include <gonio/shading/irradiance_named.hpp>

#include "poses.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace gonio::shading;
constexpr double pi = std::numbers::pi;

struct Family {
    const char* name;
    double (*lobe)(double, double, double);
    float (*lobe_float)(float, float, float);
    double (*flux)(double, double); // ∫ f sinθ dθ
};

double half_versine(double x) {
    return 2.0 * std::pow(std::sin(0.5 * x), 2.0);
}
double product(double a, double b) {
    return std::sin(0.5 * (a + b)) * std::sin(0.5 * (b - a));
}

const Family families[] = {
    {"hard", lobe_hard<double>, lobe_hard<float>, [](double, double b) { return half_versine(b); }},
    {"frostbite", lobe_frostbite<double>, lobe_frostbite<float>,
     [](double a, double b) { return half_versine(a) + 2.0 / 3.0 * product(a, b); }},
    {"linear_cos", lobe_linear_cos<double>, lobe_linear_cos<float>,
     [](double a, double b) { return half_versine(a) + product(a, b); }},
    {"smoothstep_cos", lobe_smoothstep_cos<double>, lobe_smoothstep_cos<float>,
     [](double a, double b) { return half_versine(a) + product(a, b); }},
    {"linear_angle", lobe_linear_angle<double>, lobe_linear_angle<float>,
     [](double a, double b) {
         const double m = 0.5 * (a + b);
         const double h = 0.5 * (b - a);
         return half_versine(m) + std::cos(m) * (1.0 - std::sin(h) / h);
     }},
    {"smoothstep_angle", lobe_smoothstep_angle<double>, lobe_smoothstep_angle<float>,
     [](double a, double b) {
         const double m = 0.5 * (a + b);
         const double h = 0.5 * (b - a);
         return half_versine(m) + std::cos(m) * (1.0 - 3.0 * (std::sin(h) - h * std::cos(h)) / (h * h * h));
     }},
};

TEST(SpotLobes, FluxIsThatOfTheClosedForm) {
    for (const Family& family : families) {
        for (const auto& [a, b] : {std::pair{0.2, 0.5}, {0.0, 0.7}, {0.6, 1.5}, {0.5, 2.5}, {0.05, 0.3}}) {
            double sum = 0.0;
            constexpr int steps = 20'000;
            const double ends[3] = {0.0, a, b};
            for (int piece = 0; piece < 2; ++piece)
                for (int i = 0; i < steps; ++i) {
                    const double width = (ends[piece + 1] - ends[piece]) / steps;
                    const double theta = ends[piece] + width * (i + 0.5);
                    sum += family.lobe(theta, a, b) * std::sin(theta) * width;
                }
            EXPECT_NEAR(sum, family.flux(a, b), 1e-8) << family.name << ' ' << a << ' ' << b;
        }
    }
}

TEST(SpotLobes, EdgesAndSteps) {
    for (const Family& family : families) {
        SCOPED_TRACE(family.name);
        EXPECT_EQ(family.lobe(0.0, 0.2, 0.5), 1.0);
        EXPECT_EQ(family.lobe(0.2, 0.2, 0.5), 1.0);
        EXPECT_EQ(family.lobe(0.5001, 0.2, 0.5), 0.0);
        EXPECT_EQ(family.lobe(pi, 0.2, 0.5), 0.0);
        EXPECT_EQ(family.lobe(0.3, 0.3, 0.3), 1.0) << "a = b is hard";
        EXPECT_EQ(family.lobe(0.3001, 0.3, 0.3), 0.0);
        EXPECT_EQ(family.lobe(0.0, 0.0, 0.0), 1.0);
        double last = 1.0;
        for (int i = 0; i <= 1000; ++i) {
            const double f = family.lobe(0.6 * i / 1000.0, 0.2, 0.5);
            EXPECT_LE(f, last + 1e-15);
            last = f;
        }
    }
}

// A cone of 0.01° to 0.02°; all its cosines are 1 in float.
TEST(SpotLobes, NarrowConesKeepTheirDigitsInFloat) {
    const double a = 0.01 * pi / 180.0;
    const double b = 0.02 * pi / 180.0;
    for (const Family& family : families) {
        for (int i = 0; i <= 100; ++i) {
            const auto theta = static_cast<float>(a + (b - a) * (0.005 + 0.99 * i / 100.0));
            const double expected = family.lobe(static_cast<double>(theta), static_cast<double>(static_cast<float>(a)),
                                                static_cast<double>(static_cast<float>(b)));
            EXPECT_NEAR(family.lobe_float(theta, static_cast<float>(a), static_cast<float>(b)), expected, 2e-6)
                << family.name << ' ' << i;
        }
    }
    const vec3<float> aim{0, 0, -1};
    EXPECT_NEAR(angle_from_aim(aim, vec3<float>{1e-4F, 0, -1}), 1e-4F, 1e-11F);
    EXPECT_NEAR(angle_from_aim(aim, vec3<float>{3, 0, 0}), pi / 2.0, 1e-6);
}

// The share of directions inside is the frustum's solid angle, 4 asin(sin(a/2) sin(b/2)).
TEST(SpotLobes, FrustumHasItsSolidAngle) {
    poses::Random random(71);
    const double x = 0.6;
    const double y = 0.3;
    int inside = 0;
    constexpr int count = 400'000;
    for (int i = 0; i < count; ++i)
        inside += inside_frustum(poses::random_direction(random), x, y) > 0.0 ? 1 : 0;
    const double share = 4.0 * std::asin(std::sin(x) * std::sin(y)) / (4.0 * pi);
    EXPECT_NEAR(static_cast<double>(inside) / count, share, 4.0 * std::sqrt(share / count));
    EXPECT_EQ(inside_frustum(vec3<double>{0, 0, -1}, x, y), 0.0);
}

TEST(NamedMethods, FacingAndFarTheyAgreeWithTheInverseSquare) {
    const vec3<double> c{0, 0, 100};
    const vec3<double> axis{0, 0, -1};
    const vec3<double> x{1, 0, 0};
    const vec3<double> up{0, 0, 1};
    EXPECT_NEAR(irradiance_disk_point(c, axis, 1.0, up), pi * 1e-4, 1e-12);
    EXPECT_NEAR(irradiance_disk_frostbite(c, axis, 1.0, up), pi * 1e-4, 2e-3 * pi * 1e-4); // its clamp of the cosine
    EXPECT_NEAR(irradiance_rectangle_point(c, axis, x, 2.0, 1.0, up), 2e-4, 1e-12);
    EXPECT_NEAR(irradiance_rectangle_frostbite(c, axis, x, 2.0, 1.0, up), 2e-4, 1e-7);
    const double tube = (pi + 2.0 * 2.0) * 1e-4;
    EXPECT_NEAR(irradiance_tube_point(c, x, 1.0, 2.0, up), tube, 1e-12);
    EXPECT_NEAR(irradiance_tube_frostbite(c, x, 1.0, 2.0, up), tube, 1e-3 * tube);
    EXPECT_NEAR(irradiance_tube_ue4(c, x, 1.0, 2.0, up), pi * 1e-4 / 2.0 * (2.0 + 2.0), 1e-3 * tube);
    // A light behind the plane gives nothing.
    EXPECT_EQ(irradiance_disk_frostbite(c, up, 1.0, up), 0.0);
    EXPECT_EQ(irradiance_rectangle_frostbite(c, up, x, 2.0, 1.0, up), 0.0);
}

TEST(NamedMethods, NeverNaNNorNegative) {
    poses::Random random(72);
    for (int i = 0; i < 20'000; ++i) {
        const auto f = [&](double low, double high) { return static_cast<float>(random.uniform(low, high)); };
        const auto unit = [&] {
            const poses::Vec d = i % 7 == 0 ? poses::Vec{0, 0, 1} : poses::random_direction(random);
            return vec3<float>{static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)};
        };
        const vec3<float> c = i % 11 == 0  ? vec3<float>{0, 0, 0}
                              : i % 5 == 0 ? vec3<float>{0, 0, f(-2, 2)}
                                           : vec3<float>{f(-2, 2), f(-2, 2), f(-2, 2)};
        const float p = i % 13 == 0 ? 0.0F : f(0.0, 2.0);
        const float q = i % 17 == 0 ? 0.0F : f(0.0, 2.0);
        const vec3<float> axis = unit();
        const vec3<float> n = unit();
        const vec3<float> x = unit();
        for (const float e :
             {irradiance_disk_point(c, axis, p, n), irradiance_disk_frostbite(c, axis, p, n),
              irradiance_rectangle_point(c, axis, x, p, q, n), irradiance_rectangle_frostbite(c, axis, x, p, q, n),
              irradiance_tube_point(c, axis, p, q, n), irradiance_tube_frostbite(c, axis, p, q, n),
              irradiance_tube_ue4(c, axis, p, q, n), irradiance_sphere_ue4(c, p, n)})
            ASSERT_TRUE(std::isfinite(e) && e >= 0.0F) << i << ' ' << e;
    }
}

} // namespace
