// Evaluates a recorded function in C++, in float as a shader does, or in double, which leaves only the constants' and
// polynomials' rounding.
#pragma once

#include <gonio/shader/schedule.hpp>

#include <array>
#include <span>
#include <vector>

namespace gonio::shader {

// A function that is to be evaluated many times; it refers to `function`.
class Evaluator {
public:
    explicit Evaluator(const Function& function);

    // `inputs` holds the parameters one after the other, three numbers for a vector. The result of a scalar function is
    // in the first number.
    template<class T>
    std::array<T, 3> operator()(std::span<const T> inputs) const;
    template<class T>
    std::array<T, 3> operator()(const std::vector<T>& inputs) const {
        return (*this)(std::span<const T>(inputs));
    }

private:
    const Function& function_;
    std::vector<Step> steps_;
};

} // namespace gonio::shader
