// Error against time of every way in which gonio can take the irradiance of a sphere.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/measure/error_statistics.hpp>
#include <gonio/measure/sphere_cases.hpp>
#include <gonio/measure/timing.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace gonio::measure {

struct SphereMethod {
    std::string name;      // "exact", "frostbite", "point"
    std::string precision; // "double", "float", or the instruction set of a kernel: "avx2"
    // One E/L per case; both of one length.
    std::function<void(const SphereCases&, std::span<float>)> evaluate;
};

// exact: in double, one float at a time, and the kernel of each available set; frostbite and point: float.
std::vector<SphereMethod> sphere_methods();

// E/L of each case, by quadrature (sphere_truth.hpp) on `threads` threads, 0 = all.
std::vector<double> sphere_truth(const SphereCases& cases, unsigned threads = 0);

struct SphereMeasurement {
    std::string name;
    std::string precision;
    ErrorStatistics error; // over all cases
    std::array<ErrorStatistics, stratum_count> error_by_stratum;
    Timing timing; // per receiver
};

struct SphereComparison {
    std::size_t cases = 4000;
    std::uint64_t seed = 1;
    // Relative errors are taken where E/L is above this; below it a method's absolute error tells more.
    double relative_floor = 1e-6;
    TimingOptions timing;
};

// Fills the errors of `measured`, over all and by stratum, from what a method gave; all spans of one length.
void fill_errors(SphereMeasurement& measured, std::span<const float> values, std::span<const double> truth,
                 std::span<const Stratum> strata, double relative_floor);

// Measures each method on the same cases. Fails as time_work does.
Result<std::vector<SphereMeasurement>> compare_sphere_methods(const SphereComparison& options = {});

} // namespace gonio::measure
