// The functions of math.hpp over arrays, by instruction set: how tests and measurements reach the packs of a set that
// the rest of the program is not compiled for. A renderer calls its own kernels instead.
#pragma once

#include <gonio/simd/dispatch.hpp>

#include <cstddef>

namespace gonio::simd {

struct ArrayMath {
    using Unary = void (*)(const float* x, float* result, std::size_t count);
    using Binary = void (*)(const float* a, const float* b, float* result, std::size_t count);

    InstructionSet set;
    Unary sqrt, exp2, log2, sin, cos, asin, acos, atan, atan_excess, reciprocal_power_of_two;
    Binary min, max, atan2, pow, copysign;
    // x² + 0.25² + 0.5² − r², whose middle terms make cancellation possible.
    Binary difference_of_squares;
};

// The functions of `set`, or the scalar ones where available(set) is false. Domains and errors: math.hpp.
const ArrayMath& array_math(InstructionSet set);

} // namespace gonio::simd
