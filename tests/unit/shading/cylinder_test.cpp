// The side of a cylinder: its irradiance against quadrature over its area in long double, in all strata of poses; in
// parts, scaled, from afar and inside; float against double; the rectangle that stands for it in highlights.
#include <gonio/shading/irradiance_area.hpp>
#include <gonio/shading/sample_cylinder.hpp>

#include "../scaled.hpp"
#include "area_truth.hpp"
#include "poses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace gonio::shading;
using area::Pose;
using area::Real;
using gonio::measure::hostile::Stratum;
using gonio::measure::hostile::stratum_count;
using gonio::measure::hostile::stratum_names;
using gonio::test::scaled;
using poses::Random;
using poses::Vec;

constexpr double pi = std::numbers::pi;

// A capsule's pose stands for that of the cylinder between its ends.
double exact(const Pose& pose) {
    return irradiance_cylinder(pose.center, pose.axis, pose.p, pose.q, pose.normal);
}

float in_float(const Pose& pose) {
    const auto of = [](Vec v) {
        return vec3<float>{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    };
    return irradiance_cylinder(of(pose.center), of(pose.axis), static_cast<float>(pose.p), static_cast<float>(pose.q),
                               of(pose.normal));
}

Pose pose_of(Stratum stratum, Random& random) {
    namespace hostile = gonio::measure::hostile;
    return hostile::receiver(hostile::random_light(area::Shape::tube, random), stratum, random);
}

// ∬ ⟨n·p⟩ (m·p)/|p|⁴ over the visible side, m its normal: lines along the axis, each clipped by the horizon.
double by_area(const Pose& pose) {
    const auto dot = [](Vec a, Vec b) { return Real(a.x) * b.x + Real(a.y) * b.y + Real(a.z) * b.z; };
    const Real z = dot(pose.axis, pose.center);
    const Vec to_line = gonio::shading::detail::perpendicular(pose.center, pose.axis);
    const Real d = std::sqrt(dot(to_line, to_line));
    const Real r = pose.p;
    if (d <= r) return 0.0;
    const Vec f = poses::unit(to_line);
    const Vec g = cross(pose.axis, f);
    const Real n_a = dot(pose.normal, pose.axis);
    const Real n_f = dot(pose.normal, f);
    const Real n_g = dot(pose.normal, g);
    const Real ends[2] = {z - Real(pose.q) / 2, z + Real(pose.q) / 2};
    const Real reach = r * std::hypot(n_f, n_g);
    const Real gap = d - r;
    std::vector<Real> splits = area::around(0, gap / r);
    const auto crossings = [&](Real at, Real width) {
        const Real level = n_f * d + n_a * at;
        if (!(std::fabs(level) < reach)) return;
        const Real half = std::acos(level / reach);
        for (const Real phi : {std::atan2(-n_g, n_f) - half, std::atan2(-n_g, n_f) + half}) {
            const Real turned = std::remainder(phi, 2 * std::numbers::pi_v<Real>);
            const std::vector<Real> at_it = width > 0 ? area::around(turned, width) : std::vector<Real>{turned};
            splits.insert(splits.end(), at_it.begin(), at_it.end());
        }
    };
    crossings(ends[0], 0);
    crossings(ends[1], 0);
    crossings(0, std::fabs(n_a) * gap / std::max(reach, Real(1e-30L))); // where the horizon sweeps over the peak
    const Real widest = std::acos(r / d);
    return static_cast<double>(area::integrate_split(-widest, widest, splits, [&](Real phi) -> Real {
        const Real half = std::sin(phi / 2);
        const Real p_f = gap + 2 * r * half * half;
        const Real p_g = r * std::sin(phi);
        const Real rho2 = p_f * p_f + p_g * p_g;
        const Real facing = r * (gap - 2 * d * half * half);
        const Real level = n_f * p_f + n_g * p_g;
        Real low = ends[0];
        Real high = ends[1];
        if (n_a > 0) low = std::max(low, -level / n_a);
        if (n_a < 0) high = std::min(high, -level / n_a);
        if ((n_a == 0 && level <= 0) || !(high > low) || facing <= 0) return 0;
        return facing * area::integrate_split(low, high, area::around(0, std::sqrt(rho2)), [&](Real at) {
                   const Real d2 = rho2 + at * at;
                   return std::max(level + n_a * at, Real(0)) / (d2 * d2);
               });
    }));
}

// The largest change when one input moves to a neighbouring double.
double conditioning(const Pose& pose) {
    const double base = exact(pose);
    double worst = 0.0;
    for (std::size_t k = 0; k < 11; ++k)
        for (const double direction : {-1e300, 1e300}) {
            Pose moved = pose;
            double* const inputs[11] = {&moved.center.x, &moved.center.y, &moved.center.z, &moved.axis.x,
                                        &moved.axis.y,   &moved.axis.z,   &moved.normal.x, &moved.normal.y,
                                        &moved.normal.z, &moved.p,        &moved.q};
            *inputs[k] = std::nextafter(*inputs[k], direction);
            worst = std::max(worst, std::fabs(exact(moved) - base));
        }
    return worst;
}

TEST(Cylinder, DoubleAgainstQuadratureOverItsArea) {
    Random random(5);
    std::array<double, stratum_count> worst{};
    int beside = 0;
    const int count = scaled(9'000);
    for (int i = 0; i < count; ++i) {
        const std::size_t stratum = static_cast<std::size_t>(i) % stratum_count;
        const Pose pose = pose_of(static_cast<Stratum>(stratum), random);
        const double truth = by_area(pose);
        const double value = exact(pose);
        ASSERT_TRUE(value >= 0.0 && value <= pi) << gonio::measure::hostile::to_text(pose);
        const double share = std::fabs(value - truth) / (1e-10 * truth + 1e-15 * area::subtended(pose));
        if (share > 1.0) {
            // On the surface the irradiance jumps to 0 within it.
            if (stratum == static_cast<std::size_t>(Stratum::on) && std::fabs(value - truth) > 1e-3) {
                ++beside;
                continue;
            }
            EXPECT_LE(std::fabs(value - truth), 50.0 * conditioning(pose))
                << stratum_names.at(stratum) << " truth " << truth << " got " << value << "\n  "
                << gonio::measure::hostile::to_text(pose);
            continue;
        }
        worst.at(stratum) = std::max(worst.at(stratum), share);
    }
    EXPECT_LE(beside, count / 50);
    for (std::size_t s = 0; s < stratum_count; ++s)
        RecordProperty(std::string("share_of_bar_") + stratum_names.at(s), std::to_string(worst.at(s)));
}

TEST(Cylinder, FloatAgainstDouble) {
    Random random(6);
    double worst = 0.0;
    for (int i = 0; i < scaled(45'000); ++i) {
        const std::size_t stratum = static_cast<std::size_t>(i) % stratum_count;
        const Pose pose = gonio::measure::hostile::as_float(pose_of(static_cast<Stratum>(stratum), random));
        const double truth = exact(pose);
        const double share =
            std::fabs(static_cast<double>(in_float(pose)) - truth) / (1e-5 * truth + 1e-6 * area::subtended(pose));
        EXPECT_LE(share, 1.0) << stratum_names.at(stratum) << " truth " << truth << "\n  "
                              << gonio::measure::hostile::to_text(pose);
        worst = std::max(worst, share);
    }
    RecordProperty("worst_share_of_bar", std::to_string(worst));
}

// Without caps the parts of a cylinder are cylinders, and nothing is between them.
TEST(Cylinder, IsTheSumOfItsParts) {
    Random random(7);
    for (int i = 0; i < 3'000; ++i) {
        const Pose whole = pose_of(static_cast<Stratum>(i % 5), random);
        const double part = random.uniform(0.01, 0.99);
        Pose first = whole;
        Pose second = whole;
        first.q = part * whole.q;
        second.q = whole.q - first.q;
        first.center = whole.center - whole.axis * (0.5 * (whole.q - first.q));
        second.center = whole.center + whole.axis * (0.5 * (whole.q - second.q));
        const double all = exact(whole);
        EXPECT_NEAR(exact(first) + exact(second), all,
                    1e-10 * all + 1e-15 * area::subtended(whole) + 50.0 * conditioning(whole))
            << gonio::measure::hostile::to_text(whole);
    }
}

TEST(Cylinder, IsTheSameScaledTurnedAndMirrored) {
    Random random(8);
    for (int i = 0; i < 3'000; ++i) {
        const Pose pose = pose_of(static_cast<Stratum>(i % 5), random);
        const double e = exact(pose);
        Pose large = pose;
        large.center = pose.center * 0x1p70;
        large.p = pose.p * 0x1p70;
        large.q = pose.q * 0x1p70;
        EXPECT_EQ(exact(large), e);
        Pose other_way = pose;
        other_way.axis = pose.axis * -1.0;
        other_way.p = -pose.p;
        const double near = 1e-10 * e + 1e-15 * area::subtended(pose) + 50.0 * conditioning(pose);
        EXPECT_NEAR(exact(other_way), e, near);
        // Axes permuted: a rotation without rounding.
        const auto turned = [](Vec v) { return Vec{v.y, v.z, v.x}; };
        Pose rotated = pose;
        rotated.center = turned(pose.center);
        rotated.axis = turned(pose.axis);
        rotated.normal = turned(pose.normal);
        EXPECT_NEAR(exact(rotated), e, near);
    }
}

TEST(Cylinder, ShinesLikeSineFromAfarAndNotFromWithin) {
    const Vec axis{1.0, 0.0, 0.0};
    for (const double theta : {0.01, 0.3, 1.0, 0.5 * pi, 3.0}) {
        const Vec to{-std::cos(theta), 0.0, std::sin(theta)};
        // The near side is nearer than the axis, by r of d sin θ.
        const double by = 2.0 * 0.3 / (1e6 * std::sin(theta));
        const double e = irradiance_cylinder(to * 1e6, axis, 0.3, 0.8, to);
        const double intensity = 2.0 * 0.3 * 0.8 * std::sin(theta);
        EXPECT_NEAR(e * 1e12, intensity, by * intensity) << theta;
        EXPECT_NEAR(irradiance_cylinder_point(to * 1e6, axis, 0.3, 0.8, to) / e, 1.0, by);
    }
    const Vec up{0.0, 0.0, 1.0};
    EXPECT_EQ(irradiance_cylinder(Vec{0.1, 0.1, 0.1}, axis, 0.3, 0.8, up), 0.0) << "inside";
    EXPECT_EQ(irradiance_cylinder(Vec{5.0, 0.1, 0.1}, axis, 0.3, 0.8, axis), 0.0) << "before its end";
    EXPECT_EQ(irradiance_cylinder(Vec{0.0, 0.0, 5.0}, axis, 0.0, 0.8, up), 0.0);
    EXPECT_EQ(irradiance_cylinder(Vec{0.0, 0.0, 5.0}, axis, 0.3, 0.0, up), 0.0);
    EXPECT_NEAR(irradiance_cylinder(Vec{0.0, 0.0, 0.5}, axis, 0.5, 1.0, up), pi, 1e-14) << "on its surface";
    EXPECT_NEAR(irradiance_cylinder(Vec{0.0, 0.0, 0.5 * (1.0 + 1e-13)}, axis, 0.5, 1.0, up), pi, 1e-6);
    EXPECT_NEAR(irradiance_cylinder(Vec{0.0, 0.0, 0.5}, axis, 0.5, 1.0, axis), 0.5 * pi, 1e-14);
}

// The rectangle's solid angle, which scales what highlights add up, from the side and from beyond the ends.
TEST(Cylinder, IsNearlyARectangleForHighlights) {
    Random random(9);
    double worst = 0.0;
    double sum = 0.0;
    constexpr int count = 2'000;
    for (int i = 0; i < count; ++i) {
        const double r = random.uniform(0.01, 1.0);
        const double l = random.uniform(0.05, 4.0);
        const Vec axis{1.0, 0.0, 0.0};
        const Vec center{random.uniform(-4.0, 4.0), 0.0, r * random.uniform(1.5, 10.0)};
        const Vec n = poses::unit(center);
        const CylinderLight<double> light{center, {1.0, 1.0, 1.0}, axis, r, l, 0.0};
        const auto seen = light.seen_from(center);
        const double by_rectangle = gonio::shading::detail::irradiance(seen.light, seen.to_center, n);
        const double error = std::fabs(by_rectangle / gonio::shading::detail::irradiance(light, center, n) - 1.0);
        worst = std::max(worst, error);
        sum += error;
    }
    EXPECT_LT(worst, 0.2);
    EXPECT_LT(sum / count, 0.03);
    RecordProperty("worst", std::to_string(worst));
    RecordProperty("mean", std::to_string(sum / count));
}

} // namespace
