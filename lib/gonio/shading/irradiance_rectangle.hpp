// Irradiance from a uniform one-sided rectangle, exact with horizon clipping.
//
// E/L [sr] in [0, π]: four great arcs, each cut where the receiver's plane cuts it, and one horizon arc (outline.hpp).
// A cut edge keeps its plane and changes its angle only. Far from an uncut rectangle the arcs cancel by (size/distance)
// and a 4 × 4 Gauss–Legendre rule over its surface takes their place: its error falls with the eighth power.
#pragma once

#include <gonio/shading/outline.hpp>

namespace gonio::shading {

namespace detail {

// `center` relative to the receiver, half edges x and y with x × y towards emission; all of moderate size.
template<class S>
GONIO_FORCE_INLINE S rectangle_by_arcs(vec3<S> center, vec3<S> x, vec3<S> y, vec3<S> normal) {
    const S up = dot(normal, center);
    const S up_x = dot(normal, x);
    const S up_y = dot(normal, y);
    // Summed like the corners themselves, so that at most one edge sinks below the horizon and one rises.
    const S height[4] = {(up - up_x) - up_y, (up - up_x) + up_y, (up + up_x) + up_y, (up + up_x) - up_y};
    const vec3<S> two_x = x + x;
    const vec3<S> two_y = y + y;
    const vec3<S> corner[4] = {vec3<S>{S(0), S(0), S(0)} - x - y, y - x, x + y, x - y}; // from the centre
    const vec3<S> edge[4] = {two_y, two_x, two_y * S(-1), two_x * S(-1)};

    const auto lowest = simd::min(simd::min(height[0], height[1]), simd::min(height[2], height[3]));
    if (!simd::any(lowest < S(0))) {
        S sum = S(0);
        for (int i = 0; i < 4; ++i)
            sum = sum + great_arc(center + corner[i], edge[i], normal);
        return clamp_irradiance(sum);
    }
    S sum = S(0);
    vec3<S> sinks{S(0), S(0), S(0)};
    vec3<S> rises{S(0), S(0), S(0)};
    auto cut = S(0) > S(1);
    for (int i = 0; i < 4; ++i) {
        const S from = height[i];
        const S to = height[(i + 1) % 4];
        const auto from_above = from >= S(0);
        const auto to_above = to >= S(0);
        const auto sinking = simd::both(from_above, !to_above);
        const auto rising = simd::both(!from_above, to_above);
        const S t = simd::min(from * reciprocal_or_zero(from - to), S(1)); // of the crossing, where there is one
        const S begin = simd::select(from_above, S(0), t);
        const S end = simd::select(to_above, S(1), t);
        const vec3<S> p = center + corner[i];
        const vec3<S> plane = cross(p, edge[i]);
        const S area = length(plane);
        const S angle = simd::atan2(area * simd::max(end - begin, S(0)), dot(p + edge[i] * begin, p + edge[i] * end));
        const S arc = S(0.5) * angle * dot(normal, plane) * reciprocal_or_zero(area);
        sum = sum + simd::select(simd::either(from_above, to_above), arc, S(0));
        const vec3<S> crossing = corner[i] + edge[i] * t;
        sinks = select(sinking, crossing, sinks);
        rises = select(rising, crossing, rises);
        cut = simd::either(cut, sinking);
    }
    const S closing = horizon_arc(center + sinks, rises - sinks);
    return clamp_irradiance(sum + simd::select(cut, closing, S(0)));
}

// All of it above the horizon; `toward` = distance of the rectangle's plane, > 0 in front.
template<class S>
GONIO_FORCE_INLINE S rectangle_by_points(vec3<S> center, vec3<S> x, vec3<S> y, S toward, vec3<S> normal) {
    constexpr double node[4] = {-0.86113631159405257522, -0.33998104358485626480, 0.33998104358485626480,
                                0.86113631159405257522};
    constexpr double weight[4] = {0.34785484513745385737, 0.65214515486254614263, 0.65214515486254614263,
                                  0.34785484513745385737};
    const S up = dot(normal, center);
    const S up_x = dot(normal, x);
    const S up_y = dot(normal, y);
    const S square = dot(center, center);
    const S along_x = S(2) * dot(center, x);
    const S along_y = S(2) * dot(center, y);
    const S x2 = dot(x, x);
    const S y2 = dot(y, y);
    S sum = S(0);
    for (int i = 0; i < 4; ++i) {
        const S height = simd::mul_add(S(node[i]), up_x, up);
        const S distance = square + S(node[i]) * (along_x + S(node[i]) * x2);
        S row = S(0);
        for (int k = 0; k < 4; ++k) {
            const S d2 = distance + S(node[k]) * (along_y + S(node[k]) * y2);
            row = row + S(weight[k]) * simd::mul_add(S(node[k]), up_y, height) / (d2 * d2);
        }
        sum = sum + S(weight[i]) * row;
    }
    return clamp_irradiance(sum * toward * simd::sqrt(x2 * y2));
}

struct ExactRectangle;

} // namespace detail

// Beyond this many diagonals the rule's error is below the rounding of the arcs.
template<class S>
inline constexpr double far_rectangle_diagonals = 4.0;
template<>
inline constexpr double far_rectangle_diagonals<double> = 64.0;

// E/L [sr] of a rectangle about `center` [m, from the receiver] that emits towards +`axis` only, `width` along
// `width_direction` and `height` across it. `axis`, `width_direction` (perpendicular) and the receiver's `normal` are
// unit. Behind its plane 0; in the plane, inside the outline, the limit π(1 + n·w)/2 from the front, w = −axis, and
// outside 0. Any finite input; negative sizes count as positive; no area gives 0. J. H. Lambert (outline.hpp). In float
// and packs, receivers close to the outline are evaluated in double, lane by lane.
template<class S>
GONIO_FORCE_INLINE S irradiance_rectangle(vec3<S> center, vec3<S> axis, vec3<S> width_direction, S width, S height,
                                          vec3<S> normal) {
    const S w = simd::abs(width);
    const S h = simd::abs(height);
    // 1/8: sums of three such numbers stay finite at the largest scale too.
    const S scale = S(0.125) * simd::reciprocal_power_of_two(simd::max(largest_component(center), simd::max(w, h)));
    const vec3<S> c = center * scale;
    const vec3<S> height_direction = cross(axis, width_direction);
    const S half_width = S(0.5) * (w * scale);
    const S half_height = S(0.5) * (h * scale);
    const vec3<S> x = width_direction * half_width;
    const vec3<S> y = height_direction * half_height;
    const S toward = -dot(axis, c);

    const auto lit = simd::both(toward > S(0), simd::both(half_width > S(0), half_height > S(0)));
    const auto inside =
        simd::both(simd::abs(dot(c, width_direction)) < half_width, simd::abs(dot(c, height_direction)) < half_height);
    const auto touching = simd::both(toward == S(0), inside);
    const S front =
        simd::select(touching, detail::clamp_irradiance(S(1.57079632679489661923) * (S(1) - dot(normal, axis))), S(0));
    if (!simd::any(lit)) return front;

    const S up = dot(normal, c);
    const S reach = simd::abs(dot(normal, x)) + simd::abs(dot(normal, y));
    const auto seen = up > -reach;
    if (!simd::any(simd::both(lit, seen))) return front;

    constexpr double diagonals = 2.0 * far_rectangle_diagonals<S>;
    const S half_diagonal2 = half_width * half_width + half_height * half_height;
    const auto far = simd::both(dot(c, c) > S(diagonals * diagonals) * half_diagonal2, up >= reach);
    S e = S(0);
    if (simd::any(far)) e = detail::rectangle_by_points(c, x, y, toward, normal);
    const auto arcs = simd::both(!far, simd::both(lit, seen));
    if (simd::any(arcs)) e = simd::select(far, e, detail::rectangle_by_arcs(c, x, y, normal));
    e = simd::select(simd::both(lit, seen), e, front);
    if constexpr (!__is_same(S, double)) {
        // Close to the outline the arcs turn by the rounding of the way there.
        const S beyond_x = simd::abs(dot(c, width_direction)) - half_width;
        const S beyond_y = simd::abs(dot(c, height_direction)) - half_height;
        const S inward = simd::min(simd::max(beyond_x, beyond_y), S(0));
        const S outward_x = simd::max(beyond_x, S(0));
        const S outward_y = simd::max(beyond_y, S(0));
        const S gap2 = toward * toward + outward_x * outward_x + outward_y * outward_y + inward * inward;
        const auto hard = simd::both(arcs, gap2 < S(4e-4) * half_diagonal2);
        if (simd::any(hard))
            e = detail::in_double<detail::ExactRectangle>(hard, e,
                                                          {center.x, center.y, center.z, axis.x, axis.y, axis.z,
                                                           width_direction.x, width_direction.y, width_direction.z,
                                                           width, height, normal.x, normal.y, normal.z});
    }
    return e;
}

namespace detail {

struct ExactRectangle {
    GONIO_FORCE_INLINE static double evaluate(const double (&v)[14]) {
        return irradiance_rectangle<double>({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}, v[9], v[10],
                                            {v[11], v[12], v[13]});
    }
};

} // namespace detail

} // namespace gonio::shading
