// The specular kernels of each instruction set, for the kernels that build on them.
#pragma once

#include <gonio/shading/kernels_specular.hpp>

namespace gonio::shading::detail {

// The tables, each defined in the file that is compiled for its instruction set.
extern const SpecularKernels specular_kernels_scalar;
extern const SpecularKernels specular_kernels_sse2;
extern const SpecularKernels specular_kernels_avx2;
extern const SpecularKernels specular_kernels_avx512;
extern const SpecularKernels specular_kernels_neon;
extern const SpecularKernels specular_kernels_wasm128;

} // namespace gonio::shading::detail
