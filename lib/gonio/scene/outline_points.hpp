// Outlines: points whose convex hull is what a surface is seen as.
#pragma once

#include <gonio/scene/primitives.hpp>

#include <glm/vec3.hpp>

#include <vector>

namespace gonio {

// Points of the world that, projected to any plane before the eye, have the convex hull that the surface of a primitive
// appears as. Round outlines are polygons of 32 corners: that of a sphere with its area, that of a capsule with its
// width. Nothing where there is no such outline: of an infinite plane, or for an eye inside a solid. Of lights:
// outline_points() in emitter.hpp.
std::vector<glm::dvec3> outline_points(const Primitive& primitive, const glm::dvec3& eye);

// Of flat ellipses, given by half axes that are at right angles, and of cylinders without caps.
std::vector<glm::dvec3> ellipse_outline(const glm::dvec3& center, const glm::dvec3& x, const glm::dvec3& y);
std::vector<glm::dvec3> cylinder_outline(const glm::dvec3& center, const glm::dvec3& half_axis, double radius,
                                         const glm::dvec3& eye);

} // namespace gonio
