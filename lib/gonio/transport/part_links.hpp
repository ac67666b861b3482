// How a place sees flat patches that are close, or that a light makes bright: in parts that are small beside their
// distance, whose form factors are exact.
#pragma once

#include <gonio/base/frame.hpp>
#include <gonio/simd/dispatch.hpp>
#include <gonio/transport/kernels_parts.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gonio::detail {

// A flat patch, whatever covers it.
struct FlatPatch {
    glm::dvec3 middle{0.0};
    glm::dvec2 sides_m{0.0}; // along X and Y of its chart
    double free = 1.0;       // the share of its area that is not covered, taken to lie all over it
};

class PartLinks {
public:
    explicit PartLinks(simd::InstructionSet set) : kernels_(transport::part_kernels(set)) {}

    // All patches that follow are on the plane of this chart, and seen from this place, whose normal is Z. They are
    // divided until their parts are this many of their half diagonals away.
    void begin(const Frame& place, const Frame& chart, double least_distance);
    // `weight`: of its share.
    void add(const FlatPatch& patch, std::uint32_t number, double weight);
    // What follows, of all parts that were added: those of a patch come one after the other.
    void find();

    std::size_t size() const { return numbers_.size(); }
    std::uint32_t number(std::size_t part) const { return numbers_[part]; } // of its patch
    double share(std::size_t part) const { return weights_[part] * share_[part]; }
    // Of the share without its weight, about the middle of the patch, in its sides; 0 where the share is even.
    glm::dvec2 moment(std::size_t part) const;
    // To the middle of what is seen of it, in the place's frame.
    glm::dvec3 towards(std::size_t part) const { return {middle_[0][part], middle_[1][part], middle_[2][part]}; }

private:
    struct Part { // of a patch, in its sides
        glm::dvec2 middle;
        glm::dvec2 half;
        int depth; // how often it was halved
    };
    void find_cut(std::size_t part);

    const transport::PartKernels& kernels_;
    Frame place_;
    glm::dvec3 chart_x_{0.0}, chart_y_{0.0}; // in the place's frame
    double least_distance_ = 0.0;
    std::vector<Part> undivided_;
    // Of each part:
    std::vector<std::uint32_t> numbers_;
    std::array<std::vector<double>, 3> middle_;
    std::array<std::vector<double>, 2> half_side_, at_, half_, moment_;
    std::vector<double> free_, weights_;
    std::vector<double> share_;    // without the weight
    std::vector<std::size_t> cut_; // those that the horizon cuts, or that are too close for the kernels
};

} // namespace gonio::detail
