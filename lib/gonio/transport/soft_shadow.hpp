// Soft shadows of lights with a size: the share of their light that is not blocked, as a factor on the unshadowed
// light.
//
// The ratio of E. Heitz, S. Hill and M. McGuire ("Combining Analytic Direct Illumination and Stochastic Shadows", I3D
// 2018): ∫ f ⟨n·l⟩ V dl over ∫ f ⟨n·l⟩ dl, both by the same samples, so that unshadowed points keep the closed form and
// shadowed points cannot exceed it. The paper samples points of the light at random; here the samples are the cells of
// a few lines over the light, and the hidden part of each cell is known exactly (scene/shadow_line.hpp). So there is no
// noise to filter, and overlapping solids are not counted twice. README.md has the error.
#pragma once

#include <gonio/scene/shadow_numbers.hpp>
#include <gonio/shading/kernels_reflectance.hpp>
#include <gonio/transport/kernels_shadow.hpp>
#include <gonio/transport/lit_scene.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gonio::detail {

// Points of a surface, as arrays.
class ShadowPoints {
public:
    std::size_t size() const { return numbers_.front().size(); }
    void clear() { resize(0); }
    void resize(std::size_t count) {
        for (std::vector<double>& numbers : numbers_)
            numbers.resize(count);
    }
    // `view`: unit, towards the eye; only for the luminance.
    void set(std::size_t i, const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec3& view) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto at = static_cast<std::size_t>(axis);
            numbers_[at][i] = position[axis];
            numbers_[3 + at][i] = normal[axis];
            numbers_[6 + at][i] = view[axis];
        }
    }
    void add(const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec3& view = glm::dvec3(0.0)) {
        resize(size() + 1);
        set(size() - 1, position, normal, view);
    }

    glm::dvec3 position(std::size_t i) const { return vector(0, i); }
    glm::dvec3 normal(std::size_t i) const { return vector(3, i); }
    glm::dvec3 view(std::size_t i) const { return vector(6, i); }
    const double* numbers(std::size_t axis) const { return numbers_[axis].data(); } // positions, then normals

private:
    glm::dvec3 vector(std::size_t first, std::size_t i) const {
        return {numbers_[first][i], numbers_[first + 1][i], numbers_[first + 2][i]};
    }

    std::array<std::vector<double>, 9> numbers_;
};

// The share of a light that reaches a point.
struct VisibleShare {
    double lx = 1.0; // of its illuminance, in [0, 1]: exactly 1 if nothing is in the way, exactly 0 if all is hidden
    glm::vec3 rgb{1.0F}; // of the luminance that the surface shows, per channel
};

class SoftShadow {
public:
    explicit SoftShadow(const LitScene& scene);

    // The light must have a surface at a finite distance.
    void begin(const LitLight& light);

    // The surfaces that may be between the light and the queried points of surface `own`; empty until the caller fills
    // it.
    std::vector<std::uint32_t>& bodies(std::size_t own) { return bodies_[own]; }

    // What points of the surface `own` see of the light; the surface does not shadow itself. Without `with_luminance`
    // shares of the luminance have no meaning; with it, the points have views. One for each point; valid until the next
    // call.
    std::span<const VisibleShare> visible(std::size_t own, const ShadowPoints& points, bool with_luminance);

private:
    static constexpr std::size_t block = 64; // points that are kept with their cells
    // Between the cells of a point: not a power of two, of which few lines of a cache fit at once.
    static constexpr std::size_t cell_stride = block + 16;

    const transport::ShadowKernels& kernels_for(std::size_t count) const {
        return count == 1 ? plain_kernels_ : kernels_;
    }
    void find(std::size_t own, const ShadowPoints& points, std::size_t first, std::size_t count, bool with_luminance);
    // What is settled without lines; the points that are left.
    void find_left(const ShadowPoints& points, std::size_t first, std::size_t count, bool is_glossy);
    // The points of a block that a single ball hides the light from are collected, and their closed form found at once.
    void add_behind(const ShadowPoints& points, std::size_t first, std::size_t i, double body);
    void find_past_balls();
    void find_cells_of(std::size_t k, const glm::dvec3& point); // of the points left
    double integrated(const glm::dvec3& normal) const;
    // The share of illuminance behind a single solid, if it has a closed form.
    std::optional<double> closed_form(const Primitive& body, const glm::dvec3& point, const glm::dvec3& normal) const;
    glm::vec3 visible_luminance(std::size_t own, const glm::dvec3& point, const glm::dvec3& normal,
                                const glm::dvec3& view, double share, double by_lines) const;

    const LitScene& scene_;
    const shading::ReflectanceKernels& reflectance_;
    const transport::ShadowKernels& kernels_;
    const transport::ShadowKernels& plain_kernels_; // for single points
    const LitLight* light_ = nullptr;
    LinedLight lined_;
    std::vector<std::vector<std::uint32_t>> bodies_; // by surface
    std::vector<VisibleShare> shares_;

    // Some points of a block, side by side.
    struct ChosenPoints {
        std::array<std::array<double, block>, 6> numbers{}; // positions, then normals
        std::array<std::size_t, block> index{};             // of each in the block
        std::size_t count = 0;

        void clear() { count = 0; }
        void add(const ShadowPoints& points, std::size_t first, std::size_t i) {
            for (std::size_t axis = 0; axis < numbers.size(); ++axis)
                numbers[axis][count] = points.numbers(axis)[first + i];
            index[count++] = i;
        }
        transport::ShadowReceivers receivers() const {
            transport::ShadowReceivers all;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                all.position[axis] = numbers[axis].data();
                all.normal[axis] = numbers[3 + axis].data();
            }
            all.count = count;
            return all;
        }
    };

    // Of the surface that is asked for:
    std::vector<ShadowBody> numbers_; // of the bodies
    bool may_have_balls_ = false;     // whether the light is a uniform sphere, and balls are among the bodies
    std::vector<std::byte> scratch_;

    // Of one block:
    std::array<double, block> near_{};      // transport::NearBodies
    std::array<double, block> past_ball_{}; // the share of illuminance; negative where it is not known
    ChosenPoints behind_;                   // a ball each, of which these are middle and radius
    std::array<std::array<double, block>, 3> middle_{};
    std::array<double, block> radius_{};
    ChosenPoints left_; // need lines
    std::array<double, block> visible_{};
    std::array<double, block> hiding_{};
    std::vector<float> cells_; // their visible shares, solid angles and directions

    // Of one point:
    using OfCells = std::array<float, transport::ShadowShares::cells>;
    OfCells seen_{};
    OfCells light_of_{}; // its solid angle times its luminance over the mean
    std::array<OfCells, 3> towards_{};
};

} // namespace gonio::detail
