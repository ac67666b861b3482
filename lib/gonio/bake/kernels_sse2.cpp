#include <gonio/bake/kernels_impl.hpp>

namespace gonio::bake::detail {

constinit const Kernels kernels_sse2{simd::InstructionSet::sse2, store_any<NativeDoubles<simd::sse2>>};

} // namespace gonio::bake::detail
