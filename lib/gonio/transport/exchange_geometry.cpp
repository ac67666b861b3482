#include <gonio/base/parallel.hpp>
#include <gonio/scene/primitives.hpp>
#include <gonio/transport/exchange_geometry.hpp>

#include <algorithm>

namespace gonio::detail {

namespace {

std::vector<glm::dvec3> positions_of(std::span<const Light> lights) {
    std::vector<glm::dvec3> positions;
    for (const Light& light : lights)
        if (!std::holds_alternative<SunShape>(light.shape)) positions.push_back(light.frame.origin);
    return positions;
}

bool same(const Frame& a, const Frame& b) {
    return a.origin == b.origin && a.x == b.x && a.y == b.y && a.z == b.z;
}

struct Same {
    bool operator()(const Plane& a, const Plane& b) const { return a.point == b.point && a.normal == b.normal; }
    bool operator()(const Panel& a, const Panel& b) const {
        return same(a.frame, b.frame) && a.width == b.width && a.height == b.height;
    }
    bool operator()(const Ball& a, const Ball& b) const { return a.center == b.center && a.radius == b.radius; }
    bool operator()(const Box& a, const Box& b) const { return same(a.frame, b.frame) && a.half_size == b.half_size; }
    bool operator()(const Capsule& a, const Capsule& b) const {
        return a.center == b.center && a.axis == b.axis && a.half_length == b.half_length && a.radius == b.radius;
    }
    template<class A, class B>
    bool operator()(const A& /*a*/, const B& /*of another kind*/) const {
        return false;
    }
};

} // namespace

ExchangeGeometry::ExchangeGeometry(const Stage& stage, std::span<const Light> lights, const ExchangeQuality& quality,
                                   unsigned threads, simd::InstructionSet set)
    : stage_(stage),
      light_positions_(positions_of(lights)),
      quality_(quality),
      patches_(stage_, interest_of(stage_, light_positions_), quality.patches) {
    // Stages with many things in them get fewer nodes for each.
    for (double spacing = quality.node_spacing;; spacing *= 1.2) {
        nodes_.clear();
        grids_.clear();
        for (std::size_t chart = 0; chart < patches_.charts().all().size(); ++chart)
            grids_.emplace_back(stage_, patches_.charts(), chart, patches_.square_m(), spacing, nodes_);
        std::size_t gathering = 0;
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            if (!nodes_[i].covered && nodes_[i].same_as == i) ++gathering;
        if (static_cast<double>(gathering) <= 0.75 * quality.patches || spacing > 10.0 * quality.node_spacing) break;
    }
    std::vector<Receivers::Place> places;
    for (const Cell& cell : patches_.cells())
        places.push_back({cell.position, cell.normal, own(patches_.charts().all()[cell.chart].surface), cell.covered});
    from_cells_ = Bundles(stage_, patches_, places, quality.cell_rays, threads, set);
    for (std::size_t i = 0; i < places.size(); ++i)
        escaping_.push_back(from_cells_.escaping(i));
    places.clear();
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        places.push_back({nodes_[i].position, nodes_[i].normal, own(nodes_[i].surface),
                          nodes_[i].covered || nodes_[i].same_as != i});
    from_nodes_ = Bundles(stage_, patches_, places, quality.node_rays, threads, set);
    balance();
}

void ExchangeGeometry::balance() {
    const std::size_t charts = patches_.charts().all().size();
    std::vector<double> sent(charts, 0.0);     // of 1 lm/m² from the chart, what does not escape
    std::vector<double> by_cells(charts, 0.0); // and what arrives at cells and at nodes
    std::vector<double> by_nodes(charts, 0.0);
    std::vector<double> area(charts, 0.0);
    std::vector<double> node_area(nodes_.size(), 0.0);
    for (std::uint32_t patch = 0; patch < patches_.count(); ++patch) {
        const double area_m2 = patches_.area_m2(patch);
        if (!(area_m2 > 0.0)) continue;
        const std::size_t chart = patches_.chart_of(patch);
        const std::uint32_t cell = patches_.cell_of(patch);
        area[chart] += area_m2;
        sent[chart] += area_m2 * (1.0 - escaping_[cell]);
        const NodeMean mean = around(chart, patches_.middle(patch));
        for (std::size_t i = 0; i < mean.count; ++i)
            node_area[nodes_[mean.node[i]].same_as] += mean.weight[i] * area_m2;
    }
    for (std::size_t chart = 0; chart < charts; ++chart) {
        for (std::uint32_t i = 0; i < patches_.cells().size(); ++i)
            by_cells[chart] += patches_.cell_area_m2(i) * from_cells_.of_chart(i, chart);
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            by_nodes[chart] += node_area[i] * from_nodes_.of_chart(i, chart);
    }
    cell_factor_.assign(charts, 1.0);
    node_factor_.assign(charts, 1.0);
    if (patches_.charts().endless()) return; // parts of planes are farther away than patches reach
    for (std::size_t chart = 0; chart < charts; ++chart) {
        if (!(sent[chart] > 0.5 * area[chart])) continue;
        cell_factor_[chart] = sent[chart] / by_cells[chart];
        node_factor_[chart] = sent[chart] / by_nodes[chart];
    }
}

bool ExchangeGeometry::fits(const Stage& stage, std::span<const Light> lights, const ExchangeQuality& quality) const {
    if (!(quality == quality_) || stage.surfaces.size() != stage_.surfaces.size()) return false;
    for (std::size_t i = 0; i < stage.surfaces.size(); ++i)
        if (!std::visit(Same(), stage.surfaces[i].geometry, stage_.surfaces[i].geometry)) return false;
    return !patches_.charts().uses_interest() ||
           (stage.light.position == stage_.light.position && stage.camera.position == stage_.camera.position &&
            stage.camera.target == stage_.camera.target && positions_of(lights) == light_positions_);
}

NodeMean ExchangeGeometry::around(std::size_t chart, const glm::dvec3& position) const {
    return grids_[chart].around(patches_.charts().all()[chart], position, nodes_);
}

std::size_t ExchangeGeometry::own(std::size_t surface) const {
    return is_sheet(stage_.surfaces[surface].geometry) ? RayEnd::nothing : surface;
}

std::size_t ExchangeGeometry::memory() const {
    return from_cells_.memory() + from_nodes_.memory() + nodes_.size() * sizeof(Node) +
           patches_.cells().size() * (sizeof(Cell) + 2 * sizeof(double)) +
           patches_.count() * (2 * sizeof(std::uint32_t) + 5 * sizeof(double));
}

} // namespace gonio::detail
