// Soft shadows of lights with a size: the share of their light that is not blocked, as a factor on the unshadowed
// light.
//
// The ratio of E. Heitz, S. Hill and M. McGuire ("Combining Analytic Direct Illumination and Stochastic Shadows", I3D
// 2018): ∫ f ⟨n·l⟩ V dl over ∫ f ⟨n·l⟩ dl, both by the same samples, so that unshadowed points keep the closed form and
// shadowed points cannot exceed it. The paper samples points of the light at random; here the samples are the cells of
// a few lines over the light, and the hidden part of each cell is known exactly (scene/shadow_line.hpp). So there is no
// noise to filter, and overlapping solids are not counted twice. README.md has the error.
#pragma once

#include <gonio/scene/light_lines.hpp>
#include <gonio/scene/shadow_line.hpp>
#include <gonio/shading/kernels_reflectance.hpp>
#include <gonio/transport/lit_scene.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace gonio::detail {

class SoftShadow {
public:
    explicit SoftShadow(const LitScene& scene);

    // The light must have a surface at a finite distance.
    void begin(const LitLight& light);

    // The surfaces that may be between the light and the queried points of surface `own`; empty until the caller fills
    // it.
    std::vector<std::uint32_t>& bodies(std::size_t own) { return bodies_[own]; }

    // The share of the light's illuminance that reaches the point, in [0, 1]: exactly 1 if nothing is in the way,
    // exactly 0 if all lines are hidden. `own` is the surface that the point is on; it does not shadow itself.
    double visible(std::size_t own, const glm::dvec3& point, const glm::dvec3& normal);

    // The share of the luminance that the surface shows towards `view`, per channel, at the point of the last call of
    // visible().
    glm::vec3 visible_luminance(const glm::dvec3& view) const;

private:
    static constexpr std::size_t cell_count = 4; // of a line
    using Cells = std::array<double, light_line_count * cell_count>;

    void find_hidden();
    void find_light_of_cells();
    // The share of illuminance behind a single solid, if it has a closed form.
    std::optional<double> closed_form(const Primitive& body) const;
    double integrated() const;
    double luminance_from(const glm::dvec3& direction) const;

    const LitScene& scene_;
    const shading::ReflectanceKernels& reflectance_;
    const LitLight* light_ = nullptr;
    std::vector<std::vector<std::uint32_t>> bodies_; // by surface

    // For the last point:
    std::size_t own_ = 0;
    glm::dvec3 point_{0.0};
    glm::dvec3 normal_{0.0};
    std::vector<const Primitive*> near_; // the solids that may hide something at the point
    LightLines lines_;
    std::vector<std::array<HiddenPiece, light_line_count>> hidden_; // of each line, by each of near_
    Cells seen_{};                                                  // the visible share of each cell
    Cells light_of_{};                                              // its solid angle times its luminance over the mean
    std::array<glm::dvec3, light_line_count * cell_count> towards_{}; // its middle, unit
    double share_ = 1.0;
    double by_lines_ = 1.0; // the same by the lines only
};

} // namespace gonio::detail
