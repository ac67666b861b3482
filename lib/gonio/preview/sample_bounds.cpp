#include <gonio/preview/detail/sample_bounds.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gonio::detail {

SampleBounds bounds_of(std::span<const glm::dvec3> points, std::span<const glm::dvec3> normals) {
    SampleBounds bounds;
    bounds.low = points.front();
    bounds.high = points.front();
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        bounds.low = glm::min(bounds.low, points[i]);
        bounds.high = glm::max(bounds.high, points[i]);
        sum += normals[i];
        bounds.flat = bounds.flat && normals[i] == normals.front();
    }
    bounds.center = 0.5 * (bounds.low + bounds.high);
    bounds.normal = normals.front();
    const double length = glm::length(sum);
    if (!bounds.flat && length > 0.0) bounds.normal = sum / length;
    double radius2 = 0.0;
    bounds.least_height = glm::dot(normals.front(), points.front());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 away = points[i] - bounds.center;
        radius2 = std::max(radius2, glm::dot(away, away));
        bounds.least_height = std::min(bounds.least_height, glm::dot(normals.front(), points[i]));
        if (!bounds.flat) bounds.spread_cos = std::min(bounds.spread_cos, glm::dot(bounds.normal, normals[i]));
    }
    bounds.radius = std::sqrt(radius2);
    bounds.spread_cos = std::clamp(bounds.spread_cos, 0.0, 1.0);
    bounds.spread_sin = std::sqrt((1.0 - bounds.spread_cos) * (1.0 + bounds.spread_cos));
    return bounds;
}

} // namespace gonio::detail
