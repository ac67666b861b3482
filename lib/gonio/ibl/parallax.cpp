#include <gonio/ibl/parallax.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gonio {

namespace {

glm::dvec3 or_else(const glm::dvec3& found, const glm::dvec3& direction) {
    return glm::dot(found, found) > 0.0 && std::isfinite(found.x + found.y + found.z) ? found : direction;
}

} // namespace

glm::dvec3 parallax_corrected(const ParallaxBox& box, const glm::dvec3& captured_at, const glm::dvec3& position,
                              const glm::dvec3& direction) {
    const glm::dvec3 from = glm::clamp(position, box.low, box.high);
    double distance = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0.0) continue;
        const double wall = direction[axis] > 0.0 ? box.high[axis] : box.low[axis];
        distance = std::min(distance, (wall - from[axis]) / direction[axis]);
    }
    return or_else(from + distance * direction - captured_at, direction);
}

glm::dvec3 parallax_corrected(const ParallaxSphere& sphere, const glm::dvec3& captured_at, const glm::dvec3& position,
                              const glm::dvec3& direction) {
    glm::dvec3 from = position - sphere.center;
    const double away = glm::length(from);
    if (away > sphere.radius) from *= sphere.radius / away;
    const double along = glm::dot(direction, from);
    const double square = along * along - glm::dot(from, from) + sphere.radius * sphere.radius;
    const double distance = std::sqrt(std::max(square, 0.0)) - along;
    return or_else(sphere.center + from + distance * direction - captured_at, direction);
}

} // namespace gonio
