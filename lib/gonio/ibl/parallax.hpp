// What a surface sees of an environment that was captured elsewhere: the direction from the capture to where the
// surface's ray meets a simple body around both.
//
// S. Lagarde and A. Zanuttini, "Local Image-based Lighting With Parallax-corrected Cubemaps", SIGGRAPH 2012.
#pragma once

#include <glm/vec3.hpp>

#pragma GCC visibility push(default)
namespace gonio {

// Sides along the axes [m].
struct ParallaxBox {
    glm::dvec3 low{-1.0};
    glm::dvec3 high{1.0};
};

// The surroundings of a capture as a sphere.
struct ParallaxSphere {
    glm::dvec3 center{0.0};
    double radius = 1.0; // [m]
};

// From the capture's place to where the ray from `position` in a unit `direction` leaves the body; not unit. A position
// outside the body is moved to the nearest one in it. `direction` itself if the result would be no direction.
glm::dvec3 parallax_corrected(const ParallaxBox& box, const glm::dvec3& captured_at, const glm::dvec3& position,
                              const glm::dvec3& direction);
glm::dvec3 parallax_corrected(const ParallaxSphere& sphere, const glm::dvec3& captured_at, const glm::dvec3& position,
                              const glm::dvec3& direction);

} // namespace gonio
#pragma GCC visibility pop
