// Ellipses: their irradiance against a contour integral that does not use disks, against disks, rotated, scaled and
// seen from both sides; as a disk of the same cone; float against double near their plane and in it.
#include <gonio/shading/irradiance_area.hpp>
#include <gonio/shading/sample_disk.hpp>
#include <gonio/shading/specular_named.hpp>

#include "poses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace {

using namespace gonio::shading;
using poses::Random;
using poses::Vec;
using Real = long double;

constexpr double pi = std::numbers::pi;

struct Pose {
    EllipseLight<double> light;
    Vec normal;
};

double irradiance(const Pose& pose) {
    return irradiance_ellipse(pose.light, pose.light.center, pose.normal);
}

// The contribution of the outline from t0 to t1 to ½∮ n·(p × dp)/|p|², by 16-point rules with halving.
class Contour {
public:
    explicit Contour(const Pose& pose) : pose_(pose) { up_ = cross(pose.light.axis, pose.light.width_direction); }

    [[nodiscard]] Real irradiance() const {
        const Vec u = pose_.light.width_direction * pose_.light.half_width;
        const Vec v = up_ * pose_.light.half_height;
        const Real height = dot(pose_.normal, pose_.light.center);
        const Real by_u = dot(pose_.normal, u);
        const Real by_v = dot(pose_.normal, v);
        const Real reach = std::hypot(by_u, by_v);
        constexpr Real turn = 2 * std::numbers::pi_v<Real>;
        if (height <= -reach) return 0;
        if (height >= reach) return std::fabs(between(0, turn));
        const Real middle = std::atan2(by_v, by_u);
        const Real half = std::acos(-height / reach);
        const Point from = at(middle + half);
        const Point to = at(middle - half);
        const Point n{pose_.normal.x, pose_.normal.y, pose_.normal.z};
        const Real closing = std::atan2(dot3(n, cross3(from, to)), dot3(from, to)) / 2;
        return std::fabs(between(middle - half, middle + half) + closing);
    }

private:
    struct Point {
        Real x, y, z;
    };
    static Real dot3(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    static Point cross3(const Point& a, const Point& b) {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }
    [[nodiscard]] Point along(Real by_center, Real by_u, Real by_v) const {
        const auto component = [&](double c, double u, double v) {
            return by_center * c + by_u * Real(pose_.light.half_width) * u + by_v * Real(pose_.light.half_height) * v;
        };
        const Vec& c = pose_.light.center;
        const Vec& w = pose_.light.width_direction;
        return {component(c.x, w.x, up_.x), component(c.y, w.y, up_.y), component(c.z, w.z, up_.z)};
    }
    [[nodiscard]] Point at(Real t) const { return along(1, std::cos(t), std::sin(t)); }
    [[nodiscard]] Real integrand(Real t) const {
        const Point p = at(t);
        const Point n{pose_.normal.x, pose_.normal.y, pose_.normal.z};
        return dot3(n, cross3(p, along(0, -std::sin(t), std::cos(t)))) / dot3(p, p) / 2;
    }
    [[nodiscard]] Real rule(Real low, Real high) const {
        static constexpr std::pair<Real, Real> nodes[] = {
            {0.0950125098376374401853193354249581L, 0.189450610455068496285396723208283L},
            {0.281603550779258913230460501460496L, 0.182603415044923588866763667969220L},
            {0.458016777657227386342419442983578L, 0.169156519395002538189312079030360L},
            {0.617876244402643748446671764048791L, 0.149595988816576732081501730547479L},
            {0.755404408355003033895101194847442L, 0.124628971255533872052476282192016L},
            {0.865631202387831743880467897712393L, 0.0951585116824927848099251076022462L},
            {0.944575023073232576077988415534608L, 0.0622535239386478928628438369943777L},
            {0.989400934991649932596154173450333L, 0.0271524594117540948517805724560182L}};
        const Real middle = (low + high) / 2;
        const Real half = (high - low) / 2;
        Real sum = 0;
        for (const auto& [x, weight] : nodes)
            sum += weight * (integrand(middle - half * x) + integrand(middle + half * x));
        return sum * half;
    }
    [[nodiscard]] Real halved(Real low, Real high, Real whole, int depth) const {
        const Real middle = (low + high) / 2;
        const Real left = rule(low, middle);
        const Real right = rule(middle, high);
        if (depth == 0 || std::fabs(left + right - whole) < 1e-19L) return left + right;
        return halved(low, middle, left, depth - 1) + halved(middle, high, right, depth - 1);
    }
    [[nodiscard]] Real between(Real low, Real high) const {
        constexpr int pieces = 32;
        Real sum = 0;
        for (int i = 0; i < pieces; ++i) {
            const Real a = low + (high - low) * i / pieces;
            const Real b = low + (high - low) * (i + 1) / pieces;
            sum += halved(a, b, rule(a, b), 30);
        }
        return sum;
    }

    const Pose& pose_;
    Vec up_{};
};

// Half axes up to 100:1; receivers all around, and close to the plane on the ellipse, beside it and at its rim.
Pose random_pose(Random& random) {
    const Vec axis = poses::random_direction(random);
    const Vec x = poses::unit(cross(axis, poses::random_direction(random)));
    const Vec y = cross(axis, x);
    double a = std::pow(10.0, random.uniform(-1.5, 1.5));
    double b = a * std::pow(10.0, random.uniform(-2.0, 0.0));
    if (random.uniform() < 0.5) std::swap(a, b);
    const double size = std::max(a, b);
    Vec local = poses::random_direction(random) * (size * std::pow(10.0, random.uniform(-1.0, 3.0)));
    const double where = random.uniform();
    if (where > 0.4) {
        const double turn = random.uniform(0.0, 2.0 * pi);
        const double off = std::pow(10.0, random.uniform(-4.0, 0.0)) * (random.uniform() < 0.5 ? 1.0 : -1.0);
        const double out = where < 0.7 ? random.uniform(0.0, 2.0) : 1.0 + off;
        local = {a * out * std::cos(turn), b * out * std::sin(turn), size * std::pow(10.0, random.uniform(-4.0, 0.0))};
    }
    const Vec center = (x * local.x + y * local.y + axis * std::fabs(local.z)) * -1.0;
    const Vec normal = random.uniform() < 0.3 ? poses::unit(center) : poses::random_direction(random);
    return {{center, {1.0, 1.0, 1.0}, axis, x, a, b, 0.0, false}, normal};
}

// E/L for a receiver that faces the centre: errors are relative to this.
double facing(Pose pose) {
    pose.normal = poses::unit(pose.light.center);
    return irradiance(pose);
}

TEST(Ellipse, IsItsContour) {
    Random random(7);
    double worst = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const Pose pose = random_pose(random);
        const auto truth = static_cast<double>(Contour(pose).irradiance());
        const double error = std::fabs(irradiance(pose) - truth) / facing(pose);
        worst = std::max(worst, error);
        // A height of 1e-4 over an axis of 1 % preserves 12 digits of the pose itself.
        EXPECT_LT(error, 1e-9) << i << " truth " << truth;
    }
    RecordProperty("worst", std::to_string(worst * 1e12) + "e-12");
}

