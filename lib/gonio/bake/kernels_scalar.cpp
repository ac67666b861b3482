#include <gonio/bake/kernels_impl.hpp>

namespace gonio::bake::detail {

constinit const Kernels kernels_scalar{simd::InstructionSet::scalar, store_any<ScalarDoubles>};

} // namespace gonio::bake::detail
