#include <gonio/plot/contour.hpp>

#include <array>
#include <unordered_map>

namespace gonio {

namespace {

// A cell's corners, counter-clockwise from the lowest x and y: side k runs from corner k to corner k + 1.
struct Cell {
    std::array<FieldPoint, 4> corners;
    std::array<double, 4> values{};

    Cell(const Field& field, std::size_t column, std::size_t row) {
        constexpr std::array<std::array<std::size_t, 2>, 4> steps{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t c = column + steps[k][0];
            const std::size_t r = row + steps[k][1];
            corners[k] = {field.xs[c], field.ys[r]};
            values[k] = field.value(c, r);
        }
    }

    bool inside(std::size_t k, double level) const { return values[k] >= level; }

    unsigned mask(double level) const {
        unsigned bits = 0;
        for (std::size_t k = 0; k < 4; ++k)
            if (inside(k, level)) bits |= 1U << k;
        return bits;
    }

    // Where the level crosses side k; the ends of the side must be on opposite sides of the level.
    FieldPoint crossing(std::size_t k, double level) const {
        const std::size_t n = (k + 1) % 4;
        const double weight = (level - values[k]) / (values[n] - values[k]);
        // If a corner is NaN or infinite, the line is drawn through the other end.
        const double t = weight >= 0.0 && weight <= 1.0 ? weight : inside(k, level) ? 0.0 : 1.0;
        return {corners[k].x + t * (corners[n].x - corners[k].x), corners[k].y + t * (corners[n].y - corners[k].y)};
    }

