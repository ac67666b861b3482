// The kernels of token_kernels.hpp as templates on the set's scalar; only kernels_tokens.cpp.in includes this.
// Internal.
//
// Everything is a template on S, whose name contains the instruction set, and calls no function of std::.
#pragma once

#include <gonio/profile/fast_number.hpp>
#include <gonio/profile/token_kernels.hpp>
#include <gonio/simd/instruction_sets.hpp>
#include <gonio/simd/pack.hpp>

#include <cstdint>
#include <cstring>

#if defined(__AVX2__)
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace gonio::profile_detail {

// Bit i: byte i of 64.
template<class S>
struct ByteMasks {
    std::uint64_t numeric; // one of -./0123456789
    std::uint64_t ends;    // of Separators::any: what ends a number
    std::uint64_t cr;      // of Separators::lines: CR
    std::uint64_t lf;      // and LF
};

// Tokens of one piece of a text, as offsets from its first byte. What lies between them separates numbers.
template<class S>
struct Tokens {
    static constexpr unsigned blocks = 16;                            // of 64 bytes, at most
    static constexpr std::size_t most = std::size_t{blocks} * 64 / 2; // a token and what ends it are two bytes
    static constexpr std::size_t overrun = 64;                        // entries that may be written behind the last
    std::uint32_t begins[most + overrun];
    std::uint32_t ends[most + overrun];
    std::size_t ended; // one may have begun after them, which goes on behind the piece
};

// --- One token at a time, on any machine.

template<class S>
struct TokenWords {
    static constexpr std::size_t lanes = 1;
    using Masks = ByteMasks<S>;

    static constexpr std::uint64_t bytes_of(std::uint64_t byte) { return byte * 0x0101010101010101U; }

    template<Separators separators>
    static Masks classify(const char* p) {
        Masks masks{};
#if defined(__SSE2__)
        for (unsigned i = 0; i < 64; i += 16) {
            // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): an unaligned load takes any address
            const __m128i bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(p + i));
            const auto within = [&](char lowest, char highest) {
                const __m128i above = _mm_sub_epi8(bytes, _mm_set1_epi8(lowest));
                const __m128i span = _mm_set1_epi8(static_cast<char>(highest - lowest));
                return _mm_cmpeq_epi8(_mm_min_epu8(above, span), above);
            };
            const auto equals = [&](char byte) { return _mm_cmpeq_epi8(bytes, _mm_set1_epi8(byte)); };
            const auto add = [&](std::uint64_t& mask, __m128i found) {
                mask |= std::uint64_t{static_cast<std::uint32_t>(_mm_movemask_epi8(found))} << i;
            };
            add(masks.numeric, within('-', '9'));
            if constexpr (separators == Separators::lines) {
                add(masks.cr, equals('\r'));
                add(masks.lf, equals('\n'));
            } else {
                add(masks.ends, _mm_or_si128(within('\t', '\r'), _mm_or_si128(equals(' '), equals(','))));
            }
        }
#else
        constexpr std::uint64_t high = bytes_of(0x80);
        for (unsigned i = 0; i < 64; i += 8) {
            std::uint64_t word = 0;
            std::memcpy(&word, p + i, sizeof word);
            const std::uint64_t low = word & ~high; // sums of seven bits do not reach the next byte
            const auto at_least = [&](std::uint64_t byte) { return low + bytes_of(0x80 - byte); };
            const auto equals = [&](std::uint64_t byte) { return ~((low ^ bytes_of(byte)) + bytes_of(0x7F)); };
            const auto add = [&](std::uint64_t& mask, std::uint64_t found) {
                mask |= (((found & ~word & high) >> 7U) * 0x0102040810204080U >> 56U) << i;
            };
            add(masks.numeric, at_least('-') & ~at_least('9' + 1));
            if constexpr (separators == Separators::lines) {
                add(masks.cr, equals('\r'));
                add(masks.lf, equals('\n'));
            } else {
                add(masks.ends, equals(' ') | equals(',') | (at_least('\t') & ~at_least('\r' + 1)));
            }
        }
#endif
        return masks;
    }

    // Lists offset + i for each bit i from `to` on; returns where the next goes.
    static std::uint32_t* list(std::uint64_t mask, std::uint32_t offset, std::uint32_t* to) {
        for (; mask != 0; mask &= mask - 1)
            *to++ = offset + static_cast<std::uint32_t>(__builtin_ctzll(mask));
        return to;
    }

    // Bit i of the result: token i is not a number of at most eight characters, and number i means nothing.
    static unsigned convert(const char* text, const std::uint32_t* begins, const std::uint32_t* ends, double* numbers) {
        if constexpr (__BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__) return 1;
        constexpr double powers[8] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7};
        const bool negative = text[*begins] == '-';
        const std::uint32_t length = *ends - *begins - (negative ? 1 : 0);
        if (length == 0 || length > 8) return 1;
        // The word that ends with the token; bytes before its first digit or point are cleared.
        std::uint64_t token = 0;
        std::memcpy(&token, text + *ends - 8, sizeof token);
        token = (token ^ bytes_of('0')) & ~std::uint64_t{0} << (64U - 8U * length);
        // Digits are 0 to 9 now, '.' is 0x1E, '-' 0x1D and '/' 0x1F: the bit 0x10 distinguishes them from digits, the
        // bit 1 the point from the other two. One point is allowed, and none of the others.
        const std::uint64_t point = token & bytes_of(0x10);
        if (((point & (point - 1)) | (token & point >> 4U)) != 0) return 1;
        double value = 0.0;
        if (point == 0) {
            value = static_cast<double>(static_cast<std::int64_t>(number_in(token)));
        } else {
            if (length == 1) return 1;
            // The digits before the point move up by one byte, over the point.
            const std::uint64_t before = (point >> 4U) - 1;
            const std::uint64_t digits = (token & ~(before | (point >> 4U) * 0xFF)) | (token & before) << 8U;
            value =
                static_cast<double>(static_cast<std::int64_t>(number_in(digits))) / powers[__builtin_clzll(point) / 8];
        }
        *numbers = negative ? -value : value;
        return 0;
    }

    // As convert(), for tokens of 9 to 16 characters; at least 16 bytes of text lie before their ends. Not here: the
    // method for one number is as fast.
    static constexpr bool converts_wide = false;

    // The number written by eight digits, the first in the lowest byte: pairs, fours, all eight.
    static std::uint64_t number_in(std::uint64_t digits) {
        digits = digits * 10 + (digits >> 8U);
        constexpr std::uint64_t pairs = 0x000000FF000000FFU;
        return (((digits & pairs) * 0x000F424000000064U) + ((digits >> 16U & pairs) * 0x0000271000000001U)) >> 32U;
    }

    static void widen(const double* numbers, std::size_t count, double& lowest, double& highest) {
        double low = lowest;
        double high = highest;
        for (std::size_t i = 0; i < count; ++i) {
            low = numbers[i] < low ? numbers[i] : low;
            high = numbers[i] > high ? numbers[i] : high;
        }
        lowest = low;
        highest = high;
    }
};

