#include <gonio/scene/core_vector.hpp>
#include <gonio/transport/linked_cells.hpp>
#include <gonio/transport/patches.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace gonio::detail {

LinkedCells::LinkedCells(const Patches& patches)
    : is_of_small_(patches.charts().all().size(), 0), is_bright_(is_of_small_.size(), 0) {
    const std::vector<std::uint32_t>& cells = patches.linked_cells();
    for (std::size_t first = 0; first < cells.size();) {
        const std::uint32_t chart = patches.cells()[cells[first]].chart;
        std::size_t last = first;
        while (last < cells.size() && patches.cells()[cells[last]].chart == chart)
            ++last;
        add_chart(patches, std::span(cells).subspan(first, last - first));
        first = last;
    }
}

// A part as kernels read it.
struct LinkedCells::Numbers {
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0};
    double spread = 0.0;
    double reach_m = 0.0;
    double area_m2 = 0.0;
    double least_m = std::numeric_limits<double>::infinity();
};

void LinkedCells::add_chart(const Patches& patches, std::span<const std::uint32_t> cells) {
    const std::uint32_t chart = patches.cells()[cells.front()].chart;
    for (const std::uint32_t cell : cells) {
        if (patches.cells()[cell].is_of_small) is_of_small_[chart] = 1;
        if (patches.cells()[cell].is_bright) is_bright_[chart] = 1;
    }
    const Range made{parts_.size(), parts_.size() + cells.size()};
    by_chart_.push_back({chart, made, patches.cells()[cells.front()].position});
    for (const std::uint32_t cell : cells)
        add_cell(patches, cell);
    for (std::size_t cell = made.first; cell < made.last; ++cell)
        add_patches(patches, cell);
}

void LinkedCells::add_cell(const Patches& patches, std::uint32_t number) {
    const Cell& cell = patches.cells()[number];
    const bool is_flat = patches.charts().all()[cell.chart].kind == Chart::Kind::flat;
    Numbers numbers;
    numbers.position = cell.position;
    numbers.normal = cell.normal;
    numbers.spread = cell.spread;
    numbers.reach_m = is_flat ? cell.half_diagonal_m : 0.0;
    numbers.area_m2 = patches.cell_area_m2(number);
    if (!cell.covered && !cell.is_uneven() && cell.spread <= most_spread)
        numbers.least_m = (is_flat ? least_of_flat : least_of_round) * cell.half_diagonal_m;
    add(number, numbers);
}

// As parts, or where those of cells that are not alike or stretched out are asked for one by one.
void LinkedCells::add_patches(const Patches& patches, std::size_t cell) {
    const std::uint32_t number = parts_[cell].number;
    const Cell& of = patches.cells()[number];
    const std::span<const std::uint32_t> of_cell = patches.patches_of(number);
    const bool is_long = std::any_of(of_cell.begin(), of_cell.end(),
                                     [&](std::uint32_t patch) { return patches.half_length(patch) > 0.0; });
    if (of.covered || of.is_uneven() || of.spread > most_spread || is_long) {
        parts_[cell].patches = {single_patches_.size(), single_patches_.size() + of_cell.size()};
        add_single(patches, of, of_cell);
        return;
    }
    parts_[cell].has_parts = true;
    parts_[cell].patches = {parts_.size(), parts_.size() + of_cell.size()};
    for (const std::uint32_t patch : of_cell) {
        Numbers numbers;
        numbers.position = patches.middle(patch);
        numbers.normal = patches.normal(patch);
        numbers.spread = 0.5 * of.spread;
        numbers.area_m2 = patches.area_m2(patch);
        numbers.least_m = least_of_patch * patches.half_across(patch);
        add(patch, numbers);
    }
}

void LinkedCells::add_single(const Patches& patches, const Cell& of, std::span<const std::uint32_t> of_cell) {
    const bool is_flat = patches.charts().all()[of.chart].kind == Chart::Kind::flat;
    const auto by_links = [&](std::uint32_t patch) {
        return patches.area_m2(patch) * (1.0 - static_cast<double>(patches.by_rays(patch)));
    };
    double of_all = 0.0;
    for (const std::uint32_t patch : of_cell)
        of_all += by_links(patch);
    for (const std::uint32_t patch : of_cell) {
        LinkedPatch& single = single_patches_.emplace_back();
        single.middle = patches.middle(patch);
        single.normal = patches.normal(patch);
        single.half_across_m = patches.half_across(patch);
        single.half_length_m = patches.half_length(patch);
        single.area_m2 = patches.area_m2(patch);
        single.cosine = patches.cosine_over(patch);
        single.number = patch;
        if (is_flat) single.flat = patches.flat(patch);
        if (!of.is_bright) continue;
        const auto by_rays = static_cast<double>(patches.by_rays(patch));
        single.over_rays = (1.0 - by_rays) / by_rays;
        single.of_bright = by_links(patch) / of_all;
    }
}

void LinkedCells::add(std::uint32_t number, const Numbers& numbers) {
    const auto append = [](std::array<std::vector<float>, 3>& to, const glm::dvec3& vector) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            to.at(axis).push_back(static_cast<float>(vector[static_cast<int>(axis)]));
    };
    parts_.push_back({number, {}, false});
    append(position_, numbers.position - by_chart_.back().anchor);
    append(normal_, numbers.normal);
    spread_.push_back(static_cast<float>(numbers.spread));
    reach_.push_back(static_cast<float>(numbers.reach_m));
    area_m2_.push_back(static_cast<float>(numbers.area_m2));
    least2_.push_back(static_cast<float>(numbers.least_m * numbers.least_m));
}

void LinkedCells::find_links(const transport::RayKernels& kernels, const Frame& place, const OfChart& chart,
                             const Range& parts, CellLinks& to) const {
    transport::RayCells to_parts;
    transport::RayLinks links;
    to_parts.count = parts.last - parts.first;
    to.share.resize(to_parts.count);
    links.share = to.share.data();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        to.towards.at(axis).resize(to_parts.count);
        links.towards[axis] = to.towards.at(axis).data();
        to_parts.position[axis] = position_.at(axis).data() + parts.first;
        to_parts.normal[axis] = normal_.at(axis).data() + parts.first;
    }
    to_parts.spread = spread_.data() + parts.first;
    to_parts.reach = reach_.data() + parts.first;
    to_parts.area_m2 = area_m2_.data() + parts.first;
    to_parts.least2 = least2_.data() + parts.first;
    float from[3];
    put(from, place.origin - chart.anchor);
    transport::RayFrame frame;
    put(frame.x, place.x);
    put(frame.y, place.y);
    put(frame.z, place.z);
    kernels.cell_links(to_parts, from, frame, links);
}

} // namespace gonio::detail
