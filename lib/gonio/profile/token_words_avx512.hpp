// token_words.hpp for AVX-512: eight tokens at a time. Internal.
#pragma once

#include <gonio/profile/token_words.hpp>
#include <gonio/simd/native.hpp>

#if defined(__AVX512BW__)

#include <immintrin.h>

namespace gonio::profile_detail {

template<>
struct TokenWords<simd::pack<float, simd::avx512>> {
    static constexpr std::size_t lanes = 8;
    using Masks = ByteMasks<simd::pack<float, simd::avx512>>;

    // The eight bytes before `end`.
    static long long word_before(const char* end) {
        long long bytes = 0;
        std::memcpy(&bytes, end - 8, sizeof bytes);
        return bytes;
    }
    // Of tokens with these bounds.
    static __m512i lengths(const std::uint32_t* bounds) {
        const __m512i both = _mm512_loadu_si512(bounds); // the begin in the lower half of each lane
        return _mm512_srli_epi64(_mm512_sub_epi32(both, _mm512_slli_epi64(both, 32)), 32);
    }

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

    static unsigned convert(const char* text, const std::uint32_t* bounds, double* numbers) {
        const auto word = [&](int i) { return word_before(text + bounds[2 * i + 1]); };
        const __m512i zero = _mm512_setzero_si512();
        const __m512i ones = _mm512_set1_epi8(1);
        const __m512i all = _mm512_set1_epi8(-1);
        const __m512i length = lengths(bounds);
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

    // Bit i: token i has 9 to 16 characters.
    static unsigned wide(const std::uint32_t* bounds) {
        const __m512i above = _mm512_sub_epi64(lengths(bounds), _mm512_set1_epi64(9));
        return static_cast<unsigned>(_mm512_cmple_epu64_mask(above, _mm512_set1_epi64(7)));
    }

    // Bit i: token i has more.
    static unsigned wider(const std::uint32_t* bounds) {
        return static_cast<unsigned>(_mm512_cmpgt_epi64_mask(lengths(bounds), _mm512_set1_epi64(16)));
    }

    // The eight bytes that begin this many before the end of each token.
    static __m512i words_before(const char* text, const std::uint32_t* bounds, int before) {
        const auto word = [&](int i) { return word_before(text + bounds[2 * i + 1] - (before - 8)); };
        return _mm512_set_epi64(word(7), word(6), word(5), word(4), word(3), word(2), word(1), word(0));
    }

    using Doubles = simd::doubles<simd::avx512>;
    // a b + c, rounded once.
    static Doubles fused(Doubles a, Doubles b, Doubles c) { return {_mm512_fmadd_pd(a.v, b.v, c.v)}; }

    static unsigned convert_wide(const char* text, const std::uint32_t* bounds, double* numbers) {
        const __m512i zero = _mm512_setzero_si512();
        const __m512i ones = _mm512_set1_epi8(1);
        const __m512i all = _mm512_set1_epi8(-1);
        const __m512i zeros = _mm512_set1_epi8('0');
        const __m512i length = lengths(bounds);
        // The two words that end with the tokens; bytes before a token are cleared.
        const __m512i before_low = _mm512_sub_epi64(_mm512_set1_epi64(64), _mm512_slli_epi64(length, 3)); // in bits
        const __m512i keep_high = _mm512_sllv_epi64(all, _mm512_add_epi64(before_low, _mm512_set1_epi64(64)));
        const __m512i keep_low = _mm512_sllv_epi64(all, _mm512_max_epi64(before_low, zero));
        const __m512i high = _mm512_and_si512(_mm512_xor_si512(words_before(text, bounds, 16), zeros), keep_high);
        const __m512i low = _mm512_and_si512(_mm512_xor_si512(words_before(text, bounds, 8), zeros), keep_low);
        const __m512i high_marks = _mm512_and_si512(_mm512_srli_epi64(high, 4), ones);
        const __m512i low_marks = _mm512_and_si512(_mm512_srli_epi64(low, 4), ones);
        const __m512i high_second = _mm512_srli_epi64(high, 1);
        const __m512i low_second = _mm512_srli_epi64(low, 1);
        const __m512i high_point = _mm512_andnot_si512(high, high_marks);
        const __m512i low_point = _mm512_andnot_si512(low, low_marks);
        const __m512i high_minus = _mm512_andnot_si512(high_second, high_marks);
        const __m512i low_minus = _mm512_andnot_si512(low_second, low_marks);
        const __m512i high_kept = _mm512_and_si512(keep_high, ones);
        const __m512i low_kept = _mm512_and_si512(keep_low, ones);
        // The first byte of the token, in the word that it is in.
        const __m512i high_first = _mm512_andnot_si512(_mm512_slli_epi64(keep_high, 8), high_kept);
        const __m512i low_first = _mm512_maskz_andnot_epi64(_mm512_cmple_epi64_mask(length, _mm512_set1_epi64(8)),
                                                            _mm512_slli_epi64(keep_low, 8), low_kept);
        const __m512i high_before = _mm512_add_epi64(high_point, all);
        const __m512i low_before = _mm512_add_epi64(low_point, all);
        const __mmask8 of_high = _mm512_test_epi64_mask(high_point, high_point);
        const __mmask8 of_low = _mm512_test_epi64_mask(low_point, low_point);
        const __m512i slash = _mm512_or_si512(_mm512_and_si512(high_marks, _mm512_and_si512(high, high_second)),
                                              _mm512_and_si512(low_marks, _mm512_and_si512(low, low_second)));
        const __m512i points =
            _mm512_or_si512(_mm512_and_si512(high_point, high_before), _mm512_and_si512(low_point, low_before));
        const __m512i wrong_minus =
            _mm512_or_si512(_mm512_andnot_si512(high_first, high_minus), _mm512_andnot_si512(low_first, low_minus));
        const __m512i wrong = _mm512_or_si512(_mm512_or_si512(slash, points), wrong_minus);
        const unsigned no_digit = static_cast<unsigned>(_mm512_cmpeq_epi64_mask(high_kept, high_marks)) &
                                  static_cast<unsigned>(_mm512_cmpeq_epi64_mask(low_kept, low_marks));
        const __m512i minus = _mm512_or_si512(high_minus, low_minus);
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
               static_cast<unsigned>(_mm512_test_epi64_mask(large, large)) | static_cast<unsigned>(of_high & of_low) |
               static_cast<unsigned>(_mm512_cmpgt_epi64_mask(length, _mm512_set1_epi64(16))) | no_digit;
    }

    static unsigned convert_long(const char* text, const std::uint32_t* bounds, double* numbers) {
        const __m512i zero = _mm512_setzero_si512();
        const __m512i ones = _mm512_set1_epi8(1);
        const __m512i all = _mm512_set1_epi8(-1);
        const __m512i zeros = _mm512_set1_epi8('0');
        const __m512i length = lengths(bounds);
        // The three words that end with the tokens; bytes before a token are cleared.
        const auto kept_of = [&](int before) {
            const __m512i bits = _mm512_sub_epi64(_mm512_set1_epi64(8LL * before), _mm512_slli_epi64(length, 3));
            return _mm512_sllv_epi64(all, _mm512_max_epi64(bits, zero));
        };
        const __m512i keep = kept_of(24);
        const auto kept_word = [&](int before, __m512i kept) {
            return _mm512_and_si512(_mm512_xor_si512(words_before(text, bounds, before), zeros), kept);
        };
        const __m512i high = kept_word(24, keep);
        const __m512i middle = kept_word(16, kept_of(16));
        const __m512i low = kept_word(8, kept_of(8));
        const auto marks_in = [&](__m512i word) { return _mm512_and_si512(_mm512_srli_epi64(word, 4), ones); };
        const auto second = [](__m512i word) { return _mm512_srli_epi64(word, 1); };
        const __m512i high_marks = marks_in(high);
        const __m512i middle_marks = marks_in(middle);
        const __m512i low_marks = marks_in(low);
        const __m512i high_point = _mm512_andnot_si512(high, high_marks);
        const __m512i middle_point = _mm512_andnot_si512(middle, middle_marks);
        const __m512i low_point = _mm512_andnot_si512(low, low_marks);
        const __m512i minus = _mm512_andnot_si512(second(high), high_marks);
        const __m512i first = _mm512_andnot_si512(_mm512_slli_epi64(keep, 8), _mm512_and_si512(keep, ones));
        const __m512i slash = _mm512_or_si512(_mm512_and_si512(high_marks, _mm512_and_si512(high, second(high))),
                                              _mm512_or_si512(_mm512_andnot_si512(middle_point, middle_marks),
                                                              _mm512_andnot_si512(low_point, low_marks)));
        const __m512i wrong = _mm512_or_si512(slash, _mm512_andnot_si512(first, minus));
        const __m512i points =
            _mm512_sad_epu8(_mm512_add_epi8(high_point, _mm512_add_epi8(middle_point, low_point)), zero);
        const __mmask8 of_high = _mm512_test_epi64_mask(high_point, high_point);
        const __mmask8 of_middle = _mm512_test_epi64_mask(middle_point, middle_point);
        const __mmask8 of_low = _mm512_test_epi64_mask(low_point, low_point);
        const auto digits_of = [&](__m512i word, __m512i marks) {
            return _mm512_andnot_si512(_mm512_sub_epi8(zero, marks), word);
        };
        const __m512i high_digits = digits_of(high, high_marks);
        const __m512i middle_digits = digits_of(middle, middle_marks);
        const __m512i low_digits = digits_of(low, low_marks);
        // The digits before the point move up by one byte, over the point.
        const auto moved_in = [&](__m512i point, __mmask8 of_word, unsigned of_lower) {
            return _mm512_mask_mov_epi64(_mm512_maskz_add_epi64(of_word, point, all), static_cast<__mmask8>(of_lower),
                                         all);
        };
        const __m512i low_moved = moved_in(low_point, of_low, 0);
        const __m512i middle_moved = moved_in(middle_point, of_middle, of_low);
        const __m512i high_moved = moved_in(high_point, of_high, static_cast<unsigned>(of_middle | of_low));
        const auto joined = [](__m512i digits, __m512i moved) {
            return _mm512_or_si512(_mm512_andnot_si512(moved, digits),
                                   _mm512_slli_epi64(_mm512_and_si512(digits, moved), 8));
        };
        const auto across = [](unsigned moved, __m512i digits) {
            return _mm512_maskz_srli_epi64(static_cast<__mmask8>(moved), digits, 56);
        };
        const __m512i upper = number_in(joined(high_digits, high_moved));
        const __m512i between = number_in(_mm512_or_si512(
            joined(middle_digits, middle_moved), across(static_cast<unsigned>(of_middle | of_low), high_digits)));
        const __m512i lower = number_in(_mm512_or_si512(joined(low_digits, low_moved), across(of_low, middle_digits)));
        const auto bit_in = [&](__m512i moved) { return _mm512_and_si512(moved, ones); };
        const __m512i before = _mm512_sad_epu8(
            _mm512_add_epi8(bit_in(high_moved), _mm512_add_epi8(bit_in(middle_moved), bit_in(low_moved))), zero);
        const __m512i decimals =
            _mm512_maskz_sub_epi64(static_cast<__mmask8>(of_high | of_middle | of_low), _mm512_set1_epi64(23), before);
        const __m512d power =
            _mm512_i64gather_pd(_mm512_min_epi64(decimals, _mm512_set1_epi64(22)), decimal_powers<simd::avx512>, 8);
        const __m512i eleven = _mm512_add_epi64(_mm512_mul_epu32(upper, _mm512_set1_epi64(100000000)), between);
        const auto quotients = long_quotients<simd::pack<float, simd::avx512>>(
            Doubles(_mm512_cvtepi64_pd(eleven)), Doubles(_mm512_cvtepi64_pd(lower)), Doubles(power));
        const __m512i sign = _mm512_maskz_mov_epi64(_mm512_test_epi64_mask(minus, minus), _mm512_set1_epi64(INT64_MIN));
        _mm512_storeu_pd(numbers, _mm512_castsi512_pd(_mm512_or_si512(_mm512_castpd_si512(quotients.nearest.v), sign)));
        const __m512i above_two = _mm512_sub_epi64(length, _mm512_set1_epi64(2));
        return static_cast<unsigned>(_mm512_test_epi64_mask(wrong, wrong)) |
               static_cast<unsigned>(_mm512_cmpgt_epu64_mask(above_two, _mm512_set1_epi64(22))) |
               static_cast<unsigned>(_mm512_cmpgt_epi64_mask(points, _mm512_set1_epi64(1))) |
               static_cast<unsigned>(_mm512_cmpgt_epi64_mask(upper, _mm512_set1_epi64(999))) |
               static_cast<unsigned>(_mm512_cmpgt_epi64_mask(decimals, _mm512_set1_epi64(22))) |
               static_cast<unsigned>(simd::lane_bits(!(quotients.nearest == quotients.other)));
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

} // namespace gonio::profile_detail

#endif
