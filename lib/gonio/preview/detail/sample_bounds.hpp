// Bounds of points on one surface: where they lie, and where their normals point.
#pragma once

#include <glm/vec3.hpp>

#include <span>

namespace gonio::detail {

struct SampleBounds {
    glm::dvec3 low{0.0}; // corners of the box
    glm::dvec3 high{0.0};
    glm::dvec3 center{0.0}; // of the box, and of the sphere that holds the points
    double radius = 0.0;
    glm::dvec3 normal{0.0, 0.0, 1.0}; // axis of the cone that holds every normal
    double spread_sin = 0.0;          // of its half angle; 1 where the normals fill a hemisphere or more
    double spread_cos = 1.0;
    double least_height = 0.0; // of n·p over the points, where all normals are one
    bool flat = true;          // they are
};

// `points` and `normals` (unit) have the same length, at least 1.
SampleBounds bounds_of(std::span<const glm::dvec3> points, std::span<const glm::dvec3> normals);

} // namespace gonio::detail
