// One light at points of one surface, by the requested method.
//
// exact, ltc and the methods named after a specular: the kernels of shading/. point, and ue4 for flat lights: every
// light as a point with the intensity that it sends to each position. frostbite, and ue4 for other lights: their
// irradiance replaces the exact one in the diffuse part; highlights are by the method that their authors used,
// dominant-direction and representative-point. reference: quadrature, point by point.
#pragma once

#include <gonio/transport/lit_scene.hpp>
#include <gonio/transport/point_form.hpp>
#include <gonio/transport/surface_samples.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace gonio::detail {

class SampleShader {
public:
    explicit SampleShader(const LitScene& scene) : scene_(scene) {}

    // Shades samples [first, first + count); those of weight 0 may be skipped.
    void shade(const LitLight& light, const SurfaceSamples& samples, std::size_t first, std::size_t count,
               const float* weight);

    // The same for a light that is not uniform, with its luminance as seen from its centre: rgb() and lx() are within
    // rgb_error() and lx_error() of what shade() gives. Only for lights with a LuminancePattern that
    // has_center_form().
    void shade_from_center(const LitLight& light, const SurfaceSamples& samples, std::size_t first, std::size_t count);

    // The same for a face of a luminous opening as a point at its centre, with the bounds that `forms` give, one for
    // each `of_form` samples. Only where all are bounded.
    void shade_as_point(const LitLight& light, std::span<const PointForm> forms, std::size_t of_form,
                        const SurfaceSamples& samples, std::size_t first, std::size_t count);

    // The illuminance alone, by `exact` and without regard to what occludes the light: only lx() is set.
    void illuminate(const LitLight& light, const SurfaceSamples& samples);

    // Results of the last call, `count` each.
    const std::array<std::vector<float>, 3>& rgb() const { return rgb_; } // luminance [nt]
    const std::vector<float>& lx() const { return lx_; }                  // only if illuminance is requested

    // Bounds of the last shade_from_center() or shade_as_point(), `count` each; infinite where there is none.
    const std::array<std::vector<float>, 3>& rgb_error() const { return rgb_error_; }
    const std::vector<float>& lx_error() const { return lx_error_; } // only if illuminance is requested

    // The number of samples at which the quadrature stopped before it reached the requested error.
    std::size_t not_converged() const { return not_converged_; }

private:
    // The shares of the luminance for `shade`, of the lobes and of all else.
    void find_luminance(const LitLight& light, const shading::Surfaces& surfaces, const SurfaceSamples& samples,
                        shading::LightConstants& constants);
    void integrate(const LitLight& light, const SurfaceSamples& samples, std::size_t first, const float* weight);
    void approximate(const LitLight& light, const shading::Surfaces& surfaces, const shading::LightConstants& constants,
                     std::size_t surface);

    const LitScene& scene_;
    std::vector<float> intensity_;
    std::array<std::vector<float>, 3> rgb_;
    std::array<std::vector<float>, 3> diffuse_;
    std::vector<float> lx_;
    std::array<std::vector<float>, 3> rgb_error_;
    std::vector<float> lx_error_;
    std::vector<float> share_error_;
    std::vector<float> approximate_lx_;
    std::vector<float> side_lx_;
    std::vector<float> share_;
    std::vector<float> glossy_share_;
    std::size_t not_converged_ = 0;
};

} // namespace gonio::detail