// --- Four tokens at a time.

#if defined(__AVX2__)

template<>
struct TokenWords<simd::pack<float, simd::avx2>> {
    static constexpr std::size_t lanes = 4;
    using Masks = ByteMasks<simd::pack<float, simd::avx2>>;

    template<Separators separators>
    static Masks classify(const char* p) {
        Masks masks{};
        for (unsigned i = 0; i < 64; i += 32) {
            // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): an unaligned load takes any address
            const __m256i bytes = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(p + i));
            const auto within = [&](char lowest, char highest) {
                const __m256i above = _mm256_sub_epi8(bytes, _mm256_set1_epi8(lowest));
                const __m256i span = _mm256_set1_epi8(static_cast<char>(highest - lowest));
                return _mm256_cmpeq_epi8(_mm256_min_epu8(above, span), above);
            };
            const auto equals = [&](char byte) { return _mm256_cmpeq_epi8(bytes, _mm256_set1_epi8(byte)); };
            const auto add = [&](std::uint64_t& mask, __m256i found) {
                mask |= std::uint64_t{static_cast<std::uint32_t>(_mm256_movemask_epi8(found))} << i;
            };
            add(masks.numeric, within('-', '9'));
            if constexpr (separators == Separators::lines) {
                add(masks.cr, equals('\r'));
                add(masks.lf, equals('\n'));
            } else {
                add(masks.ends, _mm256_or_si256(within('\t', '\r'), _mm256_or_si256(equals(' '), equals(','))));
            }
        }
        return masks;
    }

    // Eight at a time, and none of them waits for the number of entries: some written behind the last mean nothing.
    static std::uint32_t* list(std::uint64_t mask, std::uint32_t offset, std::uint32_t* to) {
        std::uint32_t* const behind = to + __builtin_popcountll(mask);
        while (to < behind)
            for (int i = 0; i < 8; ++i) {
                *to++ = offset + static_cast<std::uint32_t>(__builtin_ctzll(mask | std::uint64_t{1} << 63U));
                mask &= mask - 1;
            }
        return behind;
    }

    static unsigned convert(const char* text, const std::uint32_t* begins, const std::uint32_t* ends, double* numbers) {
        const auto word = [&](int i) {
            long long bytes = 0;
            std::memcpy(&bytes, text + ends[i] - 8, sizeof bytes);
            return bytes;
        };
        const auto offsets = [](const std::uint32_t* from) {
            // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): an unaligned load takes any address
            return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
        };
        const __m256i zero = _mm256_setzero_si256();
        const __m256i ones = _mm256_set1_epi8(1);
        const __m256i all = _mm256_set1_epi8(-1);
        const __m256i length = _mm256_cvtepu32_epi64(_mm_sub_epi32(offsets(ends), offsets(begins)));
        // The words that end with the tokens; bytes before a token are cleared, and all of those of a long one.
        const __m256i keep =
            _mm256_sllv_epi64(all, _mm256_sub_epi64(_mm256_set1_epi64x(64), _mm256_slli_epi64(length, 3)));
        const __m256i words = _mm256_set_epi64x(word(3), word(2), word(1), word(0));
        const __m256i token = _mm256_and_si256(_mm256_xor_si256(words, _mm256_set1_epi8('0')), keep);
        // Digits are 0 to 9 now, '-' 0x1D, '.' 0x1E and '/' 0x1F.
        const __m256i marks = _mm256_and_si256(_mm256_srli_epi64(token, 4), ones);
        const __m256i second = _mm256_srli_epi64(token, 1);
        const __m256i point = _mm256_andnot_si256(token, marks);
        const __m256i minus = _mm256_andnot_si256(second, marks);
        const __m256i kept = _mm256_and_si256(keep, ones);
        const __m256i first = _mm256_andnot_si256(_mm256_slli_epi64(keep, 8), kept);
        const __m256i before = _mm256_add_epi64(point, all); // all bits where there is no point
        const __m256i slash = _mm256_and_si256(marks, _mm256_and_si256(token, second));
        const __m256i wrong =
            _mm256_or_si256(slash, _mm256_or_si256(_mm256_andnot_si256(first, minus), _mm256_and_si256(point, before)));
        const __m256i fine =
            _mm256_andnot_si256(_mm256_cmpeq_epi64(kept, marks), _mm256_cmpeq_epi64(wrong, zero)); // and with digits
        const __m256i digits = _mm256_andnot_si256(_mm256_sub_epi8(zero, marks), token);
        // The digits before the point move up by one byte, over the point.
        const __m256i moved = _mm256_andnot_si256(_mm256_cmpeq_epi64(point, zero), before);
        const __m256i joined =
            _mm256_or_si256(_mm256_andnot_si256(moved, digits), _mm256_slli_epi64(_mm256_and_si256(digits, moved), 8));
        const __m256i number = number_in(joined);
        // By the bytes before the point; 8 where there is none.
        const __m256i index =
            _mm256_min_epi32(_mm256_sad_epu8(_mm256_and_si256(before, ones), zero), _mm256_set1_epi64x(7));
        const __m256i powers = _mm256_setr_epi32(10000000, 1000000, 100000, 10000, 1000, 100, 10, 1);
        const __m256i power =
            _mm256_blend_epi32(_mm256_permutevar8x32_epi32(powers, index), zero, 0xAA); // the upper half is powers[0]
        const __m256d value = _mm256_div_pd(to_double(number), to_double(power));
        const __m256d sign =
            _mm256_castsi256_pd(_mm256_andnot_si256(_mm256_cmpeq_epi64(minus, zero), _mm256_set1_epi64x(INT64_MIN)));
        _mm256_storeu_pd(numbers, _mm256_or_pd(value, sign));
        return ~static_cast<unsigned>(_mm256_movemask_pd(_mm256_castsi256_pd(fine))) & 0xFU;
    }

    static constexpr bool converts_wide = true;

    static unsigned convert_wide(const char* text, const std::uint32_t* begins, const std::uint32_t* ends,
                                 double* numbers) {
        const auto word = [&](int i, int before) {
            long long bytes = 0;
            std::memcpy(&bytes, text + ends[i] - before, sizeof bytes);
            return bytes;
        };
        const auto offsets = [](const std::uint32_t* from) {
            // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): an unaligned load takes any address
            return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
        };
        const __m256i zero = _mm256_setzero_si256();
        const __m256i ones = _mm256_set1_epi8(1);
        const __m256i all = _mm256_set1_epi8(-1);
        const __m256i zeros = _mm256_set1_epi8('0');
        const __m256i length = _mm256_cvtepu32_epi64(_mm_sub_epi32(offsets(ends), offsets(begins)));
        // The two words that end with the tokens; bytes before a token are cleared.
        const __m256i keep =
            _mm256_sllv_epi64(all, _mm256_sub_epi64(_mm256_set1_epi64x(128), _mm256_slli_epi64(length, 3)));
        const __m256i high_words = _mm256_set_epi64x(word(3, 16), word(2, 16), word(1, 16), word(0, 16));
        const __m256i low_words = _mm256_set_epi64x(word(3, 8), word(2, 8), word(1, 8), word(0, 8));
        const __m256i high = _mm256_and_si256(_mm256_xor_si256(high_words, zeros), keep);
        const __m256i low = _mm256_xor_si256(low_words, zeros);
        const __m256i high_marks = _mm256_and_si256(_mm256_srli_epi64(high, 4), ones);
        const __m256i low_marks = _mm256_and_si256(_mm256_srli_epi64(low, 4), ones);
        const __m256i high_second = _mm256_srli_epi64(high, 1);
        const __m256i high_point = _mm256_andnot_si256(high, high_marks);
        const __m256i low_point = _mm256_andnot_si256(low, low_marks);
        const __m256i minus = _mm256_andnot_si256(high_second, high_marks);
        const __m256i first = _mm256_andnot_si256(_mm256_slli_epi64(keep, 8), _mm256_and_si256(keep, ones));
        const __m256i high_before = _mm256_add_epi64(high_point, all);
        const __m256i low_before = _mm256_add_epi64(low_point, all);
        const __m256i no_high_point = _mm256_cmpeq_epi64(high_point, zero);
        const __m256i no_low_point = _mm256_cmpeq_epi64(low_point, zero);
        const __m256i slash = _mm256_and_si256(high_marks, _mm256_and_si256(high, high_second));
        const __m256i points =
            _mm256_or_si256(_mm256_and_si256(high_point, high_before), _mm256_and_si256(low_point, low_before));
        const __m256i wrong = _mm256_or_si256(
            _mm256_or_si256(slash, _mm256_andnot_si256(first, minus)),
            _mm256_or_si256(points, _mm256_and_si256(low_marks, low))); // in the low word only a point is right
        const __m256i one_point = _mm256_or_si256(no_high_point, no_low_point);
        const __m256i high_digits = _mm256_andnot_si256(_mm256_sub_epi8(zero, high_marks), high);
        const __m256i low_digits = _mm256_andnot_si256(_mm256_sub_epi8(zero, low_marks), low);
        // The digits before the point move up by one byte, over the point.
        const __m256i low_moved = _mm256_andnot_si256(no_low_point, low_before);
        const __m256i high_moved =
            _mm256_or_si256(_mm256_andnot_si256(no_low_point, all), _mm256_andnot_si256(no_high_point, high_before));
        const auto joined = [](__m256i digits, __m256i moved) {
            return _mm256_or_si256(_mm256_andnot_si256(moved, digits),
                                   _mm256_slli_epi64(_mm256_and_si256(digits, moved), 8));
        };
        const __m256i across = _mm256_andnot_si256(no_low_point, _mm256_srli_epi64(high_digits, 56));
        const __m256i upper = number_in(joined(high_digits, high_moved));
        const __m256i lower = number_in(_mm256_or_si256(joined(low_digits, low_moved), across));
        const __m256i number = _mm256_add_epi64(_mm256_mul_epu32(upper, _mm256_set1_epi64x(100000000)), lower);
        const __m256i before = _mm256_sad_epu8(
            _mm256_add_epi8(_mm256_and_si256(high_moved, ones), _mm256_and_si256(low_moved, ones)), zero);
        const __m256i decimals = _mm256_andnot_si256(_mm256_and_si256(no_high_point, no_low_point),
                                                     _mm256_sub_epi64(_mm256_set1_epi64x(15), before));
        alignas(32) static constexpr double powers[16] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                          1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
        const __m256d power = _mm256_i64gather_pd(powers, _mm256_and_si256(decimals, _mm256_set1_epi64x(15)), 8);
        const __m256d value = _mm256_div_pd(to_double(number), power);
        const __m256d sign =
            _mm256_castsi256_pd(_mm256_andnot_si256(_mm256_cmpeq_epi64(minus, zero), _mm256_set1_epi64x(INT64_MIN)));
        _mm256_storeu_pd(numbers, _mm256_or_pd(value, sign));
        const __m256i exact = _mm256_cmpeq_epi64(_mm256_srli_epi64(number, 52), zero);
        const __m256i fine = _mm256_and_si256(_mm256_cmpeq_epi64(wrong, zero), _mm256_and_si256(one_point, exact));
        return ~static_cast<unsigned>(_mm256_movemask_pd(_mm256_castsi256_pd(fine))) & 0xFU;
    }

    // The numbers written by eight digits each, the first in the lowest byte: pairs, fours, all eight.
    static __m256i number_in(__m256i digits) {
        const __m256i pairs = _mm256_maddubs_epi16(digits, _mm256_set1_epi16(0x010A)); // 10 and 1
        const __m256i fours = _mm256_madd_epi16(pairs, _mm256_set1_epi32(0x00010064)); // 100 and 1
        return _mm256_add_epi64(_mm256_mul_epu32(fours, _mm256_set1_epi64x(10000)), _mm256_srli_epi64(fours, 32));
    }

    // Exact below 2^52.
    static __m256d to_double(__m256i whole) {
        const __m256i exponent = _mm256_set1_epi64x(0x4330000000000000);
        return _mm256_sub_pd(_mm256_castsi256_pd(_mm256_or_si256(whole, exponent)), _mm256_castsi256_pd(exponent));
    }

    static void widen(const double* numbers, std::size_t count, double& lowest, double& highest) {
        __m256d low = _mm256_set1_pd(lowest);
        __m256d high = _mm256_set1_pd(highest);
        std::size_t i = 0;
        for (; i + 4 <= count; i += 4) {
            const __m256d four = _mm256_loadu_pd(numbers + i);
            low = _mm256_min_pd(four, low);
            high = _mm256_max_pd(four, high);
        }
        double lows[4];
        double highs[4];
        _mm256_storeu_pd(lows, low);
        _mm256_storeu_pd(highs, high);
        TokenWords<simd::avx2>::widen(numbers + i, count - i, lowest, highest);
        TokenWords<simd::avx2>::widen(lows, 4, lowest, highest);
        TokenWords<simd::avx2>::widen(highs, 4, lowest, highest);
    }
};

