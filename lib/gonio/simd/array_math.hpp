// The functions of math.hpp over arrays, by instruction set. Tests and measurements use them to reach the packs of a
// set that the rest of the program is not compiled for. A renderer calls its own kernels instead.
#pragma once

#include <gonio/simd/dispatch.hpp>

#include <cstddef>

namespace gonio::simd {

struct ArrayMath {
    using Unary = void (*)(const float* x, float* result, std::size_t count);
    using Binary = void (*)(const float* a, const float* b, float* result, std::size_t count);

    InstructionSet set;
    std::size_t lanes;
    Unary sqrt, exp2, log2, sin, cos, asin, acos, atan, atan_excess, atan_ratio_excess, atanh_ratio,
        reciprocal_power_of_two;
    Binary min, max, atan2, atan2_above, pow, copysign;
    // x² + 0.25² + 0.5² − r²; the middle terms make cancellation possible.
    Binary difference_of_squares;
    // a·b − b, formed in double and rounded once.
    Binary wide_product_less;
    // For each packet: the lanes where a > b, moved together, then 0 in the rest of the packet.
    Binary choose_greater;
};

// The functions of `set`, or the scalar ones where available(set) is false. Domains and errors: math.hpp.
const ArrayMath& array_math(InstructionSet set);
// The same on two packs at a time (twin.hpp); a single float stays single.
const ArrayMath& array_math_of_twins(InstructionSet set);

} // namespace gonio::simd
