// Finds and converts many numbers of a table at once. Internal.
//
// Reading numbers one by one makes each wait for the length of the one before. Here 64 bytes are classified without a
// branch per byte, which shows where numbers begin and end; then every number is converted independently.
#pragma once

#include <gonio/profile/fast_number.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace gonio::profile_detail {

struct ByteClasses {
    std::uint64_t numeric = 0; // bit i: byte i of 64 is one of -./0123456789
    bool other = false;        // whether any byte is neither one of those nor the end of a number
};

inline ByteClasses classify_portable(const char* p) {
    constexpr std::uint64_t ones = 0x0101010101010101U;
    constexpr std::uint64_t high = 0x80 * ones;
    ByteClasses classes;
    for (unsigned i = 0; i < 64; i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, p + i, sizeof word);
        const std::uint64_t low = word & ~high; // sums of seven bits do not reach the next byte
        const auto at_least = [&](std::uint64_t byte) { return low + (0x80 - byte) * ones; };
        const auto equals = [&](std::uint64_t byte) { return ~((low ^ (byte * ones)) + 0x7F * ones); };
        const std::uint64_t numeric = at_least('-') & ~at_least('9' + 1) & ~word & high;
        const std::uint64_t ends = (equals(' ') | equals(',') | (at_least('\t') & ~at_least('\r' + 1))) & ~word & high;
        classes.other = classes.other || (numeric | ends) != high;
        classes.numeric |= ((numeric >> 7U) * 0x0102040810204080U >> 56U) << i;
    }
    return classes;
}

inline ByteClasses classify_64(const char* p) {
#if defined(__SSE2__)
    ByteClasses classes;
    __m128i known = _mm_set1_epi8(-1);
    for (unsigned i = 0; i < 64; i += 16) {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): an unaligned load takes any address
        const __m128i bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(p + i));
        // Signed: bytes of 128 and more are below everything.
        const auto within = [&](char lowest, char highest) {
            return _mm_and_si128(_mm_cmpgt_epi8(bytes, _mm_set1_epi8(static_cast<char>(lowest - 1))),
                                 _mm_cmplt_epi8(bytes, _mm_set1_epi8(static_cast<char>(highest + 1))));
        };
        const __m128i numeric = within('-', '9');
        const __m128i ends = _mm_or_si128(within('\t', '\r'), _mm_or_si128(_mm_cmpeq_epi8(bytes, _mm_set1_epi8(' ')),
                                                                           _mm_cmpeq_epi8(bytes, _mm_set1_epi8(','))));
        known = _mm_and_si128(known, _mm_or_si128(numeric, ends));
        classes.numeric |= std::uint64_t{static_cast<std::uint32_t>(_mm_movemask_epi8(numeric))} << i;
    }
    classes.other = _mm_movemask_epi8(known) != 0xFFFF;
    return classes;
#else
    return classify_portable(p);
#endif
}

// Converts the token from `p` to `end`, which has no sign and consists of numeric bytes only (ByteClasses). At least
// eight bytes of text must lie before `p`, and decimal_lookahead bytes after `end`. False, with `value` unchanged, if
// the token needs another method, or is not a number.
inline bool convert_magnitude(const char* p, const char* end, double& value) {
    if constexpr (std::endian::native != std::endian::little) return false;
    const auto length = static_cast<std::size_t>(end - p);
    if (length > 8) [[unlikely]]
        return read_long_decimal(p, value) == end;
    // The word that ends with the token; bytes before the token are cleared.
    const std::uint64_t token = digits_at(end - 8) & (~std::uint64_t{0} << (64U - 8U * static_cast<unsigned>(length)));
    // Digits are 0 to 9 now, '.' is 0x1E, '-' 0x1D and '/' 0x1F: the bit 0x10 distinguishes them from digits, the bit 1
    // the point from the other two. One point is allowed, and none of the others.
    const std::uint64_t point = token & 0x1010101010101010U;
    if (((point & (point - 1)) | (token & (point >> 4U))) != 0) return false;
    static constexpr std::array<double, 9> powers{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e0}; // the last: no point
    std::uint64_t digits = token;
    double power = 1.0;
    if (point != 0) {
        if (length == 1) return false;
        // The digits before the point move up by one byte, over the point.
        const std::uint64_t before = (point >> 4U) - 1;
        digits = (token & ~(before | (point >> 4U) * 0xFF)) | (token & before) << 8U;
        power = powers[static_cast<std::size_t>(std::countl_zero(point)) / 8];
    }
    value = static_cast<double>(static_cast<std::int64_t>(number_of_digits(digits))) / power;
    return true;
}

// As convert_magnitude, for a token that may have a minus.
inline bool convert_token(const char* p, const char* end, double& value) {
    if (*p != '-') [[likely]]
        return convert_magnitude(p, end, value);
    double magnitude = 0.0;
    if (p + 1 == end || !convert_magnitude(p + 1, end, magnitude)) return false;
    value = -magnitude;
    return true;
}

// Calls take(begin, end) for every token from `p` on, as long as it returns true; stops at a byte of another kind and
// leaves the rest of the text. `p` must begin a token or end a number. Tokens within the last bytes before `end` are
// left too: decimal_lookahead bytes follow every token that is taken.
template<class Take>
void for_each_token(const char* p, const char* end, Take take) {
    const char* begin = nullptr; // of a token that began in the previous piece
    std::uint64_t before = 0;    // whether the byte before is numeric
    for (; end - p >= 64 + decimal_lookahead; p += 64) {
        const ByteClasses classes = classify_64(p);
        if (classes.other) return;
        std::uint64_t changes = classes.numeric ^ (classes.numeric << 1U | before);
        before = classes.numeric >> 63U;
        const auto next = [&] {
            const char* const at = p + std::countr_zero(changes);
            changes &= changes - 1;
            return at;
        };
        if (begin != nullptr) {
            if (changes == 0) continue;
            if (!take(begin, next())) return;
            begin = nullptr;
        }
        while (changes != 0) {
            begin = next();
            if (changes == 0) break;
            if (!take(begin, next())) return;
            begin = nullptr;
        }
    }
}

} // namespace gonio::profile_detail
