// The points of a chart at which the light from all around is gathered, and interpolation between them.
//
// Lines lie closer at the edges of a surface, where others stand on it. The rectangles between them are divided further
// near solids and lights, one by one. Between its corners a rectangle is exact for quadratic functions: each node has
// the slopes of what it gathers, from the nodes beside it, and half of what they add to its value counts. A node on
// the side of a larger rectangle takes the value between that one's corners, so that there are no seams. Nodes that
// something covers are left out of every mean, so that no darkness leaks from under a box.
#pragma once

#include <gonio/scene/stage.hpp>
#include <gonio/transport/axis.hpp>
#include <gonio/transport/chart.hpp>
#include <gonio/transport/spacing.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gonio::detail {

struct Node {
    static constexpr std::uint32_t none = 0xffffffffU;

    glm::dvec3 position{0.0}; // just above the surface
    glm::dvec3 normal{0.0};
    std::size_t surface = 0;
    bool covered = false;
    bool is_pole = false; // of a sphere: its slopes lie along the azimuths 0 and π/2, instead of u and v
    // On the side of a larger rectangle: the nodes at its ends, the weight of the second, and the side.
    std::array<std::uint32_t, 2> ends{none, none};
    double share = 0.0;
    int axis = 0; // 0 along u, 1 along v
    double length = 0.0;

    bool is_between() const { return ends[0] != none; }
    bool gathers() const { return !covered && !is_between(); }
};

// What a node has of a quantity, and its slopes along u and v.
struct NodeValue {
    glm::dvec3 value{0.0};
    std::array<glm::dvec3, 2> slope{glm::dvec3(0.0), glm::dvec3(0.0)};
};

// The slopes of the node `of` grow by weight · (value of `from` − value of `of`).
struct SlopeTerm {
    std::uint32_t of = 0;
    std::uint32_t from = 0;
    glm::dvec2 weight{0.0};
};

// The nodes around a point, with weights ≥ 0 that add up to 1; fewer than four where some are covered.
struct NodeMean {
    std::array<std::uint32_t, 4> node{};
    std::array<double, 4> weight{};
    std::array<glm::dvec2, 4> of_slopes{};
    std::size_t count = 0; // 0 where every node nearby is covered

    glm::dvec3 operator()(std::span<const NodeValue> of_nodes) const;
};

class NodeTree {
public:
    NodeTree() = default;
    // Makes its nodes. `square_m`: the size of a patch; `coarseness` multiplies the distances between nodes.
    NodeTree(const Stage& stage, std::span<const LightPlace> lights, const Chart& chart, double square_m,
             double coarseness, std::vector<Node>& nodes);

    // Appends the nodes it made to those of others, and numbers them anew. `slopes` gets what their slopes are made of:
    // terms of nodes that gather, from nodes that gather.
    void append(std::span<const Node> made, std::vector<Node>& nodes, std::vector<SlopeTerm>& slopes);

    // A rectangle that is not divided: which it is of those between lines, and what of it.
    struct Leaf {
        static constexpr std::uint32_t none = 0xffffffffU;
        std::uint32_t part = none;
        std::uint32_t column = 0, row = 0;
        glm::dvec2 per{1.0};   // u and v of this one, over those between the lines
        glm::dvec2 first{0.0}; // and what is subtracted from that
        glm::dvec2 size{0.0};
    };
    NodeMean around(const Chart& chart, const glm::dvec3& position) const {
        Leaf last;
        return around(chart, position, last);
    }
    // `last` is where the point before lay, and then where this one lies.
    NodeMean around(const Chart& chart, const glm::dvec3& position, Leaf& last) const;

private:
    friend class NodeTreeMaker;

    // A rectangle, which is divided in 2 along u, along v, or in 4.
    struct Part {
        std::uint32_t first_part = 0; // 0: it is not divided
        bool along_u = false;
        bool along_v = false;
        std::array<bool, 4> is_covered{}; // its corners
        std::array<bool, 4> is_pole{};
        std::array<std::uint32_t, 4> corner{}; // low v first
    };
    struct Spot {
        std::uint32_t part;
        double u, v; // of its sides, in [0, 1]
        glm::dvec2 size;
    };
    Spot spot(const glm::dvec2& at, Leaf& last) const;

    Axis columns_, rows_; // of the parts that are not part of another
    std::vector<Part> parts_;
    std::vector<SlopeTerm> slopes_; // until append()
    double gap_m_ = 0.0;            // narrower rectangles lie between the two lines of a cut
};

} // namespace gonio::detail