    bool center_inside(double level) const { return 0.25 * (values[0] + values[1] + values[2] + values[3]) >= level; }
};

constexpr unsigned all_inside = 15;

bool is_saddle(unsigned mask) {
    return mask == 5 || mask == 10;
}

// One corner of a saddle whose inside corners do not connect.
std::vector<FieldPoint> corner_piece(const Cell& cell, std::size_t k, double level) {
    return {cell.crossing((k + 3) % 4, level), cell.corners[k], cell.crossing(k, level)};
}

void add_partial(const Cell& cell, double level, unsigned mask, std::vector<std::vector<FieldPoint>>& region) {
    if (is_saddle(mask) && !cell.center_inside(level)) {
        for (std::size_t k = mask == 5 ? 0 : 1; k < 4; k += 2)
            region.push_back(corner_piece(cell, k, level));
        return;
    }
    std::vector<FieldPoint> polygon;
    for (std::size_t k = 0; k < 4; ++k) {
        if (cell.inside(k, level)) polygon.push_back(cell.corners[k]);
        if (cell.inside(k, level) != cell.inside((k + 1) % 4, level)) polygon.push_back(cell.crossing(k, level));
    }
    region.push_back(std::move(polygon));
}

// Sides are numbered across the whole field so that two adjacent cells agree on the side between them.
std::uint64_t side_id(const Field& field, std::size_t column, std::size_t row, std::size_t k) {
    const std::size_t across = 2 * (row * field.xs.size() + column); // the side from (column, row) to the right
    switch (k) {
    case 0:
        return across;
    case 1:
        return across + 3; // upwards from (column + 1, row)
    case 2:
        return across + 2 * field.xs.size();
    default:
        return across + 1; // upwards from (column, row)
    }
}

struct Segment {
    std::array<std::uint64_t, 2> sides{};
    std::array<FieldPoint, 2> ends;
    bool used = false;
};

// Whether all corners of a cell belong to one group, and that group is not below 0.
bool of_one_group(std::span<const std::int32_t> groups, std::size_t corner, std::size_t columns) {
    const std::int32_t group = groups[corner];
    return group >= 0 && group == groups[corner + 1] && group == groups[corner + columns] &&
           group == groups[corner + columns + 1];
}

std::vector<Segment> segments_of(const Field& field, double level, std::span<const std::int32_t> groups) {
    std::vector<Segment> segments;
    for (std::size_t row = 0; row + 1 < field.ys.size(); ++row)
        for (std::size_t column = 0; column + 1 < field.xs.size(); ++column) {
            const Cell cell(field, column, row);
            const unsigned mask = cell.mask(level);
            if (mask == 0 || mask == all_inside) continue;
            const std::size_t corner = row * field.xs.size() + column;
            if (!groups.empty() && !of_one_group(groups, corner, field.xs.size())) continue;
            const auto add = [&](std::size_t from, std::size_t to) {
                segments.push_back({{side_id(field, column, row, from), side_id(field, column, row, to)},
                                    {cell.crossing(from, level), cell.crossing(to, level)}});
            };
            std::array<std::size_t, 4> crossed{};
            std::size_t count = 0;
            for (std::size_t k = 0; k < 4; ++k)
                if (cell.inside(k, level) != cell.inside((k + 1) % 4, level)) crossed[count++] = k;
            if (count == 2) {
                add(crossed[0], crossed[1]);
                continue;
            }
            // A saddle: each line cuts off one of the two isolated corners.
            const bool cut_inside = !cell.center_inside(level);
            for (std::size_t k = 0; k < 4; ++k)
                if (cell.inside(k, level) == cut_inside) add((k + 3) % 4, k);
        }
    return segments;
}

} // namespace

std::vector<std::vector<FieldPoint>> region_at_least(const Field& field, double level) {
    std::vector<std::vector<FieldPoint>> region;
    for (std::size_t row = 0; row + 1 < field.ys.size(); ++row) {
        std::size_t run_begin = 0;
        std::size_t run = 0;
        const auto end_run = [&] {
            if (run == 0) return;
            const double left = field.xs[run_begin];
            const double right = field.xs[run_begin + run];
            region.push_back(
                {{left, field.ys[row]}, {right, field.ys[row]}, {right, field.ys[row + 1]}, {left, field.ys[row + 1]}});
            run = 0;
        };
        for (std::size_t column = 0; column + 1 < field.xs.size(); ++column) {
            const Cell cell(field, column, row);
            const unsigned mask = cell.mask(level);
            if (mask == all_inside) {
                if (run++ == 0) run_begin = column;
                continue;
            }
            end_run();
            if (mask != 0) add_partial(cell, level, mask, region);
        }
        end_run();
    }
    return region;
}

std::vector<ContourLine> contour_lines(const Field& field, double level, std::span<const std::int32_t> groups) {
    std::vector<Segment> segments = segments_of(field, level, groups);
    std::unordered_map<std::uint64_t, std::array<std::size_t, 2>> at_side; // a side of a line has at most two segments
    constexpr std::size_t nobody = ~std::size_t{0};
    for (std::size_t i = 0; i < segments.size(); ++i)
        for (const std::uint64_t side : segments[i].sides) {
            const auto [entry, fresh] = at_side.try_emplace(side, std::array<std::size_t, 2>{i, nobody});
            if (!fresh) entry->second[1] = i;
        }
    // Appends the points joined to `end` of a segment, until the line ends or closes.
    const auto walk = [&](std::size_t segment, std::size_t end, std::vector<FieldPoint>& points) {
        for (;;) {
            const std::uint64_t side = segments[segment].sides[end];
            const std::array<std::size_t, 2>& pair = at_side.at(side);
            const std::size_t next = pair[0] == segment ? pair[1] : pair[0];
            if (next == nobody) return false;
            if (segments[next].used) return true;
            segments[next].used = true;
            end = segments[next].sides[0] == side ? 1 : 0;
            points.push_back(segments[next].ends[end]);
            segment = next;
        }
    };
    std::vector<ContourLine> lines;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (segments[i].used) continue;
        segments[i].used = true;
        ContourLine line;
        line.points = {segments[i].ends[0], segments[i].ends[1]};
        line.closed = walk(i, 1, line.points);
        if (!line.closed) {
            std::vector<FieldPoint> before;
            (void)walk(i, 0, before);
            line.points.insert(line.points.begin(), before.rbegin(), before.rend());
        } else {
            line.points.pop_back(); // same as the first point
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

} // namespace gonio
