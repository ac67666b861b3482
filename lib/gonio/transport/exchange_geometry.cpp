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
                                   unsigned threads)
    : stage_(stage),
      light_positions_(positions_of(lights)),
      quality_(quality),
      caster_(stage_),
      patches_(stage_, interest_of(stage_, light_positions_), quality.patches),
      cell_rays_(quality.cell_rays),
      node_rays_(quality.node_rays) {
    // Stages with many things in them get fewer nodes for each.
    for (double spacing = quality.node_spacing;; spacing *= 1.2) {
        nodes_.clear();
        grids_.clear();
        for (std::size_t chart = 0; chart < patches_.charts().all().size(); ++chart)
            grids_.emplace_back(stage_, patches_.charts(), chart, patches_.square_m(), spacing, nodes_);
        if (static_cast<double>(nodes_.size()) <= quality.patches || spacing > 10.0 * quality.node_spacing) break;
    }
    const std::vector<Cell>& cells = patches_.cells();
    cell_ends_.assign(cells.size() * cell_rays_, no_patch);
    node_ends_.assign(nodes_.size() * node_rays_, no_patch);
    escaping_.assign(cells.size(), 1.0);
    const std::vector<glm::dvec3> to_cells = cosine_directions(cell_rays_);
    const std::vector<glm::dvec3> to_nodes = cosine_directions(node_rays_);
    constexpr std::size_t together = 64;
    parallel_for((cells.size() + together - 1) / together, threads, [&](std::size_t block) {
        for (std::size_t i = block * together; i < std::min((block + 1) * together, cells.size()); ++i) {
            if (cells[i].covered) continue;
            const std::span ends = std::span(cell_ends_).subspan(i * cell_rays_, cell_rays_);
            cast_bundle(caster_, patches_, frame_about(cells[i].position, cells[i].normal),
                        own(patches_.charts().all()[cells[i].chart].surface), to_cells, ends);
            const auto lost = std::count(ends.begin(), ends.end(), no_patch);
            escaping_[i] = static_cast<double>(lost) / static_cast<double>(cell_rays_);
        }
    });
    parallel_for((nodes_.size() + together - 1) / together, threads, [&](std::size_t block) {
        for (std::size_t i = block * together; i < std::min((block + 1) * together, nodes_.size()); ++i) {
            if (nodes_[i].covered || nodes_[i].same_as != i) continue;
            cast_bundle(caster_, patches_, frame_about(nodes_[i].position, nodes_[i].normal), own(nodes_[i].surface),
                        to_nodes, std::span(node_ends_).subspan(i * node_rays_, node_rays_));
        }
    });
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
    const auto add = [&](std::span<const std::uint32_t> ends, double area_m2, std::vector<double>& arrived) {
        for (const std::uint32_t patch : ends)
            if (patch != no_patch) arrived[patches_.chart_of(patch)] += area_m2 / static_cast<double>(ends.size());
    };
    for (std::uint32_t i = 0; i < patches_.cells().size(); ++i)
        add(cell_ends(i), patches_.cell_area_m2(i), by_cells);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        if (node_area[i] > 0.0) add(node_ends(i), node_area[i], by_nodes);
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
    return (cell_ends_.size() + node_ends_.size()) * sizeof(std::uint32_t) + nodes_.size() * sizeof(Node) +
           patches_.cells().size() * (sizeof(Cell) + 2 * sizeof(double)) +
           patches_.count() * (2 * sizeof(std::uint32_t) + 5 * sizeof(double));
}

} // namespace gonio::detail
