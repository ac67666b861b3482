// Error against time of every method for the specular luminance of an area light.
#pragma once

#include <gonio/measure/method.hpp>
#include <gonio/measure/specular_cases.hpp>
#include <gonio/shading/specular_method.hpp>
#include <gonio/shading/vec3.hpp>

#include <cstddef>
#include <vector>

namespace gonio::measure {

using SpecularMethodUnderTest = Method<SpecularCases>;

// ltc, representative-point, dominant-direction, specular-d, spherical-hack and sun-disk, each one float at a time and
// as a kernel of each available set; ltc also in double. ltc-share, the former default, in both, without a kernel.
// Empty for punctual.
std::vector<SpecularMethodUnderTest> specular_methods(shading::LightConstants::Kind kind);

// For each case the luminance with F = 1, per luminance of the light, by quadrature (specular_truth.hpp) on `threads`
// threads, 0 = all.
std::vector<double> specular_truth(const SpecularCases& cases, unsigned threads = 0);

// The kernels' `scale`, by the same formula in double. The light's centre is at `center`; its own position is not used.
// 0 for punctual.
double specular_in_double(const shading::LightConstants& light, shading::SpecularMethod method,
                          shading::vec3<double> center, shading::vec3<double> normal, shading::vec3<double> view,
                          double alpha);

} // namespace gonio::measure
