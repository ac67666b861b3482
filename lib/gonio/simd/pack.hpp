// pack<float, Isa>: as many floats as fit into one register of an instruction set, with the arithmetic of a float.
// pack<double, Isa>: the same number of doubles, with arithmetic only.
//
// `Isa` is a type (sse2, avx2, avx512, neon, wasm128), so it is part of the mangled name of every template that uses
// the pack: code of one set can never be mistaken for that of another. Everything is inlined; nothing fails or
// allocates. The names of scalar.hpp mean the same here, lane by lane.
#pragma once

#include <gonio/simd/instruction_sets.hpp>
#include <gonio/simd/scalar.hpp>

#include <cstddef>
#include <cstdint>

namespace gonio::simd {

// Each lane has all bits set (true) or none.
template<class Isa>
struct mask {
    using vector [[gnu::vector_size(sizeof(std::int32_t) * Isa::lanes)]] = std::int32_t;
    vector m;
};

template<class S, class Isa>
struct pack;

template<class Isa>
struct pack<float, Isa> {
    using isa = Isa;
    using native = Native<Isa>;
    using vector [[gnu::vector_size(sizeof(float) * Isa::lanes)]] = float;
    static constexpr std::size_t lanes = Isa::lanes;

    vector v;

    pack() = default;
    GONIO_FORCE_INLINE pack(vector lanes_of) : v(lanes_of) {}
    // The same number in each lane; a double is rounded to float.
    template<class T>
    requires(RealScalar<T> || __is_same(T, int)) GONIO_FORCE_INLINE explicit pack(T number)
        : v(vector{} + static_cast<float>(number)) {}

    GONIO_FORCE_INLINE friend pack operator+(pack a, pack b) { return pack(a.v + b.v); }
    GONIO_FORCE_INLINE friend pack operator-(pack a, pack b) { return pack(a.v - b.v); }
    GONIO_FORCE_INLINE friend pack operator*(pack a, pack b) { return pack(a.v * b.v); }
    GONIO_FORCE_INLINE friend pack operator/(pack a, pack b) { return pack(a.v / b.v); }
    GONIO_FORCE_INLINE friend pack operator-(pack a) { return pack(-a.v); }

    GONIO_FORCE_INLINE friend mask<Isa> operator<(pack a, pack b) { return {a.v < b.v}; }
    GONIO_FORCE_INLINE friend mask<Isa> operator<=(pack a, pack b) { return {a.v <= b.v}; }
    GONIO_FORCE_INLINE friend mask<Isa> operator>(pack a, pack b) { return {a.v > b.v}; }
    GONIO_FORCE_INLINE friend mask<Isa> operator>=(pack a, pack b) { return {a.v >= b.v}; }
    GONIO_FORCE_INLINE friend mask<Isa> operator==(pack a, pack b) { return {a.v == b.v}; }
};

// As many doubles as a pack of floats has lanes, in two registers, for the few sums that cancel in float.
template<class Isa>
struct pack<double, Isa> {
    using half = typename Native<Isa>::half_double;

    half low, high;

