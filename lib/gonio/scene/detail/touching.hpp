// The distance within which a point counts as touching a one-sided surface.
#pragma once

#include <gonio/scene/shadow_numbers.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace gonio::detail {

// How far in front of a one-sided surface a point counts as touching it: a receiver on the adjoining surface of a room
// is not behind this one.
inline double touching(const glm::dvec3& point) {
    return touching_share * (1.0 + glm::length(point));
}

} // namespace gonio::detail
