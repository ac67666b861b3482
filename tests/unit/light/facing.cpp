// Illuminance of facing receivers against integrals over the visible light.
#include <gonio/light/shape_traits.hpp>
#include <gonio/shading/irradiance_disk.hpp>
#include <gonio/shading/irradiance_rectangle.hpp>
#include <gonio/shading/irradiance_tube.hpp>

#include "quadrature.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gonio {
namespace {

using std::numbers::pi;

constexpr double ratios[] = {1e-3, 0.03, 0.2, 1.0, 3.0, 30.0, 1e3, 1e6};

template<class Kind>
double facing_illuminance(const Kind& shape, Meters distance) {
    return ShapeTraits<Kind>::facing(shape, distance).value;
}

// [0, 1] halved repeatedly towards 0, so that a light much closer than its size is resolved.
template<class F>
double halving_integral(F&& f) {
    double sum = 0.0;
    double to = 1.0;
    for (int i = 0; i < 24; ++i) {
        sum += test::integral(0.5 * to, to, 1, f);
        to *= 0.5;
    }
    return sum + test::integral(0.0, to, 1, f);
}

TEST(Facing, DiskIsTheSumOfItsRings) {
    const double r = 0.7;
    for (const double ratio : ratios) {
        const double d = ratio * r;
        const double truth = halving_integral([&](double x) {
            const double rho = r * x;
            const double q = d * d + rho * rho;
            return 2.0 * pi * rho * r * d * d / (q * q);
        });
        EXPECT_NEAR(facing_illuminance(DiskShape{Meters(r), false}, Meters(d)), truth, 1e-13 * truth) << ratio;
    }
}

TEST(Facing, RectangleIsTheSumOfItsPoints) {
    for (const double height : {0.3, 2.0, 1e-3})
        for (const double ratio : ratios) {
            const double a = 0.5;
            const double b = 0.5 * height;
            const double d = ratio;
            const double truth = 4.0 * a * b * halving_integral([&](double x) {
                                     return halving_integral([&](double y) {
                                         const double q = d * d + a * a * x * x + b * b * y * y;
                                         return d * d / (q * q);
                                     });
                                 });
            const RectShape rect{Meters(1.0), Meters(height), false};
            EXPECT_NEAR(facing_illuminance(rect, Meters(d)), truth, 1e-12 * truth) << height << " " << ratio;
        }
}

// Half planes through the receiver along the axis, at angle α from the direction to the axis, cut the capsule in
// stadiums: E/L = ∫ cosα (β + sinβ cosβ) dα up to the elevation β at which the stadium ends.
double tube_by_sections(double r, double l, double d) {
    const double s = r / d;
    const auto section = [&](double t) { // sinα = s sin t
        const double sin_alpha = s * std::sin(t);
        const double near = d * std::sqrt((1.0 - sin_alpha) * (1.0 + sin_alpha));
        const double thick = r * std::cos(t);
        const double to_end = std::hypot(near, 0.5 * l);
        const double beta = std::atan2(0.5 * l, near) + std::asin(std::min(thick / to_end, 1.0));
        return (beta + std::sin(beta) * std::cos(beta)) * s * std::cos(t);
    };
    // Steep as t approaches π/2 on contact, so halve towards there.
    return 2.0 * halving_integral([&](double x) { return section(0.5 * pi * (1.0 - x)) * 0.5 * pi; });
}

TEST(Facing, TubeIsTheSumOfItsSections) {
    for (const double l : {1e-6, 0.01, 0.2, 1.0, 30.0, 1e5})
        for (const double ratio : {1.0, 1.0 + 1e-9, 1.01, 2.0, 10.0, 1e3, 1e6}) {
            const double r = 0.1;
            const double d = ratio * r;
            const double truth = tube_by_sections(r, l, d);
            const double made = facing_illuminance(TubeShape{Meters(r), Meters(l)}, Meters(d));
            EXPECT_NEAR(made, truth, 1e-12 * truth) << l << " " << ratio;
        }
}

// "lx@d" gives the same illuminance as the shading for that receiver.
TEST(Facing, AgreesWithTheShading) {
    using Vec = shading::vec3<double>;
    const Vec up{0.0, 0.0, 1.0};
    for (const double d : {0.11, 0.2, 1.0, 7.0, 500.0}) {
        const Vec center{0.0, 0.0, d};
        const Vec down{0.0, 0.0, -1.0};
        const Vec x{1.0, 0.0, 0.0};
        const double disk = facing_illuminance(DiskShape{Meters(0.4), false}, Meters(d));
        EXPECT_NEAR(shading::irradiance_disk(center, down, 0.4, up), disk, 1e-12 * disk) << d;
        const double rect = facing_illuminance(RectShape{Meters(0.6), Meters(0.3), false}, Meters(d));
        EXPECT_NEAR(shading::irradiance_rectangle(center, down, x, 0.6, 0.3, up), rect, 1e-9 * rect) << d;
        const double tube = facing_illuminance(TubeShape{Meters(0.1), Meters(1.2)}, Meters(d));
        EXPECT_NEAR(shading::irradiance_tube(center, x, 0.1, 1.2, up), tube, 1e-9 * tube) << d;
    }
}

TEST(Facing, MeetsItsLimits) {
    const auto disk = [](double r, double d) { return facing_illuminance(DiskShape{Meters(r), false}, Meters(d)); };
    const auto rect = [](double w, double h, double d) {
        return facing_illuminance(RectShape{Meters(w), Meters(h), false}, Meters(d));
    };
    const auto tube = [](double r, double l, double d) {
        return facing_illuminance(TubeShape{Meters(r), Meters(l)}, Meters(d));
    };
    // On contact the light fills the hemisphere.
    EXPECT_NEAR(disk(1, 1e-9), pi, 1e-15);
    EXPECT_NEAR(rect(1, 2, 1e-9), pi, 1e-8);
    EXPECT_NEAR(tube(0.1, 1, 0.1), pi, 1e-15);
    // Far away the inverse square holds.
    EXPECT_NEAR(disk(1, 1e9) * 1e18, pi, 1e-14);
    EXPECT_NEAR(rect(1, 2, 1e9) * 1e18, 2.0, 1e-14);
    EXPECT_NEAR(tube(0.1, 1, 1e9) * 1e18, 0.2 + pi * 0.01, 1e-15);
    // A tube of length 0 is a sphere, an endless tube gives π r/d.
    EXPECT_NEAR(tube(0.1, 1e-300, 0.3), pi / 9, 1e-15);
    EXPECT_NEAR(tube(0.1, 1e9, 0.3), pi / 3, 1e-9);
    // No intermediate value overflows.
    EXPECT_GT(disk(1e-200, 1e-100), 0.0);
    EXPECT_NEAR(disk(1e200, 1e190), pi, 1e-15);
    EXPECT_NEAR(rect(1e200, 1e200, 1e190), pi, 1e-9);
}

TEST(Facing, IsWhatAnIlluminanceMeans) {
    const auto lux = [](const char* shape, const char* at) { return test::convert(test::shape(shape), "1000nt", at); };
    EXPECT_NEAR(lux("disk:r=10cm", "lx@50cm"), 1000 * pi * 0.01 / 0.26, 1e-11);
    EXPECT_NEAR(lux("rect:w=60cm,h=30cm", "lx@50cm"),
                1000 * facing_illuminance(RectShape{Meters(0.6), Meters(0.3), false}, Meters(0.5)), 1e-10);
    EXPECT_NEAR(lux("tube:r=1.3cm,l=1.2m", "lx@50cm"), 1000 * tube_by_sections(0.013, 1.2, 0.5), 1e-10);
    EXPECT_NEAR(lux("sphere:r=3cm", "lx@50cm"), 1000 * pi * 0.0036, 1e-12);
}

} // namespace
} // namespace gonio