#endif

// --- Eight tokens at a time.

#if defined(__AVX512BW__)

template<>
struct TokenWords<simd::pack<float, simd::avx512>> {
    static constexpr std::size_t lanes = 8;
    using Masks = ByteMasks<simd::pack<float, simd::avx512>>;

    template<Separators separators>
    static Masks classify(const char* p) {
        const __m512i bytes = _mm512_loadu_si512(p);
        const auto within = [&](char lowest, char highest) {
            return std::uint64_t{_mm512_cmple_epu8_mask(_mm512_sub_epi8(bytes, _mm512_set1_epi8(lowest)),
                                                        _mm512_set1_epi8(static_cast<char>(highest - lowest)))};
        };
        const auto equals = [&](char byte) {
            return std::uint64_t{_mm512_cmpeq_epi8_mask(bytes, _mm512_set1_epi8(byte))};
        };
        Masks masks{};
        masks.numeric = within('-', '9');
        if constexpr (separators == Separators::lines) {
            masks.cr = equals('\r');
            masks.lf = equals('\n');
        } else {
            masks.ends = within('\t', '\r') | equals(' ') | equals(',');
        }
        return masks;
    }

    static std::uint32_t* list(std::uint64_t mask, std::uint32_t offset, std::uint32_t* to) {
        __m512i places = _mm512_add_epi32(_mm512_set1_epi32(static_cast<int>(offset)),
                                          _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
        for (unsigned i = 0; i < 64; i += 16) {
            const auto sixteen = static_cast<__mmask16>(mask >> i);
            _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(sixteen, places));
            to += __builtin_popcount(sixteen);
            places = _mm512_add_epi32(places, _mm512_set1_epi32(16));
        }
        return to;
    }

