// Storing runs of texels on the widest unit that the machine has.
//
// Computed in double with two roundings for each product and sum, and added up in eight sums whatever the width: every
// instruction set gives the same bits. No function here allocates or fails.
#pragma once

#include <gonio/bake/texture.hpp>
#include <gonio/simd/dispatch.hpp>

#include <cstddef>

namespace gonio::bake {

// Of texel k the mean is mean + k·mean_step, and the web's value at its centre center + k·center_step.
struct Ramp {
    double mean = 0.0;
    double mean_step = 0.0;
    double center = 0.0;
    double center_step = 0.0;
};

struct RampTotals {
    double sum = 0.0;      // of what is stored
    double error = 0.0;    // greatest |stored − centre|
    double rounding = 0.0; // greatest |stored − mean|, negative means as 0
    double least = 0.0;    // the least mean, where one is below 0
};

struct Kernels {
    simd::InstructionSet set;
    // Stores `count` ≥ 1 texels of `type` as floats; all in the texture's own unit.
    RampTotals (*store_ramp)(const Ramp& ramp, TexelType type, float* texels, std::size_t count);
};

// Those of `set`, or the scalar ones where the machine has it not.
const Kernels& kernels(simd::InstructionSet set);

namespace detail {
extern const Kernels kernels_scalar;
#if defined(__x86_64__)
extern const Kernels kernels_sse2;
extern const Kernels kernels_avx2;
extern const Kernels kernels_avx512;
#elif defined(__aarch64__)
extern const Kernels kernels_neon;
#endif
} // namespace detail

} // namespace gonio::bake
