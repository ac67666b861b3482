#include <gonio/scene/camera.hpp>

#include <gtest/gtest.h>

namespace gonio {
namespace {

TEST(Camera, PlaceOfIsTheInverseOfRay) {
    const Camera camera{{1.0, -3.0, 2.0}, {0.5, 4.0, 0.3}, {0.1, 0.0, 1.0}, 55.0, 0.0};
    const CameraRays rays(camera, 320, 200);
    for (const double x : {-40.0, 0.0, 17.3, 160.0, 319.9})
        for (const double y : {-3.0, 0.5, 99.0, 200.0})
            for (const double distance : {0.01, 7.0, 1e4}) {
                const Ray ray = rays.ray(x, y);
                const auto place = rays.place_of(ray.origin + distance * ray.direction);
                ASSERT_TRUE(place.has_value());
                EXPECT_NEAR(place->x, x, 1e-9 * 320.0);
                EXPECT_NEAR(place->y, y, 1e-9 * 320.0);
                EXPECT_FALSE(rays.place_of(ray.origin - distance * ray.direction).has_value());
            }
}

} // namespace
} // namespace gonio
