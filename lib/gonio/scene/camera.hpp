// Camera: a pinhole that looks from a position at a target.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>

#pragma GCC visibility push(default)
namespace gonio {

// A half line.
struct Ray {
    glm::dvec3 origin;
    glm::dvec3 direction; // unit
};

// A pinhole camera.
struct Camera {
    glm::dvec3 position{0.0, -5.0, 1.5}; // [m]
    glm::dvec3 target{0.0, 0.0, 1.0};
    glm::dvec3 up{0.0, 0.0, 1.0};
    double vertical_fov_deg = 40.0; // full angle
    // Narrow pictures show more above and below, until they cover this angle horizontally; full angle, 0 for no
    // minimum.
    double least_horizontal_fov_deg = 0.0;
};

// The camera's basis for one picture size, computed once; each pixel calls ray().
class CameraRays {
public:
    CameraRays(const Camera& camera, int width, int height);

    const glm::dvec3& eye() const { return origin_; } // where all rays begin

    // The ray through the point (x, y) of the picture, in pixels from its top left corner: pixel (i, j) has its centre
    // at (i + ½, j + ½).
    Ray ray(double x, double y) const;

    // The ray through (x, y) has the direction of corner + x·right + y·down.
    struct Plane {
        glm::dvec3 corner; // from the eye to the top left corner of the picture
        glm::dvec3 right;  // one pixel
        glm::dvec3 down;   // one pixel
    };
    const Plane& plane() const { return plane_; }

    // The point of the picture, or of its plane beyond its sides, at which a point of the world appears: the ray()
    // through it meets that point. Nothing where the world's point is not in front of the eye.
    std::optional<glm::dvec2> place_of(const glm::dvec3& position) const;

private:
    glm::dvec3 origin_;
    Plane plane_;
    glm::dvec3 ahead_; // unit
};

} // namespace gonio
#pragma GCC visibility pop
