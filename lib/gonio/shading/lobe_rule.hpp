// The rules by which rows of points (lobe_rows.hpp) divide an angle.
#pragma once

#include <gonio/shading/vec2.hpp>
#include <gonio/simd/loop.hpp>

#include <cstddef>
#include <iterator>
#include <type_traits>

namespace gonio::shading::detail {

// A pair ±at of points of a rule on [-1, 1].
template<class Number>
struct AnglePairOf {
    Number weight, at;
};
using AnglePair = AnglePairOf<float>;
template<std::size_t pairs>
struct SymmetricRule {
    AnglePair pair[pairs];

    static constexpr std::size_t size() { return 2 * pairs; }
};
// Pairs of two rules. The second has fewer points, and its further pairs no weight.
template<class Number>
struct EitherPairOf {
    Number weight, at, few_weight, few_at;
};
using EitherPair = EitherPairOf<float>;
template<std::size_t pairs>
struct EitherRule {
    EitherPair pair[pairs];

    static constexpr std::size_t size() { return 2 * pairs; }
};
// Gauss–Legendre where nothing else is said. Members of a template on the scalar: nothing here may be shared between
// instruction sets.
template<class S>
struct LobeRule {
    static constexpr SymmetricRule<2> four{{{0.65214515F, 0.33998104F}, {0.34785485F, 0.86113631F}}};
    static constexpr SymmetricRule<3> six{
        {{0.46791393F, 0.23861919F}, {0.36076157F, 0.66120939F}, {0.17132449F, 0.93246951F}}};
    // Eight, or four that are exact for a polynomial of x of degree 3 and for another times √(1 − x²).
    static constexpr EitherRule<4> eight_or_four{{{0.36268378F, 0.18343464F, 0.74945408F, 0.40470353F},
                                                  {0.31370665F, 0.52553241F, 0.25054592F, 0.91678828F},
                                                  {0.22238103F, 0.79666648F, 0.0F, 0.0F},
                                                  {0.10122854F, 0.96028986F, 0.0F, 0.0F}}};
    // For a function that begins and ends like a root: exact for √(1 − x²) times a polynomial of x of degree 11
    // (Gauss–Chebyshev of the second kind, its weights over that root).
    static constexpr SymmetricRule<3> six_of_roots{
        {{0.43754662F, 0.22252093F}, {0.35088515F, 0.6234898F}, {0.19472657F, 0.90096887F}}};
};

// The points of a rule by their angles, from the least to the greatest; of an EitherRule, of its first.
template<std::size_t count, class Pair>
struct AngleRule {
    Pair at[count];
};
constexpr AnglePair mirrored(const AnglePair& pair) {
    return {pair.weight, -pair.at};
}
constexpr EitherPair mirrored(const EitherPair& pair) {
    return {pair.weight, -pair.at, pair.few_weight, -pair.few_at};
}
template<const auto& rule>
constexpr auto in_order() {
    AngleRule<rule.size(), std::remove_cvref_t<decltype(rule.pair[0])>> all{};
    constexpr std::size_t pairs = std::size(rule.pair);
    for (std::size_t i = 0; i < pairs; ++i) {
        all.at[rule.size() - pairs + i] = rule.pair[i];
        all.at[pairs - 1 - i] = mirrored(rule.pair[i]);
    }
    return all;
}

// A pair as numbers of S; of two rules, in each lane of one of them.
template<class S, class Number>
GONIO_FORCE_INLINE AnglePairOf<S> pair_of(const AnglePairOf<Number>& pair, simd::mask_of<S> /*takes_few*/) {
    return {S(pair.weight), S(pair.at)};
}
template<class S, class Number>
GONIO_FORCE_INLINE AnglePairOf<S> pair_of(const EitherPairOf<Number>& pair, simd::mask_of<S> takes_few) {
    return {simd::select(takes_few, S(pair.few_weight), S(pair.weight)),
            simd::select(takes_few, S(pair.few_at), S(pair.at))};
}

// The directions between two in a plane, at most half a turn apart.
template<class S>
struct Fan {
    vec2<S> middle, beside; // unit, perpendicular
    S half;                 // half the angle, within 4e-5 of it

    // `from` and `to` are unit.
    GONIO_FORCE_INLINE Fan(vec2<S> from, vec2<S> to) {
        const vec2<S> sum = from + to;
        const S sum2 = dot(sum, sum);
        // Opposite directions leave their sum to rounding.
        const auto opposite = sum2 < S(1e-6);
        const S length = simd::sqrt(simd::select(opposite, S(1), sum2));
        const vec2<S> bisector = select(opposite, vec2<S>{-from.y, from.x}, sum * (S(1) / length));
        const S across = S(0.5) * cross(bisector, to - from); // the sine of half
        set(bisector, across / (S(1) + simd::select(opposite, S(0), S(0.5) * length)));
    }
    // From the direction of (1, from) to that of (1, to), −1e4 ≤ from ≤ to ≤ 1e4.
    GONIO_FORCE_INLINE Fan(S from, S to) {
        const S a = simd::sqrt(simd::mul_add(from, from, S(1)));
        const S b = simd::sqrt(simd::mul_add(to, to, S(1)));
        const vec2<S> sum{a + b, simd::mul_add(from, b, to * a)}; // 2ab cos(half) long
        const S length = simd::sqrt(dot(sum, sum));
        const S twice = S(2) * a * b;
        const S inverse = S(1) / (length * (twice + length));
        set(sum * (inverse * (twice + length)), (to - from) * inverse * twice);
    }
    // Of an angle up to 0.94·π/2; sine and cosine are within 5e-6 (minimax).
    struct Turn {
        S sine, cosine;
    };
    GONIO_FORCE_INLINE static Turn turn(S angle) {
        const S square = angle * angle;
        return {
            angle * simd::detail::polynomial(square, 0.99999954F, -0.16665984F, 0.0083175814F, -0.00018673332F),
            simd::mul_add(simd::detail::polynomial(square, -0.49995528F, 0.041541302F, -0.0012884766F), square, S(1))};
    }
    // work(direction, its share of the whole angle) for each point of a rule, in one loop.
    template<std::size_t count, class Pair, class Work>
    GONIO_FORCE_INLINE void for_each(const AngleRule<count, Pair>& rule, simd::mask_of<S> takes_few,
                                     const Work& work) const {
        simd::for_each_of<S>(rule.at, [&](const auto& point) {
            const AnglePairOf<S> pair = pair_of<S>(point, takes_few);
            const auto [sine, cosine] = turn(half * pair.at);
            work(middle * cosine + beside * sine, half * pair.weight);
        });
    }
    // The directions of a rule, and their shares of the whole angle.
    template<class Rule>
    GONIO_FORCE_INLINE void divide(const Rule& rule, simd::mask_of<S> takes_few, vec2<S>* at, S* share) const {
        for (const auto& of_rule : rule.pair) {
            const AnglePairOf<S> pair = pair_of<S>(of_rule, takes_few);
            const auto [sine, cosine] = turn(half * pair.at);
            *at++ = middle * cosine - beside * sine;
            *at++ = middle * cosine + beside * sine;
            *share++ = half * pair.weight;
            *share++ = half * pair.weight;
        }
    }

private:
    // `t` is the tangent of half of `half`.
    GONIO_FORCE_INLINE void set(vec2<S> bisector, S t) {
        middle = bisector;
        beside = {-middle.y, middle.x};
        half = t * simd::detail::polynomial(t * t, 2.0F, -0.6666094F, 0.39708839F, -0.26035562F, 0.13668811F,
                                            -0.036046437F);
    }
};

} // namespace gonio::shading::detail
