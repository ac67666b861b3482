// Every shape in every stratum of poses: double against the outline in long double, float against double.
#include "../scaled.hpp"
#include "long_double_truth.hpp"
#include "stratified_poses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

namespace {

using area::Pose;
using area::Shape;
using area::Stratum;
using gonio::test::scaled;
using poses::Random;

class StratifiedIrradiance : public testing::TestWithParam<Shape> {};

std::string name_of(Shape shape) {
    constexpr const char* names[] = {"disk", "rectangle", "tube", "sphere"};
    return names[static_cast<std::size_t>(shape)];
}

INSTANTIATE_TEST_SUITE_P(Shapes, StratifiedIrradiance,
                         testing::Values(Shape::sphere, Shape::disk, Shape::rectangle, Shape::tube),
                         [](const auto& each) { return name_of(each.param); });

std::string text(const Pose& p, std::size_t stratum) {
    char line[400];
    (void)std::snprintf(line, sizeof line,
                        "%s center %.17g %.17g %.17g axis %.17g %.17g %.17g across %.17g %.17g %.17g sizes %.17g %.17g "
                        "normal %.17g %.17g %.17g",
                        area::stratum_names[stratum], p.center.x, p.center.y, p.center.z, p.axis.x, p.axis.y, p.axis.z,
                        p.across.x, p.across.y, p.across.z, p.p, p.q, p.normal.x, p.normal.y, p.normal.z);
    return line;
}

// On the light the irradiance jumps: there a value is right if it is right for a receiver moved by one rounding step.
bool right_beside(const Pose& pose, double value) {
    const double by = 1e-14 * std::fmax(std::sqrt(dot(pose.center, pose.center)), area::bounding_radius(pose));
    for (const poses::Vec step : {poses::Vec{by, 0, 0}, poses::Vec{0, by, 0}, poses::Vec{0, 0, by}})
        for (const double sign : {-1.0, 1.0}) {
            Pose moved = pose;
            moved.center = pose.center + step * sign;
            if (std::fabs(value - static_cast<double>(area::by_outline(moved))) < 1e-4) return true;
        }
    return false;
}

// At distance ρ from the rim of a disk, arcs change by the last digit of r/ρ, even where their sum does not.
double beside_the_rim(const Pose& pose) {
    if (pose.shape != Shape::disk) return 0.0;
    const double z = dot(pose.axis, pose.center);
    const double x = length(pose.center - pose.axis * z);
    return 2e-15 * pose.p / std::hypot(z, x - pose.p);
}

TEST_P(StratifiedIrradiance, DoubleAgainstLongDouble) {
    Random random(71);
    double worst[area::stratum_count] = {};
    int beside = 0;
    for (int i = 0; i < scaled(126'000); ++i) {
        const std::size_t stratum = static_cast<std::size_t>(i) % area::stratum_count;
        const Pose pose = area::receiver(area::random_light(GetParam(), random), static_cast<Stratum>(stratum), random);
        const double truth = static_cast<double>(area::by_outline(pose));
        const double value = area::exact<double>(pose);
        ASSERT_TRUE(value >= 0.0 && value <= std::numbers::pi) << text(pose, stratum);
        const double error = std::fabs(value - truth);
        const double bar = 1e-10 * truth + 1e-15 * area::subtended(pose);
        if (error > bar && std::fabs(error) > 1e-3 && right_beside(pose, value)) {
            ++beside;
            continue;
        }
        if (error > bar) {
            EXPECT_LE(error, std::fmax(50.0 * area::conditioning(pose), beside_the_rim(pose)))
                << i << " truth " << truth << " got " << value << "\n  " << text(pose, stratum);
            continue;
        }
        worst[stratum] = std::max(worst[stratum], error / bar);
    }
    EXPECT_LE(beside, scaled(126'000) / 50) << "a fifth of two strata lies in the plane or on the surface";
    for (std::size_t s = 0; s < area::stratum_count; ++s)
        RecordProperty(std::string("share_of_bar_") + area::stratum_names[s], std::to_string(worst[s]));
}

} // namespace
