// Operations that vector extensions cannot express, in intrinsics of 64-bit Arm, which always has NEON.
#pragma once

#include <gonio/simd/instruction_sets.hpp>
#include <gonio/simd/scalar.hpp>

#include <arm_neon.h>
#include <cstddef>
#include <cstdint>

namespace gonio::simd {

template<>
struct Native<neon> {
    using real = float32x4_t;
    using half_double = float64x2_t;
    GONIO_FORCE_INLINE static real sqrt(real x) { return vsqrtq_f32(x); }
    // Not vminq and vmaxq, which return NaN if either argument is NaN.
    GONIO_FORCE_INLINE static real min(real a, real b) { return vbslq_f32(vcltq_f32(a, b), a, b); }
    GONIO_FORCE_INLINE static real max(real a, real b) { return vbslq_f32(vcgtq_f32(a, b), a, b); }
    GONIO_FORCE_INLINE static half_double min(half_double a, half_double b) { return vbslq_f64(vcltq_f64(a, b), a, b); }
    GONIO_FORCE_INLINE static half_double max(half_double a, half_double b) { return vbslq_f64(vcgtq_f64(a, b), a, b); }
    GONIO_FORCE_INLINE static real mul_add(real a, real b, real c) { return vfmaq_f32(c, a, b); }
    GONIO_FORCE_INLINE static half_double mul_add(half_double a, half_double b, half_double c) {
        return vfmaq_f64(c, a, b);
    }
    template<class Mask>
    GONIO_FORCE_INLINE static real select(Mask mask, real a, real b) {
        return vbslq_f32(reinterpret_cast<uint32x4_t>(mask), a, b);
    }
    template<class Mask>
    GONIO_FORCE_INLINE static half_double select(Mask mask, half_double a, half_double b) {
        return vbslq_f64(reinterpret_cast<uint64x2_t>(mask), a, b);
    }
    GONIO_FORCE_INLINE static half_double sqrt(half_double x) { return vsqrtq_f64(x); }
    GONIO_FORCE_INLINE static int sign_bits(half_double x) {
        const uint64x2_t signs = vshrq_n_u64(vreinterpretq_u64_f64(x), 63);
        return static_cast<int>(vgetq_lane_u64(signs, 0) | vgetq_lane_u64(signs, 1) << 1);
    }
    // Bit i is the sign of lane i.
    GONIO_FORCE_INLINE static int sign_bits(real x) {
        const int32x4_t shifts = {0, 1, 2, 3};
        return static_cast<int>(vaddvq_u32(vshlq_u32(vshrq_n_u32(vreinterpretq_u32_f32(x), 31), shifts)));
    }
    static constexpr int all_sign_bits = 0xF;
    GONIO_FORCE_INLINE static half_double low(real x) { return vcvt_f64_f32(vget_low_f32(x)); }
    GONIO_FORCE_INLINE static half_double high(real x) { return vcvt_high_f64_f32(x); }
    GONIO_FORCE_INLINE static real narrow(half_double low, half_double high) {
        return vcombine_f32(vcvt_f32_f64(low), vcvt_f32_f64(high));
    }
    // The chosen lanes, as bits; `store_chosen` writes them side by side and may write garbage up to a register's
    // length.
    using choice = std::uint32_t;
    GONIO_FORCE_INLINE static choice choose(std::uint32_t bits) { return bits; }
    GONIO_FORCE_INLINE static void store_chosen(choice bits, real x, float* to) {
        float lane[4];
        vst1q_f32(&lane[0], x);
        to[0] = lane[0];
        to[bits & 1] = lane[1];
        to[(bits & 1) + ((bits >> 1) & 1)] = lane[2];
        to[(bits & 1) + ((bits >> 1) & 1) + ((bits >> 2) & 1)] = lane[3];
    }
};

} // namespace gonio::simd
