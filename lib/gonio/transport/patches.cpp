#include <gonio/base/parallel.hpp>
#include <gonio/scene/figure.hpp>
#include <gonio/transport/light_tree.hpp>
#include <gonio/transport/patches.hpp>
#include <gonio/transport/spacing.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <variant>

namespace gonio::detail {

namespace {

constexpr double least_columns = 6.0;      // around the smallest solid
constexpr double patches_per_radius = 5.0; // of a sphere, so that the edge of its dark side is in the right place
constexpr double patches_beside = 12.0;    // per radius, if another solid is closer to it than its radius
constexpr double patches_of_figure = 2.0;  // per radius of each of its fifteen limbs
constexpr std::uint32_t cell_side = 2;     // patches
constexpr double small = 6.0;              // squares; no rays miss parts of larger solids,
constexpr double thin = 0.3;               // unless they are poles with a radius of less than these squares
constexpr double bright = 3.0;             // times the mean: what rays carry of a cell close to a light
constexpr std::size_t most_bright = 400;   // cells

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

// What is bright and close in one part of a patch weighs too little, as below a light.
bool is_beside_another(const Stage& stage, const Chart& chart) {
    for (std::size_t i = 0; i < stage.surfaces.size(); ++i) {
        const Primitive& other = stage.surfaces[i].geometry;
        if (i != chart.surface && !is_of_figure(stage.surfaces[i]) && !is_sheet(other) &&
            distance_to_surface(other, chart.frame.origin) < chart.half_length + 2.0 * chart.radius)
            return true;
    }
    return false;
}

Lines lines_on(const Stage& stage, std::span<const LightPlace> lights, const Chart& chart, double square_m,
               double coarseness) {
    if (chart.kind == Chart::Kind::round) {
        const double per_radius = is_of_figure(stage.surfaces[chart.surface]) ? patches_of_figure
                                  : is_beside_another(stage, chart)           ? patches_beside
                                                                              : patches_per_radius;
        const double size_m = std::min(square_m, coarseness * chart.radius / per_radius);
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

Patches::Patches(const Stage& stage, const Interest& interest, std::span<const LightPlace> lights, double count,
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
    link_to_bright_cells(lights, square_m_ * square_m_ * count);
    linked_ = LinkedCells(*this);
}

std::array<glm::dvec3, 4> Patches::corners(std::uint32_t patch) const {
    const PatchGrid& grid = grids_[chart_of_[patch]];
    const Chart& chart = charts_.all()[chart_of_[patch]];
    const std::uint32_t column = (patch - grid.first_patch) % grid.columns;
    const std::uint32_t row = (patch - grid.first_patch) / grid.columns;
    const auto at = [&](std::uint32_t u, std::uint32_t v) { return chart.position(grid.corner(column + u, row + v)); };
    return {at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
}

double Patches::half_across(std::uint32_t patch) const {
    const double half_m = half_diagonal_m_[patch];
    return std::sqrt(half_m * half_m - half_length_m_[patch] * half_length_m_[patch]);
}

bool Patches::has_moments() const {
    return std::any_of(linked_cells_.begin(), linked_cells_.end(),
                       [&](std::uint32_t cell) { return cells_[cell].is_uneven(); });
}

FlatPatch Patches::flat(std::uint32_t patch) const {
    const std::array<glm::dvec3, 4> at = corners(patch);
    const glm::dvec2 sides_m(glm::distance(at[0], at[1]), glm::distance(at[0], at[3]));
    return {0.5 * (at[0] + at[2]), sides_m, area_m2_[patch] / (sides_m.x * sides_m.y)};
}

PatchCosine Patches::cosine_over(std::uint32_t patch) const {
    const Chart& chart = charts_.all()[chart_of_[patch]];
    if (chart.kind != Chart::Kind::round) return PatchCosine(normal_[patch]);
    const PatchGrid& grid = grids_[chart_of_[patch]];
    const std::uint32_t column = (patch - grid.first_patch) % grid.columns;
    return {chart.frame, normal_[patch], 0.5 * (grid.u.line(column + 1) - grid.u.line(column))};
}

PatchMean Patches::around(std::size_t chart, float u, float v) const {
    const PatchGrid& grid = grids_[chart];
    const Axis::Between column = grid.u.between(u, charts_.all()[chart].kind == Chart::Kind::round);
    const Axis::Between row = grid.v.between(v, false);
    const auto patch = [&](std::uint32_t c, std::uint32_t r) { return grid.first_patch + r * grid.columns + c; };
    return {{patch(column.in, row.in), patch(column.beside, row.in), patch(column.in, row.beside),
             patch(column.beside, row.beside)},
            {(1.0F - column.share) * (1.0F - row.share), column.share * (1.0F - row.share),
             (1.0F - column.share) * row.share, column.share * row.share}};
}

std::array<glm::dvec3, 2> Patches::change_over(std::uint32_t patch, std::span<const glm::dvec3> by_patch) const {
    const PatchGrid& grid = grids_[chart_of_[patch]];
    const bool is_round = charts_.all()[chart_of_[patch]].kind == Chart::Kind::round;
    const std::uint32_t column = (patch - grid.first_patch) % grid.columns;
    const std::uint32_t row = (patch - grid.first_patch) / grid.columns;
    const auto is_whole = [&](std::uint32_t of) { return area_m2_[of] > 0.0 && is_partial_[of] == 0; };
    const auto change = [&](const Axis& axis, std::uint32_t in, std::uint32_t step, bool goes_round) {
        const std::uint32_t last = axis.intervals() - 1;
        const auto width = [&](std::uint32_t interval) { return axis.line(interval + 1) - axis.line(interval); };
        const auto beside = [&](bool above) {
            return above ? (in < last ? in + 1 : goes_round ? 0 : in) : (in > 0 ? in - 1 : goes_round ? last : in);
        };
        double between = 0.0;
        std::array<std::uint32_t, 2> ends{patch, patch};
        for (const bool above : {false, true}) {
            const std::uint32_t other = beside(above);
            const std::uint32_t of = patch + other * step - in * step;
            if (other == in || !is_whole(of)) continue;
            ends.at(above ? 1 : 0) = of;
            between += 0.5 * (width(in) + width(other));
        }
        return between > 0.0 ? width(in) / between * (by_patch[ends[1]] - by_patch[ends[0]]) : glm::dvec3(0.0);
    };
    if (!is_whole(patch)) return {glm::dvec3(0.0), glm::dvec3(0.0)};
    return {change(grid.u, column, 1, is_round), change(grid.v, row, grid.columns, false)};
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

// Half the length of a patch along the straight part of a capsule, if it is much longer than wide; else 0.
double half_length_of(const Chart& chart, double low, double high, double width) {
    if (chart.kind != Chart::Kind::round || chart.half_length == 0.0) return 0.0;
    const double quarter_m = 0.5 * std::numbers::pi * chart.radius;
    const double near = 1e-6 * chart.radius;
    if (low < quarter_m - near || high > quarter_m + 2.0 * chart.half_length + near) return 0.0;
    const double length_m = high - low;
    return length_m > 2.0 * chart.radius * width ? 0.5 * length_m : 0.0;
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
            half_length_m_.push_back(half_length_of(chart, grid.v.line(row), grid.v.line(row + 1),
                                                    grid.u.line(column + 1) - grid.u.line(column)));
            chart_of_.push_back(index);
            surface_of_.push_back(static_cast<std::uint32_t>(chart.surface));
            cell_of_.push_back(grid.first_cell + row / cell_side * grid.cell_columns + column / cell_side);
        }
}

void Patches::add_cells(const Stage& stage, const Chart& chart, const PatchGrid& grid, std::uint32_t index) {
    const double lift_m = lift(square_m_);
    const Primitive& geometry = stage.surfaces[chart.surface].geometry;
    const auto* const panel = std::get_if<Panel>(&geometry);
    const double radius_m = panel != nullptr     ? 0.5 * std::hypot(panel->width, panel->height)
                            : is_sheet(geometry) ? std::numeric_limits<double>::infinity()
                                                 : bounds(geometry)->radius;
    const auto* const capsule = std::get_if<Capsule>(&geometry);
    const bool is_thin = capsule != nullptr && capsule->radius < thin * square_m_;
    const bool is_small = radius_m < small * square_m_ || is_thin;
    const bool is_crowded = chart.kind == Chart::Kind::round && is_beside_another(stage, chart);
    ray_factor_.push_back(is_thin || (is_small && panel != nullptr) ? rays_of_slight
                          : is_crowded                              ? rays_of_crowded
                                                                    : 1);
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
                for (const double u : {static_cast<double>(column), static_cast<double>(end_column)}) {
                    const glm::dvec2 corner = grid.corner(u, v);
                    cell.half_diagonal_m =
                        std::max(cell.half_diagonal_m, glm::distance(cell.position, chart.position(corner)));
                    if (chart.kind != Chart::Kind::round) continue;
                    const double cosine = glm::dot(chart.normal(corner), cell.normal);
                    cell.spread =
                        std::max(cell.spread, cosine > 0.0 ? std::sqrt(1.0 - std::min(cosine * cosine, 1.0)) : 1.0);
                }
            cell.is_of_small = is_small;
            cell.is_on_sheet = is_small && panel != nullptr;
            cell.linked_middle = cell.position;
            if (is_small) linked_cells_.push_back(static_cast<std::uint32_t>(cells_.size()));
            cells_.push_back(cell);
            cell_area_m2_.push_back(cell.covered ? 0.0 : area_m2);
        }
}

// A patch that a point light makes many times as bright as the mean of `area_m2`, which all of its light falls on,
// sends rays no more than a few times the mean, and links all above it: light then has no edge that rays would draw.
// Amounts do not matter, so parts of the light add up.
void Patches::link_to_bright_cells(std::span<const LightPlace> lights, double area_m2) {
    by_rays_.assign(cell_of_.size(), 1.0F);
    by_links_.assign(cells_.size(), 1.0F);
    // From farther away none makes anything that bright.
    const double reach_m = std::sqrt(area_m2 / (4.0 * std::numbers::pi * bright));
    std::vector<LightSphere> points;
    for (const LightPlace& light : lights)
        points.push_back({light.position, 0.0, static_cast<std::uint32_t>(points.size())});
    const LightTree tree(points);
    const auto times_the_mean = [&](const glm::dvec3& position, const glm::dvec3& normal, double least_m) {
        double most = 0.0;
        constexpr double rounding = 1.0 + 1e-9;
        const auto visit = [&](std::uint32_t index) {
            const LightPlace& light = lights[index];
            const glm::dvec3 to = light.position - position;
            const double distance = std::max(glm::length(to), least_m);
            const double one = glm::dot(to, normal) / (distance * distance * distance);
            if (one > most && glm::dot(to, to) <= reach_m * reach_m && light.may_light(position, 0.0)) most = one;
            // A light makes no more than the reciprocal of its squared distance.
            return most > 0.0 ? std::min(rounding / std::sqrt(most), reach_m) : reach_m;
        };
        tree.visit_near({position, normal}, reach_m, visit, [&](double squared_m, double height_m) {
            const double distance = std::max(std::sqrt(squared_m), least_m);
            return height_m * rounding > most * distance * distance * distance;
        });
        return most * area_m2 / (4.0 * std::numbers::pi);
    };
    struct Bright {
        double times;
        std::uint32_t cell;
    };
    std::vector<Bright> found;
    for (std::uint32_t i = 0; i < cells_.size(); ++i) {
        const Cell& cell = cells_[i];
        if (cell.covered || cell.is_of_small || charts_.all()[cell.chart].kind == Chart::Kind::round) continue;
        const double times = times_the_mean(cell.position, cell.normal, cell.half_diagonal_m);
        if (times > bright) found.push_back({times, i});
    }
    double by_rays = bright;
    if (found.size() > most_bright) {
        const auto is_before = [](const Bright& a, const Bright& b) { return a.times > b.times; };
        std::nth_element(found.begin(), found.begin() + most_bright, found.end(), is_before);
        by_rays = found[most_bright].times;
    }
    for (const Bright& one : found) {
        if (!(one.times > by_rays)) continue;
        cells_[one.cell].is_bright = true;
        linked_cells_.push_back(one.cell);
        by_links_[one.cell] = 0.0F;
        glm::dvec3 moment(0.0);
        double sum = 0.0;
        for (const std::uint32_t patch : patches_of(one.cell)) {
            const double times = times_the_mean(middle_[patch], normal_[patch], half_diagonal_m_[patch]);
            by_rays_[patch] = static_cast<float>(std::min(by_rays / times, 1.0));
            const double share = cell_area_m2_[one.cell] > 0.0 ? area_m2_[patch] / cell_area_m2_[one.cell] : 0.0;
            const double by_links = 1.0 - static_cast<double>(by_rays_[patch]);
            by_links_[one.cell] += static_cast<float>(share * by_links);
            moment += share * by_links * times * middle_[patch];
            sum += share * by_links * times;
        }
        cells_[one.cell].linked_middle = sum > 0.0 ? moment / sum : cells_[one.cell].position;
    }
    std::sort(linked_cells_.begin(), linked_cells_.end());
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
