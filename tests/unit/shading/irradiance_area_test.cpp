// The exact irradiance of disk, rectangle and tube in double: against stored values, quadrature, each other, and
// themselves in other units.
#include <gonio/shading/irradiance_sphere.hpp>
#include <gonio/shading/occlusion.hpp>

#include "../reference_rows.hpp"
#include "../scaled.hpp"
#include "area_truth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace gonio::shading;
using area::conditioning;
using area::exact;
using area::Pose;
using area::Shape;
using area::subtended;
using gonio::test::scaled;
using poses::Random;
using poses::Vec;
constexpr double pi = std::numbers::pi;

double log_uniform(Random& random, double low, double high) {
    return std::exp(random.uniform(std::log(low), std::log(high)));
}

// In front of one-sided lights; d/size as given; half of them straddle the horizon.
Pose random_pose(Shape shape, double least, double most, Random& random) {
    Pose pose;
    pose.shape = shape;
    pose.axis = poses::random_direction(random);
    pose.across = poses::unit(cross(pose.axis, poses::random_direction(random)));
    pose.p = log_uniform(random, 1e-2, 1e2);
    pose.q = pose.p * log_uniform(random, 0.02, 50.0);
    Vec away = poses::random_direction(random);
    if (dot(away, pose.axis) > 0.0) away = away * -1.0;
    const double ratio = log_uniform(random, least, most);
    pose.center = away * (ratio * area::bounding_radius(pose));
    const double s = std::min(1.0, 1.0 / ratio);
    const double cosine = random.uniform() < 0.5 ? random.uniform(-s, s) : random.uniform(-1.0, 1.0);
    pose.normal = poses::tilted(away, cosine, random);
    return pose;
}

class AreaIrradiance : public testing::TestWithParam<Shape> {};

std::string name_of(Shape shape) {
    return shape == Shape::disk ? "disk" : shape == Shape::rectangle ? "rect" : "tube";
}

INSTANTIATE_TEST_SUITE_P(Shapes, AreaIrradiance, testing::Values(Shape::disk, Shape::rectangle, Shape::tube),
                         [](const auto& each) { return name_of(each.param); });

TEST_P(AreaIrradiance, StoredReferenceValues) {
    int rows = 0;
    double worst_share = 0.0;
    for (const auto& [kind, v] : gonio::test::irradiance_rows(name_of(GetParam()))) {
        const Pose pose{GetParam(), {v[0], v[1], v[2]},   {v[3], v[4], v[5]}, {v[6], v[7], v[8]}, v[9],
                        v[10],      {v[11], v[12], v[13]}};
        const double plain_bar = 1e-10 * v[14] + 1e-15 * subtended(pose);
        const double error = std::fabs(exact<double>(pose) - v[14]);
        if (error > plain_bar) {
            EXPECT_LE(error, 50.0 * conditioning(pose)) << "row " << rows;
        }
        worst_share = std::max(worst_share, error / plain_bar);
        ++rows;
    }
    EXPECT_GE(rows, 200);
    RecordProperty("worst_share_of_plain_bar", std::to_string(worst_share));
}

TEST_P(AreaIrradiance, Quadrature) {
    Random random(51);
    double worst_relative = 0.0;
    for (int i = 0; i < scaled(300); ++i) {
        const double ranges[4][2] = {{0.05, 1.0}, {1.01, 3.0}, {3.0, 100.0}, {100.0, 1e6}};
        Pose pose = random_pose(GetParam(), ranges[i % 4][0], ranges[i % 4][1], random);
        if (GetParam() == Shape::tube) { // the quadrature needs the receiver outside the extended tube
            const double d = length(detail::perpendicular(pose.center, pose.axis));
            if (d < 1.001 * pose.p) continue;
        }
        const double truth = area::by_quadrature(pose);
        const double error = std::fabs(exact<double>(pose) - truth);
        const double bar = 1e-10 * truth + 1e-15 * subtended(pose);
        if (error > bar) {
            EXPECT_LE(error, 50.0 * conditioning(pose))
                << i << " truth " << truth << " got " << exact<double>(pose) << " error " << error;
        }
        if (truth > 1e-9) worst_relative = std::max(worst_relative, error / truth);
    }
    RecordProperty("worst_relative", std::to_string(worst_relative * 1e12) + "e-12");
}

