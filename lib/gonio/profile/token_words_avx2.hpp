// token_words.hpp for AVX2: four tokens at a time. Internal.
#pragma once

#include <gonio/profile/token_words.hpp>
#include <gonio/simd/native.hpp>

#if defined(__AVX2__)

#include <immintrin.h>

namespace gonio::profile_detail {

template<>
struct TokenWords<simd::pack<float, simd::avx2>> {
    static constexpr std::size_t lanes = 4;
    using Masks = ByteMasks<simd::pack<float, simd::avx2>>;

    // The eight bytes before `end`.
    static long long word_before(const char* end) {
        long long bytes = 0;
        std::memcpy(&bytes, end - 8, sizeof bytes);
        return bytes;
    }
    // Of tokens with these bounds.
    static __m256i lengths(const std::uint32_t* bounds) {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): an unaligned load takes any address
        const __m256i both = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(bounds)); // begins in the lower halves
        return _mm256_srli_epi64(_mm256_sub_epi32(both, _mm256_slli_epi64(both, 32)), 32);
    }

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

    static unsigned convert(const char* text, const std::uint32_t* bounds, double* numbers) {
        const auto word = [&](int i) { return word_before(text + bounds[2 * i + 1]); };
        const __m256i zero = _mm256_setzero_si256();
        const __m256i ones = _mm256_set1_epi8(1);
        const __m256i all = _mm256_set1_epi8(-1);
        const __m256i length = lengths(bounds);
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

    // Bit i: token i has 9 to 16 characters.
    static unsigned wide(const std::uint32_t* bounds) {
        const __m256i length = lengths(bounds);
        const __m256i wide = _mm256_andnot_si256(_mm256_cmpgt_epi64(length, _mm256_set1_epi64x(16)),
                                                 _mm256_cmpgt_epi64(length, _mm256_set1_epi64x(8)));
        return static_cast<unsigned>(_mm256_movemask_pd(_mm256_castsi256_pd(wide)));
    }

    // Bit i: token i has more.
    static unsigned wider(const std::uint32_t* bounds) {
        const __m256i wider = _mm256_cmpgt_epi64(lengths(bounds), _mm256_set1_epi64x(16));
        return static_cast<unsigned>(_mm256_movemask_pd(_mm256_castsi256_pd(wider)));
    }

    // The eight bytes that begin this many before the end of each token.
    static __m256i words_before(const char* text, const std::uint32_t* bounds, int before) {
        const auto word = [&](int i) { return word_before(text + bounds[2 * i + 1] - (before - 8)); };
        return _mm256_set_epi64x(word(3), word(2), word(1), word(0));
    }

    using Doubles = simd::doubles<simd::avx2>;
    // a b + c, rounded once.
    static Doubles fused(Doubles a, Doubles b, Doubles c) { return {_mm256_fmadd_pd(a.v, b.v, c.v)}; }

    static unsigned convert_wide(const char* text, const std::uint32_t* bounds, double* numbers) {
        const __m256i zero = _mm256_setzero_si256();
        const __m256i ones = _mm256_set1_epi8(1);
        const __m256i all = _mm256_set1_epi8(-1);
        const __m256i zeros = _mm256_set1_epi8('0');
        const __m256i length = lengths(bounds);
        // The two words that end with the tokens; bytes before a token are cleared.
        const __m256i before_low = _mm256_sub_epi64(_mm256_set1_epi64x(64), _mm256_slli_epi64(length, 3)); // in bits
        const __m256i is_long = _mm256_cmpgt_epi64(length, _mm256_set1_epi64x(8));
        const __m256i keep_high = _mm256_sllv_epi64(all, _mm256_add_epi64(before_low, _mm256_set1_epi64x(64)));
        const __m256i keep_low = _mm256_or_si256(_mm256_sllv_epi64(all, before_low), is_long);
        const __m256i high = _mm256_and_si256(_mm256_xor_si256(words_before(text, bounds, 16), zeros), keep_high);
        const __m256i low = _mm256_and_si256(_mm256_xor_si256(words_before(text, bounds, 8), zeros), keep_low);
        const __m256i high_marks = _mm256_and_si256(_mm256_srli_epi64(high, 4), ones);
        const __m256i low_marks = _mm256_and_si256(_mm256_srli_epi64(low, 4), ones);
        const __m256i high_second = _mm256_srli_epi64(high, 1);
        const __m256i low_second = _mm256_srli_epi64(low, 1);
        const __m256i high_point = _mm256_andnot_si256(high, high_marks);
        const __m256i low_point = _mm256_andnot_si256(low, low_marks);
        const __m256i high_minus = _mm256_andnot_si256(high_second, high_marks);
        const __m256i low_minus = _mm256_andnot_si256(low_second, low_marks);
        const __m256i high_kept = _mm256_and_si256(keep_high, ones);
        const __m256i low_kept = _mm256_and_si256(keep_low, ones);
        // The first byte of the token, in the word that it is in.
        const __m256i high_first = _mm256_andnot_si256(_mm256_slli_epi64(keep_high, 8), high_kept);
        const __m256i low_first =
            _mm256_andnot_si256(is_long, _mm256_andnot_si256(_mm256_slli_epi64(keep_low, 8), low_kept));
        const __m256i high_before = _mm256_add_epi64(high_point, all);
        const __m256i low_before = _mm256_add_epi64(low_point, all);
        const __m256i no_high_point = _mm256_cmpeq_epi64(high_point, zero);
        const __m256i no_low_point = _mm256_cmpeq_epi64(low_point, zero);
        const __m256i slash = _mm256_or_si256(_mm256_and_si256(high_marks, _mm256_and_si256(high, high_second)),
                                              _mm256_and_si256(low_marks, _mm256_and_si256(low, low_second)));
        const __m256i points =
            _mm256_or_si256(_mm256_and_si256(high_point, high_before), _mm256_and_si256(low_point, low_before));
        const __m256i wrong_minus =
            _mm256_or_si256(_mm256_andnot_si256(high_first, high_minus), _mm256_andnot_si256(low_first, low_minus));
        const __m256i wrong = _mm256_or_si256(_mm256_or_si256(slash, points), wrong_minus);
        const __m256i no_digit =
            _mm256_and_si256(_mm256_cmpeq_epi64(high_kept, high_marks), _mm256_cmpeq_epi64(low_kept, low_marks));
        const __m256i minus = _mm256_or_si256(high_minus, low_minus);
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
        const __m256d power =
            _mm256_i64gather_pd(decimal_powers<simd::avx2>, _mm256_and_si256(decimals, _mm256_set1_epi64x(15)), 8);
        const __m256d value = _mm256_div_pd(to_double(number), power);
        const __m256d sign =
            _mm256_castsi256_pd(_mm256_andnot_si256(_mm256_cmpeq_epi64(minus, zero), _mm256_set1_epi64x(INT64_MIN)));
        _mm256_storeu_pd(numbers, _mm256_or_pd(value, sign));
        const __m256i exact = _mm256_cmpeq_epi64(_mm256_srli_epi64(number, 52), zero);
        const __m256i too_long = _mm256_cmpgt_epi64(length, _mm256_set1_epi64x(16));
        const __m256i fine =
            _mm256_andnot_si256(_mm256_or_si256(no_digit, too_long),
                                _mm256_and_si256(_mm256_cmpeq_epi64(wrong, zero), _mm256_and_si256(one_point, exact)));
        return ~static_cast<unsigned>(_mm256_movemask_pd(_mm256_castsi256_pd(fine))) & 0xFU;
    }

    static unsigned convert_long(const char* text, const std::uint32_t* bounds, double* numbers) {
        const __m256i zero = _mm256_setzero_si256();
        const __m256i ones = _mm256_set1_epi8(1);
        const __m256i all = _mm256_set1_epi8(-1);
        const __m256i zeros = _mm256_set1_epi8('0');
        const __m256i length = lengths(bounds);
        const auto above = [](__m256i of, long long most) { return _mm256_cmpgt_epi64(of, _mm256_set1_epi64x(most)); };
        // The three words that end with the tokens; bytes before a token are cleared.
        const auto kept_of = [&](int before) {
            const __m256i bits = _mm256_sub_epi64(_mm256_set1_epi64x(8LL * before), _mm256_slli_epi64(length, 3));
            return _mm256_or_si256(_mm256_sllv_epi64(all, bits), above(length, before)); // negative shifts clear all
        };
        const __m256i keep = kept_of(24);
        const auto kept_word = [&](int before, __m256i kept) {
            return _mm256_and_si256(_mm256_xor_si256(words_before(text, bounds, before), zeros), kept);
        };
        const __m256i high = kept_word(24, keep);
        const __m256i middle = kept_word(16, kept_of(16));
        const __m256i low = kept_word(8, kept_of(8));
        const auto marks_in = [&](__m256i word) { return _mm256_and_si256(_mm256_srli_epi64(word, 4), ones); };
        const auto second = [](__m256i word) { return _mm256_srli_epi64(word, 1); };
        const __m256i high_marks = marks_in(high);
        const __m256i middle_marks = marks_in(middle);
        const __m256i low_marks = marks_in(low);
        const __m256i high_point = _mm256_andnot_si256(high, high_marks);
        const __m256i middle_point = _mm256_andnot_si256(middle, middle_marks);
        const __m256i low_point = _mm256_andnot_si256(low, low_marks);
        const __m256i minus = _mm256_andnot_si256(second(high), high_marks);
        const __m256i first = _mm256_andnot_si256(_mm256_slli_epi64(keep, 8), _mm256_and_si256(keep, ones));
        const __m256i slash = _mm256_or_si256(_mm256_and_si256(high_marks, _mm256_and_si256(high, second(high))),
                                              _mm256_or_si256(_mm256_andnot_si256(middle_point, middle_marks),
                                                              _mm256_andnot_si256(low_point, low_marks)));
        const __m256i wrong = _mm256_or_si256(slash, _mm256_andnot_si256(first, minus));
        const __m256i points =
            _mm256_sad_epu8(_mm256_add_epi8(high_point, _mm256_add_epi8(middle_point, low_point)), zero);
        const __m256i none_in_high = _mm256_cmpeq_epi64(high_point, zero);
        const __m256i none_in_middle = _mm256_cmpeq_epi64(middle_point, zero);
        const __m256i none_in_low = _mm256_cmpeq_epi64(low_point, zero);
        const __m256i none_below_high = _mm256_and_si256(none_in_middle, none_in_low);
        const auto digits_of = [&](__m256i word, __m256i marks) {
            return _mm256_andnot_si256(_mm256_sub_epi8(zero, marks), word);
        };
        const __m256i high_digits = digits_of(high, high_marks);
        const __m256i middle_digits = digits_of(middle, middle_marks);
        const __m256i low_digits = digits_of(low, low_marks);
        // The digits before the point move up by one byte, over the point.
        const auto moved_in = [&](__m256i point, __m256i none, __m256i none_below) {
            return _mm256_or_si256(_mm256_andnot_si256(none, _mm256_add_epi64(point, all)),
                                   _mm256_andnot_si256(none_below, all));
        };
        const __m256i low_moved = moved_in(low_point, none_in_low, all);
        const __m256i middle_moved = moved_in(middle_point, none_in_middle, none_in_low);
        const __m256i high_moved = moved_in(high_point, none_in_high, none_below_high);
        const auto joined = [](__m256i digits, __m256i moved) {
            return _mm256_or_si256(_mm256_andnot_si256(moved, digits),
                                   _mm256_slli_epi64(_mm256_and_si256(digits, moved), 8));
        };
        const auto across = [](__m256i none, __m256i digits) {
            return _mm256_andnot_si256(none, _mm256_srli_epi64(digits, 56));
        };
        const __m256i upper = number_in(joined(high_digits, high_moved));
        const __m256i between =
            number_in(_mm256_or_si256(joined(middle_digits, middle_moved), across(none_below_high, high_digits)));
        const __m256i lower =
            number_in(_mm256_or_si256(joined(low_digits, low_moved), across(none_in_low, middle_digits)));
        const auto bit_in = [&](__m256i moved) { return _mm256_and_si256(moved, ones); };
        const __m256i before = _mm256_sad_epu8(
            _mm256_add_epi8(bit_in(high_moved), _mm256_add_epi8(bit_in(middle_moved), bit_in(low_moved))), zero);
        const __m256i decimals = _mm256_andnot_si256(_mm256_and_si256(none_in_high, none_below_high),
                                                     _mm256_sub_epi64(_mm256_set1_epi64x(23), before));
        const __m256d power =
            _mm256_i64gather_pd(decimal_powers<simd::avx2>, _mm256_min_epu32(decimals, _mm256_set1_epi64x(22)), 8);
        const __m256i eleven = _mm256_add_epi64(_mm256_mul_epu32(upper, _mm256_set1_epi64x(100000000)), between);
        const auto quotients = long_quotients<simd::pack<float, simd::avx2>>(Doubles(to_double(eleven)),
                                                                             Doubles(to_double(lower)), Doubles(power));
        const __m256d sign =
            _mm256_castsi256_pd(_mm256_andnot_si256(_mm256_cmpeq_epi64(minus, zero), _mm256_set1_epi64x(INT64_MIN)));
        _mm256_storeu_pd(numbers, _mm256_or_pd(quotients.nearest.v, sign));
        const __m256i odd_length =
            _mm256_or_si256(above(length, 24), _mm256_cmpgt_epi64(_mm256_set1_epi64x(2), length));
        const __m256i odd = _mm256_or_si256(
            odd_length, _mm256_or_si256(_mm256_or_si256(above(points, 1), above(upper, 999)), above(decimals, 22)));
        const __m256i fine = _mm256_andnot_si256(odd, _mm256_cmpeq_epi64(wrong, zero));
        return (~static_cast<unsigned>(_mm256_movemask_pd(_mm256_castsi256_pd(fine))) & 0xFU) |
               static_cast<unsigned>(simd::lane_bits(!(quotients.nearest == quotients.other)));
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

} // namespace gonio::profile_detail

#endif
