#include <gonio/bake/kernels_impl.hpp>

namespace gonio::bake::detail {

constinit const Kernels kernels_neon{simd::InstructionSet::neon, store_any<NativeDoubles<simd::neon>>};

} // namespace gonio::bake::detail
