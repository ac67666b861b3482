#include <gonio/base/limits.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/scene/receiver_grid.hpp>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

namespace gonio {

namespace {

constexpr double widest_m = 1e6; // of an area that is divided by a spacing

std::string place_text(const glm::dvec3& p) {
    return fmt::format("{},{},{}", rounded(p.x), rounded(p.y), rounded(p.z));
}

Result<void> check_count(std::size_t columns, std::size_t rows, std::size_t most) {
    if (columns <= most / rows) return {};
    return fail("USE0106",
                fmt::format("a grid of {} x {} points is out of range: it may have 1 to {}", columns, rows, most),
                "use a wider spacing");
}

// Cell centres, those that `keeps` accepts.
template<class Keep>
void fill(ReceiverGrid& grid, const glm::dvec3& normal, const Keep& keeps) {
    for (std::size_t j = 0; j < grid.rows; ++j)
        for (std::size_t i = 0; i < grid.columns; ++i) {
            const glm::dvec3 center = grid.corner +
                                      grid.u * ((static_cast<double>(i) + 0.5) / static_cast<double>(grid.columns)) +
                                      grid.v * ((static_cast<double>(j) + 0.5) / static_cast<double>(grid.rows));
            if (!keeps(center)) continue;
            grid.receivers.push_back({center, normal});
            grid.cells.push_back(j * grid.columns + i);
        }
    if (grid.cells.size() == grid.rows * grid.columns) grid.cells.clear();
}

// Cells along both sides of an area.
struct CellCounts {
    std::size_t columns = 1;
    std::size_t rows = 1;
};

CellCounts cell_counts(double length_m, double width_m, const GridSpacing& spacing) {
    if (spacing.length_m || !spacing.for_sports) {
        const double step_m = spacing.length_m.value_or(grid_spacing_m(length_m, width_m));
        return {cells_along(length_m, step_m), cells_along(width_m, step_m)};
    }
    const double step_m = 0.2 * std::pow(5.0, std::log10(std::max(length_m, width_m)));
    // The odd number 2k + 1 that is nearest to n has k = (n − 1)/2, rounded.
    const auto nearest_odd = [&](double side_m) {
        const double half = std::round(0.5 * (side_m / step_m - 1.0));
        return 2 * static_cast<std::size_t>(std::clamp(half, 0.0, 1e15)) + 1;
    };
    return {nearest_odd(length_m), nearest_odd(width_m)};
}

struct Flat {
    double x = 0.0;
    double y = 0.0;
};

// Twice the area of a triangle; positive if it turns left.
double turn(const Flat& a, const Flat& b, const Flat& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool within(const Flat& a, const Flat& b, const Flat& p) {
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
           p.y <= std::max(a.y, b.y);
}

bool meet(const Flat& a, const Flat& b, const Flat& c, const Flat& d) {
    const double abc = turn(a, b, c);
    const double abd = turn(a, b, d);
    const double cda = turn(c, d, a);
    const double cdb = turn(c, d, b);
    if (((abc > 0.0) != (abd > 0.0)) && ((cda > 0.0) != (cdb > 0.0)) && abc != 0.0 && abd != 0.0 && cda != 0.0 &&
        cdb != 0.0)
        return true;
    return (abc == 0.0 && within(a, b, c)) || (abd == 0.0 && within(a, b, d)) || (cda == 0.0 && within(c, d, a)) ||
           (cdb == 0.0 && within(c, d, b));
}

bool is_inside(std::span<const Flat> corners, const Flat& p) {
    bool inside = false;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const Flat& a = corners[i];
        const Flat& b = corners[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
    }
    return inside;
}

} // namespace

double grid_spacing_m(double length_m, double width_m) {
    const double longer = std::max(length_m, width_m);
    const double shorter = std::min(length_m, width_m);
    const double d = longer >= 2.0 * shorter ? shorter : longer;
    return std::min(0.2 * std::pow(5.0, std::log10(d)), 10.0);
}

std::size_t cells_along(double length_m, double spacing_m) {
    const double cells = std::round(length_m / spacing_m);
    return cells >= 1.0 ? static_cast<std::size_t>(std::min(cells, 1e15)) : 1;
}

Result<ReceiverGrid> parallelogram_grid(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v,
                                        const GridSpacing& spacing, const glm::dvec3& normal, std::size_t most) {
    const double along_u = glm::length(u);
    const double along_v = glm::length(v);
    if (!(along_u > 0.0) || !(along_v > 0.0))
        return fail("USE0106", "the grid has an edge of length 0", "its edges span its area");
    if (!(along_u <= widest_m && along_v <= widest_m))
        return fail("USE0106", fmt::format("the grid is wider than {} m", widest_m),
                    "give its number of points as NxM");
    const CellCounts cells = cell_counts(along_u, along_v, spacing);
    ReceiverGrid grid{corner, u, v, cells.columns, cells.rows, {}, {}, {}};
    if (Result<void> fits = check_count(grid.columns, grid.rows, most); !fits) return pass_on(fits);
    fill(grid, normal, [](const glm::dvec3& /*center*/) { return true; });
    return grid;
}

Result<ReceiverGrid> polygon_grid(std::span<const glm::dvec3> corners, const GridSpacing& spacing,
                                  const std::optional<glm::dvec3>& normal, std::size_t most) {
    if (corners.size() < 3)
        return fail("USE0105", fmt::format("a polygon has at least three corners, not {}", corners.size()),
                    "for example 0,0,0.8:4,0,0.8:4,3,0.8");
    if (corners.size() > limit("polygon-corners").value)
        return fail("USE0106", fmt::format("a polygon has at most {}", to_text(limit("polygon-corners"))),
                    std::string(limits_hint));
    for (const glm::dvec3& corner : corners)
        if (!(glm::length(corner) <= widest_m))
            return fail("USE0106", fmt::format("a corner is farther away than {} m", widest_m));
    // The normal by Newell's rule, which any flat polygon has.
    glm::dvec3 area(0.0);
    for (std::size_t i = 0; i < corners.size(); ++i)
        area += glm::cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
    const std::optional<glm::dvec3> found = unit_vector(area);
    double size = 0.0;
    for (const glm::dvec3& corner : corners)
        size = std::max(size, glm::distance(corner, corners[0]));
    if (!found || !(glm::length(area) > 1e-12 * size * size))
        return fail("USE0106", "the polygon has no area", "its corners lie on a line");
    // The side that is seen from above, unless it is upright: going round does not matter.
    const glm::dvec3 n = found->z < -1e-9 ? -*found : *found;
    double off_plane = 0.0;
    for (const glm::dvec3& corner : corners)
        off_plane = std::max(off_plane, std::abs(glm::dot(corner - corners[0], n)));
    if (off_plane > 1e-6 * size)
        return fail(
            "USE0106",
            fmt::format("the polygon is not flat: its corners are up to {} m off a plane", rounded(off_plane, 3)),
            "give all corners the same height");
    const glm::dvec3 horizontal = glm::cross(glm::dvec3(0.0, 0.0, 1.0), n);
    const glm::dvec3 along = glm::length(horizontal) > 1e-9 ? glm::normalize(horizontal) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 across = glm::cross(n, along);

    std::vector<Flat> flat;
    Flat low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Flat high{-low.x, -low.y};
    for (const glm::dvec3& corner : corners) {
        flat.push_back({glm::dot(corner, along), glm::dot(corner, across)});
        low = {std::min(low.x, flat.back().x), std::min(low.y, flat.back().y)};
        high = {std::max(high.x, flat.back().x), std::max(high.y, flat.back().y)};
    }
    const std::size_t count = flat.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (i + 1) % count;
        if (flat[i].x == flat[next].x && flat[i].y == flat[next].y)
            return fail("USE0106",
                        fmt::format("corners {} and {} of the polygon are the same, {}", i + 1, next + 1,
                                    place_text(corners[i])),
                        "the last corner is joined to the first");
    }
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (i + 1) % count;
        for (std::size_t k = i + 1; k < count; ++k) {
            const bool is_neighbour = k == next || (k + 1) % count == i;
            if (is_neighbour || !meet(flat[i], flat[next], flat[k], flat[(k + 1) % count])) continue;
            return fail("USE0106",
                        fmt::format("edges of the polygon cross: {} to {}, and {} to {}", place_text(corners[i]),
                                    place_text(corners[next]), place_text(corners[k]),
                                    place_text(corners[(k + 1) % count])),
                        "name the corners in the order of going round");
        }
    }
    const double width = high.x - low.x;
    const double height = high.y - low.y;
    const CellCounts cells = cell_counts(width, height, spacing);
    const double off = glm::dot(corners[0], n);
    ReceiverGrid grid{
        low.x * along + low.y * across + off * n, width * along, height * across, cells.columns, cells.rows, {}, {},
        {corners.begin(), corners.end()}};
    if (Result<void> fits = check_count(grid.columns, grid.rows, most); !fits) return pass_on(fits);
    fill(grid, normal.value_or(n), [&](const glm::dvec3& center) {
        return is_inside(flat, {glm::dot(center, along), glm::dot(center, across)});
    });
    if (grid.receivers.empty())
        return fail("USE0106",
                    fmt::format("no point of the grid lies in the polygon at a spacing of {} m",
                                rounded(width / static_cast<double>(cells.columns))),
                    "use a smaller --spacing");
    return grid;
}

