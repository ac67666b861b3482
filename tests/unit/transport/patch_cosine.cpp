#include <gonio/transport/patch_cosine.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace gonio::detail {
namespace {

glm::dvec3 random_direction(std::mt19937_64& random) {
    std::normal_distribution<double> number;
    glm::dvec3 way;
    for (int axis = 0; axis < 3; ++axis) // arguments have no order
        way[axis] = number(random);
    return glm::normalize(way);
}

Frame random_frame(std::mt19937_64& random) {
    const glm::dvec3 z = random_direction(random);
    const glm::dvec3 x = glm::normalize(glm::cross(z, random_direction(random)));
    return {glm::dvec3(0.0), x, glm::cross(z, x), z};
}

glm::dvec3 normal_at(const Frame& frame, double azimuth, double rise) {
    const double out = std::sqrt((1.0 - rise) * (1.0 + rise));
    return out * (std::cos(azimuth) * frame.x + std::sin(azimuth) * frame.y) + rise * frame.z;
}

// By the middles of as many parts.
double quadrature(const Frame& frame, double azimuth, double rise, double half_turn, const glm::dvec3& towards) {
    constexpr int n = 2000;
    double sum = 0.0;
    for (int i = 0; i < n; ++i)
        sum +=
            std::max(glm::dot(normal_at(frame, azimuth + half_turn * ((2.0 * i + 1.0) / n - 1.0), rise), towards), 0.0);
    return sum / n;
}

TEST(PatchCosine, OfARoundPatchIsThatOfQuadrature) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    int dark = 0;
    int partly_lit = 0;
    for (int i = 0; i < 500; ++i) {
        const Frame frame = random_frame(random);
        const double azimuth = 7.0 * unit(random) - 3.5;
        const double rise = i % 3 == 0 ? 0.0 : 2.0 * unit(random) - 1.0;
        const double half_turn = 0.02 + 1.5 * unit(random) * unit(random);
        const glm::dvec3 towards = random_direction(random);
        const PatchCosine cosine(frame, normal_at(frame, azimuth, rise), half_turn);
        const double expected = quadrature(frame, azimuth, rise, half_turn, towards);
        EXPECT_NEAR(cosine.mean(towards), expected, 1e-6) << i;
        if (expected == 0.0) ++dark;
        const double low = glm::dot(normal_at(frame, azimuth - half_turn, rise), towards);
        const double high = glm::dot(normal_at(frame, azimuth + half_turn, rise), towards);
        if (low * high < 0.0) ++partly_lit;
    }
    EXPECT_GT(dark, 50);
    EXPECT_GT(partly_lit, 50);
}

// The direction, or its opposite, within the turn: the cosine is not least or greatest at the sides.
TEST(PatchCosine, SeesWhatIsInTheMiddleAlone) {
    const Frame frame{glm::dvec3(0.0), glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(0.0, 0.0, 1.0)};
    const double rise = 0.5;
    const double half_turn = 0.6;
    const PatchCosine cosine(frame, normal_at(frame, 0.0, rise), half_turn);
    for (const double facing : {1.0, -1.0}) {
        int lit = 0;
        for (double down = 0.0; down < 3.1; down += 0.01) {
            const glm::dvec3 towards = facing * glm::dvec3(std::cos(down), 0.0, -std::sin(down));
            const double expected = quadrature(frame, 0.0, rise, half_turn, towards);
            EXPECT_NEAR(cosine.mean(towards), expected, 1e-6) << facing << ' ' << down;
            const double middle = glm::dot(normal_at(frame, 0.0, rise), towards);
            const double side = glm::dot(normal_at(frame, half_turn, rise), towards);
            if (middle * side < 0.0) ++lit;
        }
        EXPECT_GT(lit, 3) << facing;
    }
}

TEST(PatchCosine, OfAFlatPatchIsThatOfItsNormal) {
    std::mt19937_64 random(2);
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 normal = random_direction(random);
        const glm::dvec3 towards = random_direction(random);
        EXPECT_EQ(PatchCosine(normal).mean(towards), std::max(glm::dot(normal, towards), 0.0));
    }
}

} // namespace
} // namespace gonio::detail
