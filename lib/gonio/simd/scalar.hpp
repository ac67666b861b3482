// The vocabulary of the shading core's templates, for one float or one double.
//
// pack.hpp overloads the same names for packs. With calls such as `simd::sqrt(x)` a template reads the same for all
// three. Comparisons of floats give bool, comparisons of packs a mask; both are combined with `both`, `either`, `!` and
// tested with `any` and `all`. No std:: functions here: the linker might keep the copy of an inline function that was
// compiled for a wide instruction set, and use it on every machine.
#pragma once

#include <cstddef>
#include <cstdint>

#ifdef GONIO_INLINE_BY_SIZE // for one instruction set: what is large is called
#define GONIO_FORCE_INLINE inline
#else
#define GONIO_FORCE_INLINE [[gnu::always_inline]] inline
#endif

namespace gonio::simd {

template<class S>
struct Traits; // value: the type of one lane; mask; integer: the same number of 32-bit integers; lanes

template<>
struct Traits<float> {
    using value = float;
    using mask = bool;
    using integer = std::int32_t;
    static constexpr std::size_t lanes = 1;
};

template<>
struct Traits<double> {
    using value = double;
    using mask = bool;
    static constexpr std::size_t lanes = 1;
};

template<class S>
using value_of = typename Traits<S>::value;
template<class S>
using mask_of = typename Traits<S>::mask;
template<class S>
using integer_of = typename Traits<S>::integer;

template<class T>
concept RealScalar = __is_same(T, float) || __is_same(T, double);

template<RealScalar T>
GONIO_FORCE_INLINE T select(bool condition, T if_true, T if_false) {
    return condition ? if_true : if_false;
}
GONIO_FORCE_INLINE bool both(bool a, bool b) {
    return a && b;
}
GONIO_FORCE_INLINE bool either(bool a, bool b) {
    return a || b;
}
GONIO_FORCE_INLINE bool any(bool condition) {
    return condition;
}
GONIO_FORCE_INLINE bool all(bool condition) {
    return condition;
}

// b if a or b is NaN. So max(x, 0) turns a NaN into 0.
template<RealScalar T>
GONIO_FORCE_INLINE T min(T a, T b) {
    return a < b ? a : b;
}
template<RealScalar T>
GONIO_FORCE_INLINE T max(T a, T b) {
    return a > b ? a : b;
}

GONIO_FORCE_INLINE float abs(float x) {
    return __builtin_fabsf(x);
}
GONIO_FORCE_INLINE double abs(double x) {
    return __builtin_fabs(x);
}

// Correctly rounded; NaN for x below 0.
GONIO_FORCE_INLINE float sqrt(float x) {
    return __builtin_sqrtf(x);
}
GONIO_FORCE_INLINE double sqrt(double x) {
    return __builtin_sqrt(x);
}

// a·b + c, rounded once where the instruction set supports it (avx2, avx512, neon) and twice elsewhere. Use it for
// speed, never for an exact remainder.
template<RealScalar T>
GONIO_FORCE_INLINE T mul_add(T a, T b, T c) {
    return a * b + c;
}

// The magnitude of x with the sign bit of `sign`.
GONIO_FORCE_INLINE float copysign(float x, float sign) {
    return __builtin_copysignf(x, sign);
}
GONIO_FORCE_INLINE double copysign(double x, double sign) {
    return __builtin_copysign(x, sign);
}

// x² + y² + z² − r² without cancellation. For floats it is computed in double, with an error of at most 2⁻⁵² of r²; for
// doubles in doubled precision (T. J. Dekker, Numerische Mathematik 18, 1971).
GONIO_FORCE_INLINE float difference_of_squares(float x, float y, float z, float r) {
    const double dx = x, dy = y, dz = z, dr = r;
    return static_cast<float>((dx * dx - dr * dr) + dy * dy + dz * dz);
}
GONIO_FORCE_INLINE double difference_of_squares(double x, double y, double z, double r) {
    const double products[4] = {x * x, -(r * r), y * y, z * z};
    double low = (__builtin_fma(x, x, -products[0]) - __builtin_fma(r, r, products[1])) +
                 (__builtin_fma(y, y, -products[2]) + __builtin_fma(z, z, -products[3]));
    double high = products[0];
    for (int i = 1; i < 4; ++i) {
        const double sum = high + products[i];
        const double part = sum - high;
        low += (high - (sum - part)) + (products[i] - part);
        high = sum;
    }
    return high + low;
}

// The power of two p with 1 ≤ x·p < 2. For 0 and subnormal x it is the largest power of two, and for the top binade the
// smallest normal one (x·p < 4). Multiplying by p is exact. x ≥ 0, finite.
GONIO_FORCE_INLINE float reciprocal_power_of_two(float x) {
    constexpr std::int32_t exponent_bits = 0x7F800000;
    std::int32_t exponent = __builtin_bit_cast(std::int32_t, x) & exponent_bits;
    if (exponent > (253 << 23)) exponent = 253 << 23;
    return __builtin_bit_cast(float, (254 << 23) - exponent);
}
GONIO_FORCE_INLINE double reciprocal_power_of_two(double x) {
    constexpr std::int64_t exponent_bits = 0x7FF0000000000000;
    std::int64_t exponent = __builtin_bit_cast(std::int64_t, x) & exponent_bits;
    if (exponent > (std::int64_t{2045} << 52)) exponent = std::int64_t{2045} << 52;
    return __builtin_bit_cast(double, (std::int64_t{2046} << 52) - exponent);
}

// The double type for intermediate results of S, where differences cancel: widen, compute, narrow.
template<class S>
struct Wider {
    using type = double;
};
template<class S>
using wider = typename Wider<S>::type;

GONIO_FORCE_INLINE double widen(float x) {
    return static_cast<double>(x);
}
GONIO_FORCE_INLINE double widen(double x) {
    return x;
}
GONIO_FORCE_INLINE void narrow(double x, float& to) {
    to = static_cast<float>(x);
}
GONIO_FORCE_INLINE void narrow(double x, double& to) {
    to = x;
}

// Loads and stores; the partial ones take the first `count` (1 … lanes) elements; partial loads repeat the last of them
// in the other lanes.
template<RealScalar T>
GONIO_FORCE_INLINE void load(const T* from, T& to) {
    to = *from;
}
template<RealScalar T>
GONIO_FORCE_INLINE void load_partial(const T* from, std::size_t /*count*/, T& to) {
    to = *from;
}
template<RealScalar T>
GONIO_FORCE_INLINE void store(T from, T* to) {
    *to = from;
}
template<RealScalar T>
GONIO_FORCE_INLINE void store_partial(T from, T* to, std::size_t /*count*/) {
    *to = from;
}
// From and to doubles, one for each lane.
template<RealScalar T>
GONIO_FORCE_INLINE void load_rounded(const double* from, T& to) {
    to = static_cast<T>(*from);
}
template<RealScalar T>
GONIO_FORCE_INLINE void store_widened(T from, double* to) {
    *to = static_cast<double>(from);
}

// The number of set bits: one instruction if the set has it, and otherwise no library call.
GONIO_FORCE_INLINE std::uint32_t bit_count(std::uint32_t bits) {
#if defined(__POPCNT__) || defined(__aarch64__) || defined(__wasm__)
    return static_cast<std::uint32_t>(__builtin_popcount(bits));
#else
    bits -= (bits >> 1) & 0x55555555U;
    bits = (bits & 0x33333333U) + ((bits >> 2) & 0x33333333U);
    return (((bits + (bits >> 4)) & 0x0F0F0F0FU) * 0x01010101U) >> 24;
#endif
}

// Integers of the width of float, for the bit work in math.hpp.
GONIO_FORCE_INLINE std::int32_t bits(float x) {
    return __builtin_bit_cast(std::int32_t, x);
}
GONIO_FORCE_INLINE void from_bits(std::int32_t integer, float& x) {
    x = __builtin_bit_cast(float, integer);
}
GONIO_FORCE_INLINE void to_real(std::int32_t integer, float& x) {
    x = static_cast<float>(integer);
}
GONIO_FORCE_INLINE void is_nonzero(std::int32_t integer, bool& mask) {
    mask = integer != 0;
}

} // namespace gonio::simd
