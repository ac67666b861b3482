// Camera: a pinhole that looks from a position at a target.
#pragma once

#include <glm/vec3.hpp>

namespace gonio {

struct Ray {
    glm::dvec3 origin;
    glm::dvec3 direction; // unit
};

struct Camera {
    glm::dvec3 position{0.0, -5.0, 1.5}; // [m]
    glm::dvec3 target{0.0, 0.0, 1.0};
    glm::dvec3 up{0.0, 0.0, 1.0};
    double vertical_fov_deg = 40.0; // full angle
    // Narrow pictures see more above and below, until they see this far to the sides; full angle, 0 for as it comes.
    double least_horizontal_fov_deg = 0.0;
};

// The camera's basis for one picture size, made once; ray() is what the pixels call.
class CameraRays {
public:
    CameraRays(const Camera& camera, int width, int height);

    // Through the point (x, y) of the picture, in pixels from its top left corner: pixel (i, j) has its centre at
    // (i + ½, j + ½).
    Ray ray(double x, double y) const;

private:
    glm::dvec3 origin_;
    glm::dvec3 corner_; // from the eye to the top left corner of the picture
    glm::dvec3 right_;  // one pixel
    glm::dvec3 down_;   // one pixel
};

} // namespace gonio