    GONIO_FORCE_INLINE friend pack operator+(pack a, pack b) { return {a.low + b.low, a.high + b.high}; }
    GONIO_FORCE_INLINE friend pack operator-(pack a, pack b) { return {a.low - b.low, a.high - b.high}; }
    GONIO_FORCE_INLINE friend pack operator*(pack a, pack b) { return {a.low * b.low, a.high * b.high}; }
    GONIO_FORCE_INLINE friend pack operator-(pack a) { return {-a.low, -a.high}; }
};

template<class Isa>
struct Wider<pack<float, Isa>> {
    using type = pack<double, Isa>;
};

template<class Isa>
GONIO_FORCE_INLINE pack<double, Isa> widen(pack<float, Isa> x) {
    return {Native<Isa>::low(x.v), Native<Isa>::high(x.v)};
}
template<class Isa>
GONIO_FORCE_INLINE void narrow(pack<double, Isa> x, pack<float, Isa>& to) {
    to.v = Native<Isa>::narrow(x.low, x.high);
}
template<class Isa>
GONIO_FORCE_INLINE pack<double, Isa> mul_add(pack<double, Isa> a, pack<double, Isa> b, pack<double, Isa> c) {
    return {Native<Isa>::mul_add(a.low, b.low, c.low), Native<Isa>::mul_add(a.high, b.high, c.high)};
}

template<class Isa>
struct Traits<pack<float, Isa>> {
    using value = float;
    using mask = simd::mask<Isa>;
    using integer = typename simd::mask<Isa>::vector;
    static constexpr std::size_t lanes = Isa::lanes;
};

template<class Isa>
GONIO_FORCE_INLINE mask<Isa> both(mask<Isa> a, mask<Isa> b) {
    return {a.m & b.m};
}
template<class Isa>
GONIO_FORCE_INLINE mask<Isa> either(mask<Isa> a, mask<Isa> b) {
    return {a.m | b.m};
}
template<class Isa>
GONIO_FORCE_INLINE mask<Isa> operator!(mask<Isa> a) {
    return {~a.m};
}
template<class Isa>
GONIO_FORCE_INLINE bool any(mask<Isa> a) {
    using vector = typename pack<float, Isa>::vector;
    return Native<Isa>::sign_bits(reinterpret_cast<vector>(a.m)) != 0;
}
template<class Isa>
GONIO_FORCE_INLINE bool all(mask<Isa> a) {
    using vector = typename pack<float, Isa>::vector;
    return Native<Isa>::sign_bits(reinterpret_cast<vector>(a.m)) == Native<Isa>::all_sign_bits;
}

template<class Isa>
GONIO_FORCE_INLINE pack<float, Isa> select(mask<Isa> condition, pack<float, Isa> if_true, pack<float, Isa> if_false) {
    return pack<float, Isa>(Native<Isa>::select(condition.m, if_true.v, if_false.v));
}
template<class Isa>
GONIO_FORCE_INLINE pack<float, Isa> min(pack<float, Isa> a, pack<float, Isa> b) {
    return pack<float, Isa>(Native<Isa>::min(a.v, b.v));
}
template<class Isa>
GONIO_FORCE_INLINE pack<float, Isa> max(pack<float, Isa> a, pack<float, Isa> b) {
    return pack<float, Isa>(Native<Isa>::max(a.v, b.v));
}
template<class Isa>
GONIO_FORCE_INLINE pack<float, Isa> sqrt(pack<float, Isa> x) {
    return pack<float, Isa>(Native<Isa>::sqrt(x.v));
}
template<class Isa>
GONIO_FORCE_INLINE pack<float, Isa> mul_add(pack<float, Isa> a, pack<float, Isa> b, pack<float, Isa> c) {
    return pack<float, Isa>(Native<Isa>::mul_add(a.v, b.v, c.v));
}

template<class Isa>
GONIO_FORCE_INLINE typename mask<Isa>::vector bits(pack<float, Isa> x) {
    return reinterpret_cast<typename mask<Isa>::vector>(x.v);
}
template<class Isa>
GONIO_FORCE_INLINE void from_bits(typename mask<Isa>::vector integers, pack<float, Isa>& x) {
    x.v = reinterpret_cast<typename pack<float, Isa>::vector>(integers);
}
template<class Isa>
GONIO_FORCE_INLINE void to_real(typename mask<Isa>::vector integers, pack<float, Isa>& x) {
    x.v = __builtin_convertvector(integers, typename pack<float, Isa>::vector);
}
template<class Isa>
GONIO_FORCE_INLINE void is_nonzero(typename mask<Isa>::vector integers, mask<Isa>& result) {
    result.m = integers != 0;
}

template<class Isa>
GONIO_FORCE_INLINE pack<float, Isa> abs(pack<float, Isa> x) {
    pack<float, Isa> result;
    from_bits(bits(x) & 0x7FFFFFFF, result);
    return result;
}
template<class Isa>
GONIO_FORCE_INLINE pack<float, Isa> copysign(pack<float, Isa> x, pack<float, Isa> sign) {
    pack<float, Isa> result;
    from_bits((bits(x) & 0x7FFFFFFF) | (bits(sign) & ~0x7FFFFFFF), result);
    return result;
}

template<class Isa>
GONIO_FORCE_INLINE pack<float, Isa> difference_of_squares(pack<float, Isa> x, pack<float, Isa> y, pack<float, Isa> z,
                                                          pack<float, Isa> r) {
    const auto dx = widen(x), dy = widen(y), dz = widen(z), dr = widen(r);
    pack<float, Isa> result;
    narrow((dx * dx - dr * dr) + dy * dy + dz * dz, result);
    return result;
}

template<class Isa>
GONIO_FORCE_INLINE pack<float, Isa> reciprocal_power_of_two(pack<float, Isa> x) {
    using integers = typename mask<Isa>::vector;
    const integers exponent = bits(x) & 0x7F800000;
    const integers highest = integers{} + (253 << 23);
    pack<float, Isa> result;
    from_bits((254 << 23) - (exponent > highest ? highest : exponent), result);
    return result;
}

template<class Isa>
GONIO_FORCE_INLINE void load(const float* from, pack<float, Isa>& to) {
    __builtin_memcpy(&to.v, from, sizeof(to.v));
}
template<class Isa>
GONIO_FORCE_INLINE void store(pack<float, Isa> from, float* to) {
    __builtin_memcpy(to, &from.v, sizeof(from.v));
}
template<class Isa>
GONIO_FORCE_INLINE void load_partial(const float* from, std::size_t count, pack<float, Isa>& to) {
    float buffer[Isa::lanes];
    for (std::size_t i = 0; i < Isa::lanes; ++i)
        buffer[i] = from[i < count ? i : count - 1];
    load(&buffer[0], to);
}
template<class Isa>
GONIO_FORCE_INLINE void store_partial(pack<float, Isa> from, float* to, std::size_t count) {
    float buffer[Isa::lanes];
    store(from, &buffer[0]);
    for (std::size_t i = 0; i < count; ++i)
        to[i] = buffer[i];
}
template<class Isa>
GONIO_FORCE_INLINE void load_rounded(const double* from, pack<float, Isa>& to) {
    pack<double, Isa> wide;
    __builtin_memcpy(&wide.low, from, sizeof(wide.low));
    __builtin_memcpy(&wide.high, from + Isa::lanes / 2, sizeof(wide.high));
    narrow(wide, to);
}
template<class Isa>
GONIO_FORCE_INLINE void store_widened(pack<float, Isa> from, double* to) {
    const pack<double, Isa> wide = widen(from);
    __builtin_memcpy(to, &wide.low, sizeof(wide.low));
    __builtin_memcpy(to + Isa::lanes / 2, &wide.high, sizeof(wide.high));
}

// Bit i is set if lane i is set.
template<class Isa>
GONIO_FORCE_INLINE std::uint32_t lane_bits(mask<Isa> a) {
    return static_cast<std::uint32_t>(Native<Isa>::sign_bits(reinterpret_cast<typename pack<float, Isa>::vector>(a.m)));
}

// Lanes chosen by bits. `store_chosen` writes them to `to` side by side, in order; it may overwrite the space after
// them, up to a whole pack's length, with garbage.
template<class S>
struct Choice;
template<class Isa>
struct Choice<pack<float, Isa>> {
    typename Native<Isa>::choice lanes;
    GONIO_FORCE_INLINE explicit Choice(std::uint32_t bits) : lanes(Native<Isa>::choose(bits)) {}
};
template<class Isa>
GONIO_FORCE_INLINE void store_chosen(const Choice<pack<float, Isa>>& which, pack<float, Isa> from, float* to) {
    Native<Isa>::store_chosen(which.lanes, from.v, to);
}

} // namespace gonio::simd
