// Angles of many directions on the widest vector unit of the machine: the arc tangent in doubles.
//
// Without fused products, so all instruction sets give the same bits. No function here allocates or fails. Internal to
// the library.
#pragma once

#include <gonio/simd/dispatch.hpp>

#include <cstddef>

namespace gonio::web_detail {

struct AngleKernels {
    simd::InstructionSet set;
    // simd::angle_deg() of `count` pairs.
    void (*angles_deg)(std::size_t count, const double* y, const double* x, double* deg);
};

// The kernels of `set`, or the scalar ones if the machine does not have it.
const AngleKernels& angle_kernels(simd::InstructionSet set);

namespace detail {
extern const AngleKernels angle_kernels_scalar;
extern const AngleKernels angle_kernels_sse2;
extern const AngleKernels angle_kernels_avx2;
extern const AngleKernels angle_kernels_avx512;
extern const AngleKernels angle_kernels_neon;
extern const AngleKernels angle_kernels_wasm128;
} // namespace detail

} // namespace gonio::web_detail
