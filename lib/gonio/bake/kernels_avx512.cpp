#include <gonio/bake/kernels_impl.hpp>

namespace gonio::bake::detail {

constinit const Kernels kernels_avx512{simd::InstructionSet::avx512, store_any<NativeDoubles<simd::avx512>>};

} // namespace gonio::bake::detail
