#include <gonio/transport/linked_cells.hpp>
#include <gonio/transport/patches.hpp>

#include <algorithm>
#include <cmath>

namespace gonio::detail {

LinkedCells::LinkedCells(const Patches& patches)
    : is_of_small_(patches.charts().all().size(), 0), is_bright_(is_of_small_.size(), 0) {
    const auto append = [](std::array<std::vector<float>, 3>& to, const glm::dvec3& vector) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            to.at(axis).push_back(static_cast<float>(vector[static_cast<int>(axis)]));
    };
    for (const std::uint32_t number : patches.linked_cells()) {
        const Cell& cell = patches.cells()[number];
        const bool is_flat = patches.charts().all()[cell.chart].kind == Chart::Kind::flat;
        const std::size_t index = spread_.size();
        if (by_chart_.empty() || by_chart_.back().chart != cell.chart) by_chart_.push_back({cell.chart, index, index});
        by_chart_.back().last = index + 1;
        if (cell.is_of_small) is_of_small_[cell.chart] = 1;
        if (cell.is_bright) is_bright_[cell.chart] = 1;
        if (index == 0) anchor_ = cell.position;
        append(position_, cell.position - anchor_);
        append(normal_, cell.normal);
        spread_.push_back(static_cast<float>(cell.spread));
        reach_.push_back(static_cast<float>(is_flat ? cell.half_diagonal_m : 0.0));
        first_patch_.push_back(patches_.size());
        for (const std::uint32_t patch : patches.patches_of(number))
            patches_.push_back({patches.middle(patch), patches.normal(patch), patches.half_across(patch),
                                patches.half_length(patch), patches.area_m2(patch), patch});
    }
    first_patch_.push_back(patches_.size());
}

void LinkedCells::find_facing(const glm::dvec3& place, const glm::dvec3& normal, std::size_t first, std::size_t last,
                              std::span<float> faces) const {
    const glm::vec3 from(place - anchor_);
    const glm::vec3 up(normal);
    const float* const x = position_[0].data();
    const float* const y = position_[1].data();
    const float* const z = position_[2].data();
    const float* const normal_x = normal_[0].data();
    const float* const normal_y = normal_[1].data();
    const float* const normal_z = normal_[2].data();
    const float* const spread = spread_.data();
    const float* const reach = reach_.data();
    float* const to = faces.data();
    for (std::size_t i = first; i < last; ++i) {
        const float to_x = x[i] - from.x;
        const float to_y = y[i] - from.y;
        const float to_z = z[i] - from.z;
        const float here = up.x * to_x + up.y * to_y + up.z * to_z;
        const float there = -(normal_x[i] * to_x + normal_y[i] * to_y + normal_z[i] * to_z);
        const float turned = spread[i] * std::sqrt(to_x * to_x + to_y * to_y + to_z * to_z);
        to[i] = std::min(here + reach[i], there + turned);
    }
}

} // namespace gonio::detail
