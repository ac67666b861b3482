// How much of a light a surface point sees past what stands on a stage.
//
// A light is taken for a ball, and the sun for a cap of the sky: the share is that of the solid angle of the cap that
// the light fills. All directions weigh alike: the cosine at the receiver is not in it. What each primitive covers:
//   ball      its cap, closed form (cap_overlap)
//   panel     its spherical polygon, closed form (polygon_overlap)
//   box       the polygons of the faces that look at the receiver, which do not overlap: closed form
//   capsule   the polygon of its outline, the round ends in 12 chords each of the same area: within 0.5 % of its radius
//   plane     all, nothing, or of a light that it cuts the segment of the light's disk behind it, as seen along the
//   plane
// Only what is nearer than the light's centre covers. Where several bodies overlap each other the product of their
// shares is taken. Of a light without size all are exact. Lights of other shapes
// than a ball, with the cosine and without counting twice what bodies cover together: the preview's soft shadows.
#pragma once

#include <gonio/scene/stage.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <span>

namespace gonio {

// The share, in [0, 1], of a spherical light (radius 0: a point) that the stage leaves free as seen from `point` on
// surface `own`, which casts no shadow on itself. 1 inside the light.
double visible_share(const Stage& stage, std::size_t own, const glm::dvec3& point, const glm::dvec3& light_center,
                     double light_radius);

// The same of a light at infinity, in the unit direction `towards` it, that is seen under the half angle [rad] in
// [0, π/2).
double visible_share_of_sun(const Stage& stage, std::size_t own, const glm::dvec3& point, const glm::dvec3& towards,
                            double half_angle);

// Whether the primitive stands within `distance` [m] (or infinity) of the ray's origin, which may lie on a sheet;
// sheets from both sides.
bool stops(const Primitive& body, const Ray& ray, double distance);

// Whether anything stands within `distance` [m] (or infinity) of the point in a unit direction: what a ray says.
bool is_hidden(const Stage& stage, std::size_t own, const glm::dvec3& point, const glm::dvec3& direction,
               double distance);

// Whether a body may keep light that comes from one ball from points in another; where it says no, every visible_share
// is 1. Errs to yes.
bool may_stand_between(const Primitive& body, const Ball& points, const Ball& light);

// Solid angle common to two caps of half angles a and b ∈ [0, π/2] whose axes are d ∈ [0, π] apart [sr].
// Closed form of the two circular segments on the sphere that the great arc between the outlines' crossings parts it
// into (the area of Mazonka 2012), each without cancellation: small caps beside large ones and narrow lenses keep their
// digits.
double cap_overlap(double a, double b, double d);

// ∫ n·ω dω over what two caps have in common, of half angles a and b ∈ [0, π/2] about unit axes [sr]: the illuminance
// that it gives at a luminance of 1 where all of it is above the horizon of n. Closed form of the two segments as in
// cap_overlap (the outline integral of area lights over each), without cancellation in small caps and narrow lenses.
double projected_cap_overlap(const glm::dvec3& axis_a, double a, const glm::dvec3& axis_b, double b,
                             const glm::dvec3& normal);

// Solid angle common to the cap of half angle a ∈ [0, π/2) and a simple polygon of great arcs in the hemisphere around
// its axis [sr]. The corners are projected from the sphere's centre on the plane that touches it at the axis: a
// direction (x, y, z), z > 0 along the axis, is (x/z, y/z). Closed form: along each edge a triangle with the axis
// inside the cap (its excess after van Oosterom and Strackee 1983), a sector of it outside. No cancellation in small
// caps.
double polygon_overlap(double a, std::span<const glm::dvec2> corners);

} // namespace gonio
