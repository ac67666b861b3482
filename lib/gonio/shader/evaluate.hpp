// Evaluates a recorded function in C++, in float as a shader does, or in double, which leaves only the constants' and
// polynomials' rounding.
#pragma once

#include <gonio/shader/function.hpp>

#include <array>
#include <span>

namespace gonio::shader {

// `inputs` holds the parameters one after the other, three numbers for a vector. The result of a scalar function is in
// the first number.
template<class T>
std::array<T, 3> evaluate(const Function& function, std::span<const T> inputs);

} // namespace gonio::shader
