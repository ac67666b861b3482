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

} // namespace

ExchangeGeometry::ExchangeGeometry(const Stage& stage, std::span<const Light> lights, const ExchangeQuality& quality,
                                   unsigned threads)
    : stage_(stage),
      caster_(stage_),
      patches_(stage_, interest_of(stage_, positions_of(lights)), quality.patches),
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
