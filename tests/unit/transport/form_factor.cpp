#include <gonio/transport/form_factor.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace gonio::detail {
namespace {

struct Patch {
    glm::dvec3 to; // the middle
    glm::dvec3 u;  // sides
    glm::dvec3 v;

    std::array<glm::dvec3, 4> corners() const {
        return {to - 0.5 * (u + v), to + 0.5 * (u - v), to + 0.5 * (u + v), to - 0.5 * (u - v)};
    }
};

const glm::dvec3 up(0.0, 0.0, 1.0);

// `height`: of the middle, at a distance of 1 to 4; the sides have a length of up to `side`.
Patch random_patch(std::mt19937_64& random, double height, double side) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&] { return glm::dvec3(unit(random), unit(random), unit(random)); };
    Patch patch;
    patch.to = glm::dvec3(1.0 + 3.0 * std::abs(unit(random)), unit(random), height);
    patch.u = 0.5 * side * vector();
    patch.v = 0.5 * side * vector();
    return patch;
}

// By the middles of n × n parts above the horizon.
double quadrature(const Patch& patch) {
    constexpr int n = 400;
    const glm::dvec3 area = glm::cross(patch.u, patch.v) / static_cast<double>(n * n);
    double sum = 0.0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const glm::dvec3 p = patch.to + ((i + 0.5) / n - 0.5) * patch.u + ((j + 0.5) / n - 0.5) * patch.v;
            const double p2 = glm::dot(p, p);
            sum += std::max(p.z, 0.0) * std::abs(glm::dot(area, p)) / (p2 * p2);
        }
    return sum / std::numbers::pi;
}

TEST(FormFactor, AnglesAreThoseOfTheArctangent) {
    for (double angle = 1e-9; angle < 1.57; angle *= 1.01) {
        const double tangent = std::tan(angle);
        EXPECT_NEAR(atan_ratio(tangent * tangent) * tangent / angle, 1.0, 3e-10) << angle;
    }
    EXPECT_EQ(atan_ratio(0.0), 1.0);
}

TEST(FormFactor, IsThatOfQuadrature) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 40; ++i) {
        const Patch patch = random_patch(random, i % 2 == 0 ? 1.0 : 0.1, 1.5); // every other one is cut by the horizon
        const double expected = quadrature(patch);
        // Middles of parts that the horizon cuts are off by a part: 1/400 of what is there, which has small cosines.
        EXPECT_NEAR(seen_above(up, patch.corners()).form_factor, expected, 1e-3 * expected + 2e-7) << i;
    }
}

TEST(FormFactor, OfPartsIsThatOfTheirCorners) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    int above = 0;
    for (int i = 0; i < 2000; ++i) {
        const Patch whole = random_patch(random, unit(random), 2.0);
        const double size = std::pow(10.0, -3.0 * unit(random));
        const glm::dvec2 half(0.25 * size * unit(random), 0.25 * size * unit(random));
        const Parallelogram sides(up, whole.u, whole.v);
        if (!sides.is_above(whole.to, half)) continue;
        ++above;
        const Patch part{whole.to, 2.0 * half.x * whole.u, 2.0 * half.y * whole.v};
        const double expected = seen_above(up, part.corners()).form_factor;
        // The edges' angles, of which the form factor is what remains, are good to 2e-10, and doubles round their sum.
        EXPECT_NEAR(sides.form_factor(whole.to, half), expected, 1e-8 * expected + 1e-15) << i;
    }
    EXPECT_GT(above, 1000);
}

TEST(FormFactor, OfPartsAddsUp) {
    std::mt19937_64 random(3);
    for (int i = 0; i < 100; ++i) {
        const Patch whole = random_patch(random, 1.0, 0.5);
        const Parallelogram sides(up, whole.u, whole.v);
        double sum = 0.0;
        for (const double x : {-0.25, 0.25})
            for (const double y : {-0.25, 0.25})
                sum += sides.form_factor(whole.to + x * whole.u + y * whole.v, {0.25, 0.25});
        const double all = sides.form_factor(whole.to, {0.5, 0.5});
        EXPECT_NEAR(sum, all, 1e-8 * all + 1e-15) << i;
    }
}

TEST(FormFactor, OfWhatIsBelowIsNothing) {
    const Patch below{{0.0, 0.0, -1.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    EXPECT_EQ(seen_above(up, below.corners()).form_factor, 0.0);
    EXPECT_FALSE(Parallelogram(up, below.u, below.v).is_above(below.to, {0.5, 0.5}));
    // All of the hemisphere but a rim.
    const Patch wide{{0.0, 0.0, 1e-3}, {10.0, 0.0, 0.0}, {0.0, 10.0, 0.0}};
    EXPECT_NEAR(seen_above(up, wide.corners()).form_factor, 1.0, 1e-6);
}

} // namespace
} // namespace gonio::detail
