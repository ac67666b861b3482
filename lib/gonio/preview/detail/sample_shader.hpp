// One light at points of one surface, by the method that is asked for.
//
// exact, ltc and the methods named after a specular: the kernels of shading/. point, and ue4 for flat lights: every
// light as a point with the intensity that it sends to each place. frostbite and ue4 else: their irradiance takes the
// exact one's place in the diffuse part, highlights are by the method that their authors took: dominant-direction and
// representative-point. reference: quadrature, point by point.
#pragma once

#include <gonio/preview/detail/lit_scene.hpp>
#include <gonio/preview/detail/tile_samples.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace gonio::detail {

class SampleShader {
public:
    explicit SampleShader(const LitScene& scene) : scene_(scene) {}

    // Of samples [first, first + count): those of weight 0 may be left out.
    void shade(const LitLight& light, const SurfaceSamples& samples, std::size_t first, std::size_t count,
               const float* weight);

    // Of the last call, `count` each.
    const std::array<std::vector<float>, 3>& rgb() const { return rgb_; } // luminance [nt]
    const std::vector<float>& lx() const { return lx_; }                  // where illuminance is asked for

    // Samples whose quadrature ended before the error that was asked for.
    std::size_t not_converged() const { return not_converged_; }

private:
    void integrate(const LitLight& light, const SurfaceSamples& samples, std::size_t first, const float* weight);
    void approximate(const LitLight& light, const shading::Surfaces& surfaces, const shading::LightConstants& constants,
                     std::size_t surface);

    const LitScene& scene_;
    std::vector<float> intensity_;
    std::array<std::vector<float>, 3> rgb_;
    std::array<std::vector<float>, 3> diffuse_;
    std::vector<float> lx_;
    std::vector<float> approximate_lx_;
    std::vector<float> side_lx_;
    std::size_t not_converged_ = 0;
};

} // namespace gonio::detail
