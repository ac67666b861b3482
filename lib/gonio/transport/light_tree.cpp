#include <gonio/transport/light_tree.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace gonio::detail {

namespace {

constexpr std::size_t spheres_in_leaf = 4;
// Each level halves the number of lights, so a deeper tree would need more lights than an index can count.
constexpr std::size_t deepest = 64;

} // namespace

bool RayCone::meets(const glm::dvec3& center, double radius) const {
    const glm::dvec3 way = center - apex;
    const double along = glm::dot(way, axis);
    const double across = std::sqrt(std::max(glm::dot(way, way) - along * along, 0.0));
    // Distance from the cone's side, negative inside; behind the apex it is an underestimate.
    return across * cosine - along * sine <= radius && along >= -radius;
}

LightTree::LightTree(std::span<const LightSphere> spheres) {
    for (const LightSphere& sphere : spheres)
        if (std::isinf(sphere.radius))
            everywhere_.push_back(sphere.light);
        else
            spheres_.push_back(sphere);
    nodes_.reserve(2 * spheres_.size() / spheres_in_leaf + 1);
    if (!spheres_.empty()) build(0, spheres_.size());
}

std::uint32_t LightTree::build(std::size_t first, std::size_t count) {
    const auto begin = spheres_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(count);
    Node node;
    node.low = begin->center - begin->radius;
    node.high = begin->center + begin->radius;
    glm::dvec3 least = begin->center;
    glm::dvec3 most = begin->center;
    for (auto sphere = begin; sphere != end; ++sphere) {
        node.low = glm::min(node.low, sphere->center - sphere->radius);
        node.high = glm::max(node.high, sphere->center + sphere->radius);
        least = glm::min(least, sphere->center);
        most = glm::max(most, sphere->center);
    }
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(node);
    if (count <= spheres_in_leaf) {
        nodes_[index].first = static_cast<std::uint32_t>(first);
        nodes_[index].count = static_cast<std::uint32_t>(count);
        return index;
    }
    const glm::dvec3 wide = most - least;
    const int axis = wide.x >= wide.y && wide.x >= wide.z ? 0 : wide.y >= wide.z ? 1 : 2;
    const std::size_t half = count / 2;
    std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(half), end,
                     [axis](const LightSphere& a, const LightSphere& b) {
                         return a.center[axis] != b.center[axis] ? a.center[axis] < b.center[axis] : a.light < b.light;
                     });
    build(first, half);
    const std::uint32_t right = build(first + half, count - half);
    nodes_[index].right = right;
    return index;
}

template<class MeetsNode, class MeetsSphere>
void LightTree::collect(const MeetsNode& meets_node, const MeetsSphere& meets_sphere,
                        std::vector<std::uint32_t>& lights) const {
    lights.insert(lights.end(), everywhere_.begin(), everywhere_.end());
    if (nodes_.empty()) return;
    std::array<std::uint32_t, deepest> waiting{};
    std::size_t depth = 0;
    waiting[depth++] = 0;
    while (depth > 0) {
        const std::uint32_t index = waiting[--depth];
        const Node& node = nodes_[index];
        if (!meets_node(node)) continue;
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
            if (meets_sphere(spheres_[i])) lights.push_back(spheres_[i].light);
        if (node.count > 0) continue;
        waiting[depth++] = node.right;
        waiting[depth++] = index + 1;
    }
}

void LightTree::meeting_box(const glm::dvec3& low, const glm::dvec3& high, std::vector<std::uint32_t>& lights) const {
    collect(
        [&](const Node& node) {
            return node.low.x <= high.x && node.low.y <= high.y && node.low.z <= high.z && node.high.x >= low.x &&
                   node.high.y >= low.y && node.high.z >= low.z;
        },
        [&](const LightSphere& sphere) {
            const glm::dvec3 away = sphere.center - glm::clamp(sphere.center, low, high);
            return glm::dot(away, away) <= sphere.radius * sphere.radius;
        },
        lights);
}

void LightTree::meeting_cone(const RayCone& cone, std::vector<std::uint32_t>& lights) const {
    collect(
        [&](const Node& node) {
            const glm::dvec3 half = 0.5 * (node.high - node.low);
            return cone.meets(node.low + half, glm::length(half));
        },
        [&](const LightSphere& sphere) { return cone.meets(sphere.center, sphere.radius); }, lights);
}

} // namespace gonio::detail