TEST_P(AreaIrradiance, DependsOnRatiosAndAnglesOnly) {
    Random random(52);
    for (int i = 0; i < scaled(4000); ++i) {
        const Pose pose = random_pose(GetParam(), 0.05, 100.0, random);
        const double base = exact<double>(pose);
        for (const double scale : {0x1p-300, 0x1p-40, 0x1p60, 0x1p300}) { // powers of two: nothing is rounded
            Pose other = pose;
            other.center = pose.center * scale;
            other.p *= scale;
            other.q *= scale;
            EXPECT_EQ(exact<double>(other), base) << i;
        }
        const Vec x = poses::random_direction(random);
        const Vec y = poses::unit(cross(x, poses::random_direction(random)));
        const Vec z = cross(x, y);
        const auto rotate = [&](Vec a) { return x * a.x + y * a.y + z * a.z; };
        const Pose turned{pose.shape, rotate(pose.center), rotate(pose.axis), rotate(pose.across), pose.p,
                          pose.q,     rotate(pose.normal)};
        EXPECT_NEAR(exact<double>(turned), base, 1e-11 * base + 100.0 * conditioning(pose) + 2e-15 * subtended(pose))
            << i;
    }
}

TEST_P(AreaIrradiance, FarAwayItIsItsIntensity) {
    Random random(53);
    for (int i = 0; i < 300; ++i) {
        const Pose pose = random_pose(GetParam(), 1e5, 1e6, random);
        const Vec l = poses::unit(pose.center);
        const double cosine = dot(pose.normal, l);
        if (cosine < 0.05) continue;
        const double facing = -dot(pose.axis, l);
        const double side = length(cross(pose.axis, l));
        double intensity = pi * pose.p * pose.p * facing;
        if (GetParam() == Shape::rectangle) intensity = pose.p * pose.q * facing;
        if (GetParam() == Shape::tube) intensity = 2.0 * pose.p * pose.q * side + pi * pose.p * pose.p;
        const double expected = intensity * cosine / dot(pose.center, pose.center);
        EXPECT_NEAR(exact<double>(pose), expected, 1e-3 * expected) << i;
        if (cosine > 0.3 && facing > 0.3) {
            EXPECT_NEAR(exact<double>(pose), expected, 1e-4 * expected) << i;
        }
    }
}

TEST(DiskIrradiance, OnTheAxisIsTheCapThatItLooksLike) {
    Random random(54);
    for (int i = 0; i < scaled(5000); ++i) {
        const Vec axis = i % 2 == 0 ? Vec{0.0, 0.0, 1.0} : poses::random_direction(random);
        const double h = log_uniform(random, 1e-4, 1e4);
        const Vec normal = poses::random_direction(random);
        const double disk = irradiance_disk(axis * -h, axis, 1.0, normal);
        // The sphere that touches the same cone: sinσ = 1/√(1 + h²), at distance 1.
        const double sine = 1.0 / std::sqrt(1.0 + h * h);
        const double cap = irradiance_sphere(axis * -1.0, sine, normal);
        EXPECT_NEAR(disk, cap, 1e-9 * cap + 4e-15 * sine + 1e-12 * sine) << i << ' ' << h;
    }
}

TEST(DiskIrradiance, InThePlaneAndTouching) {
    const Vec axis{0.0, 0.0, -1.0};
    const Vec up{0.0, 0.0, 1.0};
    const Vec slanted{0.6, 0.0, 0.8};
    EXPECT_NEAR(irradiance_disk(Vec{0, 0, 0}, axis, 1.0, up), pi, 1e-15);
    EXPECT_NEAR(irradiance_disk(Vec{0.5, 0.25, 0}, axis, 1.0, slanted), pi * 0.9, 1e-15);
    EXPECT_EQ(irradiance_disk(Vec{1.5, 0.25, 0}, axis, 1.0, slanted), 0.0);
    EXPECT_EQ(irradiance_disk(Vec{0.5, 0.25, -1e-12}, axis, 1.0, up), 0.0) << "behind";
    EXPECT_NEAR(irradiance_disk(Vec{0.5, 0.25, 1e-12}, axis, 1.0, slanted), pi * 0.9, 1e-11) << "just in front";
    EXPECT_EQ(irradiance_disk(Vec{0, 0, 1}, axis, 0.0, up), 0.0);
    // Facing on the axis: π/(1 + h²).
    EXPECT_NEAR(irradiance_disk(Vec{0, 0, 2}, axis, 1.0, up), pi / 5.0, 1e-15);
    // A wall under a disk with its centre on the wall's edge line: half of the disk is above the horizon.
    EXPECT_NEAR(irradiance_disk(Vec{0, 0, 1}, axis, 1.0, Vec{1, 0, 0}),
                irradiance_disk(Vec{0, 0, 1}, axis, 1.0, Vec{-1, 0, 0}), 1e-15);
}

