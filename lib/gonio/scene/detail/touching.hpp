// How near a sheet counts as touching it.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace gonio::detail {

// How far before a sheet something counts as touching it: a receiver on the next one of a room is not behind this one.
inline double touching(const glm::dvec3& point) {
    return 1e-7 * (1.0 + glm::length(point));
}

} // namespace gonio::detail
