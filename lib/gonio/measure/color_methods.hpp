// Methods for the colour of a temperature and the temperature of a colour: error against the 1 nm sum, and time.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/color/cct.hpp>
#include <gonio/color/chromaticity.hpp>
#include <gonio/measure/timing.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace gonio::measure {

// One method for the colour of a temperature, in one code.
struct ColorSubject {
    std::string name; // "sum-1nm", "fit", "krystek"
    std::string code; // "double", or the instruction set of a batch kernel
    Kelvin coolest;   // of its valid range, within 800–25000 K
    Kelvin hottest;
    std::function<void(const std::vector<Kelvin>&, std::vector<glm::dvec3>&)> xyz; // of each temperature
    TimedWork timed;                                                               // over its range
};

// The sum first, then the kernels of every instruction set and all of color_methods().
std::vector<ColorSubject> color_subjects();

// One method for the temperature of a colour, in double.
struct CctSubject {
    std::string name; // "newton-on-sum", "mccamy"
    double (*cct_k)(Uv at);
};

// Newton on the sum first, then all of cct_methods().
std::vector<CctSubject> cct_subjects();

struct OffLocus;

// Calls `cct_k` for each case.
TimedWork timed_cct(double (*cct_k)(Uv), std::vector<OffLocus> cases);

// Forward: Δu'v' over temperatures spaced uniformly in mired, from the hottest of the method's range (25000 K at most)
// to its coolest (800 K at least).
struct ColorMeasurement {
    std::string name;
    std::string code; // "double", or the instruction set of a batch kernel
    Kelvin coolest;
    Kelvin hottest;
    double worst = 0.0; // Δu'v'
    Kelvin worst_at;
    double rms = 0.0;
    double worst_2_to_10_kk = 0.0; // between 2000 and 10000 K
    double luminance_2700k = 1.0;  // of a light whose exact luminance is 1
    Timing timing;                 // per value
};

// Backward: kelvin, over 1500–40000 K with |Duv| ≤ 0.05, and over 2000–10000 K with |Duv| ≤ 0.005.
struct CctMeasurement {
    std::string name;
    double worst_wide_k = 0.0; // infinite if the method gives no result for some cases
    double worst_near_k = 0.0;
    Timing timing; // per value, over the narrow set
};

struct ColorComparisonOptions {
    std::size_t cases = 2000; // temperatures; chromaticities in each of the two sets
    TimingOptions timing;
};

// The sum, the kernels of every instruction set and all of color_methods(). Fails as time_work does.
Result<std::vector<ColorMeasurement>> compare_color_methods(const ColorComparisonOptions& options = {});

// Newton on the sum and all of cct_methods(). Fails as time_work does.
Result<std::vector<CctMeasurement>> compare_cct_methods(const ColorComparisonOptions& options = {});

// Temperatures spaced uniformly in mired, both ends included.
std::vector<Kelvin> temperatures_between(Kelvin coolest, Kelvin hottest, std::size_t count);

// A chromaticity and the temperature that it was made from, along the normal of the sum's locus.
struct OffLocus {
    Uv at;
    Cct truth;
};
// Seeded; uniform in mired and in Duv.
std::vector<OffLocus> chromaticities_between(Kelvin coolest, Kelvin hottest, double greatest_duv, std::size_t count);

} // namespace gonio::measure
