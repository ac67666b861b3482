// Which objects matter to the shadow at a receiver, and the edge of a shadow that is seen nearest to a direction: lines
// on the light that run across it are cut uniformly.
//
// S is double or simd::doubles, a receiver in each lane; positions except those of ShadowBody are relative to it.
#pragma once

#include <gonio/scene/shadow_line.hpp>
#include <gonio/scene/shadow_numbers.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/doubles_math.hpp>

namespace gonio::detail {

template<class S>
struct ShadowEdge {
    S distance = S(1e300);            // at most the angle between them [rad]; negative inside round objects
    vec3<S> across{S(0), S(0), S(0)}; // across the edge, of any length

    GONIO_FORCE_INLINE void take(simd::mask_of<S> where, const ShadowEdge& other) {
        distance = simd::select(where, other.distance, distance);
        across = shading::select<S>(where, other.across, across);
    }
};

// The edge of an object nearest to a unit direction. The distance is 0 for objects that the receiver touches, or that
// extend to it.
template<class S>
class NearestEdge {
public:
    GONIO_FORCE_INLINE NearestEdge(const vec3<S>& receiver, const vec3<S>& towards)
        : receiver_(receiver), towards_(towards) {}

    GONIO_FORCE_INLINE ShadowEdge<S> operator()(const ShadowBody& body) const {
        switch (body.kind) {
        case ShadowBody::Kind::plane:
            return {dot(towards_, spread<S>(body.z)), spread<S>(body.z)};
        case ShadowBody::Kind::panel:
            return of_panel(body);
        case ShadowBody::Kind::ball:
            return of_ball(body);
        case ShadowBody::Kind::box:
            return of_box(body);
        case ShadowBody::Kind::capsule:
            break;
        }
        return of_capsule(body);
    }

private:
    // A point, and the direction to it.
    struct Corner {
        vec3<S> at;
        S length;
        S off; // chord between the directions

        Corner() = default;
        GONIO_FORCE_INLINE Corner(const vec3<S>& point, const vec3<S>& towards)
            : at(point),
              length(shading::length(point)),
              off(shading::length(point * shading::reciprocal_or_zero(length) - towards)) {}
    };

    ShadowEdge<S> of_ball(const ShadowBody& ball) const {
        const vec3<S> center = spread<S>(ball.middle) - receiver_;
        const S distance = length(center);
        const S radius(ball.radius);
        const auto is_outside = distance > radius;
        const S per_distance = shading::reciprocal_or_zero(distance);
        const vec3<S> off = center * per_distance - towards_;
        ShadowEdge<S> edge{S(0), towards_};
        edge.take(is_outside, {S(2) * simd::arc_sine(simd::min(S(0.5) * length(off), S(1))) -
                                   simd::arc_sine(simd::min(radius * per_distance, S(1))),
                               off});
        return edge;
    }

    ShadowEdge<S> of_capsule(const ShadowBody& capsule) const {
        const vec3<S> center = spread<S>(capsule.middle) - receiver_;
        const vec3<S> half = spread<S>(capsule.x) * S(capsule.half_size[0]);
        const Corner a(center - half, towards_);
        const Corner b(center + half, towards_);
        const vec3<S> way = b.at - a.at;
        const S place = simd::max(simd::min(-dot(a.at, way) * shading::reciprocal_or_zero(dot(way, way)), S(1)), S(0));
        const S nearest = length(a.at + way * place);
        const S radius(capsule.radius);
        const auto is_outside = nearest > radius;
        ShadowEdge<S> of_axis = segment(a, b);
        of_axis.distance =
            of_axis.distance - simd::arc_sine(simd::min(radius * shading::reciprocal_or_zero(nearest), S(1)));
        ShadowEdge<S> edge{S(0), towards_};
        edge.take(is_outside, of_axis);
        return edge;
    }

    ShadowEdge<S> of_panel(const ShadowBody& panel) const {
        const PanelCorners<S> corners(panel, receiver_);
        Corner corner[4];
        for (int i = 0; i < 4; ++i)
            corner[i] = Corner(corners.at[i], towards_);
        ShadowEdge<S> nearest;
        for (int i = 0; i < 4; ++i)
            add(nearest, segment(corner[i], corner[(i + 1) % 4]));
        return nearest;
    }

