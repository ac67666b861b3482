// Rows of points that a lobe places: their places, and their sums against quadrature, float and the parts of a light.
#include <gonio/measure/error_statistics.hpp>
#include <gonio/measure/specular_methods.hpp>
#include <gonio/measure/specular_truth.hpp>
#include <gonio/shading/sorted_batch.hpp>
#include <gonio/shading/specular_ltc.hpp>

#include "../scaled.hpp"
#include "poses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace gonio::shading;
using gonio::shading::detail::AnglePairOf;
using gonio::shading::detail::Fan;
using gonio::shading::detail::LobeRule;
using poses::Random;
using poses::Vec;
using Kind = LightConstants::Kind;
namespace measure = gonio::measure;

constexpr double pi = std::numbers::pi;

// Both points of a pair lie at ±at of half the angle, within the 4e-5 of its own polynomial, and directions are nearly
// unit.
TEST(LobeRows, AFanDividesAnglesByTheRule) {
    const auto expect_divided = [](const auto& rule, bool takes_few, std::vector<double> nodes) {
        for (double whole = 1e-6; whole <= pi; whole = whole < 0.01 ? 10.0 * whole : whole + 0.01)
            for (const double from : {-3.0, 0.0, 1.2}) {
                const auto unit = [](double angle) { return vec2<double>{std::cos(angle), std::sin(angle)}; };
                const Fan<double> fan(unit(from), unit(from + whole));
                EXPECT_NEAR(fan.half, 0.5 * whole, 4e-5 * whole) << whole;
                std::vector<vec2<double>> at(rule.size());
                std::vector<double> weight(rule.size());
                fan.divide(rule, takes_few, at.data(), weight.data());
                for (std::size_t i = 0; i < rule.size(); ++i) {
                    const AnglePairOf<double> pair =
                        gonio::shading::detail::pair_of<double>(rule.pair[i / 2], takes_few);
                    EXPECT_NEAR(weight[i], 0.5 * whole * pair.weight, 1e-4 * whole);
                    const double node = i % 2 == 0 ? -nodes[i / 2] : nodes[i / 2];
                    const vec2<double> off = at[i] - unit(from + 0.5 * whole * (1.0 + node));
                    EXPECT_LT(std::sqrt(dot(off, off)), 5e-5 * whole) << whole << ' ' << node;
                    EXPECT_NEAR(dot(at[i], at[i]), 1.0, 1e-5) << whole << ' ' << node;
                }
            }
    };
    using Rules = LobeRule<double>;
    // The nodes, with all their digits.
    expect_divided(Rules::four, false, {0.33998104358485626, 0.86113631159405258});
    expect_divided(Rules::six, false, {0.23861918608319691, 0.66120938646626451, 0.93246951420315203});
    expect_divided(Rules::six_of_roots, false,
                   {std::cos(3.0 * pi / 7.0), std::cos(2.0 * pi / 7.0), std::cos(pi / 7.0)});
    expect_divided(Rules::eight_or_four, false,
                   {0.18343464249564980, 0.52553240991632899, 0.79666647741362674, 0.96028985649753623});
    expect_divided(Rules::eight_or_four, true, {0.4047035329057201, 0.9167882833412947, 0.0, 0.0});
}

// ∫ over [-1, 1] of x^2n, and of √(1 − x²) x^2n by the rules for roots.
TEST(LobeRows, RulesIntegratePolynomials) {
    const auto sum = [](const auto& rule, const auto& f, bool takes_few = false) {
        double total = 0.0;
        for (const auto& of_rule : rule.pair) {
            const AnglePairOf<double> pair = gonio::shading::detail::pair_of<double>(of_rule, takes_few);
            total += 2.0 * pair.weight * f(pair.at);
        }
        return total;
    };
    const auto one = [](double) { return 1.0; };
    const auto root = [](double x) { return std::sqrt(1.0 - x * x); };
    const auto to_the = [](int power, const auto& f) { return [=](double x) { return std::pow(x, power) * f(x); }; };
    using Rules = LobeRule<double>;
    for (int power = 0; power < 12; power += 2) {
        const double whole = 2.0 / (power + 1);
        if (power < 8) {
            EXPECT_NEAR(sum(Rules::four, to_the(power, one)), whole, 1e-7) << power;
        }
        EXPECT_NEAR(sum(Rules::six, to_the(power, one)), whole, 1e-7) << power;
        EXPECT_NEAR(sum(Rules::eight_or_four, to_the(power, one)), whole, 1e-7) << power;
        if (power < 4) {
            EXPECT_NEAR(sum(Rules::eight_or_four, to_the(power, one), true), whole, 1e-7) << power;
        }
    }
    double moment = 0.5 * pi; // of x^2n √(1 − x²): π/2, times (2n − 1)/(2n + 2) from each to the next
    for (int power = 0; power < 12; power += 2) {
        EXPECT_NEAR(sum(Rules::six_of_roots, to_the(power, root)), moment, 1e-7) << power;
        if (power < 4) {
            EXPECT_NEAR(sum(Rules::eight_or_four, to_the(power, root), true), moment, 1e-7) << power;
        }
        moment *= (power + 1.0) / (power + 4.0);
    }
}

