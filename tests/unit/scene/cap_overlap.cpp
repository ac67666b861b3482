// The overlap of two caps, against the integral over the smaller one in rings, in long double: half angles from so
// small that 1 − cos loses its digits up to whole hemispheres, next to larger caps, and lenses a billionth wide.
#include <gonio/scene/occlusion.hpp>

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace gonio {
namespace {

using Real = long double;

constexpr Real pi = std::numbers::pi_v<Real>;

class Numbers {
public:
    double between(double low, double high) {
        state_ = state_ * 6364136223846793005U + 1442695040888963407U;
        return low + (high - low) * static_cast<double>(state_ >> 11U) * 0x1p-53;
    }
    double log_between(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

private:
    std::uint64_t state_ = 1;
};

// ∫₀ʷ f(x, w − x) dx by the double exponential rule: the slope of f may be singular at either end.
template<class Integrand>
Real integral(Real w, const Integrand& f) {
    constexpr Real step = 1.0L / 64.0L;
    Real sum = 0.0L;
    for (int i = -280; i <= 280; ++i) {
        const Real t = step * static_cast<Real>(i);
        const Real e = std::exp(pi * std::sinh(t));
        const Real low = w * (e / (1.0L + e));
        const Real high = w / (1.0L + e);
        sum += f(low, high) * (pi * std::cosh(t)) * (low / w) * (high / w);
    }
    return sum * step * w;
}

struct Truth {
    Real area;
    Real along, across; // of ∫ ω dω: along the axis of a, and across it towards that of b
};

// a ≤ b, and their outlines cross.
Truth truth(Real a, Real b, Real d) {
    const Real left = b - d;
    const Real from = std::fabs(left); // inside this angle a ring is entirely in b (d < b), or entirely outside
    Truth sum{};
    if (left > 0.0L) {
        const Real half = std::sin(0.5L * left);
        sum.area = 4.0L * pi * half * half;
        sum.along = pi * std::sin(left) * std::sin(left);
    }
    const auto ring = [&](Real x, int what) {
        const Real theta = from + x;
        // Half angles of the part of the ring in b, by their halves: squared sine and cosine up to a common factor.
        const Real sine2 = std::sin(0.5L * (b + d - theta)) * std::sin(0.5L * (left > 0.0L ? 2.0L * from + x : x));
        const Real cosine2 = std::sin(0.5L * (b + d + theta)) * std::sin(0.5L * (left > 0.0L ? x : 2.0L * from + x));
        const Real half = 2.0L * std::atan2(std::sqrt(std::max(sine2, 0.0L)), std::sqrt(std::max(cosine2, 0.0L)));
        if (what == 0) return 2.0L * half * std::sin(theta);
        if (what == 1) return 2.0L * half * std::cos(theta) * std::sin(theta);
        return 2.0L * std::sin(half) * std::sin(theta) * std::sin(theta);
    };
    const Real width = left > 0.0L ? a - left : a + left;
    sum.area += integral(width, [&](Real x, Real) { return ring(x, 0); });
    sum.along += integral(width, [&](Real x, Real) { return ring(x, 1); });
    sum.across = integral(width, [&](Real x, Real) { return ring(x, 2); });
    return sum;
}

// Half angles and a distance at which the outlines cross; 0 is tangent from outside, 1 from inside.
struct Pose {
    double a, b, d;
};

Pose pose(Numbers& numbers, double least, double narrowest) {
    const double a = numbers.log_between(least, 1.5);
    const double b = std::min(a * numbers.log_between(1.0, 1.0 / least), 1.57);
    const double way = numbers.log_between(narrowest, 1.0);
    return {a, b, (b - a) + 2.0 * a * (numbers.between(0.0, 1.0) < 0.5 ? 1.0 - way : way)};
}

TEST(CapOverlap, HasItsDigitsHoweverSmallOrNarrow) {
    Numbers numbers;
    int small = 0;
    for (int i = 0; i < 500; ++i) {
        const auto [a, b, d] = pose(numbers, 1e-9, 1e-9);
        if (!(d < a + b && d > b - a)) continue;
        const double found = cap_overlap(a, b, d);
        EXPECT_EQ(cap_overlap(b, a, d), found);
        const Real expected = truth(a, b, d).area;
        // The overlap of two caps near hemispheres is summed from angles: a few last digits of π, however small the
        // result.
        const Real tolerance = 3e-14L * expected + (a > 1.4 ? 4e-15L : 0.0L);
        EXPECT_NEAR(static_cast<double>(found - expected), 0.0, static_cast<double>(tolerance))
            << a << ' ' << b << ' ' << d << ": " << found;
        if (a < 1e-5 && b > 1e3 * a) ++small;
    }
    EXPECT_GT(small, 80);
}

TEST(CapOverlap, HasItsDigitsWithTheCosine) {
    Numbers numbers;
    for (int i = 0; i < 500; ++i) {
        const auto [a, b, apart] = pose(numbers, 1e-7, 1e-3);
        const glm::dvec3 axis_a(0.0, 0.0, 1.0);
        const glm::dvec3 axis_b(std::sin(apart), 0.0, std::cos(apart));
        const Real d = std::atan2(Real(axis_b.x), Real(axis_b.z)); // of the rounded vectors
        if (!(d < Real(a) + b && d > Real(b) - a)) continue;
        const double tilt = numbers.between(0.0, 1.2);
        const double turn = numbers.between(0.0, 2.0 * std::numbers::pi);
        const glm::dvec3 normal(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt));
        const Truth integrals = truth(a, b, d);
        const Real expected = integrals.along * normal.z + integrals.across * normal.x;
        // The angle between the axes has an error in the last digit of a number near 1, relative to the lens's width;
        // terms that fall on either axis may have either sign.
        const Real width = std::min(Real(a) + b - d, 2.0L * a);
        const Real tolerance = integrals.area * (3e-14L + 2e-15L * (d / width)) + (a > 1.4 ? 4e-15L : 0.0L);
        for (const double found :
             {projected_cap_overlap(axis_a, a, axis_b, b, normal), projected_cap_overlap(axis_b, b, axis_a, a, normal)})
            EXPECT_NEAR(static_cast<double>(found - expected), 0.0, static_cast<double>(tolerance))
                << a << ' ' << b << ' ' << apart << ": " << found;
    }
}

// One cap inside the other, or touching it.
TEST(CapOverlap, HasItsLimits) {
    for (const double a : {1e-9, 1e-4, 0.3, 1.45}) {
        const double whole = 4.0 * std::numbers::pi * std::sin(0.5 * a) * std::sin(0.5 * a);
        const double b = std::min(1.5 * a, 1.55);
        EXPECT_DOUBLE_EQ(cap_overlap(a, b, 0.0), whole);
        EXPECT_DOUBLE_EQ(cap_overlap(a, b, b - a), whole);
        EXPECT_NEAR(cap_overlap(a, b, (b - a) * (1.0 + 1e-12)), whole, 1e-12 * whole);
        EXPECT_EQ(cap_overlap(a, b, (a + b) * (1.0 + 1e-15)), 0.0);
        EXPECT_DOUBLE_EQ(projected_cap_overlap({0, 0, 1}, a, {0, 0, 1}, b, {0, 0, 1}),
                         std::numbers::pi * std::sin(a) * std::sin(a));
    }
    EXPECT_EQ(cap_overlap(0.0, 0.3, 0.2), 0.0);
}

} // namespace
} // namespace gonio
