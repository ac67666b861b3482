// The distance within which a point counts as touching a one-sided surface.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace gonio::detail {

// How far in front of a one-sided surface a point counts as touching it: a receiver on the adjoining surface of a room
// is not behind this one.
inline double touching(const glm::dvec3& point) {
    return 1e-7 * (1.0 + glm::length(point));
}

} // namespace gonio::detail
