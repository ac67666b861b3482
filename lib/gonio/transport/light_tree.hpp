// A tree over spheres about lights: finds those that meet a box or a cone of rays in far fewer steps than a full
// search.
#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gonio::detail {

struct LightSphere {
    glm::dvec3 center{0.0};
    double radius = 0.0;
    std::uint32_t light = 0;
};

// The rays from a point within an angle of an axis.
struct RayCone {
    glm::dvec3 apex{0.0};
    glm::dvec3 axis{0.0, 0.0, 1.0}; // unit
    double sine = 0.0;              // of the half angle, below a right angle
    double cosine = 1.0;

    bool meets(const glm::dvec3& center, double radius) const;
};

class LightTree {
public:
    // Any radius ≥ 0; infinite ones meet everything.
    explicit LightTree(std::span<const LightSphere> spheres);

    // Appends the lights whose spheres meet the box [low, high], in no particular order.
    void meeting_box(const glm::dvec3& low, const glm::dvec3& high, std::vector<std::uint32_t>& lights) const;

    // Appends the lights whose spheres the cone may meet, in no particular order.
    void meeting_cone(const RayCone& cone, std::vector<std::uint32_t>& lights) const;

private:
    // The left child is at the next index; a leaf has no children and holds spheres [first, first + count).
    struct Node {
        glm::dvec3 low, high;
        std::uint32_t first = 0, count = 0;
        std::uint32_t right = 0;
    };

    std::uint32_t build(std::size_t first, std::size_t count);
    template<class MeetsNode, class MeetsSphere>
    void collect(const MeetsNode& meets_node, const MeetsSphere& meets_sphere,
                 std::vector<std::uint32_t>& lights) const;

    std::vector<LightSphere> spheres_; // those of finite radius, in the order of the leaves
    std::vector<std::uint32_t> everywhere_;
    std::vector<Node> nodes_;
};

} // namespace gonio::detail
