#include <gonio/color/kernels_impl.hpp>

namespace gonio::color::detail {

constinit const Kernels kernels_scalar = kernels_of<float>(simd::InstructionSet::scalar, "scalar");

} // namespace gonio::color::detail
