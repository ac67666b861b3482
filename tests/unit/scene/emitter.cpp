#include <gonio/light/light.hpp>
#include <gonio/scene/emitter.hpp>

#include "../light/lights.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio {
namespace {

// Shines along +X from (2, 0, 0); its Y is the world's Z.
Light sideways(const char* shape) {
    return light_of(shape, "1000nt", {2, 0, 0}, {1, 0, 0}, {0, 0, 1});
}

std::optional<double> from(const Light& light, glm::dvec3 origin, glm::dvec3 target) {
    return distance_to(light, {origin, glm::normalize(target - origin)});
}

TEST(Emitter, FlatLightsAreSeenFromTheirFront) {
    const Light disk = sideways("disk:r=1m");
    EXPECT_NEAR(from(disk, {5, 0, 0}, {2, 0, 0}).value(), 3.0, 1e-14);
    EXPECT_TRUE(from(disk, {5, 0, 0}, {2, 0.7, 0.7}));
    EXPECT_FALSE(from(disk, {5, 0, 0}, {2, 0.8, 0.7}));
    EXPECT_FALSE(from(disk, {0, 0, 0}, {2, 0, 0})); // its back
    EXPECT_TRUE(from(sideways("disk:r=1m,two-sided"), {0, 0, 0}, {2, 0, 0}));
    EXPECT_FALSE(from(disk, {5, 0, 0}, {6, 0, 0})); // behind the eye
    EXPECT_FALSE(from(disk, {2, 5, 0}, {2, 0, 0})); // edge on
}

TEST(Emitter, RectanglesKeepTheirSidesApart) {
    // Y of the light is the world's Z, so its width runs along the world's Y.
    const Light rect = sideways("rect:w=2m,h=1m");
    EXPECT_TRUE(from(rect, {5, 0, 0}, {2, 0.99, 0.49}));
    EXPECT_FALSE(from(rect, {5, 0, 0}, {2, 1.01, 0.0}));
    EXPECT_FALSE(from(rect, {5, 0, 0}, {2, 0.0, 0.51}));
}

// A capsule is all points closer than r to a segment: march along the ray until that holds.
TEST(Emitter, TubesAreMetWhereMarchingMeetsThem) {
    const Light tube = sideways("tube:r=20cm,l=1m");
    const glm::dvec3 half = 0.5 * tube.frame.x;
    const auto distance_to_surface = [&](const glm::dvec3& p) {
        const glm::dvec3 a = p - (glm::dvec3(2, 0, 0) - half);
        const double along = std::clamp(glm::dot(a, tube.frame.x), 0.0, 1.0);
        return glm::length(a - along * tube.frame.x) - 0.2;
    };
    int met = 0;
    for (int i = -20; i <= 20; ++i)
        for (int j = -20; j <= 20; ++j) {
            const glm::dvec3 origin(5, 0.3, -0.4);
            const glm::dvec3 direction = glm::normalize(glm::dvec3(-3, 0.05 * i, 0.03 * j));
            double marched = 0.0;
            for (int step = 0; step < 2000 && marched < 10.0; ++step)
                marched += distance_to_surface(origin + marched * direction);
            const bool hit = marched < 10.0 && distance_to_surface(origin + marched * direction) < 1e-6;
            const auto distance = distance_to(tube, {origin, direction});
            ASSERT_EQ(distance.has_value(), hit) << i << ' ' << j;
            if (!hit) continue;
            EXPECT_NEAR(*distance, marched, 1e-5);
            ++met;
        }
    EXPECT_GT(met, 50);
}

TEST(Emitter, CylindersAreMetOnTheirOutside) {
    const Light cylinder = sideways("cylinder:r=20cm,l=1m");
    const glm::dvec3 axis = cylinder.frame.x;
    const glm::dvec3 middle = cylinder.frame.origin;
    const glm::dvec3 across = cylinder.frame.z;
    const auto met = [&](const glm::dvec3& origin, const glm::dvec3& toward) {
        return distance_to(cylinder, {origin, glm::normalize(toward - origin)});
    };
    EXPECT_NEAR(*met(middle + 3.0 * across, middle), 2.8, 1e-14);
    EXPECT_NEAR(*met(middle + 3.0 * across, middle + 0.49 * axis), 2.8 / 3.0 * std::hypot(3.0, 0.49), 1e-14);
    EXPECT_FALSE(met(middle + 3.0 * across, middle + 0.6 * axis)) << "beside it";
    EXPECT_FALSE(met(middle + 3.0 * axis, middle)) << "into its open end";
    EXPECT_FALSE(met(middle, middle + across)) << "from inside";
    EXPECT_FALSE(met(middle + 3.0 * across, middle + 5.0 * across)) << "away from it";
    EXPECT_NEAR(reach_along(cylinder, axis), 0.5, 1e-15);
    EXPECT_NEAR(reach_along(cylinder, across), 0.2, 1e-15);
}

TEST(Emitter, PunctualLightsAndTheSunHaveNoSurface) {
    Diagnostics diagnostics;
    LightDescription description;
    description.shape = PointShape{};
    description.intensity = parse_photometric_value("1cd").value();
    const Light point = resolve_light(description, diagnostics).value();
    EXPECT_FALSE(distance_to(point, {{0, 0, 5}, {0, 0, -1}}));
}

} // namespace
} // namespace gonio
