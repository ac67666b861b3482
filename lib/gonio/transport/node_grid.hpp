// The points of a chart at which the light from all around is gathered, and interpolation between them.
//
// Rows and columns of nodes lie closer where indirect light changes faster: at the edges of a surface, where others
// stand on it, and near solids. Nodes that something covers are left out of every mean, so that no darkness leaks from
// under a box.
#pragma once

#include <gonio/scene/stage.hpp>
#include <gonio/transport/chart.hpp>
#include <gonio/transport/patches.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gonio::detail {

struct Node {
    glm::dvec3 position{0.0}; // just above the surface
    glm::dvec3 normal{0.0};
    std::size_t surface = 0;
    bool covered = false;
    std::uint32_t same_as = 0; // the number of a node at the same point, or its own
};

// The nodes around a point, with weights ≥ 0 that add up to 1; fewer than four where some are covered.
struct NodeMean {
    std::array<std::uint32_t, 4> node{};
    std::array<double, 4> weight{};
    std::size_t count = 0; // 0 where every node nearby is covered
};

class NodeGrid {
public:
    // Appends its nodes to `nodes`. `coarseness` multiplies the distances between them.
    NodeGrid(const Stage& stage, const Charts& charts, std::size_t chart, double square_m, double coarseness,
             std::vector<Node>& nodes);

    NodeMean around(const Chart& chart, const glm::dvec3& position, const std::vector<Node>& nodes) const;

private:
    std::uint32_t first_ = 0;
    bool is_round_ = false; // the columns go round
    std::vector<double> columns_;
    std::vector<double> rows_;
};

} // namespace gonio::detail
