// Elementary functions for one float, one double and packs of floats, under the same names.
//
// Floats and packs share the polynomials below (minimax, printed by fit/minimax.cpp), so a pack differs from the float
// only in the rounding of mul_add; doubles call the C library. The error bounds are in ulp of the exact result, hold on
// every instruction set and are tested (tests/unit/simd/math_test.cpp); MEASURED.md has the measured errors. Outside
// its domain a function returns what its comment states. A NaN argument gives NaN unless stated otherwise.
#pragma once

#include <gonio/simd/twin.hpp>

namespace gonio::simd {

// A float or a pack of floats.
template<class S>
concept SinglePrecision = __is_same(value_of<S>, float);

namespace detail {

// c0 + c1·t + … by Horner's rule.
template<class S>
GONIO_FORCE_INLINE S polynomial(S /*t*/, float last) {
    return S(last);
}
template<class S, class... Rest>
GONIO_FORCE_INLINE S polynomial(S t, float first, float second, Rest... rest) {
    return mul_add(polynomial(t, second, rest...), t, S(first));
}

// asin(x) for 0 ≤ x ≤ 1/2, given x² too.
template<class S>
GONIO_FORCE_INLINE S asin_small(S x, S x2) {
    return mul_add(x * x2, polynomial(x2, 0.166667521F, 0.0749529749F, 0.0454703756F, 0.0241795145F, 0.0421663076F), x);
}

// (atan(x) − x)/x³, given x² ≤ 1. Evaluated in halves and quarters (G. Estrin, 1960) instead of by Horner's rule, which
// would make half of the time of an inverse function a wait for this result.
template<class S>
GONIO_FORCE_INLINE S atan_excess_series(S square) {
    // Below this bound the result does not change, and t⁴ and its multiples, which are rounded separately without FMA,
    // would be subnormal, which is slow.
    const S t = max(square, S(1e-8F));
    const S t2 = t * t;
    const S low = mul_add(t2, polynomial(t, -0.142789081F, 0.11036396F), polynomial(t, -0.333333313F, 0.199997559F));
    const S high =
        mul_add(t2, polynomial(t, -0.0361159481F, 0.0136559475F), polynomial(t, -0.0866695791F, 0.0627121776F));
    const S t4 = t2 * t2;
    return mul_add(t4, mul_add(t4, S(-0.00242356909F), high), low);
}

template<class S>
GONIO_FORCE_INLINE S power_of_two(integer_of<S> exponent) {
    S result;
    from_bits((exponent + 127) << 23, result);
    return result;
}

template<class S>
struct SinCosParts {
    S sine, cosine;
    integer_of<S> quadrant;
};

// x = quadrant·π/2 + y with |y| ≤ π/4 (Cody and Waite, three parts), and both functions of y.
template<class S>
GONIO_FORCE_INLINE SinCosParts<S> sin_cos_parts(S x) {
    constexpr float round_to_integer = 12582912.0F; // 1.5·2²³
    const S shifted = mul_add(x, S(0.636619772F), S(round_to_integer));
    const S n = shifted - S(round_to_integer);
    S y = x - n * S(1.5703125F);
    y = y - n * S(4.8375129699707031e-4F);
    y = y - n * S(7.5497899548918822e-8F);
    const S y2 = y * y;
    const S sine = mul_add(y * y2, polynomial(y2, -0.166666552F, 0.0083321603F, -0.000195152039F), y);
    const S even = polynomial(y2, 0.0416666456F, -0.00138873153F, 2.44330677e-05F);
    const S cosine = mul_add(y2 * y2, even, S(1) - S(0.5F) * y2);
    return {sine, cosine, bits(shifted)};
}

template<class S>
GONIO_FORCE_INLINE S pick_quadrant(const SinCosParts<S>& parts, integer_of<S> quadrant) {
    mask_of<S> odd, upper;
    is_nonzero(quadrant & 1, odd);
    is_nonzero(quadrant & 2, upper);
    const S value = select(odd, parts.cosine, parts.sine);
    return select(upper, -value, value);
}

} // namespace detail

// atan(x) − x for 0 ≤ x ≤ 1, with a small relative error: no cancellation for small x. ≤ 6 ulp for floats; in double ≤
// 1e-13.
template<SinglePrecision S>
GONIO_FORCE_INLINE S atan_excess(S x) {
    const S t = x * x;
    return x * t * detail::atan_excess_series(t);
}
GONIO_FORCE_INLINE double atan_excess(double x) {
    if (x > 0.25) return __builtin_atan(x) - x;
    const double t = x * x;
    double sum = 0.0;
    for (int k = 14; k >= 1; --k)
        sum = (k % 2 == 0 ? 1.0 : -1.0) / (2 * k + 1) + t * sum;
    return x * t * sum;
}

// atan(√t)/√t − 1 for 0 ≤ t ≤ 1, with a small relative error. ≤ 4 ulp for floats; in double ≤ 1e-13.
template<SinglePrecision S>
GONIO_FORCE_INLINE S atan_ratio_excess(S t) {
    return t * detail::atan_excess_series(t);
}
GONIO_FORCE_INLINE double atan_ratio_excess(double t) {
    const double x = __builtin_sqrt(t);
    return x > 0.0 ? atan_excess(x) / x : 0.0;
}

// atanh(√t)/√t for 0 ≤ t ≤ 1/4: ≤ 2 ulp for floats.
template<SinglePrecision S>
GONIO_FORCE_INLINE S atanh_ratio(S t) {
    return mul_add(t, detail::polynomial(t, 0.333337307F, 0.199782163F, 0.146691427F, 0.082437031F, 0.181740075F),
                   S(1));
}
GONIO_FORCE_INLINE double atanh_ratio(double t) {
    const double x = __builtin_sqrt(t);
    return x < 1e-5 ? 1.0 + t / 3.0 : __builtin_atanh(x) / x;
}

// ≤ 3 ulp for any x.
template<SinglePrecision S>
GONIO_FORCE_INLINE S atan(S x) {
    const S magnitude = abs(x);
    const auto steep = magnitude > S(1);
    const S t = select(steep, S(1) / magnitude, magnitude);
    const S angle = mul_add(t, atan_ratio_excess(t * t), t);
    return copysign(select(steep, S(1.57079637F) - angle, angle), x);
}
GONIO_FORCE_INLINE double atan(double x) {
    return __builtin_atan(x);
}

// The angle of (x, y) in [−π, π]. ≤ 4 ulp for finite x and y; (±0, any zero) is ±0, and x = −0 counts as +0.
template<SinglePrecision S>
GONIO_FORCE_INLINE S atan2(S y, S x) {
    const S ax = abs(x);
    const S ay = abs(y);
    const auto steep = ay > ax;
    const S larger = select(steep, ay, ax);
    const S t = select(steep, ax, ay) / select(larger > S(0), larger, S(1));
    S angle = mul_add(t, atan_ratio_excess(t * t), t); // t³ alone might be subnormal, which is slow
    angle = select(steep, S(1.57079637F) - angle, angle);
    angle = select(x < S(0), S(3.14159274F) - angle, angle);
    return copysign(angle, y);
}
// The same for y ≥ 0 (and −0), in [0, π]: a tenth faster. Values below 1e-37 count as 0; NaN stays NaN.
template<SinglePrecision S>
GONIO_FORCE_INLINE S atan2_above(S y, S x) {
    const S ax = abs(x);
    const S t = min(ax, y) / max(max(ax, y), S(1e-37F));
    S angle = mul_add(t, atan_ratio_excess(t * t), t); // t³ alone might be subnormal, which is slow
    angle = select(y > ax, S(1.57079637F) - angle, angle);
    return select(x < S(0), S(3.14159274F) - angle, angle);
}
GONIO_FORCE_INLINE double atan2_above(double y, double x) {
    return __builtin_atan2(abs(y), x + 0.0);
}
GONIO_FORCE_INLINE double atan2(double y, double x) {
    return __builtin_atan2(y, x + 0.0);
}

// ≤ 3 ulp; |x| above 1 counts as 1.
template<SinglePrecision S>
GONIO_FORCE_INLINE S asin(S x) {
    const S magnitude = min(abs(x), S(1));
    const auto steep = magnitude > S(0.5F);
    const S half = S(0.5F) * (S(1) - magnitude);
    const S t = select(steep, sqrt(half), magnitude);
    const S angle = detail::asin_small(t, select(steep, half, magnitude * magnitude));
    return copysign(select(steep, S(1.57079637F) - (angle + angle), angle), x);
}
GONIO_FORCE_INLINE double asin(double x) {
    return __builtin_asin(max(min(x, 1.0), -1.0));
}

// ≤ 3 ulp; |x| above 1 counts as 1.
template<SinglePrecision S>
GONIO_FORCE_INLINE S acos(S x) {
    const S magnitude = min(abs(x), S(1));
    const auto steep = magnitude > S(0.5F);
    const S half = S(0.5F) * (S(1) - magnitude);
    const S t = select(steep, sqrt(half), magnitude);
    const S angle = detail::asin_small(t, select(steep, half, magnitude * magnitude));
    const S of_steep = select(x < S(0), S(3.14159274F) - (angle + angle), angle + angle);
    return select(steep, of_steep, S(1.57079637F) - copysign(angle, x));
}
GONIO_FORCE_INLINE double acos(double x) {
    return __builtin_acos(max(min(x, 1.0), -1.0));
}

// |x| ≤ 8192: absolute error ≤ 1.2e-7, and ≤ 3 ulp for |x| ≤ π/4. Beyond it the reduction loses digits.
template<SinglePrecision S>
GONIO_FORCE_INLINE S sin(S x) {
    const auto parts = detail::sin_cos_parts(x);
    return detail::pick_quadrant(parts, parts.quadrant);
}
GONIO_FORCE_INLINE double sin(double x) {
    return __builtin_sin(x);
}

// As sin; ≤ 2 ulp for |x| ≤ π/4.
template<SinglePrecision S>
GONIO_FORCE_INLINE S cos(S x) {
    const auto parts = detail::sin_cos_parts(x);
    return detail::pick_quadrant(parts, parts.quadrant + 1);
}
GONIO_FORCE_INLINE double cos(double x) {
    return __builtin_cos(x);
}

// ≤ 2 ulp while the result is a normal number; smaller results eventually become 0, and from 128 on the result is
// infinity.
template<SinglePrecision S>
GONIO_FORCE_INLINE S exp2(S x) {
    constexpr float round_to_integer = 12582912.0F; // 1.5·2²³
    const S clamped = min(max(x, S(-151)), S(129));
    const S shifted = clamped + S(round_to_integer);
    const S fraction = clamped - (shifted - S(round_to_integer));
    const S power = mul_add(fraction,
                            detail::polynomial(fraction, 0.693147182F, 0.240226477F, 0.0555033237F, 0.00961843692F,
                                               0.00133988739F, 0.00015353362F),
                            S(1));
    // In two steps: 2ⁿ alone may be too large or too small for a float even if the result is not.
    const integer_of<S> n = bits(shifted) - 0x4B400000;
    const integer_of<S> half = n >> 1;
    const S result = power * detail::power_of_two<S>(half) * detail::power_of_two<S>(n - half);
    return select(x == x, result, x); // NOLINT(misc-redundant-expression): false for a NaN
}
GONIO_FORCE_INLINE double exp2(double x) {
    return __builtin_exp2(x);
}

// ≤ 3 ulp for positive finite x; 0 gives −∞, x < 0 NaN, +∞ is outside the domain.
template<SinglePrecision S>
GONIO_FORCE_INLINE S log2(S x) {
    constexpr float least_normal = 1.17549435e-38F;
    const auto tiny = x < S(least_normal);
    const S scaled = select(tiny, x * S(33554432.0F), x);
    const integer_of<S> exponent = (bits(scaled) - 0x3F3504F3) >> 23; // of x / √½
    S m, e;
    from_bits(bits(scaled) - (exponent << 23), m);
    to_real(exponent, e);
    e = select(tiny, e - S(25), e);
    const S f = m - S(1);
    const S f2 = f * f;
    const S tail = mul_add(f * f2,
                           detail::polynomial(f, 0.333333135F, -0.250000089F, 0.200021192F, -0.166679963F, 0.142195523F,
                                              -0.124055885F, 0.11888162F, -0.116756521F, 0.0674664229F),
                           S(-0.5F) * f2);
    // log₂e = 1 + 0.4427: multiplication by the larger part is exact.
    constexpr float log2_e_less_1 = 0.442695041F;
    const S result = mul_add(tail, S(log2_e_less_1), f * S(log2_e_less_1)) + tail + f + e;
    const S infinity = S(__builtin_inff());
    return select(x > S(0), result, select(x == S(0), -infinity, S(__builtin_nanf(""))));
}
GONIO_FORCE_INLINE double log2(double x) {
    return __builtin_log2(x);
}

// x^y for x ≥ 0: ≤ 4 + 3·|y·log₂x| ulp where the result is a normal number. x⁰ = 1, 0^y = 0 for y > 0, NaN for x < 0.
template<SinglePrecision S>
GONIO_FORCE_INLINE S pow(S x, S y) {
    return select(y == S(0), S(1), exp2(y * log2(x)));
}
GONIO_FORCE_INLINE double pow(double x, double y) {
    return __builtin_pow(x, y);
}

} // namespace gonio::simd
