// Error against time of every method that gonio has for the irradiance of a sphere.
#pragma once

#include <gonio/measure/method.hpp>
#include <gonio/measure/sphere_cases.hpp>

#include <vector>

namespace gonio::measure {

using SphereMethod = Method<SphereCases>;

// exact: in double, one float at a time, and the kernel of each available set; frostbite and point: in float; frostbite
// also as a kernel of each set. (UE4 treats a sphere as a point.)
std::vector<SphereMethod> sphere_methods();

// E/L of each case, by quadrature (sphere_truth.hpp) on `threads` threads, 0 = all.
std::vector<double> sphere_truth(const SphereCases& cases, unsigned threads = 0);

} // namespace gonio::measure