// By the tangents of its first and last angle.
TEST(LobeRows, AFanOfTangentsIsThatOfTheirAngles) {
    for (const double from : {-1e4, -30.0, -1.0, -0.1, 0.0, 0.3, 5.0, 9e3})
        for (const double step : {1e-5, 0.01, 1.0, 50.0, 1e3, 2e4}) {
            const double to = std::fmin(from + step, 1e4);
            const double middle = 0.5 * (std::atan(from) + std::atan(to));
            const double half = 0.5 * std::atan2(to - from, 1.0 + from * to);
            const Fan<double> fan(from, to);
            EXPECT_NEAR(fan.half, half, 4e-5 * half) << from << ' ' << to;
            EXPECT_NEAR(fan.middle.x, std::cos(middle), 1e-12) << from << ' ' << to;
            EXPECT_NEAR(fan.middle.y, std::sin(middle), 1e-12) << from << ' ' << to;
            if (step < 0.01 * std::fabs(from)) continue; // floats do not hold the difference
            const Fan<float> in_float(static_cast<float>(from), static_cast<float>(to));
            EXPECT_NEAR(in_float.half, fan.half, 2e-5 * fan.half) << from << ' ' << to;
        }
}

// Once for each light: inlined in every place that calls it, it would take minutes to compile.
template<class S, class Light>
[[gnu::noinline]] SpecularLuminance<S> by_rows(const Light& light, vec3<S> to_center, vec3<S> normal, vec3<S> view,
                                               GgxLobe<S> lobe) {
    return specular_ltc(light, to_center, normal, view, lobe);
}

// In floats by the first of the instruction sets: not all builds have the plain one.
std::vector<double> rows_of(bool in_double, const measure::SpecularCases& cases, Kind kind) {
    for (const measure::SpecularMethodUnderTest& method : measure::specular_methods(kind))
        if (method.name == "ltc" && (method.precision == "double") == in_double)
            return measure::evaluated(method, cases);
    ADD_FAILURE() << in_double;
    return {};
}

// Where the luminance is above 1e-3 of the light's. With 8192 other poses: median 0.0006 to 0.0028, 95 % below 0.018
// to 0.064. The tolerances are what these poses give and a small margin.
TEST(LobeRows, NineteenOfTwentyPosesAreWithinTenPercent) {
    struct Tolerance {
        Kind kind;
        double median, p95;
    };
    for (const Tolerance& allowed : {Tolerance{Kind::sphere, 0.0004, 0.012}, Tolerance{Kind::disk, 0.0006, 0.042},
                                     Tolerance{Kind::rectangle, 0.007, 0.09}, Tolerance{Kind::tube, 0.001, 0.036},
                                     Tolerance{Kind::ellipse, 0.0075, 0.075}}) {
        const auto cases = measure::specular_cases(allowed.kind, gonio::test::scaled(std::size_t{500}), 7);
        const std::vector<double> in_double = rows_of(true, cases, allowed.kind);
        const std::vector<double> in_float = rows_of(false, cases, allowed.kind);
        for (std::size_t i = 0; i < cases.size(); ++i)
            EXPECT_TRUE(in_float[i] >= 0.0 && in_float[i] <= 1.0 && in_double[i] >= 0.0 && in_double[i] <= 1.0) << i;
        const measure::Spread truth =
            measure::spread_of(measure::relative_errors(in_double, measure::specular_truth(cases), 1e-3));
        const measure::Spread rounding = measure::spread_of(measure::relative_errors(in_float, in_double, 1e-3));
        if (!gonio::test::is_sanitized) {
            EXPECT_LT(truth.median, allowed.median) << static_cast<int>(allowed.kind);
            EXPECT_LT(truth.p95, allowed.p95) << static_cast<int>(allowed.kind);
            EXPECT_LT(rounding.p95, 5e-4) << static_cast<int>(allowed.kind);
        }
        EXPECT_LT(rounding.median, 2e-5) << static_cast<int>(allowed.kind);
        RecordProperty(std::to_string(static_cast<int>(allowed.kind)),
                       std::to_string(truth.median) + " " + std::to_string(truth.p95) + " " +
                           std::to_string(rounding.median) + " " + std::to_string(rounding.p95));
    }
}

