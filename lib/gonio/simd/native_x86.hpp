// Operations that vector extensions cannot express, in x86 intrinsics. Each part exists only where its instruction set
// is enabled for the file being compiled, so that no other file can use it by accident.
#pragma once

#include <gonio/simd/instruction_sets.hpp>
#include <gonio/simd/scalar.hpp>

#include <cstddef>
#include <cstdint>
#include <immintrin.h>

namespace gonio::simd {

#if defined(__SSE2__)
template<>
struct Native<sse2> {
    using real = __m128;
    using half_double = __m128d;
    GONIO_FORCE_INLINE static real sqrt(real x) { return _mm_sqrt_ps(x); }
    GONIO_FORCE_INLINE static real min(real a, real b) { return _mm_min_ps(a, b); }
    GONIO_FORCE_INLINE static real max(real a, real b) { return _mm_max_ps(a, b); }
    GONIO_FORCE_INLINE static half_double min(half_double a, half_double b) { return _mm_min_pd(a, b); }
    GONIO_FORCE_INLINE static half_double max(half_double a, half_double b) { return _mm_max_pd(a, b); }
    GONIO_FORCE_INLINE static real mul_add(real a, real b, real c) { return _mm_add_ps(_mm_mul_ps(a, b), c); }
    GONIO_FORCE_INLINE static half_double mul_add(half_double a, half_double b, half_double c) {
        return _mm_add_pd(_mm_mul_pd(a, b), c);
    }
    // Selects by the sign bit of each lane of the mask; all bits of a lane are equal.
    template<class Mask>
    GONIO_FORCE_INLINE static real select(Mask mask, real a, real b) {
        const real m = reinterpret_cast<real>(mask);
        return _mm_or_ps(_mm_and_ps(m, a), _mm_andnot_ps(m, b));
    }
    template<class Mask>
    GONIO_FORCE_INLINE static half_double select(Mask mask, half_double a, half_double b) {
        const auto m = reinterpret_cast<half_double>(mask);
        return _mm_or_pd(_mm_and_pd(m, a), _mm_andnot_pd(m, b));
    }
    GONIO_FORCE_INLINE static half_double sqrt(half_double x) { return _mm_sqrt_pd(x); }
    GONIO_FORCE_INLINE static int sign_bits(real x) { return _mm_movemask_ps(x); }
    GONIO_FORCE_INLINE static int sign_bits(half_double x) { return _mm_movemask_pd(x); }
    static constexpr int all_sign_bits = 0xF;
    GONIO_FORCE_INLINE static half_double low(real x) { return _mm_cvtps_pd(x); }
    GONIO_FORCE_INLINE static half_double high(real x) { return _mm_cvtps_pd(_mm_movehl_ps(x, x)); }
    GONIO_FORCE_INLINE static real narrow(half_double low, half_double high) {
        return _mm_movelh_ps(_mm_cvtpd_ps(low), _mm_cvtpd_ps(high));
    }
    // The chosen lanes, as bits; `store_chosen` writes them side by side and may write garbage up to a register's
    // length.
    using choice = std::uint32_t;
    GONIO_FORCE_INLINE static choice choose(std::uint32_t bits) { return bits; }
    GONIO_FORCE_INLINE static void store_chosen(choice bits, real x, float* to) {
        float lane[4];
        _mm_storeu_ps(&lane[0], x);
        to[0] = lane[0];
        to[bits & 1] = lane[1];
        to[(bits & 1) + ((bits >> 1) & 1)] = lane[2];
        to[(bits & 1) + ((bits >> 1) & 1) + ((bits >> 2) & 1)] = lane[3];
    }
};
#endif

#if defined(__AVX2__) && defined(__FMA__)
template<>
struct Native<avx2> {
    using real = __m256;
    using half_double = __m256d;
    GONIO_FORCE_INLINE static real sqrt(real x) { return _mm256_sqrt_ps(x); }
    GONIO_FORCE_INLINE static real min(real a, real b) { return _mm256_min_ps(a, b); }
    GONIO_FORCE_INLINE static real max(real a, real b) { return _mm256_max_ps(a, b); }
    GONIO_FORCE_INLINE static half_double min(half_double a, half_double b) { return _mm256_min_pd(a, b); }
    GONIO_FORCE_INLINE static half_double max(half_double a, half_double b) { return _mm256_max_pd(a, b); }
    GONIO_FORCE_INLINE static real mul_add(real a, real b, real c) { return _mm256_fmadd_ps(a, b, c); }
    GONIO_FORCE_INLINE static half_double mul_add(half_double a, half_double b, half_double c) {
        return _mm256_fmadd_pd(a, b, c);
    }
    // Without the intrinsic, compilers first compare a mask that is a product of other masks with 0.
    template<class Mask>
    GONIO_FORCE_INLINE static real select(Mask mask, real a, real b) {
        return _mm256_blendv_ps(b, a, reinterpret_cast<real>(mask));
    }
    template<class Mask>
    GONIO_FORCE_INLINE static half_double select(Mask mask, half_double a, half_double b) {
        return _mm256_blendv_pd(b, a, reinterpret_cast<half_double>(mask));
    }
    GONIO_FORCE_INLINE static half_double sqrt(half_double x) { return _mm256_sqrt_pd(x); }
    GONIO_FORCE_INLINE static int sign_bits(real x) { return _mm256_movemask_ps(x); }
    GONIO_FORCE_INLINE static int sign_bits(half_double x) { return _mm256_movemask_pd(x); }
    static constexpr int all_sign_bits = 0xFF;
    GONIO_FORCE_INLINE static half_double low(real x) { return _mm256_cvtps_pd(_mm256_castps256_ps128(x)); }
    GONIO_FORCE_INLINE static half_double high(real x) { return _mm256_cvtps_pd(_mm256_extractf128_ps(x, 1)); }
    GONIO_FORCE_INLINE static real narrow(half_double low, half_double high) {
        return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm256_cvtpd_ps(low)), _mm256_cvtpd_ps(high), 1);
    }
    using choice = __m256i; // source of each lane
    struct ChoiceTable {
        unsigned char lane[256][8];
    };
    static constexpr ChoiceTable choice_table = [] {
        ChoiceTable table{};
        for (unsigned bits = 0; bits < 256; ++bits) {
            unsigned count = 0;
            for (unsigned lane = 0; lane < 8; ++lane)
                if ((bits >> lane & 1U) != 0) table.lane[bits][count++] = static_cast<unsigned char>(lane);
        }
        return table;
    }();
    GONIO_FORCE_INLINE static choice choose(std::uint32_t bits) {
        return _mm256_cvtepu8_epi32(_mm_loadu_si64(&choice_table.lane[bits][0]));
    }
    GONIO_FORCE_INLINE static void store_chosen(choice from, real x, float* to) {
        _mm256_storeu_ps(to, _mm256_permutevar8x32_ps(x, from));
    }
};
#endif

