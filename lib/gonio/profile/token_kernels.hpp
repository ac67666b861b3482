// Reading the numbers of a table in bulk on the widest vector unit of the machine. Internal.
//
// Reading numbers one by one makes each wait for the length of the one before. Here 64 bytes are classified at once,
// which shows where numbers begin and end; then several numbers are converted together, each independently of the
// others. Every instruction set gives the same bits and stops at the same byte as any other: a number that it leaves is
// read by NumberScanner::next() or as a line of its own, so that all of this decides only the speed.
#pragma once

#include <gonio/simd/dispatch.hpp>

#include <cstddef>

namespace gonio::profile_detail {

// How numbers are separated.
enum class Separators {
    any,  // LM-63: blanks, commas and line ends
    lines // EULUMDAT: each number is directly followed by CR LF, LF or CR, and the next one by nothing else
};

// What is read, and what was.
struct NumberRun {
    const char* at = nullptr;  // where to begin; then after the last number, or, of lines, after its line
    const char* end = nullptr; // of the text
    double* numbers = nullptr; // room for `wanted` numbers
    std::size_t wanted = 0;
    std::size_t taken = 0;
    const char* last = nullptr; // where the last number begins
    double lowest = 0.0;        // both are widened to include the numbers
    double highest = 0.0;
    // Converts what has more than eight characters, or is no number; false if that needs another method.
    bool (*convert)(const char* begin, const char* end, double& value) = nullptr;
};

struct TokenKernels {
    simd::InstructionSet set;
    // Takes numbers until there are enough, or one cannot be taken. At least eight bytes of text must lie before `at`,
    // which begins a number or, unless numbers are lines, ends one. decimal_lookahead bytes follow every number that is
    // taken.
    void (*read)(NumberRun& run, Separators separators);
};

// The kernels of `set`, or the scalar ones if the machine does not have it.
const TokenKernels& token_kernels(simd::InstructionSet set);

// Those that readers on this thread use: by default of the best set available. nullptr: numbers are read one by one.
const TokenKernels* token_kernels_in_use();

// For tests: readers on this thread use `kernels` within the scope.
class UseTokenKernels {
public:
    explicit UseTokenKernels(const TokenKernels* kernels);
    UseTokenKernels(const UseTokenKernels&) = delete;
    UseTokenKernels& operator=(const UseTokenKernels&) = delete;
    ~UseTokenKernels();

private:
    const TokenKernels* before_;
};

extern const TokenKernels token_kernels_scalar;
extern const TokenKernels token_kernels_sse2;
extern const TokenKernels token_kernels_avx2;
extern const TokenKernels token_kernels_avx512;
extern const TokenKernels token_kernels_neon;
extern const TokenKernels token_kernels_wasm128;

} // namespace gonio::profile_detail
