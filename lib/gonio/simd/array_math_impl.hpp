// The bodies of array_math.hpp for one scalar. Included only by kernels_math_<set>.cpp.
#pragma once

#include <gonio/simd/array_math.hpp>
#include <gonio/simd/math.hpp>

#include <cstddef>
#include <cstdint>

namespace gonio::simd::detail {

template<class S, class Function>
void map(const float* x, float* result, std::size_t count) {
    constexpr std::size_t lanes = Traits<S>::lanes;
    std::size_t i = 0;
    S a;
    for (; i + lanes <= count; i += lanes) {
        load(x + i, a);
        store(Function::of(a), result + i);
    }
    if (i < count) {
        load_partial(x + i, count - i, a);
        store_partial(Function::of(a), result + i, count - i);
    }
}

template<class S, class Function>
void map(const float* x, const float* y, float* result, std::size_t count) {
    constexpr std::size_t lanes = Traits<S>::lanes;
    std::size_t i = 0;
    S a, b;
    for (; i + lanes <= count; i += lanes) {
        load(x + i, a);
        load(y + i, b);
        store(Function::of(a, b), result + i);
    }
    if (i < count) {
        load_partial(x + i, count - i, a);
        load_partial(y + i, count - i, b);
        store_partial(Function::of(a, b), result + i, count - i);
    }
}

#define GONIO_UNARY(name)                                                                                              \
    template<class S>                                                                                                  \
    struct name##_function {                                                                                           \
        GONIO_FORCE_INLINE static S of(S x) { return simd::name(x); }                                                  \
    };
#define GONIO_BINARY(name)                                                                                             \
    template<class S>                                                                                                  \
    struct name##_function {                                                                                           \
        GONIO_FORCE_INLINE static S of(S a, S b) { return simd::name(a, b); }                                          \
    };
GONIO_UNARY(sqrt)
GONIO_UNARY(exp2)
GONIO_UNARY(sin)
GONIO_UNARY(cos)
GONIO_UNARY(asin)
GONIO_UNARY(acos)
GONIO_UNARY(atan)
GONIO_UNARY(atan_excess)
GONIO_UNARY(atan_ratio_excess)
GONIO_UNARY(atanh_ratio)
GONIO_UNARY(reciprocal_power_of_two)
GONIO_BINARY(min)
GONIO_BINARY(max)
GONIO_BINARY(atan2)
GONIO_BINARY(atan2_above)
GONIO_BINARY(copysign)
#undef GONIO_UNARY
#undef GONIO_BINARY

// simd::log2 works on the bits of a number without a sign, and pow relies on that; here any float may occur.
template<class S>
struct log2_function {
    GONIO_FORCE_INLINE static S of(S x) { return select(x < S(0), S(__builtin_nanf("")), simd::log2(abs(x))); }
};
template<class S>
struct pow_function {
    GONIO_FORCE_INLINE static S of(S x, S y) {
        return select(x < S(0), select(y == S(0), S(1), S(__builtin_nanf(""))), simd::pow(abs(x), y));
    }
};

template<class S>
struct difference_of_squares_function {
    GONIO_FORCE_INLINE static S of(S x, S r) { return simd::difference_of_squares(x, S(0.25), S(0.5), r); }
};

template<class S>
struct wide_product_less_function {
    GONIO_FORCE_INLINE static S of(S a, S b) {
        const auto wide = simd::widen(b);
        S result;
        simd::narrow(simd::widen(a) * wide - wide, result);
        return result;
    }
};

template<class S>
struct choose_greater_function {
    GONIO_FORCE_INLINE static S of(S a, S b) {
        if constexpr (Traits<S>::lanes == 1) {
            return select(a > b, a, S(0));
        } else {
            constexpr std::size_t lanes = Traits<S>::lanes;
            float chosen[2 * lanes];
            const std::uint32_t bits = lane_bits(a > b);
            store_chosen(Choice<S>(bits), a, &chosen[0]);
            for (std::size_t i = bit_count(bits); i < lanes; ++i)
                chosen[i] = 0.0F;
            S result;
            load(&chosen[0], result);
            return result;
        }
    }
};

template<class S>
constexpr ArrayMath array_math_of(InstructionSet set) {
    return {set,
            Traits<S>::lanes,
            map<S, sqrt_function<S>>,
            map<S, exp2_function<S>>,
            map<S, log2_function<S>>,
            map<S, sin_function<S>>,
            map<S, cos_function<S>>,
            map<S, asin_function<S>>,
            map<S, acos_function<S>>,
            map<S, atan_function<S>>,
            map<S, atan_excess_function<S>>,
            map<S, atan_ratio_excess_function<S>>,
            map<S, atanh_ratio_function<S>>,
            map<S, reciprocal_power_of_two_function<S>>,
            map<S, min_function<S>>,
            map<S, max_function<S>>,
            map<S, atan2_function<S>>,
            map<S, atan2_above_function<S>>,
            map<S, pow_function<S>>,
            map<S, copysign_function<S>>,
            map<S, difference_of_squares_function<S>>,
            map<S, wide_product_less_function<S>>,
            map<S, choose_greater_function<S>>};
}

extern const ArrayMath array_math_scalar;
extern const ArrayMath array_math_twin_scalar; // the same: one lane has no twin
extern const ArrayMath array_math_sse2;
extern const ArrayMath array_math_twin_sse2;
extern const ArrayMath array_math_avx2;
extern const ArrayMath array_math_twin_avx2;
extern const ArrayMath array_math_avx512;
extern const ArrayMath array_math_twin_avx512;
extern const ArrayMath array_math_neon;
extern const ArrayMath array_math_twin_neon;
extern const ArrayMath array_math_wasm128;
extern const ArrayMath array_math_twin_wasm128;

} // namespace gonio::simd::detail
