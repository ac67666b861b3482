// twin<pack>: two packs side by side as one scalar, for formulas with long dependency chains that stall the processor.
//
// A chain of divisions, roots and polynomials keeps a unit busy only part of the time; two independent chains fill the
// gaps. A formula of a thousand instructions is too long for the processor to find the next independent one by itself.
// The names of scalar.hpp mean the same here, lane by lane; `any` and `all` test both packs.
#pragma once

#include <gonio/simd/pack.hpp>

#include <cstddef>
#include <cstdint>

namespace gonio::simd {

template<class P>
struct twin_mask {
    mask_of<P> a, b;
};

// The integers of both packs; P is a parameter so that the instruction set is part of the type's name.
template<class P>
struct twin_integer {
    integer_of<P> a, b;

    GONIO_FORCE_INLINE friend twin_integer operator+(twin_integer x, twin_integer y) { return {x.a + y.a, x.b + y.b}; }
    GONIO_FORCE_INLINE friend twin_integer operator-(twin_integer x, twin_integer y) { return {x.a - y.a, x.b - y.b}; }
    GONIO_FORCE_INLINE friend twin_integer operator+(twin_integer x, std::int32_t y) { return {x.a + y, x.b + y}; }
    GONIO_FORCE_INLINE friend twin_integer operator-(twin_integer x, std::int32_t y) { return {x.a - y, x.b - y}; }
    GONIO_FORCE_INLINE friend twin_integer operator&(twin_integer x, std::int32_t y) { return {x.a & y, x.b & y}; }
    GONIO_FORCE_INLINE friend twin_integer operator<<(twin_integer x, int bits) { return {x.a << bits, x.b << bits}; }
    GONIO_FORCE_INLINE friend twin_integer operator>>(twin_integer x, int bits) { return {x.a >> bits, x.b >> bits}; }
};

// P is a pack of floats, or the corresponding type in double.
template<class P>
struct twin {
    P a, b;

    twin() = default;
    GONIO_FORCE_INLINE twin(P first, P second) : a(first), b(second) {}
    // The same number in each lane.
    template<class T>
    requires(RealScalar<T> || __is_same(T, int)) GONIO_FORCE_INLINE explicit twin(T number) : a(number), b(number) {}

    GONIO_FORCE_INLINE friend twin operator+(twin x, twin y) { return {x.a + y.a, x.b + y.b}; }
    GONIO_FORCE_INLINE friend twin operator-(twin x, twin y) { return {x.a - y.a, x.b - y.b}; }
    GONIO_FORCE_INLINE friend twin operator*(twin x, twin y) { return {x.a * y.a, x.b * y.b}; }
    GONIO_FORCE_INLINE friend twin operator/(twin x, twin y) { return {x.a / y.a, x.b / y.b}; }
    GONIO_FORCE_INLINE friend twin operator-(twin x) { return {-x.a, -x.b}; }

