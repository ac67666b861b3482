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
// as a kernel of each available set; ltc in double too. None for punctual.
std::vector<SpecularMethodUnderTest> specular_methods(shading::LightConstants::Kind kind);

// Luminance with F = 1 per luminance of the light of each case, by quadrature (specular_truth.hpp) on `threads`
// threads, 0 = all.
std::vector<double> specular_truth(const SpecularCases& cases, unsigned threads = 0);

// What the kernels' `scale` is, by the same formula in double: the light's centre lies at `center`, its own position is
// not read. 0 for punctual.
double specular_in_double(const shading::LightConstants& light, shading::SpecularMethod method,
                          shading::vec3<double> center, shading::vec3<double> normal, shading::vec3<double> view,
                          double alpha);

} // namespace gonio::measure
