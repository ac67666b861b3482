// The part of a line on a light that an object hides: of all rays from a receiver to the points of a line, those that
// hit a convex object form one piece. Its ends are where the line begins or ends, where it enters or leaves the object,
// or where a ray is tangent to it: closed forms, without sampling.
#pragma once

#include <gonio/scene/primitives.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <span>

namespace gonio::detail {

// From `low` to `high` along the line, both in [0, 1]; nothing where low ≥ high.
struct HiddenPiece {
    double low = 1.0;
    double high = 0.0;

    void add(double t) {
        low = std::min(low, t);
        high = std::max(high, t);
    }
    bool empty() const { return !(low < high); }
};

// A line of the light, with the receiver at the origin.
struct LightLineSeen {
    glm::dvec3 from{0.0};
    glm::dvec3 along{0.0};  // to its other end
    glm::dvec3 normal{0.0}; // of the plane of the rays, from × along
    double normal_length = 0.0;

    LightLineSeen() = default;
    LightLineSeen(const glm::dvec3& begin, const glm::dvec3& end);
    LightLineSeen(const glm::dvec3& begin, const glm::dvec3& way, const glm::dvec3& of_plane, double its_length)
        : from(begin), along(way), normal(of_plane), normal_length(its_length) {}

    glm::dvec3 at(double t) const { return from + t * along; }
};

// One piece for each line, all as the receiver sees them. One-sided surfaces that it touches and solids that it lies in
// hide nothing.
void hidden_pieces(const Primitive& body, const glm::dvec3& receiver, std::span<const LightLineSeen> lines,
                   std::span<HiddenPiece> pieces);

// Whether the body and the ball have no point in common.
bool is_apart(const Primitive& body, const Ball& ball);

// The edge of an object's shadow that is nearest to a direction, as seen from a receiver: lines on the light that run
// across it are cut uniformly.
struct ShadowEdge {
    double distance = 1e300; // at most the angle between them [rad]; negative inside round objects
    glm::dvec3 across{0.0};  // across the edge, of any length
};

// `towards` is unit. The distance is 0 for objects that the receiver touches, or that extend to it.
ShadowEdge nearest_edge(const Primitive& body, const glm::dvec3& receiver, const glm::dvec3& towards);

} // namespace gonio::detail
