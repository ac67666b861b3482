#include <gonio/color/kernels_impl.hpp>
#include <gonio/simd/pack.hpp>

namespace gonio::color::detail {

constinit const Kernels kernels_neon = kernels_of<simd::pack<float, simd::neon>>(simd::InstructionSet::neon, "neon");

} // namespace gonio::color::detail
