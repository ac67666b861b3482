// doubles<Isa>: as many doubles as fit into one register of an instruction set, with the arithmetic of a double, for
// geometry whose digits do not fit into a float.
//
// The names of scalar.hpp mean the same here, lane by lane, except that nothing is fused: every set gives the bits of
// a plain double. Everything is inlined; nothing fails or allocates.
#pragma once

#include <gonio/simd/pack.hpp>
#include <gonio/simd/scalar.hpp>

#include <cstddef>
#include <cstdint>

namespace gonio::simd {

// Each lane has all bits set (true) or none.
template<class Isa>
struct doubles_mask {
    using vector [[gnu::vector_size(sizeof(float) * Isa::lanes)]] = std::int64_t;
    vector m;

    GONIO_FORCE_INLINE friend doubles_mask operator!(doubles_mask a) { return {~a.m}; }
};

template<class Isa>
struct doubles {
    using vector [[gnu::vector_size(sizeof(float) * Isa::lanes)]] = double;
    using mask = doubles_mask<Isa>;
    static constexpr std::size_t lanes = Isa::lanes / 2;

    vector v;

    doubles() = default;
    GONIO_FORCE_INLINE doubles(vector lanes_of) : v(lanes_of) {}
    // The same number in each lane.
    template<class T>
    requires(RealScalar<T> || __is_same(T, int)) GONIO_FORCE_INLINE explicit doubles(T number)
        : v(static_cast<double>(number) - vector{}) {} // keeps the sign of 0

    GONIO_FORCE_INLINE friend doubles operator+(doubles a, doubles b) { return doubles(a.v + b.v); }
    GONIO_FORCE_INLINE friend doubles operator-(doubles a, doubles b) { return doubles(a.v - b.v); }
    GONIO_FORCE_INLINE friend doubles operator*(doubles a, doubles b) { return doubles(a.v * b.v); }
    GONIO_FORCE_INLINE friend doubles operator/(doubles a, doubles b) { return doubles(a.v / b.v); }
    GONIO_FORCE_INLINE friend doubles operator-(doubles a) { return doubles(-a.v); }

    GONIO_FORCE_INLINE friend mask operator<(doubles a, doubles b) { return as_mask(a.v < b.v); }
    GONIO_FORCE_INLINE friend mask operator<=(doubles a, doubles b) { return as_mask(a.v <= b.v); }
    GONIO_FORCE_INLINE friend mask operator>(doubles a, doubles b) { return as_mask(a.v > b.v); }
    GONIO_FORCE_INLINE friend mask operator>=(doubles a, doubles b) { return as_mask(a.v >= b.v); }
    GONIO_FORCE_INLINE friend mask operator==(doubles a, doubles b) { return as_mask(a.v == b.v); }

private:
    template<class Compared>
    GONIO_FORCE_INLINE static mask as_mask(Compared compared) { // compilers disagree about the type of the lanes
        return {reinterpret_cast<typename mask::vector>(compared)};
    }
};

template<class Isa>
struct Traits<doubles<Isa>> {
    using value = double;
    using mask = doubles_mask<Isa>;
    static constexpr std::size_t lanes = Isa::lanes / 2;
};

template<class Isa>
GONIO_FORCE_INLINE doubles_mask<Isa> both(doubles_mask<Isa> a, doubles_mask<Isa> b) {
    return {a.m & b.m};
}
template<class Isa>
GONIO_FORCE_INLINE doubles_mask<Isa> either(doubles_mask<Isa> a, doubles_mask<Isa> b) {
    return {a.m | b.m};
}
template<class Isa>
GONIO_FORCE_INLINE int lane_bits(doubles_mask<Isa> a) { // bit i is set if lane i is set
    return Native<Isa>::sign_bits(reinterpret_cast<typename Native<Isa>::half_double>(a.m));
}
template<class Isa>
GONIO_FORCE_INLINE bool any(doubles_mask<Isa> a) {
    return lane_bits(a) != 0;
}
template<class Isa>
GONIO_FORCE_INLINE bool all(doubles_mask<Isa> a) {
    return lane_bits(a) == (1 << doubles<Isa>::lanes) - 1;
}

template<class Isa>
GONIO_FORCE_INLINE doubles<Isa> select(doubles_mask<Isa> condition, doubles<Isa> if_true, doubles<Isa> if_false) {
    return doubles<Isa>(Native<Isa>::select(condition.m, if_true.v, if_false.v));
}
template<class Isa>
GONIO_FORCE_INLINE doubles<Isa> min(doubles<Isa> a, doubles<Isa> b) {
    return doubles<Isa>(Native<Isa>::min(a.v, b.v));
}
template<class Isa>
GONIO_FORCE_INLINE doubles<Isa> max(doubles<Isa> a, doubles<Isa> b) {
    return doubles<Isa>(Native<Isa>::max(a.v, b.v));
}
template<class Isa>
GONIO_FORCE_INLINE doubles<Isa> sqrt(doubles<Isa> x) {
    return doubles<Isa>(Native<Isa>::sqrt(x.v));
}
template<class Isa>
GONIO_FORCE_INLINE doubles<Isa> mul_add(doubles<Isa> a, doubles<Isa> b, doubles<Isa> c) {
    return a * b + c;
}

// All bits of a double but its sign.
inline constexpr std::int64_t magnitude_bits = 0x7FFFFFFFFFFFFFFF;

template<class Isa>
GONIO_FORCE_INLINE doubles<Isa> copysign(doubles<Isa> x, doubles<Isa> sign) {
    using bits = typename doubles_mask<Isa>::vector;
    return doubles<Isa>(reinterpret_cast<typename doubles<Isa>::vector>(
        (reinterpret_cast<bits>(x.v) & magnitude_bits) | (reinterpret_cast<bits>(sign.v) & ~magnitude_bits)));
}
template<class Isa>
GONIO_FORCE_INLINE doubles<Isa> abs(doubles<Isa> x) {
    using bits = typename doubles_mask<Isa>::vector;
    return doubles<Isa>(reinterpret_cast<typename doubles<Isa>::vector>(reinterpret_cast<bits>(x.v) & magnitude_bits));
}

template<class Isa>
GONIO_FORCE_INLINE void load(const double* from, doubles<Isa>& to) {
    __builtin_memcpy(&to.v, from, sizeof(to.v));
}
template<class Isa>
GONIO_FORCE_INLINE void store(doubles<Isa> from, double* to) {
    __builtin_memcpy(to, &from.v, sizeof(from.v));
}
template<class Isa>
GONIO_FORCE_INLINE void load_partial(const double* from, std::size_t count, doubles<Isa>& to) {
    double buffer[doubles<Isa>::lanes];
    for (std::size_t i = 0; i < doubles<Isa>::lanes; ++i)
        buffer[i] = from[i < count ? i : count - 1];
    load(&buffer[0], to);
}
template<class Isa>
GONIO_FORCE_INLINE void store_partial(doubles<Isa> from, double* to, std::size_t count) {
    double buffer[doubles<Isa>::lanes];
    store(from, &buffer[0]);
    for (std::size_t i = 0; i < count; ++i)
        to[i] = buffer[i];
}

// The type for geometry in double where kernels are compiled for S: `double`, or `doubles` of its set.
template<class S>
struct InDouble {
    using type = double;
};
template<class Isa>
struct InDouble<pack<float, Isa>> {
    using type = doubles<Isa>;
};
template<class S>
using in_double = typename InDouble<S>::type;

} // namespace gonio::simd