    static unsigned convert(const char* text, const std::uint32_t* begins, const std::uint32_t* ends, double* numbers) {
        const auto word = [&](int i) {
            long long bytes = 0;
            std::memcpy(&bytes, text + ends[i] - 8, sizeof bytes);
            return bytes;
        };
        const auto offsets = [](const std::uint32_t* from) {
            // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): an unaligned load takes any address
            return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
        };
        const __m512i zero = _mm512_setzero_si512();
        const __m512i ones = _mm512_set1_epi8(1);
        const __m512i all = _mm512_set1_epi8(-1);
        const __m512i length = _mm512_cvtepu32_epi64(_mm256_sub_epi32(offsets(ends), offsets(begins)));
        // The words that end with the tokens; bytes before a token are cleared, and all of those of a long one.
        const __m512i keep =
            _mm512_sllv_epi64(all, _mm512_sub_epi64(_mm512_set1_epi64(64), _mm512_slli_epi64(length, 3)));
        const __m512i words = _mm512_set_epi64(word(7), word(6), word(5), word(4), word(3), word(2), word(1), word(0));
        const __m512i token = _mm512_and_si512(_mm512_xor_si512(words, _mm512_set1_epi8('0')), keep);
        // Digits are 0 to 9 now, '-' 0x1D, '.' 0x1E and '/' 0x1F.
        const __m512i marks = _mm512_and_si512(_mm512_srli_epi64(token, 4), ones);
        const __m512i second = _mm512_srli_epi64(token, 1);
        const __m512i point = _mm512_andnot_si512(token, marks);
        const __m512i minus = _mm512_andnot_si512(second, marks);
        const __m512i kept = _mm512_and_si512(keep, ones);
        const __m512i first = _mm512_andnot_si512(_mm512_slli_epi64(keep, 8), kept);
        const __m512i before = _mm512_add_epi64(point, all); // all bits where there is no point
        const __m512i slash = _mm512_and_si512(marks, _mm512_and_si512(token, second));
        const __m512i wrong =
            _mm512_or_si512(slash, _mm512_or_si512(_mm512_andnot_si512(first, minus), _mm512_and_si512(point, before)));
        const unsigned bad = static_cast<unsigned>(_mm512_test_epi64_mask(wrong, wrong)) |
                             static_cast<unsigned>(_mm512_cmpeq_epi64_mask(kept, marks)); // no digit
        const __m512i digits = _mm512_andnot_si512(_mm512_sub_epi8(zero, marks), token);
        // The digits before the point move up by one byte, over the point.
        const __m512i moved = _mm512_maskz_mov_epi64(_mm512_test_epi64_mask(point, point), before);
        const __m512i joined =
            _mm512_or_si512(_mm512_andnot_si512(moved, digits), _mm512_slli_epi64(_mm512_and_si512(digits, moved), 8));
        const __m512i number = number_in(joined);
        // By the bytes before the point; 8 where there is none.
        const __m512i index = _mm512_sad_epu8(_mm512_and_si512(before, ones), zero);
        const __m512d powers = _mm512_setr_pd(1e7, 1e6, 1e5, 1e4, 1e3, 1e2, 1e1, 1e0);
        const __m512d power = _mm512_permutex2var_pd(powers, index, _mm512_set1_pd(1.0));
        const __m512d value = _mm512_div_pd(_mm512_cvtepi64_pd(number), power);
        const __m512i sign = _mm512_maskz_mov_epi64(_mm512_test_epi64_mask(minus, minus), _mm512_set1_epi64(INT64_MIN));
        _mm512_storeu_pd(numbers, _mm512_castsi512_pd(_mm512_or_si512(_mm512_castpd_si512(value), sign)));
        return bad;
    }

