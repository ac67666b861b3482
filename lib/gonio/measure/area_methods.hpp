// Error against time of every way in which gonio can take the irradiance of a disk, rectangle or tube.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/measure/area_cases.hpp>
#include <gonio/measure/sphere_methods.hpp>

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace gonio::measure {

struct AreaMethod {
    std::string name;      // "exact", "frostbite", "point", "ue4"
    std::string precision; // "double", "float", or the instruction set of a kernel: "avx2"
    // One E/L per case; both of one length.
    std::function<void(const AreaCases&, std::span<float>)> evaluate;
};

// exact: in double, one float at a time, and the kernel of each available set; frostbite, point and, for the tube, ue4:
// float. None for punctual and sphere (sphere_methods.hpp has those).
std::vector<AreaMethod> area_methods(shading::LightConstants::Kind kind);

// E/L of each case by the closed form in double, which the tests hold against quadrature.
std::vector<double> area_truth(const AreaCases& cases);

// Measures each method of `kind` on the same cases, as compare_sphere_methods does. Fails as time_work does.
Result<std::vector<SphereMeasurement>> compare_area_methods(shading::LightConstants::Kind kind,
                                                            const SphereComparison& options = {});

} // namespace gonio::measure
