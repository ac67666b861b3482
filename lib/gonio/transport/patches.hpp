// A stage in patches, on which direct light is known, and in cells of a few patches, on which indirect light is solved.
#pragma once

#include <gonio/scene/stage.hpp>
#include <gonio/transport/axis.hpp>
#include <gonio/transport/chart.hpp>
#include <gonio/transport/linked_cells.hpp>
#include <gonio/transport/spacing.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gonio::detail {

// A patch and a point of it in four bytes: rays are many.
class PatchPoint {
public:
    // Patches have lower numbers; higher ones are what `PatchPoint(number)` says without a patch.
    static constexpr std::uint32_t most_patches = 0xfffff0U;

    PatchPoint() = default;
    explicit PatchPoint(std::uint32_t number) : bits_(number) {}
    PatchPoint(std::uint32_t patch, std::uint32_t part_u, std::uint32_t part_v)
        : bits_(patch << 8U | part_v << 4U | part_u) {}

    bool is_on_patch() const { return bits_ < most_patches << 8U; }
    std::uint32_t number() const { return bits_; }
    std::uint32_t patch() const { return bits_ >> 8U; }
    // From the middle of the patch, in sides.
    float u() const { return from_middle(bits_ & 15U); }
    float v() const { return from_middle(bits_ >> 4U & 15U); }

private:
    static_assert(Axis::parts == 16);
    static float from_middle(std::uint32_t part) {
        return (static_cast<float>(static_cast<std::int32_t>(part)) + 0.5F) / Axis::parts - 0.5F;
    }

    std::uint32_t bits_ = 0;
};

// One chart in a grid of patches, numbered row by row (along u first) from `first_patch`.
struct PatchGrid {
    std::uint32_t first_patch = 0;
    std::uint32_t first_cell = 0;
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    std::uint32_t cell_columns = 0;
    Axis u, v;

    glm::dvec2 corner(double column, double row) const { return {u.at(column), v.at(row)}; }
    // The patch that contains the point; the outermost ones continue without an end.
    PatchPoint point(float at_u, float at_v) const {
        const Axis::Spot column = u.spot(at_u);
        const Axis::Spot row = v.spot(at_v);
        return {first_patch + row.interval * columns + column.interval, column.part, row.part};
    }
};

struct Cell {
    glm::dvec3 position{0.0}; // just above the surface, so that rays that start here do not meet it
    glm::dvec3 normal{0.0};
    std::uint32_t chart = 0;
    double half_diagonal_m = 0.0;
    double spread = 0.0;      // the sine of the greatest angle between its normals and `normal`; 1 for more than 90°
    bool covered = false;     // lies in a solid or against another surface: it neither gets nor sends light
    bool is_of_small = false; // of what is not large: links carry what rays would miss
    bool is_on_sheet = false; // and flat: links carry all that it sends
    glm::dvec3 linked_middle{0.0}; // of a bright one, the middle of what links carry; else `position`
    bool is_bright = false;        // flat and close to a light: links carry a part of what it sends

    // Whether links carry how what it sends changes within it.
    bool is_uneven() const { return is_bright || is_on_sheet; }
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
    Patches(const Stage& stage, const Interest& interest, std::span<const LightPlace> lights, double count,
            unsigned threads);

    const Charts& charts() const { return charts_; }
    const PatchGrid& grid(std::size_t chart) const { return grids_[chart]; }
    std::size_t count() const { return cell_of_.size(); } // of patches
    double square_m() const { return square_m_; }         // the side of an ordinary one
    // Of a point of a chart, by its coordinates.
    PatchMean around(std::size_t chart, float u, float v) const;
    // How much what is known by patch changes over a patch, along u and v: by the patches beside it. 0 where something
    // covers one of them.
    std::array<glm::dvec3, 2> change_over(std::uint32_t patch, std::span<const glm::dvec3> by_patch) const;

    std::uint32_t cell_of(std::uint32_t patch) const { return cell_of_[patch]; }
    std::size_t surface_of(std::uint32_t patch) const { return surface_of_[patch]; }
    std::size_t chart_of(std::uint32_t patch) const { return chart_of_[patch]; }
    glm::dvec3 middle(std::uint32_t patch) const { return middle_[patch]; }
    glm::dvec3 normal(std::uint32_t patch) const { return normal_[patch]; }
    double half_diagonal(std::uint32_t patch) const { return half_diagonal_m_[patch]; }
    // In order: the cells of boxes, spheres and capsules that are not large, which rays would miss, and flat cells
    // close to a light, which few rays would meet.
    const std::vector<std::uint32_t>& linked_cells() const { return linked_cells_; }
    const LinkedCells& linked() const { return linked_; } // the same
    // The patches of a cell.
    std::span<const std::uint32_t> patches_of(std::uint32_t cell) const {
        return std::span(patches_of_).subspan(first_of_[cell], first_of_[cell + 1] - first_of_[cell]);
    }
    // Of what a patch sends, the share that rays carry, above 0; links carry the rest. 1 for all that is not close to a
    // light.
    float by_rays(std::uint32_t patch) const { return by_rays_[patch]; }
    // What rays carry of a patch, or links of a cell (from the number of patches on) or a group.
    float carried(std::uint32_t sender) const {
        if (sender < by_rays_.size()) return by_rays_[sender];
        const std::size_t number = sender - by_rays_.size();
        return number < by_links_.size() ? by_links_[number] : 1.0F;
    }
    std::array<glm::dvec3, 4> corners(std::uint32_t patch) const; // of a flat one, one after the other
    // Of a patch along the straight part of a thin solid that is much longer than wide, half of its length; else 0.
    double half_length(std::uint32_t patch) const { return half_length_m_[patch]; }
    double half_across(std::uint32_t patch) const; // half of its diagonal without that length
    // Points of a chart gather light with this many times the rays of others: of a small sheet or a thin pole, which
    // sees what is bright at grazing angles, or half of it; and of what is round and stands close to another solid.
    static constexpr std::size_t rays_of_slight = 8;
    static constexpr std::size_t rays_of_crowded = 2;
    std::size_t ray_factor(std::size_t chart) const { return ray_factor_[chart]; }
    bool has_moments() const;                  // whether any cell is_uneven()
    FlatPatch flat(std::uint32_t patch) const; // must be one
    PatchCosine cosine_over(std::uint32_t patch) const;
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
    void link_to_bright_cells(std::span<const LightPlace> lights, double area_m2);

    Charts charts_;
    double square_m_ = 0.0;
    double coarseness_ = 1.0;
    std::vector<PatchGrid> grids_;
    std::vector<std::size_t> ray_factor_; // by chart
    std::vector<std::uint32_t> cell_of_;  // by patch
    std::vector<std::uint32_t> surface_of_;
    std::vector<std::uint32_t> chart_of_;
    std::vector<glm::dvec3> middle_;
    std::vector<glm::dvec3> normal_;
    std::vector<double> half_diagonal_m_;
    std::vector<double> half_length_m_;
    std::vector<std::uint32_t> linked_cells_;
    LinkedCells linked_;
    std::vector<float> by_rays_;          // by patch
    std::vector<float> by_links_;         // by cell: 1 but for bright ones
    std::vector<std::uint32_t> first_of_; // by cell, in patches_of_
    std::vector<std::uint32_t> patches_of_;
    std::vector<double> area_m2_;
    std::vector<std::uint8_t> is_partial_;
    std::vector<Cell> cells_;
    std::vector<double> cell_area_m2_;
};

} // namespace gonio::detail