// Rows lie along a thin tube: across it their lengths would rise steeply at its ends.
TEST(LobeRows, ThinTubesAreAsExact) {
    measure::SpecularCases cases = measure::specular_cases(Kind::tube, gonio::test::scaled(std::size_t{500}), 7);
    for (LightConstants& light : cases.area.lights)
        light.radius *= 0.1F;
    const measure::Spread truth = measure::spread_of(
        measure::relative_errors(rows_of(true, cases, Kind::tube), measure::specular_truth(cases), 1e-3));
    EXPECT_LT(truth.median, 0.0003);
    if (!gonio::test::is_sanitized) {
        EXPECT_LT(truth.p95, 0.002);
    }
    RecordProperty("tube", std::to_string(truth.median) + " " + std::to_string(truth.p95));
}

// Rows lie along a rectangle that the horizon does not cut: their lengths have no kinks.
TEST(LobeRows, RectanglesAboveTheHorizonAreExact) {
    const measure::SpecularCases cases =
        measure::specular_cases(Kind::rectangle, gonio::test::scaled(std::size_t{1000}), 7);
    const std::vector<double> truth = measure::specular_truth(cases);
    const std::vector<double> in_double = rows_of(true, cases, Kind::rectangle);
    std::vector<double> found;
    std::vector<double> expected;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const LightConstants& light = cases.area.lights[i / measure::SpecularCases::group_size];
        const auto of = [&](const auto& v) { return Vec{v[0], v[1], v[2]}; };
        const auto at = [&](const auto& v) { return Vec{v[0][i], v[1][i], v[2][i]}; };
        const Vec axis = of(light.axis);
        const Vec across = of(light.width_direction);
        const Vec normal = at(cases.area.normal);
        const RectangleLight<double> rectangle{{}, {}, axis, across, light.width, light.height, 0.0, light.two_sided};
        if (-dot(at(cases.area.position), normal) <= gonio::shading::detail::reach(rectangle, normal)) continue;
        found.push_back(in_double[i]);
        expected.push_back(truth[i]);
    }
    const measure::Spread off = measure::spread_of(measure::relative_errors(found, expected, 1e-3));
    EXPECT_GT(found.size(), cases.size() / 10);
    if (!gonio::test::is_sanitized) {
        EXPECT_LT(off.median, 1e-5);
        EXPECT_LT(off.p95, 0.0022);
    }
    RecordProperty("rectangle",
                   std::to_string(found.size()) + " " + std::to_string(off.median) + " " + std::to_string(off.p95));
}

// A narrow lobe's tail beside a large panel, where the transformed cosine is negative over all of the light in sum.
// Quadrature gives 0.00236.
TEST(LobeRows, ATailWhereTheCosineIsNegativeIsNotDark) {
    LightConstants light;
    light.kind = Kind::rectangle;
    const Vec axis{-0.026265027, -0.990751445, 0.133123145};
    const Vec along{-0.948781729, -0.0172348954, -0.315461844};
    const float axes[2][3] = {{static_cast<float>(axis.x), static_cast<float>(axis.y), static_cast<float>(axis.z)},
                              {static_cast<float>(along.x), static_cast<float>(along.y), static_cast<float>(along.z)}};
    std::copy_n(&axes[0][0], 3, &light.axis[0]);
    std::copy_n(&axes[1][0], 3, &light.width_direction[0]);
    light.width = 0.5985F;
    light.height = 0.2008F;
    const Vec center{-0.160413548, 0.00693905586, -0.012904115};
    const Vec normal{-0.268893182, -0.339419305, -0.901382804};
    const Vec view{0.922933936, 0.134340435, -0.360756904};
    const double alpha = 0.01464;
    const double truth = measure::specular_by_quadrature(light, center, normal, view, alpha);
    EXPECT_NEAR(truth, 0.00236, 1e-5);
    const double found = measure::specular_in_double(light, SpecularMethod::ltc, center, normal, view, alpha);
    EXPECT_NEAR(found, truth, 0.5 * truth);
}

