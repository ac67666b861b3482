// Operations that vector extensions cannot express, in the intrinsics of WebAssembly's SIMD.
#pragma once

#include <gonio/simd/instruction_sets.hpp>
#include <gonio/simd/scalar.hpp>

#include <cstddef>
#include <cstdint>
#include <wasm_simd128.h>

namespace gonio::simd {

template<>
struct Native<wasm128> {
    using real [[gnu::vector_size(16)]] = float;
    using half_double [[gnu::vector_size(16)]] = double;

    GONIO_FORCE_INLINE static real sqrt(real x) { return reinterpret_cast<real>(wasm_f32x4_sqrt(v128(x))); }
    // pmin(x, y) is y < x ? y : x. Not min and max, which return NaN if either argument is NaN.
    GONIO_FORCE_INLINE static real min(real a, real b) {
        return reinterpret_cast<real>(wasm_f32x4_pmin(v128(b), v128(a)));
    }
    GONIO_FORCE_INLINE static real max(real a, real b) {
        return reinterpret_cast<real>(wasm_f32x4_pmax(v128(b), v128(a)));
    }
    GONIO_FORCE_INLINE static half_double min(half_double a, half_double b) {
        return reinterpret_cast<half_double>(wasm_f64x2_pmin(v128(b), v128(a)));
    }
    GONIO_FORCE_INLINE static half_double max(half_double a, half_double b) {
        return reinterpret_cast<half_double>(wasm_f64x2_pmax(v128(b), v128(a)));
    }
    GONIO_FORCE_INLINE static real mul_add(real a, real b, real c) { return a * b + c; }
    GONIO_FORCE_INLINE static half_double mul_add(half_double a, half_double b, half_double c) { return a * b + c; }
    template<class Mask>
    GONIO_FORCE_INLINE static real select(Mask mask, real a, real b) {
        return reinterpret_cast<real>(wasm_v128_bitselect(v128(a), v128(b), v128(mask)));
    }
    template<class Mask>
    GONIO_FORCE_INLINE static half_double select(Mask mask, half_double a, half_double b) {
        return reinterpret_cast<half_double>(wasm_v128_bitselect(v128(a), v128(b), v128(mask)));
    }
    GONIO_FORCE_INLINE static half_double sqrt(half_double x) {
        return reinterpret_cast<half_double>(wasm_f64x2_sqrt(v128(x)));
    }
    GONIO_FORCE_INLINE static int sign_bits(half_double x) { return static_cast<int>(wasm_i64x2_bitmask(v128(x))); }
    // Bit i is the sign of lane i.
    GONIO_FORCE_INLINE static int sign_bits(real x) { return static_cast<int>(wasm_i32x4_bitmask(v128(x))); }
    static constexpr int all_sign_bits = 0xF;
    GONIO_FORCE_INLINE static half_double low(real x) {
        return reinterpret_cast<half_double>(wasm_f64x2_promote_low_f32x4(v128(x)));
    }
    GONIO_FORCE_INLINE static half_double high(real x) {
        return low(reinterpret_cast<real>(wasm_i64x2_shuffle(v128(x), v128(x), 1, 1)));
    }
    GONIO_FORCE_INLINE static real narrow(half_double low, half_double high) {
        return reinterpret_cast<real>(wasm_i64x2_shuffle(wasm_f32x4_demote_f64x2_zero(v128(low)),
                                                         wasm_f32x4_demote_f64x2_zero(v128(high)), 0, 2));
    }
    // The chosen lanes, as bits; `store_chosen` writes them side by side and may write garbage up to a register's
    // length.
    using choice = std::uint32_t;
    GONIO_FORCE_INLINE static choice choose(std::uint32_t bits) { return bits; }
    GONIO_FORCE_INLINE static void store_chosen(choice bits, real x, float* to) {
        to[0] = x[0];
        to[bits & 1] = x[1];
        to[(bits & 1) + ((bits >> 1) & 1)] = x[2];
        to[(bits & 1) + ((bits >> 1) & 1) + ((bits >> 2) & 1)] = x[3];
    }

private:
    template<class Vector>
    GONIO_FORCE_INLINE static v128_t v128(Vector x) {
        return reinterpret_cast<v128_t>(x);
    }
};

} // namespace gonio::simd
