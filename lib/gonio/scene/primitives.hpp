// Primitives: the shapes that make up a stage. Lengths are metres, vectors called normal, axis or direction are unit
// vectors.
//
// Solids (sphere, box, capsule) are hit and seen from outside only; a ray that starts inside one passes out of it.
// Planes and rectangles are one-sided surfaces without thickness, hit from their lit side only. Both kinds block light:
// see occlusion.hpp.
#pragma once

#include <gonio/base/frame.hpp>
#include <gonio/scene/camera.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <optional>
#include <variant>

#pragma GCC visibility push(default)
namespace gonio {

// An infinite plane, lit and visible from the side its normal points to.
struct Plane {
    glm::dvec3 point{0.0};
    glm::dvec3 normal{0.0, 0.0, 1.0};
};

// A rectangle, lit and visible from the side that Z of its frame points to; `width` runs along X, `height` along Y.
struct Panel {
    Frame frame;
    double width = 1.0;
    double height = 1.0;
};

// A solid sphere.
struct Ball {
    glm::dvec3 center{0.0};
    double radius = 1.0;
};

// A solid box, `half_size` from its centre to its faces along the axes of its frame.
struct Box {
    Frame frame;
    glm::dvec3 half_size{0.5};
};

// All points within `radius` of a line segment: a cylinder with hemispherical ends.
struct Capsule {
    glm::dvec3 center{0.0};
    glm::dvec3 axis{0.0, 0.0, 1.0};
    double half_length = 0.5; // from the centre to the centres of the hemispherical ends
    double radius = 0.1;
};

// Any of them.
using Primitive = std::variant<Plane, Panel, Ball, Box, Capsule>;

// Takes the centres of the hemispherical ends, which must differ.
Capsule capsule_between(const glm::dvec3& from, const glm::dvec3& to, double radius);

// `up` gives Y of the rectangle, made orthogonal to the normal as for a light.
Panel panel_facing(const glm::dvec3& center, const glm::dvec3& normal, const glm::dvec3& up, double width,
                   double height);

// Distance along the ray to the point where it enters; nothing behind the origin, from inside a solid or from the dark
// side of a one-sided surface. Lines that lie in a face do not hit it. Hits keep 1e-12 of the distance for objects 1e-6
// of it wide.
std::optional<double> distance_to(const Plane& plane, const Ray& ray);
std::optional<double> distance_to(const Panel& panel, const Ray& ray);
std::optional<double> distance_to(const Ball& ball, const Ray& ray);
std::optional<double> distance_to(const Box& box, const Ray& ray);
std::optional<double> distance_to(const Capsule& capsule, const Ray& ray);

// Whether it is a plane or a rectangle, which have no inside.
bool is_sheet(const Primitive& primitive);

// The face of a box that a point on its surface lies on, numbered as in face(); 0 for all other primitives.
int face_at(const Primitive& primitive, const glm::dvec3& on_surface);

// Unit normal at a point on the surface, towards the lit side; on an edge of a box, the normal of one of its faces.
glm::dvec3 normal_at(const Primitive& primitive, const glm::dvec3& on_surface);

// Whether a point cannot see the surface because it is inside a solid, or on or behind a plane. Never for a rectangle.
bool hides(const Primitive& primitive, const glm::dvec3& point);

// The bounding sphere of a primitive; nothing for a plane.
std::optional<Ball> bounds(const Primitive& primitive);

// Counter-clockwise as seen from the lit side.
std::array<glm::dvec3, 4> corners(const Panel& panel);

// The six faces of a box, facing outwards, in the order X, −X, Y, −Y, Z, −Z.
Panel face(const Box& box, int index);

} // namespace gonio
#pragma GCC visibility pop
