// Random poses for every formula that has a shader, and what the core in double answers: for the unit tests and for
// tests/shader, which runs the shaders.
#pragma once

#include <gonio/shader/formulas.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace gonio::shader {

struct Case {
    std::vector<float> inputs;      // the parameters, one after the other
    std::array<double, 3> expected; // by the core in double, on the same floats
    double scale;                   // what is added to the result before an error is divided by it
    bool is_near;                   // where `ShaderError::near` holds
};

std::vector<Case> random_cases(const Formula& formula, std::size_t count);

// The error of a result as `ShaderError` counts it.
double error_of(const Case& pose, const std::array<double, 3>& result, Type type);

} // namespace gonio::shader
