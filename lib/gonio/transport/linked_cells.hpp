// The cells that links may stand for (ray_bundle.hpp), in the form in which each of many places asks for them.
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gonio::detail {

class Patches;

struct LinkedPatch {
    glm::dvec3 middle{0.0};
    glm::dvec3 normal{0.0};
    double half_across_m = 0.0; // half of the diagonal without the length
    double half_length_m = 0.0; // as Patches::half_length()
    double area_m2 = 0.0;
    std::uint32_t number = 0;
};

class LinkedCells {
public:
    LinkedCells() = default;
    explicit LinkedCells(const Patches& patches);

    // Those of a chart are [first, last).
    struct OfChart {
        std::uint32_t chart;
        std::size_t first, last;
    };
    const std::vector<OfChart>& by_chart() const { return by_chart_; }
    std::size_t count() const { return first_patch_.empty() ? 0 : first_patch_.size() - 1; }
    std::span<const LinkedPatch> patches_of(std::size_t index) const {
        return std::span(patches_).subspan(first_patch_[index], first_patch_[index + 1] - first_patch_[index]);
    }
    // Whether a chart is of a small solid, which has links instead of rays, or has cells whose light rays and links
    // share.
    bool is_of_small(std::size_t chart) const { return is_of_small_[chart] != 0; }
    bool is_bright(std::size_t chart) const { return is_bright_[chart] != 0; }

    // Of [first, last), the less of the two distances from the planes of place and cell to the other, above 0 where
    // they see each other. Of a round one the plane that faces the place most.
    void find_facing(const glm::dvec3& place, const glm::dvec3& normal, std::size_t first, std::size_t last,
                     std::span<float> faces) const;

private:
    std::vector<OfChart> by_chart_;
    std::vector<std::uint8_t> is_of_small_, is_bright_; // by chart
    std::vector<std::size_t> first_patch_;              // by cell, and the end of the last
    std::vector<LinkedPatch> patches_;
    glm::dvec3 anchor_{0.0}; // of positions
    std::array<std::vector<float>, 3> position_, normal_;
    std::vector<float> spread_;
    std::vector<float> reach_; // of flat ones, to their corners
};

} // namespace gonio::detail
