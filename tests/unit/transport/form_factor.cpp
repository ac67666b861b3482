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

TEST(FormFactor, IsThatOfQuadrature) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 40; ++i) {
        const Patch patch = random_patch(random, i % 2 == 0 ? 1.0 : 0.1, 1.5); // every other one is cut by the horizon
        const double expected = quadrature(patch);
        // Middles of parts that the horizon cuts are off by a part: 1/400 of what is there, which has small cosines.
        EXPECT_NEAR(seen_above(up, patch.corners()).form_factor, expected, 1e-3 * expected + 2e-7) << i;
    }
}

TEST(FormFactor, OfWhatIsBelowIsNothing) {
    const Patch below{{0.0, 0.0, -1.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    EXPECT_EQ(seen_above(up, below.corners()).form_factor, 0.0);
    // All of the hemisphere but a rim.
    const Patch wide{{0.0, 0.0, 1e-3}, {10.0, 0.0, 0.0}, {0.0, 10.0, 0.0}};
    EXPECT_NEAR(seen_above(up, wide.corners()).form_factor, 1.0, 1e-6);
}

} // namespace
} // namespace gonio::detail