    static constexpr bool converts_wide = true;

    static unsigned convert_wide(const char* text, const std::uint32_t* begins, const std::uint32_t* ends,
                                 double* numbers) {
        const auto word = [&](int i, int before) {
            long long bytes = 0;
            std::memcpy(&bytes, text + ends[i] - before, sizeof bytes);
            return bytes;
        };
        const auto words = [&](int before) {
            return _mm512_set_epi64(word(7, before), word(6, before), word(5, before), word(4, before), word(3, before),
                                    word(2, before), word(1, before), word(0, before));
        };
        const auto offsets = [](const std::uint32_t* from) {
            // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): an unaligned load takes any address
            return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
        };
        const __m512i zero = _mm512_setzero_si512();
        const __m512i ones = _mm512_set1_epi8(1);
        const __m512i all = _mm512_set1_epi8(-1);
        const __m512i zeros = _mm512_set1_epi8('0');
        const __m512i length = _mm512_cvtepu32_epi64(_mm256_sub_epi32(offsets(ends), offsets(begins)));
        // The two words that end with the tokens; bytes before a token are cleared.
        const __m512i keep =
            _mm512_sllv_epi64(all, _mm512_sub_epi64(_mm512_set1_epi64(128), _mm512_slli_epi64(length, 3)));
        const __m512i high = _mm512_and_si512(_mm512_xor_si512(words(16), zeros), keep);
        const __m512i low = _mm512_xor_si512(words(8), zeros);
        const __m512i high_marks = _mm512_and_si512(_mm512_srli_epi64(high, 4), ones);
        const __m512i low_marks = _mm512_and_si512(_mm512_srli_epi64(low, 4), ones);
        const __m512i high_second = _mm512_srli_epi64(high, 1);
        const __m512i high_point = _mm512_andnot_si512(high, high_marks);
        const __m512i low_point = _mm512_andnot_si512(low, low_marks);
        const __m512i minus = _mm512_andnot_si512(high_second, high_marks);
        const __m512i first = _mm512_andnot_si512(_mm512_slli_epi64(keep, 8), _mm512_and_si512(keep, ones));
        const __m512i high_before = _mm512_add_epi64(high_point, all);
        const __m512i low_before = _mm512_add_epi64(low_point, all);
        const __mmask8 of_high = _mm512_test_epi64_mask(high_point, high_point);
        const __mmask8 of_low = _mm512_test_epi64_mask(low_point, low_point);
        const __m512i slash = _mm512_and_si512(high_marks, _mm512_and_si512(high, high_second));
        const __m512i points =
            _mm512_or_si512(_mm512_and_si512(high_point, high_before), _mm512_and_si512(low_point, low_before));
        const __m512i wrong = _mm512_or_si512(
            _mm512_or_si512(slash, _mm512_andnot_si512(first, minus)),
            _mm512_or_si512(points, _mm512_and_si512(low_marks, low))); // in the low word only a point is right
        const __m512i high_digits = _mm512_andnot_si512(_mm512_sub_epi8(zero, high_marks), high);
        const __m512i low_digits = _mm512_andnot_si512(_mm512_sub_epi8(zero, low_marks), low);
        // The digits before the point move up by one byte, over the point.
        const __m512i low_moved = _mm512_maskz_mov_epi64(of_low, low_before);
        const __m512i high_moved = _mm512_mask_mov_epi64(_mm512_maskz_mov_epi64(of_high, high_before), of_low, all);
        const auto joined = [](__m512i digits, __m512i moved) {
            return _mm512_or_si512(_mm512_andnot_si512(moved, digits),
                                   _mm512_slli_epi64(_mm512_and_si512(digits, moved), 8));
        };
        const __m512i across = _mm512_maskz_srli_epi64(of_low, high_digits, 56);
        const __m512i upper = number_in(joined(high_digits, high_moved));
        const __m512i lower = number_in(_mm512_or_si512(joined(low_digits, low_moved), across));
        const __m512i number = _mm512_add_epi64(_mm512_mul_epu32(upper, _mm512_set1_epi64(100000000)), lower);
        const __m512i before = _mm512_sad_epu8(
            _mm512_add_epi8(_mm512_and_si512(high_moved, ones), _mm512_and_si512(low_moved, ones)), zero);
        const auto has_point = static_cast<__mmask8>(of_high | of_low);
        const __m512i decimals = _mm512_maskz_sub_epi64(has_point, _mm512_set1_epi64(15), before);
        const __m512d power = _mm512_permutex2var_pd(_mm512_setr_pd(1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7), decimals,
                                                     _mm512_setr_pd(1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15));
        const __m512d value = _mm512_div_pd(_mm512_cvtepi64_pd(number), power);
        const __m512i sign = _mm512_maskz_mov_epi64(_mm512_test_epi64_mask(minus, minus), _mm512_set1_epi64(INT64_MIN));
        _mm512_storeu_pd(numbers, _mm512_castsi512_pd(_mm512_or_si512(_mm512_castpd_si512(value), sign)));
        const __m512i large = _mm512_srli_epi64(number, 52); // not exact
        return static_cast<unsigned>(_mm512_test_epi64_mask(wrong, wrong)) |
               static_cast<unsigned>(_mm512_test_epi64_mask(large, large)) | static_cast<unsigned>(of_high & of_low);
    }

