#include <gonio/asset/content_hash.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace gonio {

namespace {

using Word = std::uint32_t;

// FIPS 180-4, sections 4.2.2 and 5.3.3.
constexpr std::array<Word, 64> round_constants{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};
constexpr std::array<Word, 8> first_state{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                          0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};

constexpr std::size_t block_size = 64;

// Section 6.2.2, with the schedule of words kept in a ring of 16.
void add_block(std::array<Word, 8>& state, const char* block) {
    std::array<Word, 16> w{};
    for (std::size_t i = 0; i < w.size(); ++i)
        for (std::size_t byte = 0; byte < 4; ++byte)
            w[i] = w[i] << 8U | static_cast<unsigned char>(block[4 * i + byte]);
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t t = 0; t < round_constants.size(); ++t) {
        const std::size_t i = t % 16;
        if (t >= 16) {
            const Word w15 = w[(t + 1) % 16];
            const Word w2 = w[(t + 14) % 16];
            w[i] += (std::rotr(w15, 7) ^ std::rotr(w15, 18) ^ w15 >> 3U) + w[(t + 9) % 16] +
                    (std::rotr(w2, 17) ^ std::rotr(w2, 19) ^ w2 >> 10U);
        }
        const Word t1 = h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + ((e & f) ^ (~e & g)) +
                        round_constants[t] + w[i];
        const Word t2 = (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
        h = g;
        g = f;
        f = e;
        e = d + t1;
        d = c;
        c = b;
        b = a;
        a = t1 + t2;
    }
    const std::array<Word, 8> sum{a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < sum.size(); ++i)
        state[i] += sum[i];
}

} // namespace

std::string sha256(std::string_view bytes) {
    std::array<Word, 8> state = first_state;
    std::string_view rest = bytes;
    for (; rest.size() >= block_size; rest.remove_prefix(block_size))
        add_block(state, rest.data());

    // Section 5.1.1: a one bit, zeros, and the length in bits.
    std::array<char, 2 * block_size> end{};
    rest.copy(end.data(), rest.size());
    end[rest.size()] = '\x80';
    const std::size_t length = rest.size() + 9 <= block_size ? block_size : 2 * block_size;
    std::uint64_t bits = std::uint64_t{bytes.size()} * 8;
    for (std::size_t i = length; bits != 0; bits >>= 8U)
        end[--i] = static_cast<char>(bits & 0xFFU);
    for (std::size_t at = 0; at < length; at += block_size)
        add_block(state, end.data() + at);

    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const Word word : state)
        for (unsigned shift = 32; shift != 0;)
            text += digits[word >> (shift -= 4) & 15U];
    return text;
}

} // namespace gonio