    GONIO_FORCE_INLINE friend twin_mask<P> operator<(twin x, twin y) { return {x.a < y.a, x.b < y.b}; }
    GONIO_FORCE_INLINE friend twin_mask<P> operator<=(twin x, twin y) { return {x.a <= y.a, x.b <= y.b}; }
    GONIO_FORCE_INLINE friend twin_mask<P> operator>(twin x, twin y) { return {x.a > y.a, x.b > y.b}; }
    GONIO_FORCE_INLINE friend twin_mask<P> operator>=(twin x, twin y) { return {x.a >= y.a, x.b >= y.b}; }
    GONIO_FORCE_INLINE friend twin_mask<P> operator==(twin x, twin y) { return {x.a == y.a, x.b == y.b}; }
};

template<class P>
struct Traits<twin<P>> {
    using value = float;
    using mask = twin_mask<P>;
    using integer = twin_integer<P>;
    static constexpr std::size_t lanes = 2 * Traits<P>::lanes;
};
template<class P>
struct Wider<twin<P>> {
    using type = twin<wider<P>>;
};

template<class P>
GONIO_FORCE_INLINE twin_mask<P> both(twin_mask<P> x, twin_mask<P> y) {
    return {both(x.a, y.a), both(x.b, y.b)};
}
template<class P>
GONIO_FORCE_INLINE twin_mask<P> either(twin_mask<P> x, twin_mask<P> y) {
    return {either(x.a, y.a), either(x.b, y.b)};
}
template<class P>
GONIO_FORCE_INLINE twin_mask<P> operator!(twin_mask<P> x) {
    return {!x.a, !x.b};
}
template<class P>
GONIO_FORCE_INLINE bool any(twin_mask<P> x) {
    return any(either(x.a, x.b));
}
template<class P>
GONIO_FORCE_INLINE bool all(twin_mask<P> x) {
    return all(both(x.a, x.b));
}

template<class P>
GONIO_FORCE_INLINE twin<P> select(twin_mask<P> condition, twin<P> if_true, twin<P> if_false) {
    return {select(condition.a, if_true.a, if_false.a), select(condition.b, if_true.b, if_false.b)};
}
template<class P>
GONIO_FORCE_INLINE twin<P> min(twin<P> x, twin<P> y) {
    return {min(x.a, y.a), min(x.b, y.b)};
}
template<class P>
GONIO_FORCE_INLINE twin<P> max(twin<P> x, twin<P> y) {
    return {max(x.a, y.a), max(x.b, y.b)};
}
template<class P>
GONIO_FORCE_INLINE twin<P> sqrt(twin<P> x) {
    return {sqrt(x.a), sqrt(x.b)};
}
template<class P>
GONIO_FORCE_INLINE twin<P> mul_add(twin<P> x, twin<P> y, twin<P> z) {
    return {mul_add(x.a, y.a, z.a), mul_add(x.b, y.b, z.b)};
}
template<class P>
GONIO_FORCE_INLINE twin<P> abs(twin<P> x) {
    return {abs(x.a), abs(x.b)};
}
template<class P>
GONIO_FORCE_INLINE twin<P> copysign(twin<P> x, twin<P> sign) {
    return {copysign(x.a, sign.a), copysign(x.b, sign.b)};
}
template<class P>
GONIO_FORCE_INLINE twin<P> difference_of_squares(twin<P> x, twin<P> y, twin<P> z, twin<P> r) {
    return {difference_of_squares(x.a, y.a, z.a, r.a), difference_of_squares(x.b, y.b, z.b, r.b)};
}
template<class P>
GONIO_FORCE_INLINE twin<P> reciprocal_power_of_two(twin<P> x) {
    return {reciprocal_power_of_two(x.a), reciprocal_power_of_two(x.b)};
}

template<class P>
GONIO_FORCE_INLINE twin_integer<P> bits(twin<P> x) {
    return {bits(x.a), bits(x.b)};
}
template<class P>
GONIO_FORCE_INLINE void from_bits(twin_integer<P> integers, twin<P>& x) {
    from_bits(integers.a, x.a);
    from_bits(integers.b, x.b);
}
template<class P>
GONIO_FORCE_INLINE void to_real(twin_integer<P> integers, twin<P>& x) {
    to_real(integers.a, x.a);
    to_real(integers.b, x.b);
}
template<class P>
GONIO_FORCE_INLINE void is_nonzero(twin_integer<P> integers, twin_mask<P>& result) {
    is_nonzero(integers.a, result.a);
    is_nonzero(integers.b, result.b);
}

template<class P>
GONIO_FORCE_INLINE twin<wider<P>> widen(twin<P> x) {
    return {widen(x.a), widen(x.b)};
}
template<class P>
GONIO_FORCE_INLINE void narrow(twin<wider<P>> x, twin<P>& to) {
    narrow(x.a, to.a);
    narrow(x.b, to.b);
}

template<class P>
GONIO_FORCE_INLINE void load(const float* from, twin<P>& to) {
    load(from, to.a);
    load(from + Traits<P>::lanes, to.b);
}
template<class P>
GONIO_FORCE_INLINE void store(twin<P> from, float* to) {
    store(from.a, to);
    store(from.b, to + Traits<P>::lanes);
}
template<class P>
GONIO_FORCE_INLINE void load_partial(const float* from, std::size_t count, twin<P>& to) {
    constexpr std::size_t lanes = Traits<P>::lanes;
    const bool second = count > lanes;
    load_partial(from, second ? lanes : count, to.a);
    load_partial(second ? from + lanes : from + count - 1, second ? count - lanes : 1, to.b);
}
template<class P>
GONIO_FORCE_INLINE void store_partial(twin<P> from, float* to, std::size_t count) {
    constexpr std::size_t lanes = Traits<P>::lanes;
    store_partial(from.a, to, count > lanes ? lanes : count);
    if (count > lanes) store_partial(from.b, to + lanes, count - lanes);
}

template<class P>
GONIO_FORCE_INLINE std::uint32_t lane_bits(twin_mask<P> x) {
    return lane_bits(x.a) | (lane_bits(x.b) << Traits<P>::lanes);
}
template<class P>
struct Choice<twin<P>> {
    Choice<P> a, b;
    std::uint32_t count_a;
    GONIO_FORCE_INLINE explicit Choice(std::uint32_t bits)
        : a(bits & low), b(bits >> Traits<P>::lanes), count_a(bit_count(bits & low)) {}

private:
    static constexpr std::uint32_t low = (std::uint32_t{1} << Traits<P>::lanes) - 1;
};
template<class P>
GONIO_FORCE_INLINE void store_chosen(const Choice<twin<P>>& which, twin<P> from, float* to) {
    store_chosen(which.a, from.a, to);
    store_chosen(which.b, from.b, to + which.count_a);
}

// A twin for a pack; a single float stays single.
template<class S>
struct Paired {
    using type = S;
};
template<class Isa>
struct Paired<pack<float, Isa>> {
    using type = twin<pack<float, Isa>>;
};
template<class S>
using paired = typename Paired<S>::type;

// The pack type of a twin; other types stay the same.
template<class S>
struct Half {
    using type = S;
};
template<class P>
struct Half<twin<P>> {
    using type = P;
};
template<class S>
using half = typename Half<S>::type;

} // namespace gonio::simd
