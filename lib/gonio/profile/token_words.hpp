// The words of tokens: 64 bytes classified, their tokens listed, and tokens converted to numbers, one at a time on any
// machine. token_words_avx2.hpp and token_words_avx512.hpp convert several together. Internal.
//
// Everything is a template on S, whose name contains the instruction set, and calls no function of std::.
#pragma once

#include <gonio/profile/fast_number.hpp>
#include <gonio/profile/token_kernels.hpp>
#include <gonio/simd/doubles.hpp>
#include <gonio/simd/instruction_sets.hpp>
#include <gonio/simd/pack.hpp>

#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
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

    // `bounds`: where each token begins and ends. Bit i of the result: token i is not a number of at most eight
    // characters, and number i means nothing.
    static unsigned convert(const char* text, const std::uint32_t* bounds, double* numbers) {
        if constexpr (__BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__) return 1;
        constexpr double powers[8] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7};
        const std::uint32_t begin = bounds[0];
        const std::uint32_t end = bounds[1];
        const bool negative = text[begin] == '-';
        const std::uint32_t length = end - begin - (negative ? 1 : 0);
        if (length == 0 || length > 8) return 1;
        // The word that ends with the token; bytes before its first digit or point are cleared.
        std::uint64_t token = 0;
        std::memcpy(&token, text + end - 8, sizeof token);
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

    // Not here, where the methods for one number are as fast: convert_wide() is as convert(), for tokens of at most 16
    // characters, and convert_long() for those of 2 to 24, but for those of less than 17 with a minus. Words that
    // they read begin up to 24 bytes before the end of a token. wide() and wider() say which tokens need two words and
    // which need three.
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

// The quotients of convert_long(): of numbers of two doubles, and powers of ten that are one (T. Dekker, A
// floating-point technique for extending the available precision, 1971).
template<class S>
struct LongQuotients {
    simd::in_double<S> nearest;
    simd::in_double<S> other; // not the same where the rounding is not certain
};

// Of upper · 10^8 + lower, both whole and exact, and `power`. TokenWords<S>::fused() rounds once.
template<class S>
GONIO_FORCE_INLINE LongQuotients<S> long_quotients(simd::in_double<S> upper, simd::in_double<S> lower,
                                                   simd::in_double<S> power) {
    using Double = simd::in_double<S>;
    using Words = TokenWords<S>;
    const Double eight_digits(1e8);
    const Double product = upper * eight_digits;
    const Double rest = Words::fused(upper, eight_digits, -product) + lower;
    const Double number = product + rest;
    const Double number_rest = rest - (number - product);
    const Double quotient = number / power;
    const Double remainder = Words::fused(-quotient, power, number) + number_rest;
    const Double quotient_rest = remainder / power;
    // The rest is known to a few of its last bits. Where one that is larger or smaller by much more than that would
    // give another sum, the number is left to the method that decides by integers.
    const Double error = quotient_rest * Double(0x1p-48);
    return {quotient + (quotient_rest + error), quotient + (quotient_rest - error)};
}

} // namespace gonio::profile_detail
