// What is measured of a method, whatever its shape: its error against the truth and its time, by stratum too.
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
#include <utility>
#include <vector>

namespace gonio::measure {

// A way to take E/L of each of `Cases`. One of the two functions is set: that of its precision; the span is as long as
// the cases.
template<class Cases>
struct Method {
    std::string name;      // "exact", "frostbite", "point", "ue4"
    std::string precision; // "double", "float", or the instruction set of a kernel: "avx2"
    std::function<void(const Cases&, std::span<float>)> evaluate;
    std::function<void(const Cases&, std::span<double>)> evaluate_double;
};

struct MethodMeasurement {
    std::string name;
    std::string precision;
    ErrorStatistics error; // over all cases
    std::array<ErrorStatistics, stratum_count> error_by_stratum;
    Timing timing; // per receiver, all strata in turn
    std::array<Timing, stratum_count> timing_by_stratum;
};

struct ComparisonOptions {
    std::size_t cases = 4000;
    std::uint64_t seed = 1;
    // Relative errors are taken where E/L is above this; below it a method's absolute error tells more.
    double relative_floor = 1e-6;
    TimingOptions timing;
    // Timed in each stratum too, on this many cases; 0: not.
    std::size_t cases_by_stratum = 0;
};

// Fills the errors of `measured`, over all and by stratum, from what a method gave; all spans of one length.
void fill_errors(MethodMeasurement& measured, std::span<const double> values, std::span<const double> truth,
                 std::span<const Stratum> strata, double relative_floor);

// Calls the method's function once; the results as doubles.
template<class Cases>
std::vector<double> evaluated(const Method<Cases>& method, const Cases& cases) {
    std::vector<double> values(cases.size());
    if (method.evaluate_double) {
        method.evaluate_double(cases, values);
        return values;
    }
    std::vector<float> single(cases.size());
    method.evaluate(cases, single);
    values.assign(single.begin(), single.end());
    return values;
}

template<class Cases>
Result<Timing> timed(const Method<Cases>& method, const Cases& cases, const TimingOptions& options) {
    std::vector<float> single(cases.size());
    std::vector<double> values(cases.size());
    const auto work = [&] {
        if (method.evaluate_double) {
            method.evaluate_double(cases, values);
        } else {
            method.evaluate(cases, single);
        }
    };
    return time_work(work, cases.size(), options);
}

// Measures each method on the same cases. `of_stratum` makes cases of one stratum. Fails as time_work does.
template<class Cases, class OfStratum>
Result<std::vector<MethodMeasurement>> compare_methods(const std::vector<Method<Cases>>& methods, const Cases& cases,
                                                       std::span<const double> truth, const OfStratum& of_stratum,
                                                       const ComparisonOptions& options) {
    std::vector<Cases> strata;
    for (std::size_t s = 0; s < stratum_count && options.cases_by_stratum > 0; ++s)
        strata.push_back(of_stratum(static_cast<Stratum>(s)));
    std::vector<MethodMeasurement> measurements;
    for (const Method<Cases>& method : methods) {
        MethodMeasurement measured{method.name, method.precision, {}, {}, {}, {}};
        Result<Timing> timing = timed(method, cases, options.timing);
        if (!timing) return pass_on(timing);
        measured.timing = *timing;
        for (std::size_t s = 0; s < strata.size(); ++s) {
            Result<Timing> of_one = timed(method, strata[s], options.timing);
            if (!of_one) return pass_on(of_one);
            measured.timing_by_stratum[s] = *of_one;
        }
        fill_errors(measured, evaluated(method, cases), truth, cases.stratum, options.relative_floor);
        measurements.push_back(std::move(measured));
    }
    return measurements;
}

} // namespace gonio::measure