#if defined(__AVX512F__) && defined(__AVX512DQ__)
template<>
struct Native<avx512> {
    using real = __m512;
    using half_double = __m512d;
    GONIO_FORCE_INLINE static real sqrt(real x) { return _mm512_sqrt_ps(x); }
    GONIO_FORCE_INLINE static real min(real a, real b) { return _mm512_min_ps(a, b); }
    GONIO_FORCE_INLINE static real max(real a, real b) { return _mm512_max_ps(a, b); }
    GONIO_FORCE_INLINE static half_double min(half_double a, half_double b) { return _mm512_min_pd(a, b); }
    GONIO_FORCE_INLINE static half_double max(half_double a, half_double b) { return _mm512_max_pd(a, b); }
    GONIO_FORCE_INLINE static real mul_add(real a, real b, real c) { return _mm512_fmadd_ps(a, b, c); }
    GONIO_FORCE_INLINE static half_double mul_add(half_double a, half_double b, half_double c) {
        return _mm512_fmadd_pd(a, b, c);
    }
    template<class Mask>
    GONIO_FORCE_INLINE static real select(Mask mask, real a, real b) {
        return _mm512_mask_blend_ps(_mm512_movepi32_mask(reinterpret_cast<__m512i>(mask)), b, a);
    }
    template<class Mask>
    GONIO_FORCE_INLINE static half_double select(Mask mask, half_double a, half_double b) {
        return _mm512_mask_blend_pd(_mm512_movepi64_mask(reinterpret_cast<__m512i>(mask)), b, a);
    }
    GONIO_FORCE_INLINE static half_double sqrt(half_double x) { return _mm512_sqrt_pd(x); }
    GONIO_FORCE_INLINE static int sign_bits(real x) { return _mm512_movepi32_mask(_mm512_castps_si512(x)); }
    GONIO_FORCE_INLINE static int sign_bits(half_double x) { return _mm512_movepi64_mask(_mm512_castpd_si512(x)); }
    static constexpr int all_sign_bits = 0xFFFF;
    GONIO_FORCE_INLINE static half_double low(real x) { return _mm512_cvtps_pd(_mm512_castps512_ps256(x)); }
    GONIO_FORCE_INLINE static half_double high(real x) { return _mm512_cvtps_pd(_mm512_extractf32x8_ps(x, 1)); }
    GONIO_FORCE_INLINE static real narrow(half_double low, half_double high) {
        return _mm512_insertf32x8(_mm512_castps256_ps512(_mm512_cvtpd_ps(low)), _mm512_cvtpd_ps(high), 1);
    }
    using choice = __mmask16;
    GONIO_FORCE_INLINE static choice choose(std::uint32_t bits) { return static_cast<choice>(bits); }
    GONIO_FORCE_INLINE static void store_chosen(choice which, real x, float* to) {
        _mm512_storeu_ps(to, _mm512_maskz_compress_ps(which, x)); // compressing directly to memory is slow on some
    }
};
#endif

} // namespace gonio::simd
