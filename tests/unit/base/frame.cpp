#include <gonio/base/frame.hpp>
#include <gonio/base/quantity.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace gonio {
namespace {

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double limit = 1e-15) {
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(a[i], b[i], limit);
}

TEST(Frame, DirectionsOfTheAxes) {
    expect_near(direction_of({degrees(0), degrees(0)}), {0, 0, -1});
    expect_near(direction_of({degrees(0), degrees(90)}), {1, 0, 0});
    expect_near(direction_of({degrees(90), degrees(90)}), {0, 1, 0});
    expect_near(direction_of({degrees(0), degrees(180)}), {0, 0, 1});
}

TEST(Frame, AnglesRoundTrip) {
    for (double c = 0.0; c < 360.0; c += 7.3)
        for (double gamma = 0.1; gamma < 180.0; gamma += 4.9) {
            const PolarAngles angles = angles_of(3.0 * direction_of({degrees(c), degrees(gamma)}));
            EXPECT_NEAR(to_degrees(angles.c), c, 1e-12);
            EXPECT_NEAR(to_degrees(angles.gamma), gamma, 1e-13);
        }
    // An acos would lose this angle completely.
    EXPECT_NEAR(angles_of(direction_of({degrees(10), Radians(1e-12)})).gamma.value, 1e-12, 1e-27);
}

TEST(Frame, AimedFramesAreOrthonormalAndRightHanded) {
    for (const glm::dvec3 direction : {glm::dvec3(0, 0, -1), glm::dvec3(0, 1, 0), glm::dvec3(0, -2, 0),
                                       glm::dvec3(0.3, 0.2, -5), glm::dvec3(1, 1e-9, 0)}) {
        const Frame frame = aimed_frame({1, 2, 3}, direction, {0, 1, 0});
        expect_near(frame.z, -glm::normalize(direction));
        expect_near(glm::cross(frame.x, frame.y), frame.z, 1e-15);
        EXPECT_NEAR(glm::dot(frame.x, frame.y), 0.0, 1e-15);
        EXPECT_NEAR(glm::length(frame.x), 1.0, 1e-15);
    }
    // The light frame of a luminaire on the ceiling is the world's frame.
    const Frame hanging = aimed_frame({0, 0, 0}, {0, 0, -1}, {0, 1, 0});
    expect_near(hanging.x, {1, 0, 0});
    expect_near(hanging.y, {0, 1, 0});
}

TEST(Quantity, ExposureValuesRoundTrip) {
    EXPECT_DOUBLE_EQ(luminance(Ev100(15.0)).value, 4096.0);
    EXPECT_DOUBLE_EQ(illuminance(EvLux(0.0)).value, 2.5);
    for (const double ev : {-6.0, 0.0, 3.3, 12.0, 20.0}) {
        EXPECT_NEAR(ev100(luminance(Ev100(ev))).value, ev, 1e-14 * 20);
        EXPECT_NEAR(ev_lux(illuminance(EvLux(ev))).value, ev, 1e-14 * 20);
    }
}

} // namespace
} // namespace gonio