    ShadowEdge<S> of_box(const ShadowBody& box) const {
        const vec3<S> middle = spread<S>(box.middle) - receiver_;
        const vec3<S> x = spread<S>(box.x) * S(box.half_size[0]);
        const vec3<S> y = spread<S>(box.y) * S(box.half_size[1]);
        const vec3<S> z = spread<S>(box.z) * S(box.half_size[2]);
        Corner corner[8];
        for (unsigned i = 0; i < 8; ++i)
            corner[i] = Corner(middle + x * S((i & 1U) != 0 ? 1 : -1) + y * S((i & 2U) != 0 ? 1 : -1) +
                                   z * S((i & 4U) != 0 ? 1 : -1),
                               towards_);
        ShadowEdge<S> nearest;
        for (unsigned i = 0; i < 8; ++i)
            for (unsigned bit = 1; bit < 8; bit *= 2)
                if ((i & bit) == 0) add(nearest, segment(corner[i], corner[i | bit]));
        return nearest;
    }

    GONIO_FORCE_INLINE static void add(ShadowEdge<S>& nearest, const ShadowEdge<S>& other) {
        nearest.take(other.distance < nearest.distance, other);
    }

    // The plane through the segment and the receiver if the direction passes the segment, else the segment's nearer
    // end.
    GONIO_FORCE_INLINE ShadowEdge<S> segment(const Corner& a, const Corner& b) const {
        const vec3<S> normal = cross(a.at, b.at);
        const S length2 = dot(normal, normal);
        const auto is_plane = length2 > S(0);
        // The direction projected into that plane: u a + v b.
        const S u = dot(cross(towards_, b.at), normal);
        const S v = dot(cross(a.at, towards_), normal);
        const auto passes = simd::both(is_plane, simd::both(u > S(0), v > S(0)));
        const S root = simd::sqrt(simd::select(is_plane, length2, S(1)));
        ShadowEdge<S> edge{simd::select(passes, simd::abs(dot(normal, towards_)) / root, simd::min(a.off, b.off)),
                           normal};
        if (simd::all(is_plane)) return edge;
        // The receiver is in line with the segment, or on it.
        const auto is_on_it =
            simd::both(!is_plane, !simd::both(simd::both(a.length > S(0), b.length > S(0)), dot(a.at, b.at) >= S(0)));
        edge.distance = simd::select(is_plane, edge.distance, simd::select(is_on_it, S(0), a.off));
        edge.across = shading::select<S>(
            is_plane, edge.across,
            shading::select<S>(is_on_it, towards_, a.at * shading::reciprocal_or_zero(a.length) - towards_));
        return edge;
    }

    vec3<S> receiver_; // in the coordinates of the stage
    vec3<S> towards_;
};

// Whether a body may block light on its way from a sphere to the receiver; may be true when in doubt.
template<class S>
GONIO_FORCE_INLINE simd::mask_of<S> may_stand_before(const ShadowBody& body, const vec3<S>& receiver,
                                                     const vec3<S>& light_center, S light_radius) {
    const vec3<S> middle = spread<S>(body.middle);
    const vec3<S> from_middle = receiver - middle;
    const vec3<S> light_from_middle = light_center - middle;
    auto parted = S(1) < S(0);
    // Receiver and light are on the same side of one of its planes, so that no part of it is between them.
    const auto part = [&](const double(&normal)[3], S half) {
        const S of_receiver = dot(from_middle, spread<S>(normal));
        const S of_light = dot(light_from_middle, spread<S>(normal));
        const auto is_beyond = simd::both(simd::abs(of_receiver) >= half - touching_distance(receiver),
                                          simd::select(of_receiver < S(0), -of_light, of_light) - light_radius >= half);
        parted = simd::either(parted, is_beyond);
    };
    if (body.kind == ShadowBody::Kind::plane || body.kind == ShadowBody::Kind::panel) part(body.z, S(0));
    if (body.kind == ShadowBody::Kind::plane) return !parted;
    if (body.kind == ShadowBody::Kind::box) {
        part(body.x, S(body.half_size[0]));
        part(body.y, S(body.half_size[1]));
        part(body.z, S(body.half_size[2]));
    }
    // All ways lie within a cone: at most as wide as the light and, where it is slender, as its middle.
    const S around(body.around);
    const vec3<S> way = light_center - receiver;
    const S length2 = dot(way, way);
    const S along = simd::max(simd::min(-dot(from_middle, way) * shading::reciprocal_or_zero(length2), S(1)), S(0));
    const auto is_slender = light_radius * light_radius < S(0.01) * length2;
    const S width = simd::select(is_slender, S(1.01) * light_radius * along + S(0.01) * around, light_radius);
    const S near = (around + width) * S(1.0 + 1e-6);
    const vec3<S> apart = from_middle + way * along;
    return simd::both(!parted, dot(apart, apart) <= near * near);
}

} // namespace gonio::detail
