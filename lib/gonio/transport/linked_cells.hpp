// The cells that links may stand for (ray_bundle.hpp), in the form in which each of many places asks for them: far ones
// in groups.
#pragma once

#include <gonio/base/frame.hpp>
#include <gonio/transport/kernels_rays.hpp>
#include <gonio/transport/part_links.hpp>
#include <gonio/transport/patch_cosine.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gonio::detail {

struct Cell;
class Patches;

struct LinkedPatch {
    glm::dvec3 middle{0.0};
    glm::dvec3 normal{0.0};
    double half_across_m = 0.0; // half of the diagonal without the length
    double half_length_m = 0.0; // as Patches::half_length()
    double area_m2 = 0.0;
    PatchCosine cosine;
    FlatPatch flat;         // of a flat one
    double over_rays = 1.0; // what links carry of it, over what rays do; 1 where they carry all
    double of_bright = 1.0; // what links carry of it, over what they do of all of a bright cell
    std::uint32_t number = 0;
};

// How a place is linked to parts of a chart, one after the other: transport::RayLinks.
struct CellLinks {
    std::vector<float> share;
    std::array<std::vector<float>, 3> towards;
};

// Cells of a small solid that lie together, as one sender.
struct CellGroup {
    std::vector<std::uint32_t> cells;
    std::uint32_t chart = 0;
    glm::dvec3 position{0.0}; // the mean
    glm::dvec3 normal{0.0};   // the mean
    double half_diagonal_m = 0.0;
    double spread = 0.0; // as of a cell
    double area_m2 = 0.0;
    double seen_m2 = 0.0; // of it, as seen along the normal from far away
};

class LinkedCells {
public:
    LinkedCells() = default;
    explicit LinkedCells(const Patches& patches);

    // A link stands for a cell that is at least as many of its half diagonals away. One that is closer is divided into
    // its patches, and so is one whose normals differ by more than this sine from its own. Rays meet patches that are
    // still closer.
    static constexpr double least_of_flat = 8.0;
    static constexpr double least_of_round = 24.0; // it is bright on one side, which is not the side that all see
    static constexpr double least_of_patch = 5.0;
    static constexpr double most_spread = 0.4;
    // The same of a group.
    static constexpr double least_of_group = 24.0;
    static constexpr double most_spread_of_group = 0.6;
    // The same of all that is round, and of groups, as coarse places see them.
    static constexpr double least_for_coarse = 8.0;

    // Parts of a chart: groups and cells, and then the patches of those cells that are flat, or nearly so, and alike.
    struct Range {
        std::size_t first = 0, last = 0;
    };
    struct OfChart {
        std::uint32_t chart = 0;
        Range whole;             // what has all of the chart
        std::size_t patches = 0; // the first part that is one
        glm::dvec3 anchor{0.0};  // near all of them
    };
    const std::vector<OfChart>& by_chart() const { return by_chart_; }
    struct Part {
        std::uint32_t number = 0; // of the cell; from the number of cells on, of the group; or of the patch
        // Of a group or a cell: what it is divided into. Of a cell without parts: single patches.
        Range parts;
        bool has_parts = false;
    };
    const Part& part(std::size_t index) const { return parts_[index]; }
    bool empty() const { return parts_.empty(); }
    std::span<const LinkedPatch> single_patches(const Part& cell) const {
        return std::span(single_patches_).subspan(cell.parts.first, cell.parts.last - cell.parts.first);
    }
    const std::vector<CellGroup>& groups() const { return groups_; }
    // Of a cell or (from the number of cells on) a group, the group that it is in, numbered like it, or `no_group`.
    static constexpr std::uint32_t no_group = 0xffffffffU;
    std::uint32_t group_of(std::uint32_t number) const { return group_of_[number]; }
    // Whether a chart is of a small solid, which has links instead of rays, or has cells whose light rays and links
    // share.
    bool is_of_small(std::size_t chart) const { return is_of_small_[chart] != 0; }
    bool is_bright(std::size_t chart) const { return is_bright_[chart] != 0; }

    // From a place, the frame of which has its normal as Z, to parts of a chart.
    void find_links(const transport::RayKernels& kernels, const Frame& place, bool is_coarse, const OfChart& chart,
                    const Range& parts, CellLinks& to) const;

private:
    void add_chart(const Patches& patches, std::span<const std::uint32_t> cells);
    void add_group(const Patches& patches, CellGroup group);
    void add_cell(const Patches& patches, std::uint32_t number);
    void add_patches(const Patches& patches, std::size_t cell);
    void add_single(const Patches& patches, const Cell& of, std::span<const std::uint32_t> of_cell);
    struct Numbers;
    void add(std::uint32_t number, const Numbers& numbers);

    std::vector<OfChart> by_chart_;
    std::vector<std::uint8_t> is_of_small_, is_bright_; // by chart
    std::vector<Part> parts_;
    std::vector<CellGroup> groups_;
    std::vector<std::uint32_t> group_of_;
    std::vector<LinkedPatch> single_patches_;
    std::array<std::vector<float>, 3> position_; // from the anchor of their chart
    std::array<std::vector<float>, 3> normal_;
    std::vector<float> spread_;
    std::vector<float> reach_; // of groups and flat cells, to their corners
    std::vector<float> area_m2_;
    std::vector<float> least2_; // the squared distance from which they are linked as a whole; infinite: never
    std::vector<float> least2_for_coarse_;
};

} // namespace gonio::detail
