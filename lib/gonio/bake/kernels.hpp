// Storing runs of texels on the widest vector unit of the machine.
//
// Computed in double, with separate roundings for each product and sum, and added up in eight sums for every width: all
// instruction sets give the same bits. No function here allocates or fails.
#pragma once

#include <gonio/bake/texture.hpp>
#include <gonio/simd/dispatch.hpp>

#include <cstddef>

namespace gonio::bake {

// The mean of texel k is mean + k·mean_step, and the web's value at its centre is center + k·center_step.
struct Ramp {
    double mean = 0.0;
    double mean_step = 0.0;
    double center = 0.0;
    double center_step = 0.0;
};

struct RampTotals {
    double sum = 0.0;      // of the stored values
    double error = 0.0;    // greatest |stored − centre|
    double rounding = 0.0; // greatest |stored − mean|, negative means as 0
    double least = 0.0;    // the least mean, if one is below 0
};

struct Kernels {
    simd::InstructionSet set;
    // Stores `count` ≥ 1 texels of `type` as floats; all numbers are in the texture's unit.
    RampTotals (*store_ramp)(const Ramp& ramp, TexelType type, float* texels, std::size_t count);
};

// The kernels of `set`, or the scalar ones if the machine does not have it.
const Kernels& kernels(simd::InstructionSet set);

namespace detail {
extern const Kernels kernels_scalar;
extern const Kernels kernels_sse2;
extern const Kernels kernels_avx2;
extern const Kernels kernels_avx512;
extern const Kernels kernels_neon;
extern const Kernels kernels_wasm128;
} // namespace detail

} // namespace gonio::bake
