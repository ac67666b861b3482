#include <gonio/simd/dispatch.hpp>

#include <array>
#include <cstddef>

namespace gonio::simd {

namespace {

constexpr std::array<std::string_view, 6> names{"scalar", "sse2", "neon", "avx2", "avx512", "wasm128"};

// The set that every machine of the architecture has; for WebAssembly, which refuses to load a module with what it
// lacks, the set that the module was compiled for.
#if defined(__x86_64__)
constexpr InstructionSet architecture_baseline = InstructionSet::sse2;
#elif defined(__aarch64__)
constexpr InstructionSet architecture_baseline = InstructionSet::neon;
#elif defined(__wasm_simd128__)
constexpr InstructionSet architecture_baseline = InstructionSet::wasm128;
#else
constexpr InstructionSet architecture_baseline = InstructionSet::scalar;
#endif

// What the processor supports and the system saves on a context switch; the compiler's runtime checks both.
bool machine_has(InstructionSet set) {
    if (set == architecture_baseline) return true;
#if !defined(GONIO_NO_SCALAR_KERNELS)
    if (set == InstructionSet::scalar) return true;
#endif
#if defined(__x86_64__)
    const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (set == InstructionSet::avx2) return has_avx2;
    if (set == InstructionSet::avx512)
        return has_avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
#endif
    return false;
}

struct Available {
    std::array<InstructionSet, names.size()> sets{};
    std::size_t count = 0;
};

const Available& machine() {
    static const Available found = [] {
        Available a;
        for (std::size_t i = 0; i < names.size(); ++i)
            if (machine_has(static_cast<InstructionSet>(i))) a.sets[a.count++] = static_cast<InstructionSet>(i);
        return a;
    }();
    return found;
}

} // namespace

const char* to_text(InstructionSet set) {
    return names[static_cast<std::size_t>(set)].data();
}

std::optional<InstructionSet> parse_instruction_set(std::string_view name) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name) return static_cast<InstructionSet>(i);
    return std::nullopt;
}

std::span<const std::string_view> instruction_set_names() {
    return names;
}

bool available(InstructionSet set) {
    for (const InstructionSet each : available_sets())
        if (each == set) return true;
    return false;
}

std::span<const InstructionSet> available_sets() {
    return {machine().sets.data(), machine().count};
}

InstructionSet best_available() {
    return available_sets().back();
}

} // namespace gonio::simd
