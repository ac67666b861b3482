// Grids of receivers on flat areas: rectangles, polygons, and the working plane of a room.
//
// Spacing by EN 12464-1: p = 0.2·5^log10(d) metres, at most 10 m, d the longer side, or the shorter one where the sides
// are at 2 to 1 or more; each side has as many cells as p goes into it, rounded to the nearest number (2021; earlier
// editions round up). By EN 12193, for sports, d is the longer side always, and the numbers of cells are odd. Receivers
// are at the centres of the cells. A polygon has the cells of the rectangle around it whose centres lie inside.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/scene/stage.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// Receivers in the cells of a parallelogram; along U first.
struct ReceiverGrid {
    glm::dvec3 corner{0.0}; // of the parallelogram [m]
    glm::dvec3 u{1.0, 0.0, 0.0};
    glm::dvec3 v{0.0, 1.0, 0.0};
    std::size_t columns = 0; // along U
    std::size_t rows = 0;    // along V
    std::vector<Receiver> receivers;
    std::vector<std::size_t> cells;  // of each receiver: row · columns + column; empty: all of them, in order
    std::vector<glm::dvec3> outline; // of a polygon
    std::size_t cell_of(std::size_t receiver) const { return cells.empty() ? receiver : cells[receiver]; }
};

// Of EN 12464-1 [m], for sides greater than 0.
double grid_spacing_m(double length_m, double width_m);

// The cells that a side is divided into by a spacing: rounded, at least 1.
std::size_t cells_along(double length_m, double spacing_m);

// How a grid is spaced.
struct GridSpacing {
    std::optional<double> length_m{}; // between points; empty: by a standard
    bool for_sports = false;          // EN 12193, else EN 12464-1
};

// The grid of a parallelogram; `normal` of every receiver. Fails (usage) on an area without a size and on more points
// than `most`.
Result<ReceiverGrid> parallelogram_grid(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v,
                                        const GridSpacing& spacing, const glm::dvec3& normal, std::size_t most);

// Of a flat polygon with at least three corners, in either order of going round. U is the horizontal direction of its
// plane, or X. Fails (usage) as parallelogram_grid(), on edges that cross or touch, on corners off the plane, and if no
// centre lies inside.
Result<ReceiverGrid> polygon_grid(std::span<const glm::dvec3> corners, const GridSpacing& spacing,
                                  const std::optional<glm::dvec3>& normal, std::size_t most);

// The value that a percentage of the values does not exceed, linear between the sorted values; 0 for none.
double percentile(std::span<const double> values, double percent);

// A rectangle on the floor plan, X and Y.
struct FloorArea {
    glm::dvec3 low{0.0};
    glm::dvec3 high{0.0};
};

// The free area between the walls of a stage at a height: its planes and rectangles that face along X or Y. Nothing
// unless there is one on each of the four sides.
std::optional<FloorArea> area_between_walls(const Stage& stage, double height_m);

// The floor of a stage that is above a height, or the ceiling below it: a horizontal plane or rectangle that faces
// away. nullptr if there is none.
const Surface* beyond_height(const Stage& stage, double height_m);

} // namespace gonio
#pragma GCC visibility pop
