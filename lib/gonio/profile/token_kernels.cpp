#include <gonio/profile/token_kernels.hpp>
#include <gonio/simd/kernel_choice.hpp>

namespace gonio::profile_detail {

namespace {

const TokenKernels*& in_use() {
    thread_local const TokenKernels* kernels = &token_kernels(simd::best_available());
    return kernels;
}

} // namespace

const TokenKernels& token_kernels(simd::InstructionSet set) {
    return GONIO_CHOSEN_KERNELS(set, token_kernels);
}

const TokenKernels* token_kernels_in_use() {
    return in_use();
}

UseTokenKernels::UseTokenKernels(const TokenKernels* kernels) : before_(in_use()) {
    in_use() = kernels;
}

UseTokenKernels::~UseTokenKernels() {
    in_use() = before_;
}

} // namespace gonio::profile_detail
