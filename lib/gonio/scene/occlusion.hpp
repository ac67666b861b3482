// The share of a light that a surface point sees past the objects on a stage.
//
// A light counts as a sphere, and the sun as a cap of the sky: the share is that of the solid angle of the cap that the
// light fills. All directions have the same weight: the cosine at the receiver is not included. What each primitive
// covers:
//   sphere     its cap, closed form (cap_overlap)
//   rectangle  its spherical polygon, closed form (polygon_overlap)
//   box        the polygons of the faces towards the receiver, which do not overlap: closed form
//   capsule    the polygon of its outline, round ends as 12 chords of equal area each: within 0.5 % of its radius
//   plane      all or nothing; if it cuts the light, the segment of the light's disk behind it, as seen along the plane
// Only objects nearer than the light's centre cover it. Where several objects overlap, the product of their free shares
// is used. All results are exact for a light without size. The preview's soft shadows handle lights of other shapes
// than a sphere, include the cosine and do not count overlaps twice.
#pragma once

#include <gonio/scene/stage.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <span>

namespace gonio {

inline constexpr std::size_t no_surface = static_cast<std::size_t>(-1);

// The share, in [0, 1], of a spherical light (radius 0: a point) that the stage leaves free as seen from `point` on
// surface `own`, which casts no shadow on itself. 1 inside the light. `emitter` is the surface that emits the light, if
// one does, and does not block it.
double visible_share(const Stage& stage, std::size_t own, const glm::dvec3& point, const glm::dvec3& light_center,
                     double light_radius, std::size_t emitter = no_surface);

// The same for a light at infinity, in the unit direction `towards` it, with the half angle [rad] in [0, π/2).
double visible_share_of_sun(const Stage& stage, std::size_t own, const glm::dvec3& point, const glm::dvec3& towards,
                            double half_angle);

// Whether the primitive is hit within `distance` [m] (or infinity) of the ray's origin, which may lie on a one-sided
// surface; such surfaces are hit from both sides.
bool stops(const Primitive& body, const Ray& ray, double distance);

// Whether any object is within `distance` [m] (or infinity) of the point in a unit direction, tested with a ray; other
// than `own` and `emitter`, as above.
bool is_hidden(const Stage& stage, std::size_t own, const glm::dvec3& point, const glm::dvec3& direction,
               double distance, std::size_t emitter = no_surface);

// Whether an object may block light on its way from one sphere to points in another; if false, every visible_share is
// 1. May return true when in doubt.
bool may_stand_between(const Primitive& body, const Ball& points, const Ball& light);

// Whether all of an object is on the other side of a flat light than all points of a sphere: it hides nothing of the
// light from them. False for lights that are not flat.
bool is_behind(const Primitive& body, const Light& light, const Ball& points);

// Solid angle common to two caps of half angles a and b ∈ [0, π/2] with axes d ∈ [0, π] apart [sr]. Closed form: the
// great arc between the crossings of the outlines divides the overlap into two circular segments on the sphere (the
// area of Mazonka 2012), each computed without cancellation: small caps beside large ones and narrow lenses keep their
// digits.
double cap_overlap(double a, double b, double d);

// ∫ n·ω dω over the overlap of two caps with half angles a and b ∈ [0, π/2] about unit axes [sr]: the illuminance of
// the overlap at a luminance of 1 if all of it is above the horizon of n. Closed form of the two segments as in
// cap_overlap (the outline integral of area lights over each), without cancellation in small caps and narrow lenses.
double projected_cap_overlap(const glm::dvec3& axis_a, double a, const glm::dvec3& axis_b, double b,
                             const glm::dvec3& normal);

// Solid angle common to the cap of half angle a ∈ [0, π/2) and a simple polygon of great arcs in the hemisphere around
// its axis [sr]. The corners are projected from the sphere's centre on the plane tangent to it at the axis: a direction
// (x, y, z), z > 0 along the axis, is (x/z, y/z). Closed form: each edge gives a triangle with the axis for its part
// inside the cap (excess after van Oosterom and Strackee 1983) and a sector of the cap for its part outside. No
// cancellation in small caps.
double polygon_overlap(double a, std::span<const glm::dvec2> corners);

} // namespace gonio
