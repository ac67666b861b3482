#include <gonio/transport/patch_cosine.hpp>

#include "../preview/numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gonio::detail {
namespace {

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
    test::Numbers numbers(1);
    int dark = 0;
    int partly_lit = 0;
    for (int i = 0; i < 500; ++i) {
        const Frame frame = numbers.frame();
        const double azimuth = numbers.between(-3.5, 3.5);
        const double rise = i % 3 == 0 ? 0.0 : numbers.between(-1.0, 1.0);
        const double half_turn = 0.02 + 1.5 * numbers.between(0.0, 1.0) * numbers.between(0.0, 1.0);
        const glm::dvec3 towards = numbers.direction();
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
    test::Numbers numbers(2);
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 normal = numbers.direction();
        const glm::dvec3 towards = numbers.direction();
        EXPECT_EQ(PatchCosine(normal).mean(towards), std::max(glm::dot(normal, towards), 0.0));
    }
}

} // namespace
} // namespace gonio::detail
