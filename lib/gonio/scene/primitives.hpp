// Primitives: the shapes that a stage is made of. Lengths are metres, vectors called normal, axis or direction are unit
// vectors.
//
// Solids (ball, box, capsule) are met and seen from outside only; a ray that starts in one passes out of it. Planes and
// panels are sheets without thickness, met from their lit side only. Both keep light from passing: see occlusion.hpp.
#pragma once

#include <gonio/base/frame.hpp>
#include <gonio/scene/camera.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <optional>
#include <variant>

namespace gonio {

// An infinite plane that is lit and seen from the side its normal points to.
struct Plane {
    glm::dvec3 point{0.0};
    glm::dvec3 normal{0.0, 0.0, 1.0};
};

// A rectangle that is lit and seen from the side that Z of its frame points to; `width` runs along X, `height` along Y.
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

// All points within `radius` of a line: a cylinder with round ends.
struct Capsule {
    glm::dvec3 center{0.0};
    glm::dvec3 axis{0.0, 0.0, 1.0};
    double half_length = 0.5; // from the centre to the middles of the round ends
    double radius = 0.1;
};

using Primitive = std::variant<Plane, Panel, Ball, Box, Capsule>;

// Of the round ends' middles, which must differ.
Capsule capsule_between(const glm::dvec3& from, const glm::dvec3& to, double radius);

// `up` gives Y of the panel, made orthogonal to the normal as a light's is.
Panel panel_facing(const glm::dvec3& center, const glm::dvec3& normal, const glm::dvec3& up, double width,
                   double height);

// Distance along the ray to where it enters; nothing behind the origin and nothing from inside a solid or from the dark
// side of a sheet. Lines that lie in a face do not meet it. Hits keep 1e-12 of the distance for bodies 1e-6 of it wide.
std::optional<double> distance_to(const Plane& plane, const Ray& ray);
std::optional<double> distance_to(const Panel& panel, const Ray& ray);
std::optional<double> distance_to(const Ball& ball, const Ray& ray);
std::optional<double> distance_to(const Box& box, const Ray& ray);
std::optional<double> distance_to(const Capsule& capsule, const Ray& ray);

// Whether it is a plane or a panel, which has no inside.
bool is_sheet(const Primitive& primitive);

// The face of a box that a point on its surface lies on, as face() counts them; 0 of all other primitives.
int face_at(const Primitive& primitive, const glm::dvec3& on_surface);

// Unit normal at a point on the surface, towards the side that is lit; on an edge of a box that of one of its faces.
glm::dvec3 normal_at(const Primitive& primitive, const glm::dvec3& on_surface);

// Whether a point cannot see the surface for being in a solid, or on or behind a plane. Never of a panel.
bool hides(const Primitive& primitive, const glm::dvec3& point);

// The sphere around a primitive; nothing around a plane.
std::optional<Ball> bounds(const Primitive& primitive);

// Counter-clockwise as seen from the lit side.
std::array<glm::dvec3, 4> corners(const Panel& panel);

// The six faces of a box, looking outwards: of X, −X, Y, −Y, Z, −Z.
Panel face(const Box& box, int index);

} // namespace gonio
