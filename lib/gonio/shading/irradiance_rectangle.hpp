// Irradiance from a uniform one-sided rectangle, exact with horizon clipping.
//
// E/L [sr] in [0, π]: four great arcs, each cut where the receiver's plane cuts it, and one horizon arc (outline.hpp).
// The pose is transformed to the light's own axes in double and rounded once, each coordinate to its own last digit, so
// that float stays exact next to the outline. After mirroring so that n_x, n_y ≥ 0, the corners go below the horizon in
// a fixed order: each half of the outline from the highest to the lowest corner has at most one crossing, so no other
// cases arise. Far from an uncut rectangle the arcs cancel by (size/distance); there opposite edges are combined as the
// difference of their angles, which is computed from the known differences of their distances.
#pragma once

#include <gonio/shading/outline.hpp>

namespace gonio::shading {

namespace detail {

// In the light's axes x (width), y (height), z (away from its front), seen from the receiver; of moderate size.
template<class S>
struct RectanglePose {
    S x, y, z;            // of the centre; z > 0 in front
    S x_rest, y_rest;     // the rounding error of x and y
    S half_x, half_y;     // ≥ 0
    S n_x, n_y, n_z;      // the receiver's normal
    S up, rise_x, rise_y; // heights over the receiver's plane: of the centre, and by half_x and half_y
};

// Computed in W: `wider<S>`, or S itself where rounding errors of the distance do no harm.
template<class W, class S>
GONIO_FORCE_INLINE RectanglePose<S> rectangle_pose(vec3<S> center, vec3<S> axis, vec3<S> width_direction, S width,
                                                   S height, vec3<S> normal, bool two_sided) {
    const S w = simd::abs(width);
    const S h = simd::abs(height);
    // 1/8: sums of three such numbers stay finite even at the largest scale.
    const S scale = S(0.125) * simd::reciprocal_power_of_two(simd::max(largest_component(center), simd::max(w, h)));
    const vec3<S> scaled = center * scale;
    RectanglePose<S> p;
    p.half_x = S(0.5) * (w * scale);
    p.half_y = S(0.5) * (h * scale);
    if constexpr (__is_same(W, S)) {
        p.x = dot(width_direction, scaled);
        p.y = dot(cross(axis, width_direction), scaled);
        p.z = -dot(axis, scaled);
        p.x_rest = S(0);
        p.y_rest = S(0);
    } else {
        const vec3<W> c = widen(scaled);
        const vec3<W> a = widen(axis);
        const vec3<W> b = widen(width_direction);
        const W along_x = dot(b, c);
        const W along_y = dot(cross(a, b), c);
        simd::narrow(along_x, p.x);
        simd::narrow(along_x - simd::widen(p.x), p.x_rest);
        simd::narrow(along_y, p.y);
        simd::narrow(along_y - simd::widen(p.y), p.y_rest);
        simd::narrow(-dot(a, c), p.z);
    }
    p.n_x = dot(normal, width_direction);
    p.n_y = dot(normal, cross(axis, width_direction));
    p.n_z = -dot(normal, axis);
    if (two_sided) {
        p.n_z = simd::select(p.z < S(0), -p.n_z, p.n_z);
        p.z = simd::abs(p.z);
    }
    p.rise_x = p.n_x * p.half_x;
    p.rise_y = p.n_y * p.half_y;
    p.up = simd::mul_add(p.n_x, p.x, simd::mul_add(p.n_y, p.y, p.n_z * p.z));
    return p;
}

// Mirrors the pose so that n_x, n_y ≥ 0.
template<class S>
GONIO_FORCE_INLINE void mirror(RectanglePose<S>& p) {
    const auto left = p.n_x < S(0);
    const auto down = p.n_y < S(0);
    p.x = simd::select(left, -p.x, p.x);
    p.y = simd::select(down, -p.y, p.y);
    p.x_rest = simd::select(left, -p.x_rest, p.x_rest);
    p.y_rest = simd::select(down, -p.y_rest, p.y_rest);
    p.n_x = simd::abs(p.n_x);
    p.n_y = simd::abs(p.n_y);
    p.rise_x = simd::abs(p.rise_x);
    p.rise_y = simd::abs(p.rise_y);
}

// A piece of a straight line that subtends the angle θ. v is tan(θ/2) or, where θ is obtuse, cot(θ/2).
template<class S>
struct EdgeAngle {
    S inverse;     // v = length · distance of the line · inverse
    S excess;      // atan(v)/v − 1
    S by_distance; // 2 atan(v) divided by the line's distance
};

// Takes its length, the square of the line's distance, and 1 over the sum of the product of its ends' lengths and the
// magnitude of their dot product.
template<class S>
GONIO_FORCE_INLINE EdgeAngle<S> edge_angle(S length, S distance2, S inverse) {
    const S t = length * inverse;
    const S excess = simd::atan_ratio_excess(t * t * distance2);
    return {inverse, excess, S(2) * simd::mul_add(t, excess, t)};
}

// Where the horizon cuts the outline: offsets from the centre, both at the lowest corner if it does not cut.
template<class S>
struct RectangleCut {
    S a_x, a_y, b_x, b_y;
    simd::mask_of<S> before3, before1; // A lies before corner 3, B before corner 1
};

// Corners: 0 the lowest (−x, −y), 1 (−x, +y), 2 the highest (+x, +y), 3 (+x, −y). A is on the way from 2 via 3 to 0, B
// on the way via 1; both are corner 2 where nothing is above.
template<class S>
GONIO_FORCE_INLINE RectangleCut<S> rectangle_cut(const RectanglePose<S>& p) {
    constexpr double least = 1e-30;
    const auto before3 = (p.up + p.rise_x) - p.rise_y < S(0);
    const auto before1 = (p.up - p.rise_x) + p.rise_y < S(0);
    const S rate_a = simd::max(simd::select(before3, p.n_y, p.n_x), S(least));
    const S rate_b = simd::max(simd::select(before1, p.n_x, p.n_y), S(least));
    const S a = -simd::select(before3, p.up + p.rise_x, p.up - p.rise_y) / rate_a;
    const S b = -simd::select(before1, p.up + p.rise_y, p.up - p.rise_x) / rate_b;
    const S end_a = simd::select(before3, p.half_y, p.half_x);
    const S end_b = simd::select(before1, p.half_x, p.half_y);
    const S at_a = simd::max(simd::min(a, end_a), -end_a);
    const S at_b = simd::max(simd::min(b, end_b), -end_b);
    return {simd::select(before3, p.half_x, at_a),
            simd::select(before3, at_a, -p.half_y),
            simd::select(before1, at_b, -p.half_x),
            simd::select(before1, p.half_y, at_b),
            before3,
            before1};
}

// An uncut rectangle, no nearer than a fifth of its half diagonal, with no edge that subtends more than 90°: opposite
// edges are combined, as the difference of their angles from the known differences of their distances. Without that,
// far rectangles cancel. Nothing else cancels, so the pose may be rounded like any other product.
template<class S>
struct RectangleApart {
    S irradiance;
    simd::mask_of<S> valid;
};

template<class S>
GONIO_FORCE_INLINE RectangleApart<S> rectangle_apart(const RectanglePose<S>& p) {
    const S x0 = p.x - p.half_x;
    const S x1 = p.x + p.half_x;
    const S y0 = p.y - p.half_y;
    const S y1 = p.y + p.half_y;
    const S z2 = p.z * p.z;
    const S to_x0 = simd::mul_add(x0, x0, z2); // squares of the distances of the edges' lines
    const S to_x1 = simd::mul_add(x1, x1, z2);
    const S to_y0 = simd::mul_add(y0, y0, z2);
    const S to_y1 = simd::mul_add(y1, y1, z2);
    const S dot_x0 = simd::mul_add(y1, y0, to_x0);
    const S dot_x1 = simd::mul_add(y1, y0, to_x1);
    const S dot_y0 = simd::mul_add(x1, x0, to_y0);
    const S dot_y1 = simd::mul_add(x1, x0, to_y1);
    const S half_diagonal2 = simd::mul_add(p.half_x, p.half_x, p.half_y * p.half_y);
    const S least_dot = simd::min(simd::min(dot_x0, dot_x1), simd::min(dot_y0, dot_y1));
    const S square0 = simd::mul_add(y0, y0, to_x0); // of the corners (x0, y0), (x0, y1), (x1, y1), (x1, y0)
    const S square1 = simd::mul_add(y1, y1, to_x0);
    const S square2 = simd::mul_add(y1, y1, to_x1);
    const S square3 = simd::mul_add(y0, y0, to_x1);
    const S least_square = simd::min(simd::min(square0, square1), simd::min(square2, square3));
    const auto valid = simd::both(least_square > S(0.04) * half_diagonal2, least_dot >= S(0));
    const S d0 = simd::sqrt(square0);
    const S d1 = simd::sqrt(square1);
    const S d2 = simd::sqrt(square2);
    const S d3 = simd::sqrt(square3);
    const S product_x0 = d1 * d0;
    const S product_x1 = d2 * d3;
    const S product_y0 = d3 * d0;
    const S product_y1 = d2 * d1;
    const S sum_x0 = product_x0 + dot_x0;
    const S sum_x1 = product_x1 + dot_x1;
    const S sum_y0 = product_y0 + dot_y0;
    const S sum_y1 = product_y1 + dot_y1;
    const S inverse_x = S(1) / (sum_x0 * sum_x1);
    const S inverse_y = S(1) / (sum_y0 * sum_y1);
    const S whole_x = p.half_x + p.half_x;
    const S whole_y = p.half_y + p.half_y;
    const EdgeAngle<S> arc_x0 = edge_angle(whole_y, to_x0, inverse_x * sum_x1);
    const EdgeAngle<S> arc_x1 = edge_angle(whole_y, to_x1, inverse_x * sum_x0);
    const EdgeAngle<S> arc_y0 = edge_angle(whole_x, to_y0, inverse_y * sum_y1);
    const EdgeAngle<S> arc_y1 = edge_angle(whole_x, to_y1, inverse_y * sum_y0);
    const S over_x0 = simd::mul_add(p.n_x, p.z, -(p.n_z * x0)); // the arcs' plane normals, projected on n
    const S over_y0 = simd::mul_add(p.n_y, p.z, -(p.n_z * y0));
    const S grows_x = (p.x + p.x) * whole_x;
    const S grows_y = (p.y + p.y) * whole_y;
    const S both_x = product_x1 + product_x0;
    const S both_y = product_y1 + product_y0;
    const S inverse = S(1) / (both_x * both_y);
    const S more_x = grows_x * simd::mul_add(square0 + square1 + grows_x, inverse * both_y, S(1));
    const S more_y = grows_y * simd::mul_add(square0 + square3 + grows_y, inverse * both_x, S(1));
    // Halves: the outline's sum is twice the value here, and E/L is half of the sum.
    const S less_x = whole_y * arc_x0.inverse *
                     simd::mul_add(more_x * arc_x1.inverse, S(1) + arc_x1.excess, arc_x0.excess - arc_x1.excess);
    const S less_y = whole_x * arc_y0.inverse *
                     simd::mul_add(more_y * arc_y1.inverse, S(1) + arc_y1.excess, arc_y0.excess - arc_y1.excess);
    const S facing = p.n_z * simd::mul_add(p.half_x, arc_x1.by_distance, p.half_y * arc_y1.by_distance);
    return {facing + simd::mul_add(over_x0, less_x, over_y0 * less_y), valid};
}

template<class S>
GONIO_FORCE_INLINE S rectangle_in_front(RectanglePose<S>& p) {
    const auto never = S(0) > S(1);
    const auto cut = p.up < simd::abs(p.rise_x) + simd::abs(p.rise_y);
    RectangleCut<S> c{-p.half_x, -p.half_y, -p.half_x, -p.half_y, never, never};
    if (simd::any(cut)) {
        mirror(p);
        c = rectangle_cut(p);
    }
    // From the receiver, each coordinate to its own last digit.
    const S x0 = (p.x - p.half_x) + p.x_rest;
    const S x1 = (p.x + p.half_x) + p.x_rest;
    const S y0 = (p.y - p.half_y) + p.y_rest;
    const S y1 = (p.y + p.half_y) + p.y_rest;
    vec3<S> a{x0, y0, p.z};
    vec3<S> b = a;
    if (simd::any(cut)) {
        a = {(p.x + c.a_x) + p.x_rest, (p.y + c.a_y) + p.y_rest, p.z};
        b = {(p.x + c.b_x) + p.x_rest, (p.y + c.b_y) + p.y_rest, p.z};
    }
    const S z2 = p.z * p.z;
    const S to_x0 = simd::mul_add(x0, x0, z2); // squares of the distances of the edges' lines
    const S to_x1 = simd::mul_add(x1, x1, z2);
    const S to_y0 = simd::mul_add(y0, y0, z2);
    const S to_y1 = simd::mul_add(y1, y1, z2);
    const S square_a = dot(a, a);
    const S square1 = simd::mul_add(y1, y1, to_x0);
    const S square3 = simd::mul_add(y0, y0, to_x1);
    const S d_a = simd::sqrt(square_a);
    const S d1 = simd::sqrt(square1);
    const S d2 = simd::sqrt(simd::mul_add(y1, y1, to_x1));
    const S d3 = simd::sqrt(square3);
    S d_b = d_a;
    if (simd::any(cut)) d_b = simd::sqrt(dot(b, b));
    const S dot_x0 = simd::mul_add(y1, b.y, to_x0);
    const S dot_x1 = simd::mul_add(y1, a.y, to_x1);
    const S dot_y0 = simd::mul_add(x1, a.x, to_y0);
    const S dot_y1 = simd::mul_add(x1, b.x, to_y1);
    const S product_x0 = d1 * d_b;
    const S product_x1 = d2 * simd::select(c.before3, d_a, d3);
    const S product_y0 = d3 * d_a;
    const S product_y1 = d2 * simd::select(c.before1, d_b, d1);
    const S sum_x0 = product_x0 + simd::abs(dot_x0);
    const S sum_x1 = product_x1 + simd::abs(dot_x1);
    const S sum_y0 = product_y0 + simd::abs(dot_y0);
    const S sum_y1 = product_y1 + simd::abs(dot_y1);
    const S inverse_x = S(1) / (sum_x0 * sum_x1);
    const S inverse_y = S(1) / (sum_y0 * sum_y1);
    const EdgeAngle<S> arc_x0 = edge_angle(p.half_y - c.b_y, to_x0, inverse_x * sum_x1);
    const EdgeAngle<S> arc_x1 = edge_angle(p.half_y - c.a_y, to_x1, inverse_x * sum_x0);
    const EdgeAngle<S> arc_y0 = edge_angle(p.half_x - c.a_x, to_y0, inverse_y * sum_y1);
    const EdgeAngle<S> arc_y1 = edge_angle(p.half_x - c.b_x, to_y1, inverse_y * sum_y0);
    const S over_x = p.n_x * p.z;
    const S over_y = p.n_y * p.z;
    const S over_x0 = simd::mul_add(-p.n_z, x0, over_x); // the arcs' plane normals, projected on n
    const S over_y0 = simd::mul_add(-p.n_z, y0, over_y);

    // Where uncut and not close, opposite edges are combined: the difference of their angles is computed from the known
    // differences of their distances; otherwise far rectangles cancel.
    const S half_diagonal2 = simd::mul_add(p.half_x, p.half_x, p.half_y * p.half_y);
    const S least_dot = simd::min(simd::min(dot_x0, dot_x1), simd::min(dot_y0, dot_y1));
    const S least_distance2 = simd::min(simd::min(to_x0, to_x1), simd::min(to_y0, to_y1));
    const auto apart = simd::both(simd::both(least_distance2 > S(0.04) * half_diagonal2, least_dot >= S(0)), !cut);
    S sum = S(0);
    if (simd::any(apart)) {
        const S grows_x = S(4) * p.x * p.half_x;
        const S grows_y = S(4) * p.y * p.half_y;
        const S both_x = product_x1 + product_x0;
        const S both_y = product_y1 + product_y0;
        const S inverse = S(1) / (both_x * both_y);
        const S more_x = grows_x * simd::mul_add(square_a + square1 + grows_x, inverse * both_y, S(1));
        const S more_y = grows_y * simd::mul_add(square_a + square3 + grows_y, inverse * both_x, S(1));
        const S less_x = S(4) * p.half_y * arc_x0.inverse *
                         simd::mul_add(more_x * arc_x1.inverse, S(1) + arc_x1.excess, arc_x0.excess - arc_x1.excess);
        const S less_y = S(4) * p.half_x * arc_y0.inverse *
                         simd::mul_add(more_y * arc_y1.inverse, S(1) + arc_y1.excess, arc_y0.excess - arc_y1.excess);
        sum = S(2) * p.n_z * simd::mul_add(p.half_x, arc_x1.by_distance, p.half_y * arc_y1.by_distance) +
              simd::mul_add(over_x0, less_x, over_y0 * less_y);
    }
    if (!simd::all(apart)) {
        S by_x0 = arc_x0.by_distance;
        S by_x1 = arc_x1.by_distance;
        S by_y0 = arc_y0.by_distance;
        S by_y1 = arc_y1.by_distance;
        const auto obtuse = [](S & angle, S dot, S distance2) __attribute__((always_inline)) {
            const S half_turn = S(3.14159265358979323846) / simd::sqrt(distance2);
            angle = simd::select(dot < S(0), half_turn - angle, angle);
        };
        if (simd::any(simd::min(dot_x0, dot_x1) < S(0))) {
            obtuse(by_x0, dot_x0, to_x0);
            obtuse(by_x1, dot_x1, to_x1);
        }
        if (simd::any(simd::min(dot_y0, dot_y1) < S(0))) {
            obtuse(by_y0, dot_y0, to_y0);
            obtuse(by_y1, dot_y1, to_y1);
        }
        const S over_x1 = simd::mul_add(-p.n_z, x1, over_x);
        const S over_y1 = simd::mul_add(-p.n_z, y1, over_y);
        const S direct =
            simd::mul_add(over_x0, by_x0, -(over_x1 * by_x1)) + simd::mul_add(over_y0, by_y0, -(over_y1 * by_y1));
        sum = simd::select(apart, sum, direct);
    }
    if (!simd::any(cut)) return clamp_irradiance(S(0.5) * sum);
    // From the nearer end: as a sum from the other end its position would be lost to rounding.
    const vec3<S> step{c.b_x - c.a_x, c.b_y - c.a_y, S(0)};
    const auto from_b = d_b < d_a;
    const S closing = horizon_arc({simd::select(from_b, b.x, a.x), simd::select(from_b, b.y, a.y), p.z},
                                  select(from_b, vec3<S>{-step.x, -step.y, S(0)}, step), {p.n_x, p.n_y, p.n_z});
    return clamp_irradiance(simd::mul_add(S(0.5), sum, simd::select(cut, closing, S(0))));
}

// The smallest height over the light that counts as different from 0, relative to the size of the scene: its square is
// a normal number.
template<class S>
inline constexpr double least_rectangle_height = 0x1p-60;
template<>
inline constexpr double least_rectangle_height<double> = 0x1p-500;

struct RectangleInDouble;

// E/L of a rectangle entirely above the horizon, in front of it and apart from it; the other lanes are marked hard.
// Float is enough.
template<class S>
GONIO_FORCE_INLINE Survey<S> survey_rectangle_above(vec3<S> center, vec3<S> axis, vec3<S> width_direction, S width,
                                                    S height, vec3<S> normal, bool two_sided) {
    const RectanglePose<S> p = rectangle_pose<S>(center, axis, width_direction, width, height, normal, two_sided);
    const auto above = p.up >= simd::abs(p.rise_x) + simd::abs(p.rise_y);
    const auto exists = simd::both(p.half_x > S(0), p.half_y > S(0));
    const auto easy = simd::both(simd::both(above, exists), p.z > S(0));
    if (!simd::any(easy)) return {S(0), !easy};
    const RectangleApart<S> apart = rectangle_apart(p);
    return {clamp_irradiance(apart.irradiance), !simd::both(easy, apart.valid)};
}

// As irradiance_rectangle, except in the hard lanes: just over the light, where arcs turn by the rounding error of the
// distance to an edge.
template<class S>
GONIO_FORCE_INLINE Survey<S> survey_rectangle(vec3<S> center, vec3<S> axis, vec3<S> width_direction, S width, S height,
                                              vec3<S> normal, bool two_sided) {
    RectanglePose<S> p =
        rectangle_pose<simd::wider<S>>(center, axis, width_direction, width, height, normal, two_sided);
    const auto area = simd::both(p.half_x > S(0), p.half_y > S(0));
    // Points that rounding leaves undecided count as lit: beside the outline they may see half of the light.
    const S slack = S(__is_same(S, double) ? 1e-15 : 1e-6) *
                    (simd::abs(p.x) + simd::abs(p.y) + simd::abs(p.z) + p.half_x + p.half_y);
    const auto seen = simd::both(area, p.up > -(simd::abs(p.rise_x) + simd::abs(p.rise_y)) - slack);
    const auto lit = simd::both(p.z > S(0), seen);
    S e = S(0);
    if (simd::any(p.z == S(0))) {
        // Each side to its own last digit: on an edge a rounding error could amount to the whole light.
        const auto within_x = simd::both((p.x - p.half_x) + p.x_rest<S(0), (p.x + p.half_x) + p.x_rest> S(0));
        const auto within_y = simd::both((p.y - p.half_y) + p.y_rest<S(0), (p.y + p.half_y) + p.y_rest> S(0));
        const auto inside = simd::both(within_x, within_y);
        e = simd::select(simd::both(inside, p.z == S(0)), clamp_irradiance(S(1.57079632679489661923) * (S(1) + p.n_z)),
                         S(0));
    }
    if (!simd::any(lit)) return {e, S(0) > S(1)};
    const S least = S(3e-4) * simd::max(p.half_x, p.half_y);
    const auto over = simd::both(simd::abs(p.x) < p.half_x + least, simd::abs(p.y) < p.half_y + least);
    const auto hard = simd::both(lit, simd::both(p.z < least, over));
    p.z = simd::max(p.z, S(least_rectangle_height<S>));
    return {simd::select(lit, rectangle_in_front(p), e), hard};
}

} // namespace detail

// E/L [sr] of a rectangle about `center` [m, from the receiver] that emits towards +`axis` only, `width` along
// `width_direction` and `height` across it. `axis`, `width_direction` (perpendicular) and the receiver's `normal` are
// unit. 0 behind its plane. In the plane: inside the outline the limit π(1 + n·w)/2 from the front, w = −axis; outside
// 0. Any finite input; negative sizes count as positive; zero area gives 0. J. H. Lambert (outline.hpp). In float and
// packs, receivers lower over it than 3e-4 of the larger half side are evaluated in double, lane by lane. `two_sided`:
// it emits to both sides, and the receiver sees the side it is on.
template<class S>
GONIO_FORCE_INLINE S irradiance_rectangle(vec3<S> center, vec3<S> axis, vec3<S> width_direction, S width, S height,
                                          vec3<S> normal, bool two_sided = false) {
    if constexpr (!__is_same(S, double)) {
        const auto above =
            detail::survey_rectangle_above(center, axis, width_direction, width, height, normal, two_sided);
        if (!simd::any(above.hard)) return above.irradiance;
    }
    const auto rectangle = detail::survey_rectangle(center, axis, width_direction, width, height, normal, two_sided);
    const S e = rectangle.irradiance;
    if constexpr (!__is_same(S, double)) {
        if (simd::any(rectangle.hard))
            return detail::in_double<detail::RectangleInDouble>(
                rectangle.hard, e,
                {center.x, center.y, center.z, axis.x, axis.y, axis.z, width_direction.x, width_direction.y,
                 width_direction.z, width, height, normal.x, normal.y, normal.z, S(two_sided ? 1 : 0)});
    }
    return e;
}

namespace detail {

struct RectangleInDouble {
    GONIO_FORCE_INLINE static double evaluate(const double (&v)[15]) {
        return irradiance_rectangle<double>({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}, v[9], v[10],
                                            {v[11], v[12], v[13]}, v[14] != 0.0);
    }
};

} // namespace detail

} // namespace gonio::shading
