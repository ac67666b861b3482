// Error against time of every method for the irradiance of a disk, rectangle, tube or cylinder.
#pragma once

#include <gonio/measure/area_cases.hpp>
#include <gonio/measure/method.hpp>

#include <vector>

namespace gonio::measure {

using AreaMethod = Method<AreaCases>;

// exact: in double, one float at a time, and the kernel of each available set. frostbite, point and, for the tube, ue4:
// in float; frostbite and ue4 also as a kernel of each set. Empty for punctual and sphere (sphere_methods.hpp has the
// sphere).
std::vector<AreaMethod> area_methods(shading::LightConstants::Kind kind);

// E/L of each case by the closed form in double, which the tests compare with quadrature.
std::vector<double> area_truth(const AreaCases& cases);

} // namespace gonio::measure
