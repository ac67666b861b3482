#include <gonio/base/parallel.hpp>
#include <gonio/transport/patches.hpp>
#include <gonio/transport/spacing.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

namespace gonio::detail {

namespace {

constexpr double least_columns = 6.0;      // around the smallest solid
constexpr double patches_per_radius = 5.0; // of a sphere, so that the edge of its dark side is in the right place
constexpr std::uint32_t cell_side = 2;     // patches
constexpr double small = 6.0;              // squares; no rays miss parts of larger solids

std::vector<double> uniform(const Range& range, double size_m, double least) {
    constexpr double most_intervals = 400.0;
    const double count = std::clamp(std::ceil((range.high - range.low) / size_m * (1.0 - 1e-9)), least, most_intervals);
    std::vector<double> lines;
    for (double i = 0.0; i <= count; i += 1.0)
        lines.push_back(i == count ? range.high : range.low + (range.high - range.low) * i / count);
    return lines;
}

struct Lines {
    std::vector<double> u, v;

    double patches() const { return static_cast<double>(u.size() - 1) * static_cast<double>(v.size() - 1); }
};

Lines lines_on(const Stage& stage, std::span<const glm::dvec3> lights, const Chart& chart, double square_m,
               double coarseness) {
    if (chart.kind == Chart::Kind::round) {
        const double size_m = std::min(square_m, coarseness * chart.radius / patches_per_radius);
        std::vector<double> around = uniform({0.0, 2.0 * std::numbers::pi * chart.radius}, size_m, least_columns);
        for (double& line : around)
            line /= chart.radius;
        around.back() = chart.u.high;
        // Half a sphere at each end.
        const double quarter_m = 0.5 * std::numbers::pi * chart.radius;
        std::vector<double> along = uniform({0.0, quarter_m}, size_m, 2.0);
        if (chart.half_length > 0.0) {
            along.pop_back();
            const std::vector<double> straight = uniform({quarter_m, chart.v.high - quarter_m}, square_m, 1.0);
            along.insert(along.end(), straight.begin(), straight.end());
        }
        along.pop_back();
        for (const double line : uniform({chart.v.high - quarter_m, chart.v.high}, size_m, 2.0))
            along.push_back(line);
        return {std::move(around), std::move(along)};
    }
    const SpacingPair spacing = spacing_of_patches(stage, lights, chart, square_m, coarseness);
    return {lines_of(spacing.u, 0.0), lines_of(spacing.v, 0.0)};
}

} // namespace

Patches::Patches(const Stage& stage, const Interest& interest, std::span<const glm::dvec3> lights, double count,
                 unsigned threads)
    : charts_(stage, interest), square_m_(charts_.square_of(count)), coarseness_(std::sqrt(8000.0 / count)) {
    std::vector<Lines> lines;
    for (int attempt = 0; attempt < 8; ++attempt) {
        lines.clear();
        double patches = 0.0;
        for (const Chart& chart : charts_.all()) {
            lines.push_back(lines_on(stage, lights, chart, square_m_, coarseness_));
            patches += lines.back().patches();
        }
        if (patches <= 6.0 * count) break;
        const double factor = std::max(std::sqrt(patches / (6.0 * count)), 1.1);
        square_m_ *= factor;
        coarseness_ *= factor;
    }
    for (std::size_t c = 0; c < charts_.all().size(); ++c) {
        const Chart& chart = charts_.all()[c];
        PatchGrid grid;
        grid.u = Axis(std::move(lines[c].u));
        grid.v = Axis(std::move(lines[c].v));
        grid.columns = grid.u.intervals();
        grid.rows = grid.v.intervals();
        grid.first_patch = static_cast<std::uint32_t>(cell_of_.size());
        grid.first_cell = static_cast<std::uint32_t>(cells_.size());
        grid.cell_columns = (grid.columns + cell_side - 1) / cell_side;
        grids_.push_back(grid);
        add_patches(stage, chart, grid, static_cast<std::uint32_t>(c), threads);
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

PatchMean Patches::around(std::size_t chart, const glm::dvec2& coordinates) const {
    const PatchGrid& grid = grids_[chart];
    const bool is_round = charts_.all()[chart].kind == Chart::Kind::round;
    struct Place {
        std::uint32_t low, high;
        float share;
    };
    // Between the middles of two intervals.
    const auto place = [](const Axis& axis, double x, bool goes_round) {
        const std::uint32_t in = axis.index(x);
        const std::uint32_t last = axis.intervals() - 1;
        const auto middle = [&](std::uint32_t interval) { return axis.at(interval + 0.5); };
        const double from_middle = x - middle(in);
        const std::uint32_t beside = from_middle < 0.0 ? (in > 0       ? in - 1
                                                          : goes_round ? last
                                                                       : in)
                                                       : (in < last    ? in + 1
                                                          : goes_round ? 0
                                                                       : in);
        if (beside == in) return Place{in, in, 0.0F};
        const double between = 0.5 * (axis.line(in + 1) - axis.line(in) + axis.line(beside + 1) - axis.line(beside));
        return Place{in, beside, static_cast<float>(std::min(std::abs(from_middle) / between, 1.0))};
    };
    const Place column = place(grid.u, coordinates.x, is_round);
    const Place row = place(grid.v, coordinates.y, false);
    const auto patch = [&](std::uint32_t c, std::uint32_t r) { return grid.first_patch + r * grid.columns + c; };
    return {{patch(column.low, row.low), patch(column.high, row.low), patch(column.low, row.high),
             patch(column.high, row.high)},
            {(1.0F - column.share) * (1.0F - row.share), column.share * (1.0F - row.share),
             (1.0F - column.share) * row.share, column.share * row.share}};
}

bool Patches::same_under(const Stage& stage, std::span<const glm::dvec3> lights) const {
    for (std::size_t c = 0; c < charts_.all().size(); ++c) {
        const Lines lines = lines_on(stage, lights, charts_.all()[c], square_m_, coarseness_);
        if (!grids_[c].u.has(lines.u) || !grids_[c].v.has(lines.v)) return false;
    }
    return true;
}

namespace {

// What is left of a patch beside what covers it.
struct Uncovered {
    float share = 1.0F;
    bool is_partial = false;
};

Uncovered uncovered(const Stage& stage, const Chart& chart, const PatchGrid& grid, std::uint32_t column,
                    std::uint32_t row, double lift_m) {
    const auto covered = [&](double u, double v) {
        const glm::dvec2 at = grid.corner(column + u, row + v);
        const glm::dvec3 normal = chart.normal(at);
        return Patches::is_covered(stage, chart.surface, chart.position(at) + lift_m * normal, normal, lift_m);
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
    const double rough = share_free(3, -0.24);
    if (rough == 0.0 || rough == 1.0) return {static_cast<float>(rough), false};
    return {static_cast<float>(share_free(8, 0.0)), true};
}

} // namespace

void Patches::add_patches(const Stage& stage, const Chart& chart, const PatchGrid& grid, std::uint32_t index,
                          unsigned threads) {
    const double lift_m = lift(square_m_);
    std::vector<Uncovered> free(static_cast<std::size_t>(grid.rows) * grid.columns);
    parallel_for(grid.rows, threads, [&](std::size_t row) {
        for (std::uint32_t column = 0; column < grid.columns; ++column)
            free[row * grid.columns + column] =
                uncovered(stage, chart, grid, column, static_cast<std::uint32_t>(row), lift_m);
    });
    for (std::uint32_t row = 0; row < grid.rows; ++row)
        for (std::uint32_t column = 0; column < grid.columns; ++column) {
            const Uncovered& left = free[static_cast<std::size_t>(row) * grid.columns + column];
            is_partial_.push_back(left.is_partial ? 1 : 0);
            area_m2_.push_back(static_cast<double>(left.share) *
                               chart.area(grid.corner(column, row), grid.corner(column + 1.0, row + 1.0)));
            middle_.push_back(chart.position(grid.corner(column + 0.5, row + 0.5)));
            normal_.push_back(chart.normal(grid.corner(column + 0.5, row + 0.5)));
            const auto to_corner = [&](double u, double v) {
                return glm::distance(middle_.back(), chart.position(grid.corner(column + u, row + v)));
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
    const Primitive& geometry = stage.surfaces[chart.surface].geometry;
    const bool is_small = !is_sheet(geometry) && bounds(geometry)->radius < small * square_m_;
    for (std::uint32_t row = 0; row < grid.rows; row += cell_side)
        for (std::uint32_t column = 0; column < grid.columns; column += cell_side) {
            const std::uint32_t end_row = std::min(row + cell_side, grid.rows);
            const std::uint32_t end_column = std::min(column + cell_side, grid.columns);
            Cell cell;
            cell.chart = index;
            double area_m2 = 0.0;
            double largest_m2 = -1.0;
            glm::dvec2 in_largest(0.0);
            glm::dvec2 middle(0.0);
            for (std::uint32_t r = row; r < end_row; ++r)
                for (std::uint32_t c = column; c < end_column; ++c) {
                    const double patch_m2 = area_m2_[grid.first_patch + r * grid.columns + c];
                    area_m2 += patch_m2;
                    middle += patch_m2 * grid.corner(c + 0.5, r + 0.5);
                    if (patch_m2 > largest_m2) {
                        largest_m2 = patch_m2;
                        in_largest = {c + 0.5, r + 0.5};
                    }
                }
            // Edges of other surfaces lie between patches, so the middle of a cell may be on one.
            const glm::dvec2 at =
                area_m2 > 0.0 ? middle / area_m2 : grid.corner(0.5 * (column + end_column), 0.5 * (row + end_row));
            const auto place = [&](const glm::dvec2& where) {
                cell.normal = chart.normal(where);
                cell.position = chart.position(where) + lift_m * cell.normal;
                return !is_covered(stage, chart.surface, cell.position, cell.normal, lift_m);
            };
            cell.covered = !place(at) && !place(grid.corner(in_largest.x, in_largest.y));
            for (const double v : {static_cast<double>(row), static_cast<double>(end_row)})
                for (const double u : {static_cast<double>(column), static_cast<double>(end_column)})
                    cell.half_diagonal_m =
                        std::max(cell.half_diagonal_m, glm::distance(cell.position, chart.position(grid.corner(u, v))));
            if (is_small) cells_of_solids_.push_back(static_cast<std::uint32_t>(cells_.size()));
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
