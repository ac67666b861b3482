// Samplers of lights: χ² against their densities, and densities against solid angles computed differently.
#include <gonio/shading/irradiance_cylinder.hpp>
#include <gonio/shading/irradiance_disk.hpp>
#include <gonio/shading/irradiance_rectangle.hpp>
#include <gonio/shading/irradiance_tube.hpp>
#include <gonio/shading/sample_cylinder.hpp>
#include <gonio/shading/sample_disk.hpp>
#include <gonio/shading/sample_rectangle.hpp>
#include <gonio/shading/sample_sphere.hpp>
#include <gonio/shading/sample_tube.hpp>

#include "chi_square.hpp"
#include "poses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace gonio::shading;
using poses::Random;
using poses::Vec;

struct Sampler {
    std::string name;
    Vec axis;           // axis of the cells
    double reach = 1.0; // [rad] approximate
    double most = 0.0;  // of a uniform density: 1/solid angle times the factor that the header allows
    std::function<LightSample<double>(double, double)> sample;
    std::function<double(Vec)> pdf;
    std::function<bool(Vec)> hit; // tests the light's surface, not its outline
};

bool hits_ball(Vec center, double radius, Vec l) {
    const double t = dot(center, l);
    const Vec miss = center - l * t;
    return dot(center, center) < radius * radius || (t > 0.0 && dot(miss, miss) <= radius * radius);
}

template<class Made>
Sampler wrap(std::string name, Vec axis, double reach, const Made& made, std::function<bool(Vec)> hit) {
    return {std::move(name),
            poses::unit(axis),
            reach,
            0.0,
            [made](double u0, double u1) { return made.sample(u0, u1); },
            [made](Vec l) { return made.pdf(l); },
            std::move(hit)};
}

Sampler sphere(const std::string& name, Vec center, double r) {
    return wrap(name, center, std::asin(std::min(r / length(center), 1.0)), SphereSampler<double>(center, r),
                [=](Vec l) { return hits_ball(center, r, l); });
}

Sampler disk(const std::string& name, Vec center, Vec axis, double r) {
    const double reach = std::atan2(r, std::max(length(center) - r, 0.05));
    return wrap(name, center, reach, DiskSampler<double>(center, axis, r), [=](Vec l) {
        const double t = dot(center, axis) / dot(l, axis);
        const Vec off = l * t - center;
        return t > 0.0 && dot(off, off) <= r * r;
    });
}

Sampler rectangle(const std::string& name, Vec center, Vec axis, Vec across, double w, double h) {
    const double reach = std::atan2(0.5 * std::hypot(w, h), std::max(length(center) - 0.5 * std::hypot(w, h), 0.05));
    return wrap(name, center, reach, RectangleSampler<double>(center, axis, across, w, h), [=](Vec l) {
        const double t = dot(center, axis) / dot(l, axis);
        const Vec off = l * t - center;
        return t > 0.0 && std::abs(dot(off, across)) <= 0.5 * w && std::abs(dot(off, cross(axis, across))) <= 0.5 * h;
    });
}

// Whether a ray enters a cylinder through its side.
bool hits_side(Vec center, Vec axis, double r, double l, Vec d) {
    const Vec across = d - axis * dot(axis, d);
    const Vec to_line = center - axis * dot(axis, center);
    const double speed2 = dot(across, across);
    const double closest = dot(to_line, across) / speed2;
    const Vec miss = to_line - across * closest;
    const double half2 = (r * r - dot(miss, miss)) / speed2;
    if (half2 < 0.0) return false;
    const double t = closest - std::sqrt(half2);
    return t > 0.0 && std::abs(t * dot(d, axis) - dot(center, axis)) <= 0.5 * l;
}

Sampler tube(const std::string& name, Vec center, Vec axis, double r, double l) {
    const double reach = std::atan2(0.5 * l + r, std::max(length(center) - 0.5 * l - r, 0.05));
    return wrap(name, center, reach, TubeSampler<double>(center, axis, r, l), [=](Vec d) {
        if (hits_ball(center - axis * (0.5 * l), r, d) || hits_ball(center + axis * (0.5 * l), r, d)) return true;
        const Vec to_line = center - axis * dot(axis, center);
        if (length(to_line) < r && std::abs(dot(axis, center)) < 0.5 * l) return true;
        return hits_side(center, axis, r, l, d);
    });
}

Sampler cylinder(const std::string& name, Vec center, Vec axis, double r, double l) {
    const double reach = std::atan2(0.5 * l + r, std::max(length(center) - 0.5 * l - r, 0.05));
    return wrap(name, center, reach, CylinderSampler<double>(center, axis, r, l),
                [=](Vec d) { return hits_side(center, axis, r, l, d); });
}

