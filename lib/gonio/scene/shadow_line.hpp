// The part of a line on a light that an object hides: of all rays from a receiver to the points of a line, those that
// hit a convex object form one piece. Its ends are where the line begins or ends, where it enters or leaves the object,
// or where a ray is tangent to it: closed forms, without sampling.
#pragma once

#include <gonio/scene/primitives.hpp>

#include <glm/vec3.hpp>

#include <algorithm>

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

// `from` and `to` are relative to the receiver. One-sided surfaces and solids that the receiver lies in hide nothing.
HiddenPiece hidden_piece(const Primitive& body, const glm::dvec3& receiver, const glm::dvec3& from,
                         const glm::dvec3& to);

// The edge of an object's shadow that is nearest to a direction, as seen from a receiver: lines on the light that run
// across it are cut uniformly.
struct ShadowEdge {
    double distance = 1e300; // at most the angle between them [rad]; negative inside round objects
    glm::dvec3 across{0.0};  // across the edge, of any length
};

// `towards` is unit. The distance is 0 for objects that the receiver touches, or that extend to it.
ShadowEdge nearest_edge(const Primitive& body, const glm::dvec3& receiver, const glm::dvec3& towards);

} // namespace gonio::detail
