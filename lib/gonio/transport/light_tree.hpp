// A tree over spheres about lights: finds those that meet a box or a cone of rays in far fewer steps than a full
// search.
#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
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

    // Calls visit(light) for the lights whose centres lie within `reach` of a place and not behind its plane by more
    // than a margin, and for some others, those of the nearer half of the tree first. It returns how far away a light
    // may still matter, which is no farther than before; less than 0 ends the search. Spheres of infinite radius are
    // left out.
    struct Before {
        glm::dvec3 place{0.0};
        glm::dvec3 normal{0.0, 0.0, 1.0}; // unit
        double margin = 0.0;
    };
    template<class Visit>
    void visit_near(const Before& before, double reach, const Visit& visit) const {
        visit_near(before, reach, visit, [](double /*squared distance*/, double /*height*/) { return true; });
    }
    // The same, but only lights of which may_matter(squared distance, height) says so, asked with the least distance
    // and the greatest height over the plane that a light of a node can have [m].
    template<class Visit, class MayMatter>
    void visit_near(const Before& before, double reach, const Visit& visit, const MayMatter& may_matter) const {
        if (!nodes_.empty()) visit_near(0, before, reach, visit, may_matter);
    }

private:
    // The left child is at the next index; a leaf has no children and holds spheres [first, first + count).
    struct Node {
        glm::dvec3 low, high;
        std::uint32_t first = 0, count = 0;
        std::uint32_t right = 0;
    };

    static double squared_distance(const Node& node, const glm::dvec3& place) {
        const glm::dvec3 away = place - glm::clamp(place, node.low, node.high);
        return glm::dot(away, away);
    }

    // The greatest height of the node over the plane, and a little more for rounding.
    static double height(const Node& node, const Before& before, double reach) {
        const glm::dvec3 middle = 0.5 * (node.low + node.high) - before.place;
        const double half = 0.5 * glm::dot(node.high - node.low, glm::abs(before.normal));
        constexpr double rounding = 1e-9;
        return glm::dot(middle, before.normal) + half + rounding * (reach + half);
    }

    template<class Visit, class MayMatter>
    // NOLINTNEXTLINE(misc-no-recursion): as deep as the tree
    void visit_near(std::uint32_t index, const Before& before, double& reach, const Visit& visit,
                    const MayMatter& may_matter) const {
        const Node& node = nodes_[index];
        const double squared_m = squared_distance(node, before.place);
        if (reach < 0.0 || squared_m > reach * reach) return;
        const double height_m = height(node, before, reach);
        if (height_m < -before.margin || !may_matter(squared_m, height_m)) return;
        for (std::uint32_t i = node.first; i < node.first + node.count && reach >= 0.0; ++i)
            reach = visit(spheres_[i].light);
        if (node.count > 0) return;
        const bool is_right_nearer =
            squared_distance(nodes_[node.right], before.place) < squared_distance(nodes_[index + 1], before.place);
        visit_near(is_right_nearer ? node.right : index + 1, before, reach, visit, may_matter);
        visit_near(is_right_nearer ? index + 1 : node.right, before, reach, visit, may_matter);
    }

    std::uint32_t build(std::size_t first, std::size_t count);
    template<class MeetsNode, class MeetsSphere>
    void collect(const MeetsNode& meets_node, const MeetsSphere& meets_sphere,
                 std::vector<std::uint32_t>& lights) const;

    std::vector<LightSphere> spheres_; // those of finite radius, in the order of the leaves
    std::vector<std::uint32_t> everywhere_;
    std::vector<Node> nodes_;
};

} // namespace gonio::detail