    // The numbers written by eight digits each, the first in the lowest byte: pairs, fours, all eight.
    static __m512i number_in(__m512i digits) {
        const __m512i pairs = _mm512_maddubs_epi16(digits, _mm512_set1_epi16(0x010A)); // 10 and 1
        const __m512i fours = _mm512_madd_epi16(pairs, _mm512_set1_epi32(0x00010064)); // 100 and 1
        return _mm512_add_epi64(_mm512_mul_epu32(fours, _mm512_set1_epi64(10000)), _mm512_srli_epi64(fours, 32));
    }

    static void widen(const double* numbers, std::size_t count, double& lowest, double& highest) {
        __m512d low = _mm512_set1_pd(lowest);
        __m512d high = _mm512_set1_pd(highest);
        std::size_t i = 0;
        for (; i + 8 <= count; i += 8) {
            const __m512d eight = _mm512_loadu_pd(numbers + i);
            low = _mm512_min_pd(eight, low);
            high = _mm512_max_pd(eight, high);
        }
        double lows[8];
        double highs[8];
        _mm512_storeu_pd(lows, low);
        _mm512_storeu_pd(highs, high);
        TokenWords<simd::avx512>::widen(numbers + i, count - i, lowest, highest);
        TokenWords<simd::avx512>::widen(lows, 8, lowest, highest);
        TokenWords<simd::avx512>::widen(highs, 8, lowest, highest);
    }
};

