#include <gonio/asset/content_hash.hpp>
#include <gonio/asset/detail/sha256_blocks.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace gonio {

std::string sha256(std::string_view bytes) {
    constexpr std::size_t block_size = detail::sha256_block_size;
    const detail::AddSha256Blocks instructions = detail::sha256_instructions();
    const detail::AddSha256Blocks add_blocks = instructions != nullptr ? instructions : detail::add_sha256_blocks;
    // FIPS 180-4, section 5.3.3.
    detail::Sha256State state{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                              0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    const std::size_t whole = bytes.size() / block_size;
    add_blocks(state, bytes.data(), whole);

    // Section 5.1.1: a one bit, zeros, and the length in bits.
    const std::string_view rest = bytes.substr(whole * block_size);
    std::array<char, 2 * block_size> end{};
    rest.copy(end.data(), rest.size());
    end[rest.size()] = '\x80';
    const std::size_t length = rest.size() + 9 <= block_size ? block_size : 2 * block_size;
    std::uint64_t bits = std::uint64_t{bytes.size()} * 8;
    for (std::size_t i = length; bits != 0; bits >>= 8U)
        end[--i] = static_cast<char>(bits & 0xFFU);
    add_blocks(state, end.data(), length / block_size);

    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const std::uint32_t word : state)
        for (unsigned shift = 32; shift != 0;)
            text += digits[word >> (shift -= 4) & 15U];
    return text;
}

} // namespace gonio
