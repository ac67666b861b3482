// The blocks of SHA-256 (FIPS 180-4, section 6.2.2).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace gonio::detail {

inline constexpr std::size_t sha256_block_size = 64; // bytes

using Sha256State = std::array<std::uint32_t, 8>;

// Adds `count` blocks of bytes to the state.
using AddSha256Blocks = void (*)(Sha256State& state, const char* blocks, std::size_t count);

void add_sha256_blocks(Sha256State& state, const char* blocks, std::size_t count);

// The same by the processor's own instructions, in a sixth of the time; null where it has none.
AddSha256Blocks sha256_instructions();

} // namespace gonio::detail