TEST(Ellipse, OfTwoEqualAxesIsADisk) {
    Random random(8);
    for (int i = 0; i < 5000; ++i) {
        Pose pose = random_pose(random);
        pose.light.half_height = pose.light.half_width;
        const double disk = irradiance_disk(pose.light.center, pose.light.axis, pose.light.half_width, pose.normal);
        EXPECT_NEAR(irradiance(pose), disk, 1e-10 * facing(pose)) << i;
    }
}

TEST(Ellipse, TurnedScaledAndTurnedOverItIsTheSame) {
    Random random(9);
    for (int i = 0; i < 2000; ++i) {
        const Pose pose = random_pose(random);
        const double e = irradiance(pose);
        Pose swapped = pose; // with its height along X
        swapped.light.width_direction = cross(pose.light.axis, pose.light.width_direction);
        std::swap(swapped.light.half_width, swapped.light.half_height);
        EXPECT_NEAR(irradiance(swapped), e, 1e-10 * facing(pose)) << i;
        for (const double scale : {0x1p-60, 0x1p60}) {
            Pose scaled = pose;
            scaled.light.center = pose.light.center * scale;
            scaled.light.half_width *= scale;
            scaled.light.half_height *= scale;
            EXPECT_EQ(irradiance(scaled), e) << i;
        }
        Pose over = pose; // seen from behind
        over.light.axis = pose.light.axis * -1.0;
        EXPECT_EQ(irradiance(over), 0.0) << i;
        over.light.two_sided = true;
        EXPECT_NEAR(irradiance(over), e, 1e-10 * facing(pose)) << i;
    }
}

TEST(Ellipse, LiesBetweenTheDisksInAndAboutIt) {
    Random random(10);
    for (int i = 0; i < 2000; ++i) {
        const Pose pose = random_pose(random);
        const auto disk = [&](double r) { return irradiance_disk(pose.light.center, pose.light.axis, r, pose.normal); };
        const double slack = 1e-10 * facing(pose);
        EXPECT_GE(irradiance(pose), disk(std::min(pose.light.half_width, pose.light.half_height)) - slack) << i;
        EXPECT_LE(irradiance(pose), disk(std::max(pose.light.half_width, pose.light.half_height)) + slack) << i;
    }
}

