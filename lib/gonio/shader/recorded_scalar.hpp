// A scalar that records what is computed with it, for the shading core's templates, and the vocabulary of simd/ for it.
//
// The templates find the vocabulary where they are defined, so this header comes before simd/math.hpp and shading/: use
// recorded.hpp, which includes them in that order. A shader has floats only: the wider scalar is the same one, and what
// the core computes in double is computed in float. `any` and `all` answer so that both sides of a condition are
// recorded, and `select` then decides. Arithmetic belongs to the Recording that is open in this thread.
#pragma once

#include <gonio/shader/graph.hpp>
#include <gonio/simd/scalar.hpp>

namespace gonio::shader {

// Functions that a shader gets beside the one asked for, each if something calls it. helpers.cpp has their bodies: the
// core's templates, recorded once.
enum class Helper : std::uint8_t {
    atan_series,
    atanh_ratio,
    arc_tangent,
    arc_tangent2,
    angle_above,
    arc_cosine,
    sine,
    cosine,
    reciprocal_or_zero,
    normalize_or_zero,
    schlick_weight,
    solid_angle,
    frostbite_cap,
    window_squared,
    horizon_arc
};
inline constexpr std::size_t helper_count = static_cast<std::size_t>(Helper::horizon_arc) + 1;

// While it lives, this thread records into `graph`.
class Recording {
public:
    explicit Recording(Graph& graph);
    ~Recording();
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;
    static Graph& graph();

private:
    Graph* before_;
};

struct RecordedMask {
    NodeId node = no_node;

    friend RecordedMask operator!(RecordedMask a) { return {Recording::graph().unary(Operation::invert, a.node)}; }
};

// The nearest integer to a recorded number, of which the two last binary digits can be read: for quadrants.
struct RecordedInteger {
    NodeId node = no_node; // a whole number
};

struct Recorded {
    NodeId node = no_node;

    Recorded() = default;
    template<class T>
    requires(simd::RealScalar<T> || __is_same(T, int)) explicit Recorded(T number)
        : node(Recording::graph().constant(static_cast<double>(number))) {}
    static Recorded of(NodeId id) {
        Recorded recorded;
        recorded.node = id;
        return recorded;
    }
    static Recorded unary(Operation operation, Recorded a) { return of(Recording::graph().unary(operation, a.node)); }
    static Recorded binary(Operation operation, Recorded a, Recorded b) {
        return of(Recording::graph().binary(operation, a.node, b.node));
    }
    static RecordedMask compare(Operation operation, Recorded a, Recorded b) {
        return {Recording::graph().binary(operation, a.node, b.node)};
    }

    friend Recorded operator+(Recorded a, Recorded b) { return binary(Operation::add, a, b); }
    friend Recorded operator-(Recorded a, Recorded b) { return binary(Operation::subtract, a, b); }
    friend Recorded operator*(Recorded a, Recorded b) { return binary(Operation::multiply, a, b); }
    friend Recorded operator/(Recorded a, Recorded b) { return binary(Operation::divide, a, b); }
    friend Recorded operator-(Recorded a) { return unary(Operation::negate, a); }
    friend RecordedMask operator<(Recorded a, Recorded b) { return compare(Operation::less, a, b); }
    friend RecordedMask operator<=(Recorded a, Recorded b) { return compare(Operation::less_equal, a, b); }
    friend RecordedMask operator>(Recorded a, Recorded b) { return compare(Operation::greater, a, b); }
    friend RecordedMask operator>=(Recorded a, Recorded b) { return compare(Operation::greater_equal, a, b); }
    friend RecordedMask operator==(Recorded a, Recorded b) { return compare(Operation::equal, a, b); }
};

// Limits that the core sets against overflow at 1e38 m; a shader has no such lengths.
inline constexpr double beyond_any_length = 1e15;

Recorded call(Helper helper, Recorded a, Recorded b = {}, Recorded c = {});

inline RecordedInteger operator+(RecordedInteger a, int b) {
    return {(Recorded::of(a.node) + Recorded(b)).node};
}
// n & 1 and n & 2, for whole n of either sign.
inline RecordedInteger operator&(RecordedInteger a, int digit) {
    const Recorded n = Recorded::of(a.node);
    const Recorded period(2 * digit);
    const Recorded rest = n - period * Recorded::unary(Operation::floor, n * (Recorded(1) / period));
    return {Recorded::unary(Operation::floor, rest * (Recorded(1) / Recorded(digit))).node};
}

} // namespace gonio::shader