#endif

// --- A run of numbers.

// Lists the tokens of the text from `text` on that are surely whole, `wanted` of them or more. Returns whether more may
// follow in this way: not after a byte that no number or separator has, and not near the end of the text.
template<class S, Separators separators>
bool find_tokens(const char* text, const char* end, std::size_t wanted, unsigned blocks, Tokens<S>& tokens) {
    std::uint64_t before = 0;    // whether the byte before is numeric
    std::uint64_t cr_before = 0; // whether it is CR
    std::uint64_t wrong = 0;
    std::uint32_t* begins_to = tokens.begins;
    std::uint32_t* ends_to = tokens.ends;
    std::uint32_t offset = 0;
    for (; offset < blocks * 64 && static_cast<std::size_t>(ends_to - tokens.ends) < wanted; offset += 64) {
        if (end - text < static_cast<std::ptrdiff_t>(offset) + 64 + decimal_lookahead) break;
        const ByteMasks<S> masks = TokenWords<S>::template classify<separators>(text + offset);
        const std::uint64_t numeric = masks.numeric;
        const std::uint64_t after_numeric = numeric << 1U | before;
        const std::uint64_t begins = numeric & ~after_numeric;
        const std::uint64_t ends = ~numeric & after_numeric;
        if constexpr (separators == Separators::lines) {
            const std::uint64_t after_cr = masks.cr << 1U | cr_before;
            wrong = ~(numeric | masks.cr | masks.lf) | (masks.cr & ~after_numeric) |
                    (masks.lf & ~(after_numeric | after_cr));
            cr_before = masks.cr >> 63U;
        } else {
            wrong = ~(numeric | masks.ends);
        }
        before = numeric >> 63U;
        const std::uint64_t right = (wrong & (0 - wrong)) - 1; // the bytes before the first wrong one
        begins_to = TokenWords<S>::list(begins & right, offset, begins_to);
        ends_to = TokenWords<S>::list(ends & right, offset, ends_to);
        if (wrong != 0) break;
    }
    tokens.ended = static_cast<std::size_t>(ends_to - tokens.ends);
    return wrong == 0 && end - text >= static_cast<std::ptrdiff_t>(offset) + 64 + decimal_lookahead;
}

