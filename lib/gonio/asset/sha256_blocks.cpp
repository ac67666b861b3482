#include <gonio/asset/detail/sha256_blocks.hpp>

#include <bit>

#if defined(__x86_64__)
#include <cpuid.h>
#include <immintrin.h>
#endif

namespace gonio::detail {

namespace {

using Word = std::uint32_t;

// Section 4.2.2.
alignas(16) constexpr std::array<Word, 64> round_constants{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

// With the schedule of words kept in a ring of 16.
void add_block(Sha256State& state, const char* block) {
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
    const Sha256State sum{a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < sum.size(); ++i)
        state[i] += sum[i];
}

#if defined(__x86_64__)

// Intel's SHA extensions: an instruction for two rounds, whose registers hold a, b, e, f and c, d, g, h, and two for
// four words of the schedule.
__attribute__((target("sha,ssse3,sse4.1"))) void add_by_instructions(Sha256State& state, const char* blocks,
                                                                     std::size_t count) {
    const auto lane = [&](std::size_t i) { return static_cast<int>(state[i]); };
    __m128i abef = _mm_set_epi32(lane(0), lane(1), lane(4), lane(5));
    __m128i cdgh = _mm_set_epi32(lane(2), lane(3), lane(6), lane(7));
    const __m128i big_endian = _mm_set_epi8(12, 13, 14, 15, 8, 9, 10, 11, 4, 5, 6, 7, 0, 1, 2, 3);
    for (; count > 0; --count, blocks += sha256_block_size) {
        const __m128i abef_before = abef;
        const __m128i cdgh_before = cdgh;
        __m128i w[4]; // a ring
        for (std::size_t four = 0; four < 16; ++four) {
            __m128i& words = w[four % 4];
            const __m128i last = w[(four + 3) % 4];
            if (four < 4) {
                words = _mm_shuffle_epi8(_mm_loadu_si128(reinterpret_cast<const __m128i*>(blocks) + four), big_endian);
            } else {
                const __m128i seven_before = _mm_alignr_epi8(last, w[(four + 2) % 4], 4);
                words = _mm_add_epi32(_mm_sha256msg1_epu32(words, w[(four + 1) % 4]), seven_before);
                words = _mm_sha256msg2_epu32(words, last);
            }
            const __m128i added =
                _mm_add_epi32(words, _mm_load_si128(reinterpret_cast<const __m128i*>(round_constants.data()) + four));
            cdgh = _mm_sha256rnds2_epu32(cdgh, abef, added); // what was c, d, g, h is a, b, e, f after two rounds
            abef = _mm_sha256rnds2_epu32(abef, cdgh, _mm_shuffle_epi32(added, 0x0E));
        }
        abef = _mm_add_epi32(abef, abef_before);
        cdgh = _mm_add_epi32(cdgh, cdgh_before);
    }
    alignas(16) std::array<Word, 4> fe_ba{};
    alignas(16) std::array<Word, 4> hg_dc{};
    _mm_store_si128(reinterpret_cast<__m128i*>(fe_ba.data()), abef);
    _mm_store_si128(reinterpret_cast<__m128i*>(hg_dc.data()), cdgh);
    state = {fe_ba[3], fe_ba[2], hg_dc[3], hg_dc[2], fe_ba[1], fe_ba[0], hg_dc[1], hg_dc[0]};
}

bool has_instructions() {
    unsigned eax = 0;
    unsigned ebx = 0;
    unsigned ecx = 0;
    unsigned edx = 0;
    constexpr unsigned sha = 1U << 29U;
    return __get_cpuid_count(7, 0, &eax, &ebx, &ecx, &edx) != 0 && (ebx & sha) != 0 &&
           __builtin_cpu_supports("ssse3") && __builtin_cpu_supports("sse4.1");
}

#endif

} // namespace

void add_sha256_blocks(Sha256State& state, const char* blocks, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        add_block(state, blocks + i * sha256_block_size);
}

AddSha256Blocks sha256_instructions() {
#if defined(__x86_64__)
    static const bool is_there = has_instructions();
    if (is_there) return add_by_instructions;
#endif
    return nullptr;
}

} // namespace gonio::detail
