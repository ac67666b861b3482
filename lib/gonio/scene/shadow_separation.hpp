// A plane between a light and what may hide it.
#pragma once

#include <gonio/scene/primitives.hpp>
#include <gonio/scene/shadow_numbers.hpp>

#include <glm/vec3.hpp>

#include <optional>

namespace gonio::detail {

// All of the body is on one side of the plane or on it, all of the light on the other, to which the normal points.
struct Separation {
    glm::dvec3 point;
    glm::dvec3 normal; // of any length
};

// Two convex objects that have no point in common have such a plane; where they nearly touch it may not be found. A
// light without a shape of its own is the sphere around it.
std::optional<Separation> separation(const Primitive& body, const LinedLight& light);

} // namespace gonio::detail