TEST(RectangleIrradiance, InThePlaneAndTouching) {
    const Vec axis{0.0, 0.0, -1.0};
    const Vec x{1.0, 0.0, 0.0};
    const Vec up{0.0, 0.0, 1.0};
    const Vec slanted{0.6, 0.0, 0.8};
    EXPECT_NEAR(irradiance_rectangle(Vec{0, 0, 0}, axis, x, 2.0, 1.0, up), pi, 1e-15);
    EXPECT_NEAR(irradiance_rectangle(Vec{0.75, 0.25, 0}, axis, x, 2.0, 1.0, slanted), pi * 0.9, 1e-15);
    EXPECT_EQ(irradiance_rectangle(Vec{0.75, 0.75, 0}, axis, x, 2.0, 1.0, slanted), 0.0);
    EXPECT_EQ(irradiance_rectangle(Vec{0.75, 0.25, -1e-12}, axis, x, 2.0, 1.0, up), 0.0) << "behind";
    EXPECT_NEAR(irradiance_rectangle(Vec{0.75, 0.25, 1e-12}, axis, x, 2.0, 1.0, slanted), pi * 0.9, 1e-10);
    EXPECT_EQ(irradiance_rectangle(Vec{0, 0, 1}, axis, x, 0.0, 1.0, up), 0.0);
    EXPECT_EQ(irradiance_rectangle(Vec{0, 0, 1}, axis, x, 1.0, 0.0, up), 0.0);
    // A corner of a 1 × 1 square over the receiver at distance 1 (the textbook's parallel plates): π F,
    // F = (1/2π)·2·(1/√2) atan(1/√2).
    EXPECT_NEAR(irradiance_rectangle(Vec{0.5, 0.5, 1.0}, axis, x, 1.0, 1.0, up),
                std::atan(std::sqrt(0.5)) / std::sqrt(2.0), 1e-15);
}

