// Where a light is seen in the transformed space of a lobe's cosine, and the part of a row (lobe_rows.hpp) inside it.
#pragma once

#include <gonio/shading/light_points.hpp>
#include <gonio/shading/lights.hpp>
#include <gonio/shading/lobe_rule.hpp>
#include <gonio/shading/ltc_share.hpp>

#include <cstddef>

namespace gonio::shading::detail {

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

// A light is thin if the angle between two planes that touch it along its sides has a greater cosine.
inline constexpr double thin_cosine = 0.9;

// Half as many rows are enough for a tube that is thinner still and half of whose length is more than so many radii.
inline constexpr double thinner_cosine = 0.99;
inline constexpr double slender = 4.0;

// Regions: convex cones of directions above the receiver's horizon. Each has
//     nearest                    the unit normal, inwards, of a plane that touches it near z'
//     for_each_extreme(A, work)  work(p', whether p is in the region, or on its outline) for points that include those
//                                of the greatest and least ω about A; work also gets all ω where A is in the region
//     row(B, A)                  the part of a row
//     rows, along_row            the rules over ω and along a row
//     has_axis                   whether rows may lie along the light: along `own_axis`, unit, in the plane of
//                                `own_nearest`, where `along_light`

// A rectangle. The patch's centre, u and v are in the receiver's frame.
template<class S>
struct RectangleRegion {
    static constexpr const auto& rows = LobeRule<S>::four;
    static constexpr const auto& along_row = LobeRule<S>::six;
    static constexpr bool has_axis = true;

    vec3<S> corner[4];
    S up[4];              // their heights above the horizon
    simd::mask_of<S> cut; // one is below
    vec3<S> edge[4];
    vec3<S> horizon;
    vec3<S> nearest;
    // Rows along two edges have no kinks in their lengths, unless the horizon cuts them.
    vec3<S> own_axis, own_nearest;
    simd::mask_of<S> along_light;

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
        const vec3<S> nearest_u = nearer_plane(edge[0], edge[2]);
        const vec3<S> nearest_v = nearer_plane(edge[1], edge[3]);
        // Along the edges between whose planes the light is the narrower.
        const S cosine_u = dot(edge[0], edge[2]);
        const S cosine_v = dot(edge[1], edge[3]);
        const auto along_v = cosine_v < cosine_u;
        own_axis = normalized(select(along_v, v1, u1));
        own_nearest = select(along_v, nearest_v, nearest_u);
        nearest = nearer_plane(nearest_u, nearest_v);
        cut = simd::min(simd::min(up[0], up[1]), simd::min(up[2], up[3])) < S(0);
        nearest = select(cut, nearer_plane(nearest, horizon), nearest);
        along_light = simd::either(!cut, simd::min(cosine_u, cosine_v) < S(-thin_cosine));
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
    static constexpr bool has_axis = false;

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
    static constexpr const auto& rows = LobeRule<S>::eight_or_four;
    static constexpr const auto& along_row = LobeRule<S>::six;
    static constexpr bool has_axis = true;

    CircleCone<S> end[2];
    vec3<S> touch[2][2]; // where the side's two tangent planes touch the ends
    S up[2][2];
    vec3<S> side[2]; // the planes' normals, inwards
    vec3<S> horizon;
    vec3<S> nearest;
    simd::mask_of<S> beyond; // in the infinite cylinder: only one end is seen
    // Rows lie along a thin tube: across it their lengths would have kinks where they leave the side for an end.
    vec3<S> own_axis, own_nearest;
    simd::mask_of<S> along_light;
    simd::mask_of<S> takes_few_rows; // along one whose ends are little of it

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
        own_nearest = nearer_plane(side[0], side[1]);
        nearest = own_nearest;
        if (simd::any(beyond))
            nearest = select(beyond, select(tube.along > S(0), end[0].touching(), end[1].touching()), nearest);
        const S side_cosine = dot(side[0], side[1]);
        along_light = simd::both(!beyond, side_cosine < S(-thin_cosine));
        takes_few_rows =
            simd::both(along_light, simd::both(tube.half > S(slender) * tube.radius, side_cosine < S(-thinner_cosine)));
        own_axis = normalized(axis1);
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

} // namespace gonio::shading::detail