std::vector<Sampler> samplers() {
    const Vec m = poses::unit({0.3, -0.5, -0.8});
    const Vec b = poses::unit(cross(m, Vec{0.2, 1.0, 0.1}));
    const Vec a = poses::unit({0.4, 0.8, -0.3});
    return {sphere("sphere", {0.3, 0.4, 1.0}, 0.5),
            sphere("far sphere", {30.0, 40.0, 100.0}, 0.5),
            sphere("touched sphere", {0.3, 0.4, 1.0}, std::sqrt(1.25) * (1.0 - 1e-9)),
            sphere("inside a sphere", {0.1, 0.1, 0.0}, 1.0),
            disk("disk", {-0.2, 0.4, 1.0}, m, 0.7),
            disk("disk on the axis", m * -1.0, m, 0.7),
            disk("far disk", {-20.0, 40.0, 100.0}, m, 0.7),
            disk("near disk", m * -0.1 + b * 0.3, m, 1.0),
            disk("slanted disk", m * -0.05 + b * 1.2, m, 1.0),
            disk("disk hardly below", m * -1e-9 + b * 0.3, m, 1.0),
            disk("disk below its rim", m * -1e-3 + b * 1.0002, m, 1.0),
            rectangle("rectangle", {-0.2, 0.4, 1.0}, m, b, 1.2, 0.7),
            rectangle("far rectangle", {-20.0, 40.0, 100.0}, m, b, 1.2, 0.7),
            rectangle("very far rectangle", {-2e4, 4e4, 1e5}, m, b, 1.2, 0.7),
            rectangle("near rectangle", m * -0.05 + b * 0.2, m, b, 1.2, 0.7),
            rectangle("rectangle hardly below", m * -1e-9 + b * 0.2, m, b, 1.2, 0.7),
            rectangle("long rectangle", {-0.2, 0.4, 1.0}, m, b, 8.0, 0.1),
            tube("tube", {-0.2, 0.4, 1.0}, a, 0.2, 1.5),
            tube("thin tube", {-0.2, 0.4, 1.0}, a, 0.04, 1.5),
            tube("fat tube", {-0.2, 0.4, 1.0}, a, 0.6, 0.3),
            tube("far tube", {-20.0, 40.0, 100.0}, a, 0.2, 1.5),
            tube("tube end-on", a * 2.0 + Vec{0.05, 0.0, 0.0}, a, 0.3, 1.5),
            tube("inside a tube", {0.1, 0.1, 0.0}, a, 0.5, 1.5),
            cylinder("cylinder", {-0.2, 0.4, 1.0}, a, 0.2, 1.5),
            cylinder("thin cylinder", {-0.2, 0.4, 1.0}, a, 0.04, 1.5),
            cylinder("fat cylinder", {-0.2, 0.4, 1.0}, a, 0.6, 0.3),
            cylinder("far cylinder", {-20.0, 40.0, 100.0}, a, 0.2, 1.5),
            cylinder("cylinder before its end", a * 2.0 + b * 0.6, a, 0.3, 1.5),
            cylinder("near cylinder", b * 0.51 + a * 0.2, a, 0.5, 1.5)};
}

