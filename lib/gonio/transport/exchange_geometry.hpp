// What interreflection needs of a stage that does not depend on its lights' amounts, colours or on its materials.
#pragma once

#include <gonio/transport/interreflection.hpp>
#include <gonio/transport/node_tree.hpp>
#include <gonio/transport/patches.hpp>
#include <gonio/transport/ray_bundle.hpp>
#include <gonio/transport/ray_caster.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace gonio::detail {

class ExchangeGeometry {
public:
    ExchangeGeometry(Stage stage, std::span<const Light> lights, const ExchangeQuality& quality, unsigned threads,
                     simd::InstructionSet set);

    const Stage& stage() const { return stage_; }
    const ExchangeQuality& quality() const { return quality_; }
    const Patches& patches() const { return patches_; }
    const std::vector<Node>& nodes() const { return nodes_; }
    // From what nodes gathered, by node, to all of them and their slopes.
    std::vector<NodeValue> field_of(std::span<const glm::dvec3> gathered) const;

    // How many rays each node of a chart has.
    std::size_t node_rays(std::size_t chart) const { return patches_.ray_factor(chart) * quality_.node_rays; }
    const Bundles& from_cells() const { return from_cells_; }
    const Bundles& from_nodes() const { return from_nodes_; }
    // The share of a cell's rays that meet no patch.
    double escaping(std::size_t cell) const { return escaping_[cell]; }

    // What the rays of all cells, or of all nodes, see of a chart is this much too little: with these factors on what
    // it sends, uniform light from a chart arrives in full. 1 for charts that most of the light leaves without return,
    // where the number of rays that return is too uncertain.
    double cell_factor(std::size_t chart) const { return cell_factor_[chart]; }
    double node_factor(std::size_t chart) const { return node_factor_[chart]; }

    // Whether these surfaces, positions of lights and sides that they emit to are those of this geometry.
    bool fits(const Stage& stage, std::span<const Light> lights, const ExchangeQuality& quality) const;

    NodeMean around(std::size_t chart, const glm::dvec3& position) const;
    // Around the middle of a patch; none for one without an area.
    const NodeMean& around(std::uint32_t patch) const { return around_[patch]; }
    const NodeTree& tree(std::size_t chart) const { return trees_[chart]; }
    // The surface if it is a solid: rays that start on it do not meet it again.
    std::size_t own(std::size_t surface) const;
    std::size_t memory() const;

private:
    void order_between();
    void balance();

    Stage stage_;
    std::vector<LightPlace> lights_; // that are not at infinity
    ExchangeQuality quality_;
    Patches patches_;
    std::vector<Node> nodes_;
    std::vector<NodeTree> trees_;        // by chart
    std::vector<SlopeTerm> slopes_;      // of the nodes
    std::vector<std::uint32_t> between_; // nodes between others, after those
    std::vector<NodeMean> around_;       // by patch
    Bundles from_cells_;
    Bundles from_nodes_;
    std::vector<double> escaping_;
    std::vector<double> cell_factor_; // by chart
    std::vector<double> node_factor_;
};

// The nodes around one point after another: those that lie close together are found faster.
class NodeReader {
public:
    explicit NodeReader(const ExchangeGeometry& geometry) : geometry_(geometry) {}

    NodeMean around(std::size_t surface, int face, const glm::dvec3& position) {
        const std::size_t chart = geometry_.patches().charts().index_of(surface, face);
        if (chart != chart_) last_ = {};
        chart_ = chart;
        return geometry_.tree(chart).around(geometry_.patches().charts().all()[chart], position, last_);
    }

private:
    const ExchangeGeometry& geometry_;
    std::size_t chart_ = 0;
    NodeTree::Leaf last_;
};

} // namespace gonio::detail