namespace gonio::simd {

template<>
struct Traits<shader::Recorded> {
    using value = float;
    using mask = shader::RecordedMask;
    using integer = shader::RecordedInteger;
    static constexpr std::size_t lanes = 1;
};
template<>
struct Wider<shader::Recorded> {
    using type = shader::Recorded;
};

inline shader::Recorded widen(shader::Recorded x) {
    return x;
}
inline void narrow(shader::Recorded x, shader::Recorded& to) {
    to = x;
}

inline shader::Recorded select(shader::RecordedMask condition, shader::Recorded if_true, shader::Recorded if_false) {
    return shader::Recorded::of(shader::Recording::graph().select(condition.node, if_true.node, if_false.node));
}
inline shader::RecordedMask both(shader::RecordedMask a, shader::RecordedMask b) {
    return {shader::Recording::graph().binary(shader::Operation::both, a.node, b.node)};
}
inline shader::RecordedMask either(shader::RecordedMask a, shader::RecordedMask b) {
    return {shader::Recording::graph().binary(shader::Operation::either, a.node, b.node)};
}
inline bool any(shader::RecordedMask condition) {
    return !shader::Recording::graph().is_truth(condition.node, false);
}
inline bool all(shader::RecordedMask condition) {
    return shader::Recording::graph().is_truth(condition.node, true);
}

inline shader::Recorded min(shader::Recorded a, shader::Recorded b) {
    if (shader::Recording::graph().is_at_least(b.node, shader::beyond_any_length)) return a;
    return shader::Recorded::binary(shader::Operation::min, a, b);
}
inline shader::Recorded max(shader::Recorded a, shader::Recorded b) {
    return shader::Recorded::binary(shader::Operation::max, a, b);
}
inline shader::Recorded abs(shader::Recorded x) {
    return shader::Recorded::unary(shader::Operation::abs, x);
}
inline shader::Recorded sqrt(shader::Recorded x) {
    return shader::Recorded::unary(shader::Operation::sqrt, x);
}
inline shader::Recorded exp2(shader::Recorded x) {
    return shader::Recorded::unary(shader::Operation::exp2, x);
}
inline shader::Recorded log2(shader::Recorded x) {
    return shader::Recorded::unary(shader::Operation::log2, x);
}
// Compilers of shaders fuse it where that is faster.
inline shader::Recorded mul_add(shader::Recorded a, shader::Recorded b, shader::Recorded c) {
    return a * b + c;
}
// A zero counts as positive.
inline shader::Recorded copysign(shader::Recorded x, shader::Recorded sign) {
    const shader::Recorded magnitude = abs(x);
    return select(sign < shader::Recorded(0), -magnitude, magnitude);
}
inline shader::Recorded difference_of_squares(shader::Recorded x, shader::Recorded y, shader::Recorded z,
                                              shader::Recorded r) {
    return (x * x - r * r) + y * y + z * z;
}
// Of a number to which math.hpp has added 1.5·2²³, which makes its last binary digits those of the nearest integer.
inline shader::RecordedInteger bits(shader::Recorded shifted) {
    return {(shifted - shader::Recorded(12582912.0F)).node};
}
inline void is_nonzero(shader::RecordedInteger digit, shader::RecordedMask& mask) {
    mask = shader::Recorded::of(digit.node) > shader::Recorded(0);
}
// The core scales poses by a power of two against overflow. Shaders stay in metres, within a stated range, so that the
// scale disappears. Rounding does not change.
inline shader::Recorded reciprocal_power_of_two(shader::Recorded /*x*/) {
    return shader::Recorded::of(shader::Recording::graph().free_scale());
}

// Intrinsics of the graphics card may be off by 4096 ulp, so inverse functions are those of math.hpp.
inline shader::Recorded atanh_ratio(shader::Recorded t) {
    return call(shader::Helper::atanh_ratio, t);
}
inline shader::Recorded atan(shader::Recorded x) {
    return call(shader::Helper::arc_tangent, x);
}
inline shader::Recorded atan2(shader::Recorded y, shader::Recorded x) {
    return call(shader::Helper::arc_tangent2, y, x);
}
inline shader::Recorded atan2_above(shader::Recorded y, shader::Recorded x) {
    return call(shader::Helper::angle_above, y, x);
}
inline shader::Recorded acos(shader::Recorded x) {
    return call(shader::Helper::arc_cosine, x);
}
// Of a constant it is a constant.
shader::Recorded sin(shader::Recorded x);
shader::Recorded cos(shader::Recorded x);

namespace detail {
inline shader::Recorded atan_excess_series(shader::Recorded square) {
    return call(shader::Helper::atan_series, square);
}
} // namespace detail

} // namespace gonio::simd