// From a point that is 6e-8 of the radius in front of a disk's plane, beside the disk: rounding turns its cone.
TEST(LobeRows, ADiskSeenEdgeOnIsAlmostDark) {
    using Point = vec3<float>;
    const Point center{-0x1.4bb9b4p-5F, -0x1.7a2feep-9F, 0x1.9027a8p-7F};
    const Point normal{-0x1.085c9ap-1F, -0x1.6a323ep-2F, 0x1.8f532ap-1F};
    const Point view{-0x1.9f9df6p-2F, 0x1.0812b6p-1F, 0x1.824beap-1F};
    const Point axis{-0x1.ebd51ap-3F, -0x1.900ef8p-2F, -0x1.c6fcccp-1F};
    for (const bool two_sided : {false, true}) {
        const DiskLight<float> light{center, {}, axis, 0x1.01aa02p-5F, 0.0F, two_sided};
        const float value = by_rows(light, center, normal, view, GgxLobe<float>{0x1.6c5f8cp-6F}).scale;
        EXPECT_GE(value, 0.0F);
        EXPECT_LT(value, 1e-8F); // its solid angle is 1e-9 sr
    }
}

// A rectangle is the sum of its halves as far as the sums are exact: its rows are placed otherwise than theirs.
TEST(LobeRows, HalvesOfARectangleAddToTheWhole) {
    Random random(31);
    std::vector<double> off;
    for (int i = 0; i < gonio::test::scaled(4000); ++i) {
        const GgxLobe<double> lobe{std::exp(random.uniform(std::log(0.03), 0.0))};
        const Vec n{0.0, 0.0, 1.0};
        const Vec v = poses::tilted(n, random.uniform(0.1, 1.0), random);
        const Vec l = poses::tilted(n, random.uniform(0.0, 1.0), random);
        const Vec facing = poses::tilted(l * -1.0, random.uniform(0.3, 1.0), random);
        const Vec across = poses::unit(cross(facing, poses::random_direction(random)));
        const double width = std::exp(random.uniform(std::log(0.1), std::log(4.0)));
        const auto value = [&](double w, double shift) {
            return by_rows(RectangleLight<double>{l, {}, facing, across, w, 0.7 * width, 0.0, false},
                           l + across * shift, n, v, lobe)
                .scale;
        };
        const double whole = value(width, 0.0);
        if (whole < 1e-3) continue;
        off.push_back(std::fabs((value(0.5 * width, 0.25 * width) + value(0.5 * width, -0.25 * width)) / whole - 1.0));
    }
    std::sort(off.begin(), off.end());
    EXPECT_LT(off[off.size() / 2], 0.002);
    EXPECT_LT(off[off.size() * 95 / 100], 0.05);
    RecordProperty("median", std::to_string(off[off.size() / 2]));
    RecordProperty("p95", std::to_string(off[off.size() * 95 / 100]));
}

// Turning the scene about the normal, or scaling it, changes nothing but rounding.
TEST(LobeRows, TurnedAndScaledScenesAreTheSame) {
    Random random(32);
    for (int i = 0; i < gonio::test::scaled(2000); ++i) {
        const GgxLobe<double> lobe{std::exp(random.uniform(std::log(0.01), 0.0))};
        const Vec n{0.0, 0.0, 1.0};
        const Vec v = poses::tilted(n, random.uniform(0.05, 1.0), random);
        const Vec l = poses::random_direction(random) * 2.0;
        const Vec axis = poses::random_direction(random);
        const double turn = random.uniform(0.0, 2.0 * pi);
        const auto turned = [&](Vec p) {
            return Vec{std::cos(turn) * p.x - std::sin(turn) * p.y, std::sin(turn) * p.x + std::cos(turn) * p.y, p.z};
        };
        const auto values = [&](auto same, double scale) {
            const Vec c = same(l) * scale;
            return std::vector<double>{
                by_rows(SphereLight<double>{c, {}, scale, 0.0}, c, n, same(v), lobe).scale,
                by_rows(DiskLight<double>{c, {}, same(axis), scale, 0.0, true}, c, n, same(v), lobe).scale,
                by_rows(TubeLight<double>{c, {}, same(axis), 0.3 * scale, 3.0 * scale, 0.0}, c, n, same(v), lobe)
                    .scale};
        };
        const auto plain = values([](Vec p) { return p; }, 1.0);
        const auto other = values(turned, 64.0);
        for (std::size_t k = 0; k < plain.size(); ++k)
            EXPECT_NEAR(other[k], plain[k], 1e-6 * plain[k] + 1e-9) << i << ' ' << k;
    }
}

