#include <gonio/transport/patches.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <variant>

namespace gonio::detail {

namespace {

constexpr std::uint32_t least_columns = 6; // of the outline of the smallest solid
constexpr std::uint32_t most_columns = 400;
constexpr std::uint32_t cell_side = 2; // patches

std::uint32_t columns_of(const Range& range, double unit_m, double square_m, std::uint32_t least) {
    const double length = (range.warped(range.high) - range.warped(range.low)) * unit_m;
    const double columns = std::ceil(length / square_m * (1.0 - 1e-9));
    return std::clamp(static_cast<std::uint32_t>(std::min(columns, 1e6)), least, most_columns);
}

} // namespace

Patches::Patches(const Stage& stage, const Interest& interest, double count)
    : charts_(stage, interest), square_m_(charts_.square_of(count)) {
    for (std::size_t c = 0; c < charts_.all().size(); ++c) {
        const Chart& chart = charts_.all()[c];
        PatchGrid grid;
        const bool is_round = chart.kind == Chart::Kind::round;
        grid.columns = columns_of(chart.u, is_round ? chart.radius : 1.0, square_m_, is_round ? least_columns : 2);
        grid.rows = columns_of(chart.v, 1.0, square_m_, is_round ? least_columns / 2 : 2);
        grid.first_patch = static_cast<std::uint32_t>(cell_of_.size());
        grid.first_cell = static_cast<std::uint32_t>(cells_.size());
        grid.cell_columns = (grid.columns + cell_side - 1) / cell_side;
        grid.low_u = chart.u.warped(chart.u.low);
        grid.low_v = chart.v.warped(chart.v.low);
        grid.per_u = grid.columns / (chart.u.warped(chart.u.high) - grid.low_u);
        grid.per_v = grid.rows / (chart.v.warped(chart.v.high) - grid.low_v);
        grids_.push_back(grid);
        add_patches(stage, chart, grid, static_cast<std::uint32_t>(c));
        add_cells(stage, chart, grid, static_cast<std::uint32_t>(c));
    }
    first_of_.assign(cells_.size() + 1, 0);
    for (const std::uint32_t cell : cell_of_)
        ++first_of_[cell + 1];
    for (std::size_t cell = 0; cell < cells_.size(); ++cell)
        first_of_[cell + 1] += first_of_[cell];
    patches_of_.resize(cell_of_.size());
    std::vector<std::uint32_t> next(first_of_.begin(), first_of_.end() - 1);
    for (std::uint32_t patch = 0; patch < cell_of_.size(); ++patch)
        patches_of_[next[cell_of_[patch]]++] = patch;
}

std::uint32_t Patches::at(std::size_t chart, const glm::dvec2& coordinates) const {
    const Chart& on = charts_.all()[chart];
    const PatchGrid& grid = grids_[chart];
    const double column = (on.u.warped(coordinates.x) - grid.low_u) * grid.per_u;
    const double row = (on.v.warped(coordinates.y) - grid.low_v) * grid.per_v;
    const auto index = [](double at, std::uint32_t count) {
        return static_cast<std::uint32_t>(std::clamp(at, 0.0, static_cast<double>(count - 1)));
    };
    return grid.first_patch + index(row, grid.rows) * grid.columns + index(column, grid.columns);
}

PatchMean Patches::around(std::size_t chart, const glm::dvec2& coordinates) const {
    const Chart& on = charts_.all()[chart];
    const PatchGrid& grid = grids_[chart];
    const bool is_round = on.kind == Chart::Kind::round;
    struct Place {
        std::uint32_t low, high;
        float share;
    };
    const auto place = [](double at, std::uint32_t count, bool goes_round) {
        const double from_middle = at - 0.5;
        const double floor = std::floor(from_middle);
        const auto share = static_cast<float>(from_middle - floor);
        if (floor < 0.0) return goes_round ? Place{count - 1, 0, share} : Place{0, 0, share};
        const auto low = static_cast<std::uint32_t>(std::min(floor, static_cast<double>(count - 1)));
        if (low + 1 >= count) return Place{low, goes_round ? 0 : low, share};
        return Place{low, low + 1, share};
    };
    const Place column = place((on.u.warped(coordinates.x) - grid.low_u) * grid.per_u, grid.columns, is_round);
    const Place row = place((on.v.warped(coordinates.y) - grid.low_v) * grid.per_v, grid.rows, false);
    const auto patch = [&](std::uint32_t c, std::uint32_t r) { return grid.first_patch + r * grid.columns + c; };
    return {{patch(column.low, row.low), patch(column.high, row.low), patch(column.low, row.high),
             patch(column.high, row.high)},
            {(1.0F - column.share) * (1.0F - row.share), column.share * (1.0F - row.share),
             (1.0F - column.share) * row.share, column.share * row.share}};
}

glm::dvec3 Patches::normal(std::uint32_t patch) const {
    const Chart& chart = charts_.all()[chart_of(patch)];
    return chart.normal(chart.coordinates(middle(patch)));
}

void Patches::add_patches(const Stage& stage, const Chart& chart, const PatchGrid& grid, std::uint32_t index) {
    const double lift_m = lift(square_m_);
    for (std::uint32_t row = 0; row < grid.rows; ++row)
        for (std::uint32_t column = 0; column < grid.columns; ++column) {
            // The part that is not covered.
            const auto covered = [&](double u, double v) {
                const glm::dvec2 at = grid.corner(chart, column + u, row + v);
                const glm::dvec3 normal = chart.normal(at);
                return is_covered(stage, chart.surface, chart.position(at) + lift_m * normal, normal, lift_m);
            };
            const auto share_free = [&](int along, double inset) {
                int free = 0;
                for (int v = 0; v < along; ++v)
                    for (int u = 0; u < along; ++u)
                        if (!covered(inset + (1.0 - 2.0 * inset) * (u + 0.5) / along,
                                     inset + (1.0 - 2.0 * inset) * (v + 0.5) / along))
                            ++free;
                return static_cast<double>(free) / (along * along);
            };
            // The grid of 3×3 reaches to the corners.
            double free = share_free(3, -0.24);
            const bool whole = free == 0.0 || free == 1.0;
            if (!whole) free = share_free(8, 0.0);
            is_partial_.push_back(whole ? 0 : 1);
            const double area_m2 =
                free * chart.area(grid.corner(chart, column, row), grid.corner(chart, column + 1.0, row + 1.0));
            area_m2_.push_back(area_m2);
            middle_.push_back(chart.position(grid.corner(chart, column + 0.5, row + 0.5)));
            const auto to_corner = [&](double u, double v) {
                return glm::distance(middle_.back(), chart.position(grid.corner(chart, column + u, row + v)));
            };
            half_diagonal_m_.push_back(
                std::max({to_corner(0.0, 0.0), to_corner(1.0, 0.0), to_corner(0.0, 1.0), to_corner(1.0, 1.0)}));
            chart_of_.push_back(index);
            surface_of_.push_back(static_cast<std::uint32_t>(chart.surface));
            cell_of_.push_back(grid.first_cell + row / cell_side * grid.cell_columns + column / cell_side);
        }
}

void Patches::add_cells(const Stage& stage, const Chart& chart, const PatchGrid& grid, std::uint32_t index) {
    const double lift_m = lift(square_m_);
    for (std::uint32_t row = 0; row < grid.rows; row += cell_side)
        for (std::uint32_t column = 0; column < grid.columns; column += cell_side) {
            const std::uint32_t end_row = std::min(row + cell_side, grid.rows);
            const std::uint32_t end_column = std::min(column + cell_side, grid.columns);
            Cell cell;
            cell.chart = index;
            double area_m2 = 0.0;
            double largest_m2 = -1.0;
            glm::dvec2 in_largest(0.0);
            for (std::uint32_t r = row; r < end_row; ++r)
                for (std::uint32_t c = column; c < end_column; ++c) {
                    const double patch_m2 = area_m2_[grid.first_patch + r * grid.columns + c];
                    area_m2 += patch_m2;
                    if (patch_m2 > largest_m2) {
                        largest_m2 = patch_m2;
                        in_largest = {c + 0.5, r + 0.5};
                    }
                }
            const glm::dvec2 at = grid.corner(chart, 0.5 * (column + end_column), 0.5 * (row + end_row));
            const auto place = [&](const glm::dvec2& where) {
                cell.normal = chart.normal(where);
                cell.position = chart.position(where) + lift_m * cell.normal;
                return !is_covered(stage, chart.surface, cell.position, cell.normal, lift_m);
            };
            cell.covered = !place(at) && !place(grid.corner(chart, in_largest.x, in_largest.y));
            for (const double v : {static_cast<double>(row), static_cast<double>(end_row)})
                for (const double u : {static_cast<double>(column), static_cast<double>(end_column)})
                    cell.half_diagonal_m = std::max(
                        cell.half_diagonal_m, glm::distance(cell.position, chart.position(grid.corner(chart, u, v))));
            if (!is_sheet(stage.surfaces[chart.surface].geometry))
                cells_of_solids_.push_back(static_cast<std::uint32_t>(cells_.size()));
            cells_.push_back(cell);
            cell_area_m2_.push_back(cell.covered ? 0.0 : area_m2);
        }
}

bool Patches::is_covered(const Stage& stage, std::size_t surface, const glm::dvec3& above, const glm::dvec3& normal,
                         double lift_m) {
    for (std::size_t i = 0; i < stage.surfaces.size(); ++i) {
        if (i == surface) continue;
        const Primitive& other = stage.surfaces[i].geometry;
        if (hides(other, above)) return true;
        const auto* const panel = std::get_if<Panel>(&other);
        if (panel == nullptr || glm::dot(panel->frame.z, normal) >= 0.0) continue;
        const glm::dvec3 local = panel->frame.to_local(above - panel->frame.origin);
        if (local.z <= 0.0 && local.z > -2.0 * lift_m && std::abs(local.x) <= 0.5 * panel->width &&
            std::abs(local.y) <= 0.5 * panel->height)
            return true;
    }
    return false;
}

} // namespace gonio::detail
