#include <gonio/scene/core_vector.hpp>
#include <gonio/transport/linked_cells.hpp>
#include <gonio/transport/patches.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace gonio::detail {

namespace {

constexpr std::uint32_t widest_group = 8; // cells along a side
// Kernels compute this many parts at once, or a divisor of it. What they compute behind the last one means nothing, but
// parts of a pack take longer than a whole one.
constexpr std::size_t whole_packs = 16;

// Cells of a chart that lie in a square, of which the chart's ends may cut something off.
struct Square {
    std::uint32_t column, row, side; // in cells
};

// The sine of the sum of two angles of at most 90°, or 1 beyond 90°.
double sine_of_sum(double cosine, double other_sine) {
    const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
    const double other_cosine = std::sqrt(std::max(1.0 - other_sine * other_sine, 0.0));
    return cosine > other_sine ? sine * other_cosine + cosine * other_sine : 1.0;
}

// Whether a link may stand for the whole of a cell.
bool is_alike(const Cell& cell) {
    return !cell.covered && !cell.is_uneven() && cell.spread <= LinkedCells::most_spread;
}

// The area of a cell as seen from far away along a unit vector is the product with this.
glm::dvec3 seen_area_m2(const Patches& patches, std::uint32_t cell) {
    glm::dvec3 sum(0.0);
    for (const std::uint32_t patch : patches.patches_of(cell))
        sum += patches.area_m2(patch) * patches.normal(patch);
    return sum;
}

// The cells of a chart in rows.
class CellGrid {
public:
    CellGrid(const Patches& patches, std::uint32_t chart, std::size_t cells)
        : patches_(patches),
          first_(patches.grid(chart).first_cell),
          columns_(patches.grid(chart).cell_columns),
          rows_(static_cast<std::uint32_t>(cells) / columns_) {}

    struct Member {
        Square square;
        std::uint32_t of = LinkedCells::no_group; // the group that it is in
        std::optional<CellGroup> group;           // none: a cell
    };
    std::uint32_t number_of(const Square& square) const { return first_ + square.row * columns_ + square.column; }
    Square square_of(std::uint32_t cell) const { return {(cell - first_) % columns_, (cell - first_) / columns_, 1}; }

    // Squares of the widest groups, or what they are divided into.
    std::vector<Member> whole() const {
        std::vector<Member> members;
        for (std::uint32_t row = 0; row < rows_; row += widest_group)
            for (std::uint32_t column = 0; column < columns_; column += widest_group)
                add({column, row, widest_group}, LinkedCells::no_group, members);
        return members;
    }
    void add_quarters(const Square& square, std::uint32_t of, std::vector<Member>& members) const {
        const std::uint32_t half = square.side / 2;
        for (const std::uint32_t row : {square.row, square.row + half})
            for (const std::uint32_t column : {square.column, square.column + half})
                add({column, row, half}, of, members);
    }

private:
    void add(const Square& square, std::uint32_t of, std::vector<Member>& members) const {
        if (square.row >= rows_ || square.column >= columns_) return;
        std::optional<CellGroup> group;
        if (square.side > 1) group = group_of(square);
        if (square.side == 1 || group)
            members.push_back({square, of, std::move(group)});
        else
            add_quarters(square, of, members);
    }

    // None for cells that are not alike or send nothing, and for a single one.
    std::optional<CellGroup> group_of(const Square& square) const {
        CellGroup group;
        glm::dvec3 moment(0.0);
        glm::dvec3 seen_m2(0.0);
        for (std::uint32_t row = square.row; row < std::min(square.row + square.side, rows_); ++row)
            for (std::uint32_t column = square.column; column < std::min(square.column + square.side, columns_);
                 ++column) {
                const std::uint32_t number = number_of({column, row, 1});
                const Cell& cell = patches_.cells()[number];
                const double area_m2 = patches_.cell_area_m2(number);
                if (!is_alike(cell) || !(area_m2 > 0.0)) return std::nullopt;
                group.cells.push_back(number);
                group.chart = cell.chart;
                group.area_m2 += area_m2;
                moment += area_m2 * cell.position;
                seen_m2 += seen_area_m2(patches_, number);
            }
        if (group.cells.size() < 2) return std::nullopt;
        group.position = moment / group.area_m2;
        group.seen_m2 = glm::length(seen_m2);
        group.normal = seen_m2 / group.seen_m2;
        for (const std::uint32_t number : group.cells) {
            const Cell& cell = patches_.cells()[number];
            group.half_diagonal_m =
                std::max(group.half_diagonal_m, glm::distance(cell.position, group.position) + cell.half_diagonal_m);
            group.spread = std::max(group.spread, sine_of_sum(glm::dot(cell.normal, group.normal), cell.spread));
        }
        if (group.spread > LinkedCells::most_spread_of_group) return std::nullopt;
        return group;
    }

    const Patches& patches_;
    std::uint32_t first_, columns_, rows_;
};

} // namespace

LinkedCells::LinkedCells(const Patches& patches)
    : is_of_small_(patches.charts().all().size(), 0),
      is_bright_(is_of_small_.size(), 0),
      group_of_(patches.cells().size(), no_group) {
    const std::vector<std::uint32_t>& cells = patches.linked_cells();
    for (std::size_t first = 0; first < cells.size();) {
        const std::uint32_t chart = patches.cells()[cells[first]].chart;
        std::size_t last = first;
        while (last < cells.size() && patches.cells()[cells[last]].chart == chart)
            ++last;
        add_chart(patches, std::span(cells).subspan(first, last - first));
        first = last;
    }
    for (std::vector<float>* const array : {&position_[0], &position_[1], &position_[2], &normal_[0], &normal_[1],
                                            &normal_[2], &spread_, &reach_, &area_m2_, &least2_, &least2_for_coarse_})
        array->resize(array->size() + whole_packs - 1);
}