double percentile(std::span<const double> values, double percent) {
    if (values.empty()) return 0.0;
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    const double at = std::clamp(percent / 100.0, 0.0, 1.0) * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    const double share = at - static_cast<double>(below);
    return (1.0 - share) * sorted[below] + share * sorted[above];
}

const Surface* beyond_height(const Stage& stage, double height_m) {
    for (const Surface& surface : stage.surfaces) {
        const auto* const plane = std::get_if<Plane>(&surface.geometry);
        const auto* const panel = std::get_if<Panel>(&surface.geometry);
        if (plane == nullptr && panel == nullptr) continue;
        const glm::dvec3& normal = plane != nullptr ? plane->normal : panel->frame.z;
        const double above = height_m - (plane != nullptr ? plane->point.z : panel->frame.origin.z);
        if (std::abs(normal.z) > 1.0 - 1e-9 && above * normal.z < 0.0) return &surface;
    }
    return nullptr;
}

std::optional<FloorArea> area_between_walls(const Stage& stage, double height_m) {
    constexpr double far = std::numeric_limits<double>::infinity();
    FloorArea area{{-far, -far, height_m}, {far, far, height_m}};
    const auto wall = [&](const glm::dvec3& point, const glm::dvec3& normal) {
        for (int axis = 0; axis < 2; ++axis) {
            if (normal[axis] > 1.0 - 1e-9) area.low[axis] = std::max(area.low[axis], point[axis]);
            if (normal[axis] < -1.0 + 1e-9) area.high[axis] = std::min(area.high[axis], point[axis]);
        }
    };
    for (const Surface& surface : stage.surfaces) {
        if (const auto* const plane = std::get_if<Plane>(&surface.geometry)) wall(plane->point, plane->normal);
        const auto* const panel = std::get_if<Panel>(&surface.geometry);
        if (panel == nullptr) continue;
        // A picture on a wall is no wall: what the height passes through is.
        const double reach =
            0.5 * (std::abs(panel->frame.x.z) * panel->width + std::abs(panel->frame.y.z) * panel->height);
        if (std::abs(panel->frame.origin.z - height_m) <= reach) wall(panel->frame.origin, panel->frame.z);
    }
    const bool is_closed = area.low.x > -far && area.low.y > -far && area.high.x < far && area.high.y < far;
    if (!is_closed || !(area.low.x < area.high.x && area.low.y < area.high.y)) return std::nullopt;
    return area;
}

} // namespace gonio