TEST(LightSamplers, FollowTheirDensities) {
    const std::vector<Sampler> all = samplers();
    const double least = chi_square::sidak(1e-3, all.size());
    Random random(11);
    for (const Sampler& s : all) {
        // Rings crowd about the axis as far as the light reaches.
        const double narrow = std::min(1.0, 0.35 * s.reach);
        // Beside the light's middle, so that outlines do not run along cell borders.
        const Vec beside = cross(s.axis, Vec{0.5, -0.7, 0.2}) * (0.2 * std::min(s.reach, 1.0));
        const chi_square::Cells cells(s.axis + beside, {0.3, 0.2, 0.9}, narrow);
        const chi_square::Outcome outcome = chi_square::test(
            cells,
            [&] {
                const double u0 = random.uniform();
                return s.sample(u0, random.uniform()).direction;
            },
            s.pdf, 40'000, 32);
        EXPECT_NEAR(outcome.integral, 1.0, 3e-3) << s.name;
        EXPECT_GT(outcome.probability, least) << s.name << ": " << outcome.statistic << " of " << outcome.degrees;
        EXPECT_GT(outcome.degrees, 50U) << s.name;
    }
}

// Samples lie on the light, with the density of pdf(); and every direction that hits the light has a density.
TEST(LightSamplers, DrawTheLightAndNothingElse) {
    Random random(12);
    for (const Sampler& s : samplers()) {
        std::size_t missed = 0;
        std::size_t wrong = 0;
        constexpr std::size_t count = 4000;
        for (std::size_t i = 0; i < count; ++i) {
            const double u0 = random.uniform();
            const LightSample<double> drawn = s.sample(u0, random.uniform());
            EXPECT_NEAR(length(drawn.direction), 1.0, 1e-12) << s.name;
            // Slightly inside the outline: rounding may put points of the outline on either side.
            const double pdf = s.pdf(drawn.direction);
            if (!s.hit(drawn.direction)) ++missed;
            if (!(std::abs(pdf / drawn.pdf - 1.0) < 1e-6)) ++wrong;
        }
        EXPECT_LE(missed, count / 1000) << s.name;
        EXPECT_LE(wrong, count / 1000) << s.name;
        for (std::size_t i = 0; i < count; ++i) {
            const Vec l = poses::unit(s.axis + poses::random_direction(random) * std::min(s.reach * 1.5, 10.0));
            EXPECT_EQ(s.pdf(l) > 0.0, s.hit(l)) << s.name;
        }
    }
}

// E[⟨n·l⟩/pdf] is the irradiance, known in closed form: the densities are right as a whole.
TEST(LightSamplers, MeanIsTheIrradiance) {
    const Vec m = poses::unit({0.3, -0.5, -0.8});
    const Vec b = poses::unit(cross(m, Vec{0.2, 1.0, 0.1}));
    const Vec a = poses::unit({0.4, 0.8, -0.3});
    const Vec n = poses::unit({0.3, -0.2, 0.5});
    const Vec c{-0.2, 0.4, 1.0};
    const auto mean = [&](const auto& sampler) {
        constexpr int side = 400; // uniform strata
        double sum = 0.0;
        for (int i = 0; i < side; ++i)
            for (int k = 0; k < side; ++k) {
                const auto drawn = sampler.sample((i + 0.5) / side, (k + 0.5) / side);
                sum += std::max(dot(n, drawn.direction), 0.0) / drawn.pdf;
            }
        return sum / (double{side} * side);
    };
    EXPECT_NEAR(mean(SphereSampler<double>(c, 0.9)), irradiance_sphere(c, 0.9, n), 2e-5);
    EXPECT_NEAR(mean(DiskSampler<double>(c, m, 0.9)), irradiance_disk(c, m, 0.9, n), 2e-5);
    EXPECT_NEAR(mean(RectangleSampler<double>(c, m, b, 1.5, 0.8)), irradiance_rectangle(c, m, b, 1.5, 0.8, n), 2e-5);
    EXPECT_NEAR(mean(TubeSampler<double>(c, a, 0.2, 1.5)), irradiance_tube(c, a, 0.2, 1.5, n), 1e-3);
    EXPECT_NEAR(mean(CylinderSampler<double>(c, a, 0.2, 1.5)), irradiance_cylinder(c, a, 0.2, 1.5, n), 2e-5);
}

template<class Sampler>
void expect_finite(const Sampler& sampler, Random& random) {
    for (int i = 0; i < 20; ++i) {
        const auto u0 = static_cast<float>(random.uniform());
        const auto drawn = sampler.sample(u0, static_cast<float>(random.uniform()));
        EXPECT_TRUE(std::isfinite(drawn.pdf) && drawn.pdf > 0.0F);
        EXPECT_NEAR(length(drawn.direction), 1.0F, 1e-5F);
    }
}

TEST(LightSamplers, FloatIsFiniteFromNearToFar) {
    Random random(13);
    for (int i = 0; i < 4000; ++i) {
        const auto number = [&](double low, double high) {
            return static_cast<float>(std::exp(random.uniform(std::log(low), std::log(high))));
        };
        const Vec axis_d = poses::random_direction(random);
        const Vec across_d = poses::unit(cross(axis_d, poses::random_direction(random)));
        const Vec to = poses::random_direction(random);
        const auto of = [](Vec v) {
            return vec3<float>{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
        };
        const vec3<float> center = of(to) * number(1e-3, 1e3);
        expect_finite(SphereSampler<float>(center, 1.0F), random);
        expect_finite(DiskSampler<float>(center, of(axis_d), 1.0F), random);
        expect_finite(RectangleSampler<float>(center, of(axis_d), of(across_d), 1.0F, number(1e-2, 1e2)), random);
        expect_finite(TubeSampler<float>(center, of(axis_d), number(1e-2, 1.0), 1.0F), random);
        const float radius = number(1e-2, 1.0);
        const vec3<float> across = center - of(axis_d) * dot(center, of(axis_d));
        if (length(across) > 1.001F * radius)
            expect_finite(CylinderSampler<float>(center, of(axis_d), radius, 1.0F), random);
    }
}

// A uniform sampler's density is 1 over the solid angle. Below a disk's rim the cone is almost a slice of a quarter of
// the sky, and close to a flat light it is a hemisphere: there, too, every sampler must be nearly uniform.
TEST(LightSamplers, FlatLightsAreEvenHardlyOverThem) {
    Random random(14);
    const Vec m = poses::unit({0.3, -0.5, -0.8});
    const Vec b = poses::unit(cross(m, Vec{0.2, 1.0, 0.1}));
    const auto spread = [&](const auto& sampler) {
        double least = HUGE_VAL;
        double most = 0.0;
        for (int i = 0; i < 500; ++i) {
            const double u0 = random.uniform();
            const double pdf = sampler.sample(u0, random.uniform()).pdf;
            least = std::min(least, pdf);
            most = std::max(most, pdf);
        }
        return most / least;
    };
    for (const double z : {1e-1, 1e-2, 1e-3, 1e-5, 1e-9, 1e-13})
        for (const double x : {0.0, 0.3, 0.9, 0.99, 0.9999, 1.0, 1.0001, 1.01, 1.1, 2.0}) {
            EXPECT_LT(spread(DiskSampler<double>(m * -z + b * x, m, 1.0)), 1.1) << z << ' ' << x;
            const RectangleSampler<double> rectangle(m * -z + b * (0.6 * x), m, b, 1.2, 0.7);
            if (rectangle.solid_angle() > 1e-7) { // else by area
                EXPECT_LT(spread(rectangle), 1.1) << z << ' ' << x;
            }
        }
}

// In the plane of a flat light, from either sign of 0: inside the outline the hemisphere in front of the light, on the
// outline and outside nothing.
template<class S>
void expect_limits_in_the_plane() {
    constexpr auto tolerance = S(__is_same(S, double) ? 1e-11 : 2e-6);
    const auto even = S(0.5 / std::numbers::pi);
    for (const S zero : {S(0.0), S(-0.0)})
        for (const S side : {S(1), S(-1)}) {
            const vec3<S> axis{S(0), S(0), side};
            const vec3<S> across{S(1), S(0), S(0)};
            const auto look = [&](const auto& sampler, bool inside) {
                Random random(15);
                for (int i = 0; i < 200; ++i) {
                    const auto u0 = static_cast<S>(random.uniform(0.0, 0.999));
                    const auto drawn = sampler.sample(u0, static_cast<S>(random.uniform(0.0, 0.999)));
                    EXPECT_NEAR(length(drawn.direction), S(1), tolerance);
                    EXPECT_NEAR(drawn.pdf, inside ? even : S(0), tolerance);
                    EXPECT_NEAR(sampler.pdf(drawn.direction), inside ? even : S(0), tolerance);
                    if (inside) {
                        EXPECT_LT(drawn.direction.z * side, S(0)) << "the light shines along `axis`";
                    }
                    EXPECT_EQ(sampler.pdf(drawn.direction * S(-1)), S(0));
                }
            };
            for (const S x : {S(0), S(0.3), S(-0.99)}) {
                look(DiskSampler<S>({x, S(0), zero}, axis, S(1)), true);
                look(RectangleSampler<S>({x, S(0.2), zero}, axis, across, S(2), S(1)), true);
            }
            for (const S x : {S(1), S(-1), S(1.001), S(30)}) {
                look(DiskSampler<S>({x, S(0), zero}, axis, S(1)), false);
                look(RectangleSampler<S>({x, S(0.2), zero}, axis, across, S(2), S(1)), false);
            }
            look(RectangleSampler<S>({S(0), S(0.5), zero}, axis, across, S(2), S(1)), false);
            look(RectangleSampler<S>({S(1), S(0.5), zero}, axis, across, S(2), S(1)), false);
        }
}

TEST(LightSamplers, InTheirPlaneFlatLightsAreTheirLimits) {
    expect_limits_in_the_plane<float>();
    expect_limits_in_the_plane<double>();
}

// On the surface of a light that is not flat: the part in front of the tangent plane.
TEST(LightSamplers, OnTheirSurfaceSolidLightsAreHemispheres) {
    Random random(16);
    const auto look = [&](const auto& sampler, Vec inward) {
        for (int i = 0; i < 200; ++i) {
            const double u0 = random.uniform();
            const auto drawn = sampler.sample(u0, random.uniform());
            EXPECT_GE(dot(drawn.direction, inward), -1e-15);
            EXPECT_NEAR(drawn.pdf, 0.5 / std::numbers::pi, 1e-14);
            EXPECT_NEAR(sampler.pdf(drawn.direction), drawn.pdf, 1e-14);
        }
        EXPECT_EQ(sampler.pdf(inward * -1.0), 0.0);
    };
    for (const double zero : {0.0, -0.0}) {
        look(SphereSampler<double>({zero, 0.5, zero}, 0.5), {0.0, 1.0, 0.0});
        look(TubeSampler<double>({0.2, 0.5, zero}, {1.0, 0.0, zero}, 0.5, 2.0), {0.0, 1.0, 0.0});
        look(TubeSampler<double>({1.5, zero, zero}, {1.0, 0.0, zero}, 0.5, 2.0), {1.0, 0.0, 0.0});
    }
}

} // namespace
