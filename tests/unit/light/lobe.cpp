// Solid angles of lobes against integrals of the lobes, and against the textbook's formulas in their valid range.
#include <gonio/light/lobe.hpp>

#include "quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gonio {
namespace {

using std::numbers::pi;

constexpr Falloff falloffs[] = {Falloff::frostbite,      Falloff::hard,         Falloff::linear_cos,
                                Falloff::smoothstep_cos, Falloff::linear_angle, Falloff::smoothstep_angle};

constexpr double half_angles_deg[] = {0.0,  1e-6,    1e-4,  2e-4,  0.5,  1.0,     10.0, 20.0,
                                      25.0, 25.0001, 28.64, 28.66, 45.0, 89.9999, 90.0};

// 2π ∫ f sinθ dθ of the textbook's lobe in long double: over 1 − cosθ = 2 sin²(θ/2) if the lobe is a polynomial in it,
// else over θ.
double integrated(const SpotShape& spot) {
    using Real = long double;
    const Real a = spot.inner.value;
    const Real b = spot.outer.value;
    const auto c = [](Real theta) { return 2 * std::sin(theta / 2) * std::sin(theta / 2); };
    const auto smooth = [](Real x) { return x * x * (3 - 2 * x); };
    const auto by_cos = [&](auto&& f) {
        return c(a) + test::integral<Real>(c(a), c(b), 1, [&](Real x) { return f((c(b) - x) / (c(b) - c(a))); });
    };
    const auto by_angle = [&](auto&& f) {
        return c(a) + test::integral<Real>(a, b, 4, [&](Real t) { return f((b - t) / (b - a)) * std::sin(t); });
    };
    Real value = c(b);
    if (a < b) {
        if (spot.falloff == Falloff::frostbite) value = by_cos([](Real x) { return x * x; });
        if (spot.falloff == Falloff::linear_cos) value = by_cos([](Real x) { return x; });
        if (spot.falloff == Falloff::smoothstep_cos) value = by_cos(smooth);
        if (spot.falloff == Falloff::linear_angle) value = by_angle([](Real x) { return x; });
        if (spot.falloff == Falloff::smoothstep_angle) value = by_angle(smooth);
    }
    return static_cast<double>(2 * std::numbers::pi_v<Real> * value);
}

template<class Check>
void for_all_spots(Check&& check) {
    for (const Falloff falloff : falloffs)
        for (const double inner : half_angles_deg)
            for (const double outer : half_angles_deg)
                if (inner <= outer && outer > 0.0)
                    check(SpotShape{degrees(outer), degrees(inner), falloff, {}, nullptr});
}

TEST(Lobe, SolidAngleIsTheIntegralOfTheTextbookLobe) {
    double worst = 0.0;
    for_all_spots([&](const SpotShape& spot) {
        const double truth = integrated(spot);
        const double error = std::abs(lobe_solid_angle(spot).value - truth) / truth;
        EXPECT_LT(error, 2e-15) << to_text(spot.falloff) << " " << to_degrees(spot.inner) << " "
                                << to_degrees(spot.outer);
        worst = std::max(worst, error);
    });
    RecordProperty("worst_relative_error", std::to_string(worst * 1e16) + "e-16");
}

TEST(Lobe, SolidAngleIsTheIntegralOfTheShippedLobe) {
    for_all_spots([&](const SpotShape& spot) {
        const auto ring = [&](double t) { return lobe(spot, Radians(t)) * std::sin(t); };
        const double a = spot.inner.value;
        const double b = spot.outer.value;
        const double sum =
            2.0 * pi *
            (test::integral(0.0, a, 4, ring) + test::integral(a, b, 4, ring) + test::integral(b, pi, 1, ring));
        EXPECT_NEAR(sum, lobe_solid_angle(spot).value, 1e-13 * sum)
            << to_text(spot.falloff) << " " << to_degrees(spot.inner) << " " << to_degrees(spot.outer);
    });
}

// The formulas in 1 − cos, where nothing cancels.
TEST(Lobe, MatchesTheTextbook) {
    for (const auto& [inner, outer] : {std::pair{25.0, 40.0}, {0.0, 60.0}, {30.0, 90.0}}) {
        const double a = inner * pi / 180;
        const double b = outer * pi / 180;
        const double ca = std::cos(a);
        const double cb = std::cos(b);
        const double D = b - a;
        const auto flux = [&](Falloff falloff) {
            return lobe_solid_angle(SpotShape{Radians(b), Radians(a), falloff, {}, nullptr}).value;
        };
        const double bar = 2e-14;
        EXPECT_NEAR(flux(Falloff::hard), 2 * pi * (1 - cb), bar);
        EXPECT_NEAR(flux(Falloff::frostbite), 2 * pi * ((1 - ca) + (ca - cb) / 3), bar);
        EXPECT_NEAR(flux(Falloff::linear_cos), 2 * pi * ((1 - ca) + (ca - cb) / 2), bar);
        EXPECT_NEAR(flux(Falloff::smoothstep_cos), 2 * pi * ((1 - ca) + (ca - cb) / 2), bar);
        EXPECT_NEAR(flux(Falloff::linear_angle), 2 * pi * (1 - (std::sin(b) - std::sin(a)) / D), bar);
        EXPECT_NEAR(flux(Falloff::smoothstep_angle),
                    2 * pi * (1 - 6 / (D * D * D) * (2 * (std::sin(b) - std::sin(a)) - D * (ca + cb))), 10 * bar);
    }
}

TEST(Lobe, FallsFromOneToZeroWithoutAJump) {
    for_all_spots([&](const SpotShape& spot) {
        const double a = spot.inner.value;
        const double b = spot.outer.value;
        EXPECT_EQ(lobe(spot, Radians(0.0)), 1.0);
        EXPECT_EQ(lobe(spot, Radians(a)), 1.0);
        EXPECT_EQ(lobe(spot, Radians(b * 1.0001)), 0.0);
        if (spot.falloff == Falloff::hard || a == b) return;
        EXPECT_EQ(lobe(spot, Radians(b)), 0.0);
        double before = 1.0;
        for (int i = 1; i <= 64; ++i) {
            const double here = lobe(spot, Radians(a + (b - a) * i / 64));
            EXPECT_LE(here, before + 1e-15);
            EXPECT_GT(here, before - 0.05);
            before = here;
        }
    });
    EXPECT_EQ(lobe(SpotShape{degrees(40), degrees(25), Falloff::frostbite, {}, nullptr}, Radians(std::nan(""))), 0.0);
}

TEST(Lobe, PyramidIsTheIntegralOfItsBase) {
    for (const double h : {1e-6, 0.1, 40.0, 60.0, 90.0, 179.0, 179.999999})
        for (const double v : {1e-6, 0.1, 40.0, 60.0, 90.0, 179.0}) {
            const FrustumShape frustum{degrees(h), degrees(v), {}, nullptr};
            // ∬ dx dy (1+x²+y²)^(−3/2), integrated over x by hand, y = tan t; in smaller steps towards the steep ends.
            using Real = long double;
            const Real half_h = static_cast<Real>(frustum.horizontal.value) / 2;
            const Real half_v = static_cast<Real>(frustum.vertical.value) / 2;
            const auto strip = [&](Real t) {
                return 2 * std::sin(half_h) * std::cos(t) /
                       std::sqrt(std::cos(half_h) * std::cos(half_h) +
                                 std::sin(half_h) * std::sin(half_h) * std::cos(t) * std::cos(t));
            };
            Real truth = 0;
            Real from = 0;
            for (int i = 0; i < 40; ++i) {
                const Real to = i == 39 ? half_v : half_v * (1 - std::pow(Real(0.5), Real(i + 1)));
                truth += 2 * test::integral<Real>(from, to, 1, strip);
                from = to;
            }
            const double expected = static_cast<double>(truth);
            EXPECT_NEAR(lobe_solid_angle(frustum).value, expected, 1e-14 * expected) << h << " " << v;
        }
    // The textbook's formula, where its arcsine is not close to the end of its range.
    const FrustumShape frustum{degrees(60), degrees(40), {}, nullptr};
    EXPECT_NEAR(lobe_solid_angle(frustum).value, 4 * std::asin(std::sin(pi / 6) * std::sin(pi / 9)), 1e-15);
}

} // namespace
} // namespace gonio
