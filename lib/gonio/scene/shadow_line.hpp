// What a body hides of a line on a light: of all rays from a receiver to the points of a line, those that meet a convex
// body form one piece. Its ends are where the line begins or ends, where it runs into the body, or where a ray only
// touches it: closed forms, without sampling.
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

// `from` and `to` are relative to the receiver. Sheets that the receiver lies in and solids that it lies in hide
// nothing.
HiddenPiece hidden_piece(const Primitive& body, const glm::dvec3& receiver, const glm::dvec3& from,
                         const glm::dvec3& to);

// The edge of a body's shadow that a receiver sees nearest to a direction: lines on the light that run across it are
// cut evenly.
struct ShadowEdge {
    double distance = 1e300; // not above the angle between them [rad]; of round bodies negative towards their inside
    glm::dvec3 across{0.0};  // across the edge, of any length
};

// `towards` is unit. An edge at no distance of bodies that the receiver touches, or that reach up to it.
ShadowEdge nearest_edge(const Primitive& body, const glm::dvec3& receiver, const glm::dvec3& towards);

} // namespace gonio::detail
