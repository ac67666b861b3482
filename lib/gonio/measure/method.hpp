// A method that computes a number for each case of a set, in one code: the subject of every measurement.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace gonio::measure {

// Exactly one of the two functions is set, according to the precision; the span has one element per case.
template<class Cases>
struct Method {
    std::string name;      // "exact", "frostbite", "point", "ue4"
    std::string precision; // "double", "float", or the instruction set of a kernel: "avx2"
    std::function<void(const Cases&, std::span<float>)> evaluate;
    std::function<void(const Cases&, std::span<double>)> evaluate_double;
};

// Calls the method's function once; returns the results as doubles.
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

} // namespace gonio::measure
