#include <gonio/ibl/parallax.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace gonio {
namespace {

using Vec = glm::dvec3;

void expect_near(const Vec& found, const Vec& expected, double tolerance) {
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(found[axis], expected[axis], tolerance) << axis;
}

// By hand: the ray leaves the box through its east wall, and the sphere where |P + tR − centre| is its radius.
TEST(Parallax, MeetsTheBody) {
    const Vec direction = glm::normalize(Vec(0.6, 0.3, 0.742));
    const Vec position(1.0, 0.5, 0.0);
    expect_near(
        parallax_corrected(ParallaxBox{{-2.0, -3.0, 0.0}, {3.0, 3.0, 2.5}}, {0.0, 0.0, 1.2}, position, direction),
        {3.0, 1.5, 2.0 / 0.6 * 0.742 - 1.2}, 1e-12);
    const ParallaxSphere sphere{{0.0, 0.0, 1.0}, 4.0};
    const Vec seen = parallax_corrected(sphere, {0.0, 0.0, 1.0}, position, direction);
    EXPECT_NEAR(glm::length(seen), 4.0, 1e-12);
    expect_near(seen, {3.21944, 1.60972, 1.74471}, 1e-5);
}

// From the capture's own place everything is where it was captured.
TEST(Parallax, ChangesNothingAtTheCapture) {
    const Vec place(0.3, -0.2, 1.1);
    for (const Vec& direction : {Vec(1.0, 0.0, 0.0), Vec(0.0, -0.6, 0.8), glm::normalize(Vec(-1.0, 2.0, -3.0))}) {
        expect_near(glm::normalize(parallax_corrected(ParallaxBox{Vec(-2.0), Vec(3.0)}, place, place, direction)),
                    direction, 1e-12);
        expect_near(glm::normalize(parallax_corrected(ParallaxSphere{place, 2.0}, place, place, direction)), direction,
                    1e-12);
    }
}

// Positions outside are moved into the body, and no result is without a direction.
TEST(Parallax, HasADirectionEverywhere) {
    const ParallaxBox box{Vec(-1.0), Vec(1.0)};
    const ParallaxSphere sphere{Vec(0.0), 1.0};
    for (const Vec& position : {Vec(0.0), Vec(5.0, 0.0, 0.0), Vec(1.0), Vec(-1e9, 1e9, 0.0)})
        for (const Vec& direction : {Vec(1.0, 0.0, 0.0), Vec(0.0, 0.0, -1.0), glm::normalize(Vec(1.0))})
            for (const Vec& place : {Vec(0.0), Vec(1.0, 0.0, 0.0), Vec(0.5, 0.5, 0.5)}) {
                for (const Vec& seen : {parallax_corrected(box, place, position, direction),
                                        parallax_corrected(sphere, place, position, direction)}) {
                    EXPECT_TRUE(glm::length(seen) > 0.0);
                    EXPECT_LT(glm::length(seen), 10.0);
                }
            }
}

} // namespace
} // namespace gonio
