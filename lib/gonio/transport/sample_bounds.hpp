// Bounds of points on one surface: their positions and their normals.
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <span>

namespace gonio::detail {

struct SampleBounds {
    glm::dvec3 low{0.0}; // corners of the box
    glm::dvec3 high{0.0};
    glm::dvec3 center{0.0}; // of the box, and of the bounding sphere of the points
    double radius = 0.0;
    glm::dvec3 normal{0.0, 0.0, 1.0}; // axis of the cone that contains every normal
    double spread_sin = 0.0;          // of its half angle; 1 if the normals fill a hemisphere or more
    double spread_cos = 1.0;
    double least_height = 0.0; // of n·p over the points, if all normals are equal
    bool flat = true;          // whether all normals are equal
};

// Collects the bounds of points one by one.
class BoundsBuilder {
public:
    // `normal` must have unit length.
    void add(const glm::dvec3& point, const glm::dvec3& normal);
    void add(const BoundsBuilder& others);
    // Points with their coordinates relative to `anchor`, and their normals, by axis; at least one.
    void add(const glm::dvec3& anchor, const std::array<std::span<const float>, 3>& points,
             const std::array<std::span<const float>, 3>& normals);
    // Needs at least one point.
    SampleBounds bounds() const;

private:
    bool empty_ = true;
    bool flat_ = true;
    glm::dvec3 low_{0.0}, high_{0.0};
    glm::dvec3 first_normal_{0.0}, normal_low_{0.0}, normal_high_{0.0};
    double least_height_ = 0.0;
};

} // namespace gonio::detail