TEST(Ellipse, InItsPlaneShowsAHemisphereInsideAndNothingOutside) {
    const Vec axis{0.0, 0.0, -1.0};
    const Vec x{1.0, 0.0, 0.0};
    const auto at = [&](double to_x, double to_y, double depth, Vec normal) {
        return irradiance({{{to_x, to_y, depth}, {1.0, 1.0, 1.0}, axis, x, 2.0, 0.5, 0.0, false}, poses::unit(normal)});
    };
    const Vec up{0.0, 0.0, 1.0};
    const Vec slanted{0.6, 0.0, 0.8};
    EXPECT_NEAR(at(0.0, 0.0, 0.0, up), pi, 1e-15);
    EXPECT_NEAR(at(1.9, 0.1, 0.0, slanted), 0.9 * pi, 1e-15);
    EXPECT_EQ(at(1.0, 0.49, 0.0, slanted), 0.0);
    EXPECT_EQ(at(0.1, 0.6, 0.0, slanted), 0.0);
    EXPECT_NEAR(at(1.0, 0.2, 1e-9, slanted), 0.9 * pi, 1e-8) << "just in front";
    EXPECT_EQ(at(1.0, 0.2, -1e-9, slanted), 0.0) << "behind";
    EXPECT_NEAR(at(0.0, 0.0, 2.0, up), pi * 2.0 * 0.5 / std::sqrt((4.0 + 4.0) * (4.0 + 0.25)), 1e-15) << "on the axis";
}

// The disk's own outline is on the ellipse's cone.
TEST(Ellipse, SeenAsADiskHasTheSameDirections) {
    Random random(11);
    for (int i = 0; i < 2000; ++i) {
        const Pose pose = random_pose(random);
        const EllipseLight<double>& light = pose.light;
        const auto seen = light.seen_from(light.center);
        const Vec up = cross(light.axis, light.width_direction);
        const double depth = -dot(light.axis, light.center);
        const Vec any = std::fabs(seen.light.axis.x) < 0.6 ? Vec{1, 0, 0} : Vec{0, 1, 0};
        const Vec u = poses::unit(cross(seen.light.axis, any));
        const Vec v = cross(seen.light.axis, u);
        for (int k = 0; k < 16; ++k) {
            const double t = 2.0 * pi * k / 16;
            const Vec rim = seen.to_center + (u * std::cos(t) + v * std::sin(t)) * seen.light.radius;
            // The distance to the ellipse's plane.
            const double forward = -dot(light.axis, rim);
            ASSERT_GT(forward, 0.0) << i;
            const Vec off = rim * (depth / forward) - light.center;
            const double on =
                std::hypot(dot(off, light.width_direction) / light.half_width, dot(off, up) / light.half_height);
            const double grazing = depth / length(light.center);
            EXPECT_NEAR(on, 1.0, 1e-12 / (grazing * grazing) + 1e-9) << i << ' ' << k;
        }
    }
}

// The disk's sampler draws the ellipse's directions: E[⟨n·l⟩/pdf] is its irradiance.
TEST(Ellipse, SampledAsADiskGivesItsIrradiance) {
    const EllipseLight<double> light{{-0.2, 0.4, 1.0},
                                     {1.0, 1.0, 1.0},
                                     poses::unit({0.3, -0.5, -0.8}),
                                     poses::unit(cross(poses::unit({0.3, -0.5, -0.8}), Vec{0.2, 1.0, 0.1})),
                                     1.2,
                                     0.3,
                                     0.0,
                                     false};
    const Vec n = poses::unit({0.3, -0.2, 0.5});
    const auto seen = light.seen_from(light.center);
    const DiskSampler<double> sampler(seen.to_center, seen.light.axis, seen.light.radius);
    constexpr int side = 400;
    double sum = 0.0;
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k) {
            const auto drawn = sampler.sample((i + 0.5) / side, (k + 0.5) / side);
            sum += std::max(dot(n, drawn.direction), 0.0) / drawn.pdf;
        }
    EXPECT_NEAR(sum / (double{side} * side), irradiance_ellipse(light, light.center, n), 2e-5);
}

TEST(Ellipse, HostileInputGivesFiniteNumbersThatAreNotNegative) {
    Random random(12);
    for (int i = 0; i < 50000; ++i) {
        const auto any = [&] { return static_cast<float>(poses::hostile(random)); };
        const vec3<float> center{any(), any(), any()};
        const vec3<float> axis{any(), any(), any()};
        const vec3<float> across{any(), any(), any()};
        const EllipseLight<float> light{center, {1.0F, 1.0F, 1.0F},    axis, across, any(), any(),
                                        0.0F,   random.uniform() < 0.5};
        const vec3<float> normal{any(), any(), any()};
        const float e = irradiance_ellipse(light, center, normal);
        ASSERT_TRUE(e >= 0.0F && e <= 3.1415929F) << i << ' ' << e;
        const auto specular =
            specular_by<SpecularMethod::ltc>(light, center, normalized(normal), normalized(axis), 0.3F);
        ASSERT_TRUE(specular.scale >= 0.0F && specular.scale <= 1.0F) << i << ' ' << specular.scale;
    }
}

} // namespace
