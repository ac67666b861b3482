// The integral of a lobe over the directions in which a receiver sees a light, along rows of points that the lobe
// places.
//
// A linearly transformed cosine (ltc_lobe.hpp) takes the lobe almost to a cosine, and the light's cone of directions to
// another convex cone. That cone is cut into half planes through an axis A that is perpendicular to the cosine's axis
// z' and parallel to the boundary nearest to it: B cos ψ + A sin ψ, where B is at the angle ω about A. The rows, over
// ω, are placed as if the lobe were the cosine. Along a row, 1 + (tan θ_h/α)² of the half vector (the denominator of
// GGX, whose square is in the lobe) is nearly a quadratic polynomial of τ = tan ψ, so the points are placed as if it
// were: at equal steps of the angle whose tangent is (τ − τ_min)/width. At each point the lobe itself is evaluated, so
// nothing of the fit is left but the places. A row ends exactly at the light's outline and at the receiver's horizon.
//
// Directions here are in the receiver's frame (ltc_frame), and primed ones in the transformed space. Nothing fails:
// finite input gives finite sums.
#pragma once

#include <gonio/shading/light_points.hpp>
#include <gonio/shading/lights.hpp>
#include <gonio/shading/ltc_share.hpp>
#include <gonio/shading/vec2.hpp>
#include <gonio/simd/loop.hpp>

#include <cstddef>
#include <iterator>
#include <utility>

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
    float middle = 0.0F; // the weight of a point at 0, if there is one

    constexpr std::size_t size() const { return 2 * pairs + (middle > 0.0F ? 1 : 0); }
};
// Gauss–Legendre but for one. Members of a template on the scalar: nothing here may be shared between instruction sets.
template<class S>
struct LobeRule {
    static constexpr SymmetricRule<2> four{{{0.65214515F, 0.33998104F}, {0.34785485F, 0.86113631F}}};
    static constexpr SymmetricRule<2> five{{{0.47862867F, 0.53846931F}, {0.23692689F, 0.90617985F}}, 0.56888889F};
    static constexpr SymmetricRule<3> six{
        {{0.46791393F, 0.23861919F}, {0.36076157F, 0.66120939F}, {0.17132449F, 0.93246951F}}};
    static constexpr SymmetricRule<4> eight{{{0.36268378F, 0.18343464F},
                                             {0.31370665F, 0.52553241F},
                                             {0.22238103F, 0.79666648F},
                                             {0.10122854F, 0.96028986F}}};
    // For a function that begins and ends like a root: exact for √(1 − x²) times a polynomial of x of degree 11
    // (Gauss–Chebyshev of the second kind, its weights over that root).
    static constexpr SymmetricRule<3> six_of_roots{
        {{0.43754662F, 0.22252093F}, {0.35088515F, 0.6234898F}, {0.19472657F, 0.90096887F}}};
};

