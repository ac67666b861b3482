// A stage in patches, on which direct light is known, and in cells of a few patches, on which indirect light is solved.
#pragma once

#include <gonio/scene/stage.hpp>
#include <gonio/transport/axis.hpp>
#include <gonio/transport/chart.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gonio::detail {

// One chart in a grid of patches, numbered row by row (along u first) from `first_patch`.
struct PatchGrid {
    std::uint32_t first_patch = 0;
    std::uint32_t first_cell = 0;
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    std::uint32_t cell_columns = 0;
    Axis u, v;

    glm::dvec2 corner(double column, double row) const { return {u.at(column), v.at(row)}; }
    std::uint32_t patch(double at_u, double at_v) const {
        return first_patch + v.index(at_v) * columns + u.index(at_u);
    }
};

struct Cell {
    glm::dvec3 position{0.0}; // just above the surface, so that rays that start here do not meet it
    glm::dvec3 normal{0.0};
    std::uint32_t chart = 0;
    double half_diagonal_m = 0.0;
    bool covered = false; // lies in a solid or against another surface: it neither gets nor sends light
};

// The patches whose middles are around a point, with weights that add up to 1.
struct PatchMean {
    std::array<std::uint32_t, 4> patch{};
    std::array<float, 4> weight{};
};

class Patches {
public:
    // Nothing smaller than this is `covered` by chance, and rays start this far above a surface [m].
    static double lift(double square_m) { return 1e-4 * square_m; }

    // About `count` of them, smaller where `lights` are close and solids stand.
    Patches(const Stage& stage, const Interest& interest, std::span<const glm::dvec3> lights, double count,
            unsigned threads);

    const Charts& charts() const { return charts_; }
    const PatchGrid& grid(std::size_t chart) const { return grids_[chart]; }
    std::size_t count() const { return cell_of_.size(); } // of patches
    double square_m() const { return square_m_; }         // the side of an ordinary one
    // Whether lights at other places divide the stage in the same way.
    bool same_under(const Stage& stage, std::span<const glm::dvec3> lights) const;

    // The patch that contains the point of the surface; the outermost ones continue without an end.
    std::uint32_t at(std::size_t chart, const glm::dvec3& position) const {
        return at(chart, charts_.all()[chart].coordinates(position));
    }
    std::uint32_t at(std::size_t chart, const glm::dvec2& coordinates) const {
        return grids_[chart].patch(coordinates.x, coordinates.y);
    }
    PatchMean around(std::size_t chart, const glm::dvec2& coordinates) const;

    std::uint32_t cell_of(std::uint32_t patch) const { return cell_of_[patch]; }
    std::size_t surface_of(std::uint32_t patch) const { return surface_of_[patch]; }
    std::size_t chart_of(std::uint32_t patch) const { return chart_of_[patch]; }
    glm::dvec3 middle(std::uint32_t patch) const { return middle_[patch]; }
    glm::dvec3 normal(std::uint32_t patch) const { return normal_[patch]; }
    double half_diagonal(std::uint32_t patch) const { return half_diagonal_m_[patch]; }
    // The cells of boxes, spheres and capsules that are not large, and the patches of a cell.
    const std::vector<std::uint32_t>& cells_of_solids() const { return cells_of_solids_; }
    std::span<const std::uint32_t> patches_of(std::uint32_t cell) const {
        return std::span(patches_of_).subspan(first_of_[cell], first_of_[cell + 1] - first_of_[cell]);
    }
    double area_m2(std::uint32_t patch) const { return area_m2_[patch]; } // without what is covered
    // Whether the edge of what covers it crosses the patch.
    bool is_partial(std::uint32_t patch) const { return is_partial_[patch] != 0; }
    const std::vector<Cell>& cells() const { return cells_; }
    double cell_area_m2(std::uint32_t cell) const { return cell_area_m2_[cell]; }

    // Whether the point above a surface lies in a solid or behind another surface that touches this one there.
    static bool is_covered(const Stage& stage, std::size_t surface, const glm::dvec3& above, const glm::dvec3& normal,
                           double lift_m);

private:
    void add_patches(const Stage& stage, const Chart& chart, const PatchGrid& grid, std::uint32_t index,
                     unsigned threads);
    void add_cells(const Stage& stage, const Chart& chart, const PatchGrid& grid, std::uint32_t index);

    Charts charts_;
    double square_m_ = 0.0;
    double coarseness_ = 1.0;
    std::vector<PatchGrid> grids_;
    std::vector<std::uint32_t> cell_of_; // by patch
    std::vector<std::uint32_t> surface_of_;
    std::vector<std::uint32_t> chart_of_;
    std::vector<glm::dvec3> middle_;
    std::vector<glm::dvec3> normal_;
    std::vector<double> half_diagonal_m_;
    std::vector<std::uint32_t> cells_of_solids_;
    std::vector<std::uint32_t> first_of_; // by cell, in patches_of_
    std::vector<std::uint32_t> patches_of_;
    std::vector<double> area_m2_;
    std::vector<std::uint8_t> is_partial_;
    std::vector<Cell> cells_;
    std::vector<double> cell_area_m2_;
};

} // namespace gonio::detail