// Converts the tokens of the list `left`, which convert() could not; returns the first that no method converts, or
// `count`.
template<class S>
std::size_t convert_left(const char* text, const Tokens<S>& tokens, const std::uint16_t* left, std::size_t left_count,
                         std::size_t count, const NumberRun& run, double* numbers) {
    using Words = TokenWords<S>;
    const auto slowly = [&](std::size_t k) {
        return run.convert(text + tokens.begins[k], text + tokens.ends[k], numbers[k]);
    };
    if constexpr (Words::converts_wide) {
        constexpr std::size_t lanes = Words::lanes;
        std::uint16_t group[lanes]; // tokens to convert together
        std::uint32_t begins[lanes];
        std::uint32_t ends[lanes];
        std::size_t grouped = 0;
        std::size_t converted = count; // before the first that is not
        const auto close_group = [&] {
            if (grouped == 0) return;
            for (std::size_t k = grouped; k < lanes; ++k) {
                begins[k] = begins[0];
                ends[k] = ends[0];
            }
            double some[lanes];
            const unsigned bad = Words::convert_wide(text, begins, ends, some);
            for (std::size_t k = 0; k < grouped; ++k) {
                if ((bad >> k & 1U) == 0)
                    numbers[group[k]] = some[k];
                else if (!slowly(group[k]) && group[k] < converted)
                    converted = group[k];
            }
            grouped = 0;
        };
        for (std::size_t i = 0; i < left_count && converted == count; ++i) {
            const std::uint16_t token = left[i];
            const std::uint32_t length = tokens.ends[token] - tokens.begins[token];
            // Shorter ones were refused for another reason; eight bytes lie before the text.
            if (length <= 8 || length > 16 || tokens.ends[token] < 8) {
                if (!slowly(token)) converted = token;
                continue;
            }
            group[grouped] = token;
            begins[grouped] = tokens.begins[token];
            ends[grouped] = tokens.ends[token];
            if (++grouped == lanes) close_group();
        }
        close_group();
        return converted;
    } else {
        for (std::size_t i = 0; i < left_count; ++i)
            if (!slowly(left[i])) return left[i];
    }
    return count;
}

// Converts the first `count` tokens; returns how many could be.
template<class S>
std::size_t convert_tokens(const char* text, Tokens<S>& tokens, std::size_t count, const NumberRun& run,
                           double* numbers) {
    using Words = TokenWords<S>;
    constexpr std::size_t lanes = Words::lanes;
    std::uint16_t left[Tokens<S>::most + lanes];
    std::size_t left_count = 0;
    const auto leave = [&](unsigned bad, std::size_t i) {
        for (; bad != 0; bad &= bad - 1)
            left[left_count++] = static_cast<std::uint16_t>(i + static_cast<unsigned>(__builtin_ctz(bad)));
    };
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes)
        leave(Words::convert(text, tokens.begins + i, tokens.ends + i, numbers + i), i);
    if (i < count) {
        for (std::size_t k = count; k < i + lanes; ++k) {
            tokens.begins[k] = tokens.begins[count - 1];
            tokens.ends[k] = tokens.ends[count - 1];
        }
        double some[lanes] = {};
        const unsigned bad = Words::convert(text, tokens.begins + i, tokens.ends + i, some);
        for (std::size_t k = i; k < count; ++k)
            numbers[k] = some[k - i];
        leave(bad & ((1U << (count - i)) - 1), i);
    }
    return left_count == 0 ? count : convert_left(text, tokens, left, left_count, count, run, numbers);
}

template<class S, Separators separators>
void read_run(NumberRun& run) {
    Tokens<S> tokens;
    bool more = true;
    // Small pieces first: where every second number needs another method, much would be looked at in vain.
    for (unsigned blocks = 2; more && run.taken < run.wanted; blocks = Tokens<S>::blocks) {
        const char* const text = run.at;
        const std::size_t wanted = run.wanted - run.taken;
        more = find_tokens<S, separators>(text, run.end, wanted, blocks, tokens);
        const std::size_t found = tokens.ended < wanted ? tokens.ended : wanted;
        double* const numbers = run.numbers + run.taken;
        const std::size_t count = convert_tokens<S>(text, tokens, found, run, numbers);
        if (count == 0) return;
        TokenWords<S>::widen(numbers, count, run.lowest, run.highest);
        run.taken += count;
        run.last = text + tokens.begins[count - 1];
        run.at = text + tokens.ends[count - 1];
        if constexpr (separators == Separators::lines) run.at += run.at[0] == '\r' && run.at[1] == '\n' ? 2 : 1;
        more = more && count == found;
    }
}

template<class S>
void read_any(NumberRun& run, Separators separators) {
    if (separators == Separators::lines)
        read_run<S, Separators::lines>(run);
    else
        read_run<S, Separators::any>(run);
}

} // namespace gonio::profile_detail