// A part as kernels read it.
struct LinkedCells::Numbers {
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0};
    double spread = 0.0;
    double reach_m = 0.0;
    double area_m2 = 0.0;
    double least_m = std::numeric_limits<double>::infinity();
    double least_for_coarse_m = std::numeric_limits<double>::infinity();
};

// Level by level, so that what one part is divided into lies beside what the next is.
void LinkedCells::add_chart(const Patches& patches, std::span<const std::uint32_t> cells) {
    const std::uint32_t chart = patches.cells()[cells.front()].chart;
    for (const std::uint32_t cell : cells) {
        if (patches.cells()[cell].is_of_small) is_of_small_[chart] = 1;
        if (patches.cells()[cell].is_bright) is_bright_[chart] = 1;
    }
    const CellGrid grid(patches, chart, cells.size());
    std::vector<CellGrid::Member> level;
    if (is_of_small_[chart] != 0)
        level = grid.whole();
    else
        for (const std::uint32_t cell : cells)
            level.push_back({grid.square_of(cell), no_group, std::nullopt});
    const std::size_t first = parts_.size();
    by_chart_.push_back({chart, {first, first + level.size()}, 0, patches.cells()[cells.front()].position});
    std::vector<std::size_t> of_cells;
    while (!level.empty()) {
        std::vector<CellGrid::Member> next;
        const std::size_t below = parts_.size() + level.size();
        for (CellGrid::Member& member : level) {
            if (!member.group) {
                const std::uint32_t cell = grid.number_of(member.square);
                group_of_[cell] = member.of;
                of_cells.push_back(parts_.size());
                add_cell(patches, cell);
                continue;
            }
            group_of_.push_back(member.of);
            add_group(patches, std::move(*member.group));
            const std::size_t before = next.size();
            grid.add_quarters(member.square, parts_.back().number, next);
            parts_.back().parts = {below + before, below + next.size()};
            parts_.back().has_parts = true;
        }
        level = std::move(next);
    }
    by_chart_.back().patches = parts_.size();
    for (const std::size_t cell : of_cells)
        add_patches(patches, cell);
}

void LinkedCells::add_group(const Patches& patches, CellGroup group) {
    const auto number = static_cast<std::uint32_t>(patches.cells().size() + groups_.size());
    Numbers numbers;
    numbers.position = group.position;
    numbers.normal = group.normal;
    numbers.spread = group.spread;
    numbers.reach_m = group.half_diagonal_m;
    numbers.area_m2 = group.seen_m2;
    if (group.spread <= most_spread) numbers.least_m = least_of_group * group.half_diagonal_m;
    numbers.least_for_coarse_m = least_for_coarse * group.half_diagonal_m;
    add(number, numbers);
    groups_.push_back(std::move(group));
}

void LinkedCells::add_cell(const Patches& patches, std::uint32_t number) {
    const Cell& cell = patches.cells()[number];
    const bool is_flat = patches.charts().all()[cell.chart].kind == Chart::Kind::flat;
    Numbers numbers;
    numbers.position = cell.position;
    numbers.normal = cell.normal;
    numbers.spread = cell.spread;
    numbers.reach_m = is_flat ? cell.half_diagonal_m : 0.0;
    numbers.area_m2 = is_flat ? patches.cell_area_m2(number) : glm::length(seen_area_m2(patches, number));
    if (is_alike(cell)) {
        numbers.least_m = (is_flat ? least_of_flat : least_of_round) * cell.half_diagonal_m;
        numbers.least_for_coarse_m = (is_flat ? least_of_flat : least_for_coarse) * cell.half_diagonal_m;
    }
    add(number, numbers);
}

// As parts, or where those of cells that are not alike or stretched out are asked for one by one.
void LinkedCells::add_patches(const Patches& patches, std::size_t cell) {
    const std::uint32_t number = parts_[cell].number;
    const Cell& of = patches.cells()[number];
    const std::span<const std::uint32_t> of_cell = patches.patches_of(number);
    const bool is_long = std::any_of(of_cell.begin(), of_cell.end(),
                                     [&](std::uint32_t patch) { return patches.half_length(patch) > 0.0; });
    if (!is_alike(of) || is_long) {
        parts_[cell].parts = {single_patches_.size(), single_patches_.size() + of_cell.size()};
        add_single(patches, of, of_cell);
        return;
    }
    parts_[cell].has_parts = true;
    parts_[cell].parts = {parts_.size(), parts_.size() + of_cell.size()};
    for (const std::uint32_t patch : of_cell) {
        Numbers numbers;
        numbers.position = patches.middle(patch);
        numbers.normal = patches.normal(patch);
        numbers.spread = 0.5 * of.spread;
        numbers.area_m2 = patches.area_m2(patch);
        numbers.least_m = numbers.least_for_coarse_m = least_of_patch * patches.half_across(patch);
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
    least2_for_coarse_.push_back(static_cast<float>(numbers.least_for_coarse_m * numbers.least_for_coarse_m));
}

void LinkedCells::find_links(const transport::RayKernels& kernels, const Frame& place, bool is_coarse,
                             const OfChart& chart, const Range& parts, CellLinks& to) const {
    transport::RayCells to_parts;
    transport::RayLinks links;
    to_parts.count = (parts.last - parts.first + whole_packs - 1) / whole_packs * whole_packs;
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
    to_parts.least2 = (is_coarse ? least2_for_coarse_ : least2_).data() + parts.first;
    float from[3];
    put(from, place.origin - chart.anchor);
    transport::RayFrame frame;
    put(frame.x, place.x);
    put(frame.y, place.y);
    put(frame.z, place.z);
    kernels.cell_links(to_parts, from, frame, links);
}

} // namespace gonio::detail
