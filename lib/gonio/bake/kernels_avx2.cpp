#include <gonio/bake/kernels_impl.hpp>

namespace gonio::bake::detail {

constinit const Kernels kernels_avx2{simd::InstructionSet::avx2, store_any<NativeDoubles<simd::avx2>>};

} // namespace gonio::bake::detail