// The points of a rule by their angles, from the least to the greatest.
template<std::size_t count>
struct AngleRule {
    AnglePair at[count];
};
template<const auto& rule>
constexpr AngleRule<rule.size()> in_order() {
    AngleRule<rule.size()> all{};
    constexpr std::size_t pairs = std::size(rule.pair);
    for (std::size_t i = 0; i < pairs; ++i) {
        all.at[rule.size() - pairs + i] = rule.pair[i];
        all.at[pairs - 1 - i] = {rule.pair[i].weight, -rule.pair[i].at};
    }
    if (rule.middle > 0.0F) all.at[pairs] = {rule.middle, 0.0F};
    return all;
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
    // work(direction, its share of the whole angle) for both points of a pair.
    template<class Work>
    GONIO_FORCE_INLINE void for_both(const AnglePair& pair, const Work& work) const {
        const auto [sine, cosine] = turn(half * S(pair.at));
        work(middle * cosine - beside * sine, half * S(pair.weight));
        work(middle * cosine + beside * sine, half * S(pair.weight));
    }
    // The same for all points of a rule in one loop.
    template<std::size_t count, class Work>
    GONIO_FORCE_INLINE void for_each(const AngleRule<count>& rule, const Work& work) const {
        simd::for_each_of<S>(rule.at, [&](const auto& point) {
            const auto [sine, cosine] = turn(half * S(point.at));
            work(middle * cosine + beside * sine, half * S(point.weight));
        });
    }
    // All points of a rule, with their shares of the whole angle.
    template<std::size_t pairs>
    GONIO_FORCE_INLINE void divide(const SymmetricRule<pairs>& rule, vec2<S>* at, S* share) const {
        if (rule.middle > 0.0F) {
            *at++ = middle;
            *share++ = half * S(rule.middle);
        }
        for (const AnglePair& pair : rule.pair)
            for_both(
                pair, [&](vec2<S> direction, S angle) __attribute__((always_inline)) {
                    *at++ = direction;
                    *share++ = angle;
                });
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

// The part of a row inside a region: τ from `from` to `to`, nothing where `to` is not greater.
template<class S>
struct RowPart {
    S from, to;

    static constexpr double far = 1e12;

    GONIO_FORCE_INLINE static RowPart all() { return {S(-far), S(far)}; }
    // The part on the positive side of a plane, given its normal's components along B and A.
    GONIO_FORCE_INLINE void keep(S along_b, S along_a) {
        const S inverse = S(-1) / simd::select(along_a == S(0), S(1), along_a); // the same for all rows
        const S crossing = along_b * inverse;
        from = simd::select(along_a > S(0), simd::max(from, crossing), from);
        to = simd::select(along_a < S(0), simd::min(to, crossing), to);
    }
};

// The nearer of two planes to z', by their unit normals.
template<class S>
GONIO_FORCE_INLINE vec3<S> nearer_plane(vec3<S> a, vec3<S> b) {
    return select(b.z < a.z, b, a);
}

// The circle's plane that touches the cone where it is nearest to z', or nearly there, unit; `rim` is u' × v', `by_cos`
// c' × v' and `by_sin` u' × c' of the cone c' + u' cos t + v' sin t, with rim·c' > 0.
template<class S>
GONIO_FORCE_INLINE vec3<S> touching_plane(vec3<S> rim, vec3<S> by_cos, vec3<S> by_sin) {
    const S h = simd::sqrt(simd::mul_add(by_cos.z, by_cos.z, by_sin.z * by_sin.z));
    const auto tilted = h > S(1e-18);
    const S inverse = S(1) / simd::select(tilted, h, S(1));
    const S cosine = simd::select(tilted, by_cos.z * inverse, S(1));
    return normalized(rim - by_cos * cosine - by_sin * (by_sin.z * inverse));
}

// Regions: convex cones of directions above the receiver's horizon. Each has
//     nearest                    the unit normal, inwards, of a plane that touches it near z'
//     for_each_extreme(A, work)  work(p', whether p is in the region, or on its outline) for points that include those
//                                of the greatest and least ω about A; work also gets all ω where A is in the region
//     row(B, A)                  the part of a row
//     rows, along_row            the rules over ω and along a row
//     has_corners                whether the length of a row, over ω, has kinks, which a rule does not know

// A rectangle. The patch's centre, u and v are in the receiver's frame.
template<class S>
struct RectangleRegion {
    static constexpr const auto& rows = LobeRule<S>::four;
    static constexpr const auto& along_row = LobeRule<S>::five;
    static constexpr bool has_corners = true;

    vec3<S> corner[4];
    S up[4];              // their heights above the horizon
    simd::mask_of<S> cut; // one is below
    vec3<S> edge[4];
    vec3<S> horizon;
    vec3<S> nearest;

    template<bool sheared>
    GONIO_FORCE_INLINE RectangleRegion(const LtcLobe<S, sheared>& lobe, const RectanglePoints<S>& points)
        : horizon(lobe.horizon()) {
        const vec3<S>& c = points.patch.center;
        const vec3<S>& u = points.patch.u;
        const vec3<S>& v = points.patch.v;
        const vec3<S> c1 = lobe(c);
        const vec3<S> u1 = lobe(u);
        const vec3<S> v1 = lobe(v);
        corner[0] = c1 - u1 - v1;
        corner[1] = c1 + u1 - v1;
        corner[2] = c1 + u1 + v1;
        corner[3] = c1 - u1 + v1;
        up[0] = c.z - u.z - v.z;
        up[1] = c.z + u.z - v.z;
        up[2] = c.z + u.z + v.z;
        up[3] = c.z - u.z + v.z;
        const S sign = simd::copysign(S(1), dot(c, cross(u, v)));
        edge[0] = normalized(cross(corner[0], u1) * sign);
        edge[1] = normalized(cross(corner[1], v1) * sign);
        edge[2] = normalized(cross(u1, corner[2]) * sign);
        edge[3] = normalized(cross(v1, corner[3]) * sign);
        nearest = nearer_plane(nearer_plane(edge[0], edge[1]), nearer_plane(edge[2], edge[3]));
        cut = simd::min(simd::min(up[0], up[1]), simd::min(up[2], up[3])) < S(0);
        nearest = select(cut, nearer_plane(nearest, horizon), nearest);
    }

    template<class Work>
    GONIO_FORCE_INLINE void for_each_extreme(vec3<S> /*axis*/, const Work& work) const {
        for (std::size_t i = 0; i < 4; ++i)
            work(corner[i], up[i] >= S(0));
        if (!simd::any(cut)) return;
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t next = (i + 1) % 4;
            const auto crosses =
                simd::either(simd::both(up[i] >= S(0), up[next] < S(0)), simd::both(up[i] < S(0), up[next] >= S(0)));
            const S t = up[i] / simd::select(crosses, up[i] - up[next], S(1));
            work(corner[i] + (corner[next] - corner[i]) * t, crosses);
        }
    }
    GONIO_FORCE_INLINE RowPart<S> row(vec3<S> base, vec3<S> axis) const {
        RowPart<S> part = RowPart<S>::all();
        for (const vec3<S>& normal : edge)
            part.keep(dot(normal, base), dot(normal, axis));
        part.keep(dot(horizon, base), dot(horizon, axis));
        return part;
    }
};

// The cone of a circle c + u cos t + v sin t, before it is cut by the horizon.
template<class S>
struct CircleCone {
    vec3<S> c1, u1, v1;      // transformed
    vec3<S> rim, by_u, by_v; // p' = (rim·p' c' + by_u·p' u' + by_v·p' v')/(rim·c'), rim·c' > 0
    CircleCut<S> horizon;

    template<bool sheared>
    GONIO_FORCE_INLINE CircleCone(const LtcLobe<S, sheared>& lobe, vec3<S> c, vec3<S> u, vec3<S> v)
        : c1(lobe(c)), u1(lobe(u)), v1(lobe(v)), horizon(c.z, u.z, v.z) {
        const S sign = simd::copysign(S(1), dot(c, cross(u, v)));
        rim = cross(u1, v1) * sign;
        by_u = cross(v1, c1) * sign;
        by_v = cross(c1, u1) * sign;
    }
    GONIO_FORCE_INLINE vec3<S> touching() const { return touching_plane(rim, by_u * S(-1), by_v * S(-1)); }

    template<class Work>
    GONIO_FORCE_INLINE void for_each_extreme(vec3<S> axis, const Work& work) const {
        const S a0 = dot(axis, rim);
        const S a1 = dot(axis, by_u);
        const S a2 = dot(axis, by_v);
        const S h2 = simd::mul_add(a1, a1, a2 * a2);
        const S outside = h2 - a0 * a0; // of the axis
        const auto touched = outside > S(0);
        const S inverse = S(1) / simd::max(h2, S(1e-36));
        const S root = simd::sqrt(simd::max(outside, S(0)));
        const auto at = [&](S cosine, S sine) { return c1 + u1 * cosine + v1 * sine; };
        for (int sign = -1; sign <= 1; sign += 2) {
            const S cosine = simd::mul_add(a1, a0, S(-sign) * a2 * root) * inverse;
            const S sine = simd::mul_add(a2, a0, S(sign) * a1 * root) * inverse;
            const S beside = cosine * horizon.cos_middle + sine * horizon.sin_middle;
            const auto above = simd::both(!horizon.below, simd::either(!horizon.cut, beside >= horizon.cos_reach));
            work(at(cosine, sine), simd::both(touched, above));
        }
        work(at(horizon.cos_sink(), horizon.sin_sink()), horizon.cut);
        work(at(horizon.cos_rise(), horizon.sin_rise()), horizon.cut);
        work.all(simd::both(!touched, !horizon.below));
    }
    // The row's part without the horizon; at infinity, with no length, where the row would meet the cone beyond ±A.
    // `plane` is B × A.
    GONIO_FORCE_INLINE RowPart<S> row(vec3<S> base, vec3<S> axis, vec3<S> plane) const {
        const S a0 = dot(axis, rim);
        const S a1 = dot(axis, by_u);
        const S a2 = dot(axis, by_v);
        const S b0 = dot(base, rim);
        const S b1 = dot(base, by_u);
        const S b2 = dot(base, by_v);
        // a τ² + 2 b τ + … ≤ 0 inside; the discriminant by the distance of the row's plane from c'.
        const S a = simd::mul_add(a1, a1, a2 * a2) - a0 * a0;
        const S b = simd::mul_add(a1, b1, a2 * b2) - a0 * b0;
        const S from_u = dot(plane, u1);
        const S from_v = dot(plane, v1);
        const S from_c = dot(plane, c1);
        const S across = simd::mul_add(from_u, from_u, from_v * from_v) - from_c * from_c;
        const S root = simd::abs(dot(rim, c1)) * simd::sqrt(simd::max(across, S(0)));
        const auto crossed = across > S(0);
        const auto outside = a > S(0); // the axis, of the cone
        const S c = simd::mul_add(b1, b1, b2 * b2) - b0 * b0;
        const S q = -(b + simd::copysign(root, b));                    // neither root cancels
        const S inverse = S(1) / simd::select(a == S(0), S(1e-30), a); // the same for all rows
        const S one = q * inverse;
        const S other = c / simd::select(q == S(0), S(1e-30), q);
        const S low = simd::min(one, other);
        const S high = simd::max(one, other);
        // Where the axis is in the cone, or in its mirror image, one of both is in the image.
        const auto ahead = a0 > S(0);
        RowPart<S> part{simd::select(outside, low, simd::select(ahead, high, S(-RowPart<S>::far))),
                        simd::select(outside, high, simd::select(ahead, S(RowPart<S>::far), low))};
        const auto near_side = simd::either(!outside, simd::mul_add(a0, S(0.5) * (low + high), b0) > S(0));
        // A cone behind the axis, or behind −A.
        const S behind = simd::copysign(S(RowPart<S>::far), dot(axis, c1));
        part.from = simd::select(near_side, part.from, behind);
        part.to = simd::select(near_side, part.to, behind);
        part.from = simd::select(crossed, part.from, S(RowPart<S>::far));
        part.to = simd::select(crossed, part.to, S(-RowPart<S>::far));
        return part;
    }
};

// A sphere, a disk or the sun; `inside`: the whole hemisphere.
template<class S>
struct CircleRegion {
    static constexpr const auto& rows = LobeRule<S>::six_of_roots;
    static constexpr const auto& along_row = LobeRule<S>::six;
    static constexpr bool has_corners = false;

    CircleCone<S> cone;
    vec3<S> horizon;
    vec3<S> nearest;

    template<bool sheared>
    GONIO_FORCE_INLINE CircleRegion(const LtcLobe<S, sheared>& lobe, const DiskPoints<S>& points)
        : cone(lobe, points.patch.center, points.patch.u, points.patch.v),
          horizon(lobe.horizon()),
          nearest(cone.touching()) {
        nearest = select(cone.horizon.cut, nearer_plane(nearest, horizon), nearest);
    }
    template<class Work>
    GONIO_FORCE_INLINE void for_each_extreme(vec3<S> axis, const Work& work) const {
        cone.for_each_extreme(axis, work);
    }
    GONIO_FORCE_INLINE RowPart<S> row(vec3<S> base, vec3<S> axis) const {
        RowPart<S> part = cone.row(base, axis, cross(base, axis));
        part.keep(dot(horizon, base), dot(horizon, axis));
        return part;
    }
};

// A tube in the receiver's frame, all lengths scaled by the same factor: its centre is toward·across + axis·along.
template<class S>
struct TubeSeen {
    vec3<S> axis, toward; // unit, perpendicular
    S across, along;
    S radius, half;

    template<class Frame>
    GONIO_FORCE_INLINE TubeSeen(const TubeLight<S>& light, const Frame& frame, vec3<S> to_center) {
        const S scale = points_scale(light, to_center);
        const vec3<S> c = frame(to_center) * scale;
        axis = frame(light.axis);
        along = dot(axis, c);
        const vec3<S> away = perpendicular(c, axis);
        across = length(away);
        toward = away * reciprocal_or_zero(across);
        radius = simd::abs(light.radius) * scale;
        half = S(0.5) * (simd::abs(light.length) * scale);
    }
    GONIO_FORCE_INLINE vec3<S> center() const { return toward * across + axis * along; }
};

// A tube: the convex hull of its ends' cones.
template<class S>
struct TubeRegion {
    static constexpr const auto& rows = LobeRule<S>::eight;
    static constexpr const auto& along_row = LobeRule<S>::six;
    static constexpr bool has_corners = false;

    CircleCone<S> end[2];
    vec3<S> touch[2][2]; // where the side's two tangent planes touch the ends
    S up[2][2];
    vec3<S> side[2]; // the planes' normals, inwards
    vec3<S> horizon;
    vec3<S> nearest;
    simd::mask_of<S> beyond; // in the infinite cylinder: only one end is seen

    template<bool sheared>
    GONIO_FORCE_INLINE TubeRegion(const LtcLobe<S, sheared>& lobe, const TubeSeen<S>& tube)
        : end{end_of(lobe, tube, -1.0), end_of(lobe, tube, 1.0)}, horizon(lobe.horizon()) {
        const vec3<S> axis1 = lobe(tube.axis);
        beyond = tube.across <= tube.radius;
        const S gap2 = simd::max((tube.across - tube.radius) * (tube.across + tube.radius), S(0));
        const S inverse = reciprocal_or_zero(tube.across);
        const S base = gap2 * inverse;
        const S aside = tube.radius * simd::sqrt(gap2) * inverse;
        const vec3<S> toward1 = lobe(tube.toward);
        const vec3<S> beside = cross(tube.axis, tube.toward);
        const vec3<S> beside1 = lobe(beside);
        for (std::size_t k = 0; k < 2; ++k) {
            const S sign = S(k == 0 ? 1 : -1);
            for (std::size_t i = 0; i < 2; ++i) {
                const S along = simd::mul_add(S(i == 0 ? -1 : 1), tube.half, tube.along);
                touch[k][i] = toward1 * base + beside1 * (sign * aside) + axis1 * along;
                up[k][i] =
                    simd::mul_add(tube.toward.z, base, simd::mul_add(beside.z, sign * aside, tube.axis.z * along));
            }
            side[k] = normalized(cross(axis1, toward1 * base + beside1 * (sign * aside)) * -sign);
        }
        const auto cut = simd::either(simd::either(end[0].horizon.cut, end[0].horizon.below),
                                      simd::either(end[1].horizon.cut, end[1].horizon.below));
        nearest = nearer_plane(side[0], side[1]);
        if (simd::any(beyond))
            nearest = select(beyond, select(tube.along > S(0), end[0].touching(), end[1].touching()), nearest);
        nearest = select(cut, nearer_plane(nearest, horizon), nearest);
    }
    template<bool sheared>
    GONIO_FORCE_INLINE static CircleCone<S> end_of(const LtcLobe<S, sheared>& lobe, const TubeSeen<S>& tube,
                                                   double sign) {
        const S along = simd::mul_add(S(sign), tube.half, tube.along);
        const vec3<S> to_end = tube.toward * tube.across + tube.axis * along;
        const S distance = length(to_end);
        const S inverse = reciprocal_or_zero(distance);
        const S sine = simd::min(tube.radius * inverse, S(1));
        const S cosine = simd::max(simd::sqrt((S(1) - sine) * (S(1) + sine)), S(1e-4));
        const vec3<S> l = select(distance > S(0), to_end * inverse, vec3<S>{S(0), S(0), S(1)});
        const TangentFrame<S> frame(l);
        return {lobe, l * cosine, frame.x * sine, frame.y * sine};
    }

    template<class Work>
    GONIO_FORCE_INLINE void for_each_extreme(vec3<S> axis, const Work& work) const {
        end[0].for_each_extreme(axis, work);
        end[1].for_each_extreme(axis, work);
        for (std::size_t k = 0; k < 2; ++k) {
            const auto crosses = simd::both(!beyond, simd::either(simd::both(up[k][0] >= S(0), up[k][1] < S(0)),
                                                                  simd::both(up[k][0] < S(0), up[k][1] >= S(0))));
            const S t = up[k][0] / simd::select(crosses, up[k][0] - up[k][1], S(1));
            work(touch[k][0] + (touch[k][1] - touch[k][0]) * t, crosses);
        }
    }
    GONIO_FORCE_INLINE RowPart<S> row(vec3<S> base, vec3<S> axis) const {
        const vec3<S> plane = cross(base, axis);
        const RowPart<S> first = end[0].row(base, axis, plane);
        const RowPart<S> second = end[1].row(base, axis, plane);
        RowPart<S> part{simd::min(first.from, second.from), simd::max(first.to, second.to)};
        // Where the row crosses a side between the ends.
        for (std::size_t k = 0; k < 2; ++k) {
            const S before = dot(plane, touch[k][0]);
            const S behind = dot(plane, touch[k][1]);
            const auto between =
                simd::either(simd::both(before >= S(0), behind < S(0)), simd::both(before < S(0), behind >= S(0)));
            const auto valid = simd::both(between, !beyond);
            const vec3<S> at = touch[k][0] * simd::abs(behind) + touch[k][1] * simd::abs(before);
            const S along_a = dot(side[k], axis);
            const S along_b = dot(at, base);
            const S beside_b = dot(at, axis);
            // A row along the side leaves it at ±A.
            const S inwards = simd::select(along_b > S(0), along_a, -along_a);
            const auto leaves =
                simd::either(simd::both(simd::abs(along_a) < S(1e-5), beside_b > S(0)), inwards <= S(-1e-5));
            const S crossing = simd::select(along_b > S(0), beside_b / simd::max(along_b, S(1e-30)),
                                            simd::select(leaves, S(RowPart<S>::far), S(-RowPart<S>::far)));
            part.from = simd::select(simd::both(valid, !leaves), simd::min(part.from, crossing), part.from);
            part.to = simd::select(simd::both(valid, leaves), simd::max(part.to, crossing), part.to);
        }
        part.keep(dot(horizon, base), dot(horizon, axis));
        return part;
    }
};

// The region of a light whose points (light_points.hpp) are known.
template<class S, class Frame, bool sheared>
GONIO_FORCE_INLINE RectangleRegion<S> region_of(const LtcLobe<S, sheared>& lobe, const RectanglePoints<S>& points,
                                                const RectangleLight<S>& /*light*/, const Frame& /*frame*/,
                                                vec3<S> /*to_center*/) {
    return {lobe, points};
}
template<class S, class Light, class Frame, bool sheared>
GONIO_FORCE_INLINE CircleRegion<S> region_of(const LtcLobe<S, sheared>& lobe, const DiskPoints<S>& points,
                                             const Light& /*light*/, const Frame& /*frame*/, vec3<S> /*to_center*/) {
    return {lobe, points};
}
template<class S, class Frame, bool sheared>
GONIO_FORCE_INLINE TubeRegion<S> region_of(const LtcLobe<S, sheared>& lobe, const TubePoints<S>& /*points*/,
                                           const TubeLight<S>& light, const Frame& frame, vec3<S> to_center) {
    return {lobe, TubeSeen<S>(light, frame, to_center)};
}

// Collects the first and last direction about an axis, by components along two unit vectors, the second of which is
// never negative within a region; made positive, so that 0 and half a turn remain apart.
template<class S>
struct Extremes {
    vec3<S> ahead, inward;
    vec2<S>& first;
    vec2<S>& last;

    GONIO_FORCE_INLINE void operator()(vec3<S> p, simd::mask_of<S> valid) const {
        const S x = dot(ahead, p);
        const vec2<S> at{x, simd::max(dot(inward, p), S(1e-7) * simd::abs(x))};
        first = select(simd::both(valid, cross(first, at) < S(0)), at, first);
        last = select(simd::both(valid, cross(last, at) > S(0)), at, last);
    }
    GONIO_FORCE_INLINE void all(simd::mask_of<S> whole) const {
        first = select(whole, vec2<S>{S(1), S(0)}, first);
        last = select(whole, vec2<S>{S(-1), S(0)}, last);
    }
};

// The rule over ω: at least six rows for a lobe whose ridge may bend.
template<class S, class Region, bool more>
struct RowRule {
    static constexpr const auto& rows = Region::rows;
};
template<class S, class Region>
struct RowRule<S, Region, true> {
    static constexpr const auto& rows = LobeRule<S>::six;
};

// A region's points and the solid angles that they stand for, as the points of a light (light_points.hpp). `v` is the
// view in the receiver's frame, v.z > 0.
template<class S, class Region, class Lobe, class Cosine>
class RowPoints {
public:
    static constexpr bool needs_more_rows = !Lobe::is_even && (Region::rows.size() < 6);
    static constexpr const auto& rule = RowRule<S, Region, needs_more_rows>::rows;
    static constexpr std::size_t rows = rule.size();
    static constexpr std::size_t points_of_row = Region::along_row.size();
    static constexpr std::size_t size = rows * points_of_row;

    GONIO_FORCE_INLINE RowPoints(const Region& region, const Cosine& cosine, const Lobe& lobe, vec3<S> v)
        : region_(region), v_(v), inwards_(region.nearest), slopes_(lobe.slopes()) {
        const S slant = simd::sqrt(simd::mul_add(inwards_.x, inwards_.x, inwards_.y * inwards_.y));
        const auto tilted = slant > S(1e-12);
        const S inverse_slant = S(1) / simd::select(tilted, slant, S(1));
        const vec2<S> slanted{inwards_.x * inverse_slant, inwards_.y * inverse_slant};
        vec2<S> beside = select(tilted, slanted, vec2<S>{S(1), S(0)}); // level, across A
        auto from_horizon = S(0) > S(1);
        if constexpr (!Lobe::is_even) {
            // The ridge of a thin lobe bends, which the transform does not undo. Where the light covers its peak, the
            // rows cross the ridge, whatever the light's boundary does.
            from_horizon = simd::both(lobe.is_thin(), inwards_.z > S(0.7));
            const vec2<S> across = lobe.across_ridge();
            beside = select(from_horizon, vec2<S>{across.y, -across.x}, beside);
            inwards_ = select(from_horizon, vec3<S>{S(0), S(0), S(1)}, inwards_);
        }
        const vec3<S>& e = inwards_;
        const S level = simd::select(from_horizon, S(0), slant);
        axis_ = {-beside.y, beside.x, S(0)};
        ahead_ = {-(e.z * beside.x), -(e.z * beside.y), level};

        first_ = {S(-1), S(1e-20)};
        last_ = {S(1), S(-1e-20)};
        region.for_each_extreme(axis_, Extremes<S>{ahead_, e, first_, last_});
        first_ = normalized(first_);
        last_ = normalized(last_);
        // The cosine ends where z' is 0. Beyond, as far as the light began before (from α² to 2α, as tangents), little
        // is left of the lobe; all of a light that begins there is taken.
        const vec2<S> horizon{-e.z, level};
        const S before = cross(first_, horizon);
        const S cosine_before = dot(first_, horizon);
        const S ahead_by = simd::select(cosine_before > S(0), before / simd::max(cosine_before, S(1e-12)), S(1e12));
        const S alpha = lobe.width(beside);
        const S further = simd::min(simd::max(ahead_by, alpha * alpha), S(2) * alpha);
        const vec2<S> limit = normalized(horizon + vec2<S>{-horizon.y, horizon.x} * further);
        const auto within = simd::both(before > S(0), limit.y > S(0)); // less than half a turn from the first
        last_ = select(simd::both(within, cross(limit, last_) > S(0)), limit, last_);
        const auto empty = simd::both(cross(first_, last_) <= S(0), dot(first_, last_) > S(-0.5));

        const S determinant = simd::mul_add(cosine.m00, cosine.m22, -(cosine.m02 * cosine.m20));
        const S inverse = S(1) / simd::max(determinant, S(1e-30));
        back_ = {cosine.m00 * inverse, cosine.m02 * inverse, cosine.m20 * inverse,
                 cosine.m22 * inverse, S(1) / cosine.m11,    cosine.shear};
        toward_axis_ = back_(axis_);
        strength_ = simd::select(empty, S(0), inverse * back_.inverse_m11);
    }

    // work(p, strength, by_cosine) for each point; the receiver sees it under the solid angle strength/|p|³, and
    // by_cosine is the transformed cosine times that, strength (M p)_z/|M p|⁴.
    template<class Work>
    GONIO_FORCE_INLINE void for_each(const Work& work) const {
        const Fan<S> around(first_, last_);
        if constexpr (simd::is_recorded<S>) {
            around.for_each(in_order<rule>(), [&](vec2<S> turned, S turn) { for_each_of_row(turned, turn, work); });
        } else {
            // One loop over each, so that its body is compiled once.
            vec2<S> turned[rows];
            S turn[rows];
            around.divide(rule, &turned[0], &turn[0]);
            for (std::size_t k = 0; k < rows; ++k)
                for_each_of_row(turned[k], turn[k], work);
        }
    }

private:
    // The inverse of a cosine's transform.
    struct Back {
        S m00, m02, m20, m22; // over the determinant of the four
        S inverse_m11;
        [[no_unique_address]] decltype(Cosine::shear) shear;

        GONIO_FORCE_INLINE vec3<S> operator()(vec3<S> q) const {
            return {simd::mul_add(m22, q.x, -(m02 * q.z)), shear.undone(q.x, q.y) * inverse_m11,
                    simd::mul_add(m00, q.z, -(m20 * q.x))};
        }
    };

    template<class Work>
    GONIO_FORCE_INLINE void for_each_of_row(vec2<S> turned, S turn, const Work& work) const {
        const vec3<S> base = ahead_ * turned.x + inwards_ * turned.y;
        const RowPart<S> part = region_.row(base, axis_);

        // The half vector's slopes over α at a point of the part, and their change with τ: where the square of the
        // slopes is least, and how fast it grows. Elsewhere on the row the light could be below the horizon.
        const S last = simd::max(part.to, part.from);
        const vec3<S> toward_base = back_(base);
        S least = S(0);
        S dr2 = S(1);
        S spread = S(1);
        S width = S(1); // spread/dr2
        for (int step = 0; step < (Lobe::is_even ? 1 : 2); ++step) {
            const S nearest = simd::min(simd::max(part.from, least), last);
            const vec3<S> toward_nearest = mul_add(toward_axis_, nearest, toward_base);
            const S inverse_base = S(1) / simd::sqrt(simd::max(dot(toward_nearest, toward_nearest), S(1e-36)));
            const vec3<S> l = toward_nearest * inverse_base;
            const vec3<S> change = (toward_axis_ - l * dot(l, toward_axis_)) * inverse_base;
            const vec3<S> h = l + v_;
            const S inverse_z = S(1) / simd::max(h.z, S(1e-6));
            const vec2<S> r = slopes_({h.x * inverse_z, h.y * inverse_z});
            const vec2<S> dr = slopes_({simd::mul_add(-(h.x * inverse_z), change.z, change.x) * inverse_z,
                                        simd::mul_add(-(h.y * inverse_z), change.z, change.y) * inverse_z});
            dr2 = simd::max(dot(dr, dr), S(1e-30));
            const S inverse_dr2 = S(1) / dr2;
            least = simd::mul_add(-dot(r, dr), inverse_dr2, nearest);
            const S aside = cross(r, dr);
            spread = simd::sqrt(simd::mul_add(aside, aside, dr2));
            width = spread * inverse_dr2;
        }

        if constexpr (!Lobe::is_even) {
            // Far from the part, where a row almost meets the axis, a second step may end so far away that the
            // difference to the part is lost. From here already the points are at nearly equal steps of τ.
            const S reach = S(1e3) * (last - part.from);
            least = simd::min(simd::max(least, part.from - reach), last + reach);
        }
        // In units of the width.
        const S inverse_width = dr2 / simd::max(spread, S(1e-30));
        const auto clamped = [&](S tau) __attribute__((always_inline)) {
            return simd::min(simd::max((tau - least) * inverse_width, S(-1e4)), S(1e4));
        };
        const S from = clamped(part.from);
        const S to = clamped(part.to);
        const Fan<S> along(from, to);
        const S strength = simd::select(from < to, strength_ * turn * width, S(0));
        // The direction at τ = least + width·y/x, times x. Transformed it is x B + t A with t = x τ, where A is level.
        const vec3<S> by_x = mul_add(toward_axis_, least, toward_base);
        const vec3<S> by_y = toward_axis_ * width;
        const S rising = strength * base.z;

        const auto place = [&](vec2<S> at, S angle) __attribute__((always_inline)) {
            const S t = simd::mul_add(least, at.x, width * at.y);
            const S ratio = at.x / simd::mul_add(t, t, at.x * at.x);
            work(mul_add(by_x, at.x, by_y * at.y), angle * at.x * strength, rising * angle * ratio * ratio);
        };
        if constexpr (simd::is_recorded<S>) {
            along.for_each(in_order<Region::along_row>(), place);
        } else {
            vec2<S> at[points_of_row];
            S angle[points_of_row];
            along.divide(Region::along_row, &at[0], &angle[0]);
            for (std::size_t k = 0; k < points_of_row; ++k)
                place(at[k], angle[k]);
        }
    }

    const Region& region_;
    vec3<S> v_;
    vec3<S> axis_, ahead_, inwards_; // A; B at ω = 0 and at a quarter of a turn
    vec3<S> toward_axis_;
    vec2<S> first_, last_; // ω
    Back back_;
    decltype(std::declval<Lobe>().slopes()) slopes_;
    S strength_;
};

} // namespace gonio::shading::detail