// The dark side of a flat light, and lights below the horizon, give nothing.
TEST(LobeRows, NothingComesFromBehind) {
    Random random(34);
    for (int i = 0; i < gonio::test::scaled(2000); ++i) {
        const GgxLobe<double> lobe{random.uniform(0.05, 1.0)};
        const Vec n{0.0, 0.0, 1.0};
        const Vec v = poses::tilted(n, random.uniform(0.05, 1.0), random);
        const Vec l = poses::tilted(n, random.uniform(0.0, 1.0), random);
        const Vec away = poses::tilted(l, random.uniform(0.05, 1.0), random);
        const Vec across = poses::unit(cross(away, poses::random_direction(random)));
        const double size = std::exp(random.uniform(std::log(0.01), std::log(100.0)));
        const auto disk = [&](bool two_sided) {
            return by_rows(DiskLight<double>{l, {}, away, size, 0.0, two_sided}, l, n, v, lobe).scale;
        };
        const auto rectangle = [&](bool two_sided) {
            return by_rows(RectangleLight<double>{l, {}, away, across, size, size, 0.0, two_sided}, l, n, v, lobe)
                .scale;
        };
        EXPECT_EQ(disk(false), 0.0) << i;
        EXPECT_EQ(rectangle(false), 0.0) << i;
        EXPECT_GT(disk(true), 0.0) << i;
        EXPECT_GT(rectangle(true), 0.0) << i;
        const Vec below = l * -1.0;
        const double little = 0.5 * std::fabs(below.z);
        EXPECT_EQ(by_rows(SphereLight<double>{below, {}, little, 0.0}, below, n, v, lobe).scale, 0.0) << i;
        EXPECT_EQ(by_rows(TubeLight<double>{below, {}, {1.0, 0.0, 0.0}, little, 1.0, 0.0}, below, n, v, lobe).scale,
                  0.0)
            << i;
    }
}

// In [0, 1] for any numbers, in float.
TEST(LobeRows, FiniteForHostileNumbers) {
    Random random(33);
    for (int i = 0; i < gonio::test::scaled(60000); ++i) {
        const auto h = [&] { return static_cast<float>(poses::hostile(random)); };
        const auto direction = [&] {
            const Vec d = poses::random_direction(random);
            return vec3<float>{static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)};
        };
        const vec3<float> n = direction();
        const vec3<float> v = i % 5 == 0 ? n : direction();
        const vec3<float> c{h(), h(), h()};
        const vec3<float> axis = direction();
        const vec3<float> across = normalized(cross(axis, direction()));
        const GgxLobe<float> lobe{std::clamp(std::fabs(h()), 1e-4F, 1.0F)};
        const float p = h();
        const float q = h();
        const SpecularLuminance<float> found[] = {
            by_rows(SphereLight<float>{c, {}, p, 0.0F}, c, n, v, lobe),
            by_rows(DiskLight<float>{c, {}, axis, p, 0.0F, i % 2 == 0}, c, n, v, lobe),
            by_rows(RectangleLight<float>{c, {}, axis, across, p, q, 0.0F, i % 2 == 0}, c, n, v, lobe),
            by_rows(TubeLight<float>{c, {}, axis, p, q, 0.0F}, c, n, v, lobe)};
        for (const SpecularLuminance<float>& each : found) {
            ASSERT_TRUE(each.scale >= 0.0F && each.scale <= 1.0F) << i << ' ' << each.scale;
            ASSERT_TRUE(each.grazing >= 0.0F && each.grazing <= 1.0F) << i << ' ' << each.grazing;
        }
    }
}

} // namespace
