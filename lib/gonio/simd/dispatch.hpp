// Instruction sets at run time: which sets exist, which this machine has, and their names.
//
// The library is built for the least capable processor of its architecture. Code that needs more is in separate source
// files and is reached through function pointers, only after a check with the functions below. Nothing fails, nothing
// allocates.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio::simd {

// `avx2` includes FMA; `avx512` means F, DQ, BW and VL; `wasm128` is the SIMD of WebAssembly. Ascending preference
// within an architecture.
enum class InstructionSet : std::uint8_t { scalar, sse2, neon, avx2, avx512, wasm128 };

// "scalar", "sse2", "neon", "avx2", "avx512", "wasm128": the names that `--simd` takes.
const char* to_text(InstructionSet set);

// The set with that name; empty if there is none. Independent of this machine: use `available` for that.
std::optional<InstructionSet> parse_instruction_set(std::string_view name);

// Every name that parse_instruction_set takes, in the order of the enumeration.
std::span<const std::string_view> instruction_set_names();

// Whether this build has code for `set` and this machine (processor and system) runs it. `scalar` always is.
bool available(InstructionSet set);

// The available sets, `scalar` first, the widest last.
std::span<const InstructionSet> available_sets();

// The last of available_sets().
InstructionSet best_available();

} // namespace gonio::simd
#pragma GCC visibility pop