TEST(RectangleIrradiance, ItsPartsAddUp) {
    Random random(55);
    for (int i = 0; i < scaled(20'000); ++i) {
        const Pose whole = random_pose(Shape::rectangle, 0.05, i % 2 == 0 ? 3.0 : 300.0, random);
        const double share = random.uniform(0.05, 0.95);
        Pose left = whole;
        Pose right = whole;
        left.p = whole.p * share;
        right.p = whole.p * (1.0 - share);
        left.center = whole.center - whole.across * (0.5 * right.p);
        right.center = whole.center + whole.across * (0.5 * left.p);
        const double sum = exact<double>(left) + exact<double>(right);
        EXPECT_NEAR(sum, exact<double>(whole), 1e-10 * sum + 4e-15 * subtended(whole) + 100.0 * conditioning(whole))
            << i;
    }
}

TEST(TubeIrradiance, InsideAndTouching) {
    const Vec axis{1.0, 0.0, 0.0};
    const Vec up{0.0, 0.0, 1.0};
    EXPECT_EQ(irradiance_tube(Vec{0, 0, 0}, axis, 1.0, 4.0, up), pi);
    EXPECT_EQ(irradiance_tube(Vec{1.9, 0.3, 0.8}, axis, 1.0, 4.0, up), pi);
    EXPECT_EQ(irradiance_tube(Vec{2.9, 0, 0}, axis, 1.0, 4.0, up), pi);
    EXPECT_EQ(irradiance_tube(Vec{5, 0, 0}, axis, 0.0, 4.0, up), 0.0);
    // On the cylinder, π(1 + n·l)/2 with l the direction to the axis.
    for (const Vec n : {Vec{0, 0, 1}, Vec{0, 0, -1}, Vec{0, 0.6, 0.8}, Vec{0.8, 0, -0.6}, Vec{1, 0, 0}}) {
        EXPECT_NEAR(irradiance_tube(Vec{0.5, 0, 1}, axis, 1.0, 4.0, n), pi * (1.0 + n.z) / 2.0, 3e-8) << n.x << n.y;
        // On the end's tip.
        EXPECT_NEAR(irradiance_tube(Vec{3, 0, 0}, axis, 1.0, 4.0, n), pi * (1.0 + n.x) / 2.0, 3e-8) << n.x << n.y;
    }
    // On the extended axis only the nearer sphere is visible.
    EXPECT_EQ(irradiance_tube(Vec{5, 0, 0}, axis, 1.0, 4.0, Vec{1, 0, 0}),
              irradiance_sphere(Vec{3, 0, 0}, 1.0, Vec{1, 0, 0}));
}

// Nothing jumps across the boundary of "the nearer sphere alone" (D = r).
TEST(TubeIrradiance, ContinuousWhereOneEndHidesTheOther) {
    Random random(56);
    for (int i = 0; i < scaled(5000); ++i) {
        const Vec n = poses::random_direction(random);
        const double z = random.uniform(3.0, 20.0);
        const auto at = [&](double d) { return irradiance_tube(Vec{z, d, 0}, Vec{1, 0, 0}, 1.0, 4.0, n); };
        EXPECT_NEAR(at(1.0 - 1e-10), at(1.0 + 1e-10), 1e-9) << i;
    }
}

TEST(TubeIrradiance, WithoutLengthItIsASphere) {
    Random random(57);
    for (int i = 0; i < scaled(20'000); ++i) {
        Pose pose = random_pose(Shape::tube, 1.0001, 100.0, random);
        const double d = length(pose.center);
        pose.center = pose.center * (random.uniform(1.001, 50.0) * pose.p / d);
        pose.q = 0.0;
        const double sphere = irradiance_sphere(pose.center, pose.p, pose.normal);
        const double tolerance = 1e-12 * sphere + 4e-15 * subtended(pose) + 100.0 * conditioning(pose);
        EXPECT_NEAR(exact<double>(pose), sphere, tolerance) << i;
        pose.q = 1e-9 * pose.p;
        EXPECT_NEAR(exact<double>(pose), sphere, 1e-8 * sphere + 1e-8 * pose.p / length(pose.center)) << i;
    }
}

// Unclipped and thin: E = ∫ 2r sinγ ⟨n·l⟩/d² over the axis, by the midpoint rule.
TEST(TubeIrradiance, ThinItIsALambertLine) {
    Random random(58);
    for (int i = 0; i < scaled(300); ++i) {
        Pose pose = random_pose(Shape::tube, 1.0, 10.0, random);
        pose.q = 1.0;
        pose.p = 1e-6;
        pose.center = poses::random_direction(random) * random.uniform(0.8, 10.0);
        pose.normal = poses::unit(pose.center);
        double sum = 0.0;
        constexpr int steps = 4000;
        for (int k = 0; k < steps; ++k) {
            const Vec at = pose.center + pose.axis * ((k + 0.5) / steps - 0.5);
            const double d2 = dot(at, at);
            sum +=
                2.0 * pose.p * length(cross(pose.axis, at)) * std::max(0.0, dot(pose.normal, at)) / (d2 * d2 * steps);
        }
        EXPECT_NEAR(exact<double>(pose), sum, 1e-4 * sum) << i;
    }
}

// A disk and the square of the same area at a large distance, and a polygon of strips against the disk at any distance.
TEST(DiskIrradiance, IsTheLimitOfStrips) {
    Random random(59);
    for (int i = 0; i < scaled(60); ++i) {
        const Pose disk = random_pose(Shape::disk, 1.2, 10.0, random);
        const Vec y = cross(disk.axis, disk.across);
        constexpr int strips = 2000;
        double sum = 0.0;
        for (int k = 0; k < strips; ++k) {
            const double t0 = pi * k / strips;
            const double t1 = pi * (k + 1) / strips;
            const double middle = 0.5 * (std::cos(t0) + std::cos(t1)) * disk.p;
            const double height = disk.p * (std::cos(t0) - std::cos(t1));
            const double width = 2.0 * disk.p * std::sin(0.5 * (t0 + t1));
            sum += irradiance_rectangle(disk.center + y * middle, disk.axis, disk.across, width, height, disk.normal);
        }
        EXPECT_NEAR(exact<double>(disk), sum, 2e-6 * sum + 1e-9) << i;
    }
}

double hostile(Random& random) {
    static constexpr double special[] = {0.0,   -0.0,  1.0,    -1.0,  5e-324, 1e-310,  1e-300,  1e-160,
                                         1e-45, 1e-20, 1e-7,   0.5,   0.9999, 1.001,   1e10,    1e19,
                                         1e40,  1e155, -1e155, 1e300, -1e300, 1.7e308, -1.7e308};
    const std::uint64_t choice = random.bits() % 40;
    if (choice < std::size(special)) return special[choice];
    return random.uniform(-2.0, 2.0);
}

TEST_P(AreaIrradiance, HostileInputGivesANumberFromZeroToPi) {
    Random random(60);
    const auto pick = [&](Vec near) {
        const std::uint64_t choice = random.bits() % 8;
        if (choice < 4) return near;
        if (choice == 4) return Vec{0, 0, 1};
        if (choice == 5) return Vec{-1, 0, 0};
        return poses::random_direction(random);
    };
    for (int i = 0; i < scaled(1'000'000); ++i) {
        Pose pose;
        pose.shape = GetParam();
        pose.axis = pick(Vec{0, 1, 0});
        pose.across = i % 3 == 0 ? Vec{1, 0, 0} : poses::random_direction(random);
        pose.normal = pick(pose.axis);
        pose.center = {hostile(random), hostile(random), hostile(random)};
        pose.p = hostile(random);
        pose.q = hostile(random);
        const double e = exact<double>(pose);
        ASSERT_TRUE(e >= 0.0 && e <= pi) << i << ' ' << e << " center " << pose.center.x << ' ' << pose.center.y << ' '
                                         << pose.center.z << " sizes " << pose.p << ' ' << pose.q;
        const float f = exact<float>(pose); // numbers beyond the range of float become infinite: still no NaN
        ASSERT_TRUE(f >= 0.0F && f <= std::numbers::pi_v<float>)
            << i << ' ' << f << " center " << pose.center.x << ' ' << pose.center.y << ' ' << pose.center.z << " sizes "
            << pose.p << ' ' << pose.q;
    }
}

TEST(SkyVisibility, IsWhatTheOccluderLeaves) {
    const Vec up{0, 0, 1};
    EXPECT_NEAR(sky_visibility_sphere(Vec{0, 0, 2}, 1.0, up), 0.75, 1e-15);
    EXPECT_EQ(sky_visibility_sphere(Vec{0, 0, -2}, 1.0, up), 1.0);
    EXPECT_EQ(sky_visibility_sphere(Vec{0, 0, 0.5}, 1.0, up), 0.0);
    EXPECT_NEAR(sky_visibility_tube(Vec{0, 0, 2}, Vec{1, 0, 0}, 1.0, 0.0, up), 0.75, 1e-14);
    EXPECT_EQ(sky_visibility_tube(Vec{0, 0, -2}, Vec{1, 0, 0}, 1.0, 3.0, up), 1.0);
    // A cylinder of infinite length: the cosine-weighted share of the strip |sin| < s is s.
    EXPECT_NEAR(sky_visibility_tube(Vec{0, 0, 4}, Vec{1, 0, 0}, 1.0, 1e9, up), 0.75, 1e-9);
    EXPECT_NEAR(static_cast<double>(
                    sky_visibility_tube(vec3<float>{0, 0, 4}, vec3<float>{1, 0, 0}, 1.0F, 1e9F, vec3<float>{0, 0, 1})),
                0.75, 1e-6);
}

} // namespace
