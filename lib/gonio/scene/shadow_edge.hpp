// Which objects matter to the shadow at a receiver, and the edge of a shadow that is seen nearest to a direction: lines
// on the light that run across it are cut uniformly.
//
// A receiver in each lane; positions except those of ShadowBody and of receivers are relative to it.
#pragma once

#include <gonio/scene/shadow_line.hpp>
#include <gonio/scene/shadow_numbers.hpp>
#include <gonio/scene/unfused.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/doubles_math.hpp>

namespace gonio::detail {

// An edge and how far it is seen from a direction.
template<class S>
struct ShadowEdge {
    // Square of the sine of the angle between them; beyond a right angle 2 minus that.
    S away = S(4);
    vec3<S> across{S(0), S(0), S(0)}; // across the edge, of any length

    GONIO_FORCE_INLINE void take(simd::mask_of<S> where, const ShadowEdge& other) {
        away = simd::select(where, other.away, away);
        across = shading::select<S>(where, other.across, across);
    }
    GONIO_FORCE_INLINE static S away_of(S square_of_sine, S cosine) {
        return simd::select(cosine > S(0), square_of_sine, S(2) - square_of_sine);
    }
};

// The edge of an object nearest to a unit direction; the direction itself where the receiver is inside.
template<class S>
class NearestEdge {
public:
    GONIO_FORCE_INLINE explicit NearestEdge(const vec3<S>& towards) : towards_(towards) {}

    // `middle`: of the body.
    GONIO_FORCE_INLINE ShadowEdge<S> operator()(const ShadowBody& body, const vec3<S>& middle) const {
        switch (body.kind) {
        case ShadowBody::Kind::plane: {
            const vec3<S> normal = spread<S>(body.z);
            const S sine = unfused::dot(towards_, normal);
            return {sine * sine, normal};
        }
        case ShadowBody::Kind::panel:
            return of_panel(body, middle);
        case ShadowBody::Kind::ball:
            return of_ball(body, middle);
        case ShadowBody::Kind::box:
            return of_box(body, middle);
        case ShadowBody::Kind::capsule:
            break;
        }
        return of_capsule(body, middle);
    }

private:
    struct Corner {
        vec3<S> at;
        vec3<S> turn; // direction × at
        S away;

        Corner() = default;
        GONIO_FORCE_INLINE Corner(const vec3<S>& point, const vec3<S>& towards)
            : at(point),
              turn(unfused::cross(towards, point)),
              away(ShadowEdge<S>::away_of(unfused::dot(turn, turn) *
                                              shading::reciprocal_or_zero(unfused::dot(point, point)),
                                          unfused::dot(point, towards))) {}
    };

    // What is seen around an angle from its middle, from the squares of two sines and the sign of the middle's cosine.
    GONIO_FORCE_INLINE static S away_from_rim(S of_middle, S of_radius) {
        const auto is_before = of_middle <= S(1);
        const S square = simd::select(is_before, of_middle, S(2) - of_middle);
        const S cosine = simd::sqrt(simd::max(S(1) - square, S(0)));
        const S sine = simd::sqrt(square);
        const S signed_cosine = simd::select(is_before, cosine, -cosine);
        const S rim_cosine = simd::sqrt(simd::max(S(1) - of_radius, S(0)));
        const S rim_sine = simd::sqrt(of_radius);
        const S between = sine * rim_cosine - signed_cosine * rim_sine;
        return ShadowEdge<S>::away_of(between * between, signed_cosine * rim_cosine + sine * rim_sine);
    }

    ShadowEdge<S> of_ball(const ShadowBody& ball, const vec3<S>& center) const {
        const Corner middle(center, towards_);
        const S distance2 = unfused::dot(center, center);
        const S radius2 = spread<S>(ball.radius * ball.radius);
        ShadowEdge<S> edge{S(0), towards_};
        edge.take(distance2 > radius2, {away_from_rim(middle.away, radius2 * shading::reciprocal_or_zero(distance2)),
                                        unfused::cross(middle.turn, towards_)});
        return edge;
    }

    ShadowEdge<S> of_capsule(const ShadowBody& capsule, const vec3<S>& center) const {
        const vec3<S> half = spread<S>(capsule.x) * spread<S>(capsule.half_size[0]);
        const S along = unfused::dot(center, spread<S>(capsule.x));
        const S place = simd::max(simd::min(-along, spread<S>(capsule.half_size[0])), -spread<S>(capsule.half_size[0]));
        const vec3<S> nearest = center + spread<S>(capsule.x) * place;
        const S nearest2 = unfused::dot(nearest, nearest);
        const S radius2 = spread<S>(capsule.radius * capsule.radius);
        ShadowEdge<S> of_axis = segment(Corner(center - half, towards_), Corner(center + half, towards_));
        of_axis.away = away_from_rim(of_axis.away, radius2 * shading::reciprocal_or_zero(nearest2));
        ShadowEdge<S> edge{S(0), towards_};
        edge.take(nearest2 > radius2, of_axis);
        return edge;
    }

    ShadowEdge<S> of_panel(const ShadowBody& panel, const vec3<S>& middle) const {
        const PanelCorners<S> corners(panel, middle);
        Corner corner[4];
        for (int i = 0; i < 4; ++i)
            corner[i] = Corner(corners.at[i], towards_);
        ShadowEdge<S> nearest;
        for (int i = 0; i < 4; ++i)
            add(nearest, segment(corner[i], corner[(i + 1) % 4]));
        return nearest;
    }

    ShadowEdge<S> of_box(const ShadowBody& box, const vec3<S>& middle) const {
        const vec3<S> x = spread<S>(box.x) * spread<S>(box.half_size[0]);
        const vec3<S> y = spread<S>(box.y) * spread<S>(box.half_size[1]);
        const vec3<S> z = spread<S>(box.z) * spread<S>(box.half_size[2]);
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
        nearest.take(other.away < nearest.away, other);
    }

    // The plane through the segment and the receiver if the direction passes the segment, else the segment's nearer
    // end.
    GONIO_FORCE_INLINE ShadowEdge<S> segment(const Corner& a, const Corner& b) const {
        const vec3<S> normal = unfused::cross(a.at, b.at);
        const S length2 = unfused::dot(normal, normal);
        // The direction projected into that plane: u a + v b.
        const S u = unfused::dot(b.turn, normal);
        const S v = -unfused::dot(a.turn, normal);
        const auto is_plane = length2 > S(0);
        const auto passes = simd::both(is_plane, simd::both(u > S(0), v > S(0)));
        const S sine = unfused::dot(normal, towards_);
        const S nearer_end = simd::min(a.away, b.away);
        const S away = simd::select(passes, sine * sine / simd::select(is_plane, length2, S(1)), nearer_end);
        if (simd::all(is_plane)) return {away, normal};
        // The receiver is in line with the segment, or on it.
        return {away, shading::select<S>(is_plane, normal, unfused::cross(a.turn, towards_))};
    }

    vec3<S> towards_;
};

// Which bodies may block light on its way from a sphere to the receiver; some of them may not.
template<class S>
class WaysFromSphere {
public:
    GONIO_FORCE_INLINE WaysFromSphere(const vec3<S>& receiver, const double (&center)[3], double radius)
        : receiver_(receiver),
          way_(spread<S>(center) - receiver),
          touching_(touching_distance(receiver)),
          center_{center[0], center[1], center[2]},
          radius_(radius) {
        const S length2 = unfused::dot(way_, way_);
        per_length2_ = shading::reciprocal_or_zero(length2);
        is_slender_ = S(radius * radius) < S(0.01) * length2;
        is_somewhere_ = length2 > S(0);
    }

    GONIO_FORCE_INLINE simd::mask_of<S> may_meet(const ShadowBody& body) const {
        const vec3<S> from_middle = receiver_ - spread<S>(body.middle);
        auto parted = !is_somewhere_;
        // Receiver and light are on the same side of one of its planes, so that no part of it is between them.
        const auto part = [&](const double(&normal)[3], double half) {
            const S of_receiver = unfused::dot(from_middle, spread<S>(normal));
            const double of_light = (center_[0] - body.middle[0]) * normal[0] +
                                    (center_[1] - body.middle[1]) * normal[1] +
                                    (center_[2] - body.middle[2]) * normal[2];
            const auto is_beyond =
                simd::both(simd::abs(of_receiver) >= S(half) - touching_,
                           simd::select(of_receiver < S(0), S(-of_light), S(of_light)) - S(radius_) >= S(half));
            parted = simd::either(parted, is_beyond);
        };
        if (body.kind == ShadowBody::Kind::plane || body.kind == ShadowBody::Kind::panel) part(body.z, 0.0);
        if (body.kind == ShadowBody::Kind::plane) return !parted;
        if (body.kind == ShadowBody::Kind::box) {
            part(body.x, body.half_size[0]);
            part(body.y, body.half_size[1]);
            part(body.z, body.half_size[2]);
        }
        // All ways lie within a cone: at most as wide as the light and, where it is slender, as its middle.
        const S along = simd::max(simd::min(-unfused::dot(from_middle, way_) * per_length2_, S(1)), S(0));
        const S width = simd::select(is_slender_, S(1.01 * radius_) * along + S(0.01 * body.around), S(radius_));
        const S near = (spread<S>(body.around) + width) * S(1.0 + 1e-6);
        const vec3<S> apart = from_middle + way_ * along;
        return simd::both(!parted, unfused::dot(apart, apart) <= near * near);
    }

private:
    vec3<S> receiver_; // in the coordinates of the stage
    vec3<S> way_;
    S touching_;
    S per_length2_;
    double center_[3];
    double radius_;
    simd::mask_of<S> is_slender_;
    simd::mask_of<S> is_somewhere_;
};

// Planes through the receiver with all ways from a long or a rectangular light on one side of each: what is wholly on
// the other side blocks nothing. WaysFromSphere says far less of such lights.
template<class S>
class SidesOfWays {
public:
    // Whether they say something of the body.
    GONIO_FORCE_INLINE static bool may_be_beside(const LinedLight& light, const ShadowBody& body) {
        return body.kind != ShadowBody::Kind::plane &&
               (light.kind == LinedLight::Kind::tube || light.kind == LinedLight::Kind::cylinder ||
                light.kind == LinedLight::Kind::rectangle);
    }

    GONIO_FORCE_INLINE SidesOfWays(const LinedLight& light, const vec3<S>& receiver) : receiver_(receiver) {
        const vec3<S> center = spread<S>(light.center) - receiver;
        const vec3<S> x = spread<S>(light.x) * spread<S>(light.half_size[0]);
        if (light.kind == LinedLight::Kind::rectangle) {
            const vec3<S> y = spread<S>(light.y) * spread<S>(light.half_size[1]);
            const vec3<S> corners[4] = {center - x - y, center + x - y, center + x + y, center - x + y};
            for (int i = 0; i < 4; ++i) {
                const vec3<S>& a = corners[i];
                const vec3<S>& b = corners[(i + 1) % 4];
                const vec3<S> normal = unfused::cross(a, b);
                set(i, shading::select<S>(unfused::dot(normal, center) > S(0), normal * S(-1), normal), a, b);
            }
            return;
        }
        // The ways are as wide as the light around the triangle of its axis and the receiver.
        const vec3<S> a = center - x;
        const vec3<S> b = center + x;
        width_ = spread<S>(light.radius);
        set(0, unfused::cross(a, b), a, b);
        const vec3<S>& normal = normals_[0];
        normals_[1] = normal * S(-1);
        set(2, unfused::cross(a, normal), a, normal); // its product with b is negative
        set(3, unfused::cross(normal, b), normal, b); // as is that of this with a
    }

    GONIO_FORCE_INLINE simd::mask_of<S> may_meet(const ShadowBody& body) const {
        if (body.kind == ShadowBody::Kind::plane) return S(0) <= S(0);
        const vec3<S> middle = spread<S>(body.middle) - receiver_;
        auto parted = S(1) < S(0);
        for (const vec3<S>& normal : normals_) {
            S extent = spread<S>(body.radius);
            const auto add = [&](const double(&axis)[3], double half) {
                extent = extent + simd::abs(unfused::dot(normal, spread<S>(axis))) * S(half);
            };
            if (body.kind != ShadowBody::Kind::ball) add(body.x, body.half_size[0]);
            if (body.kind == ShadowBody::Kind::panel || body.kind == ShadowBody::Kind::box)
                add(body.y, body.half_size[1]);
            if (body.kind == ShadowBody::Kind::box) add(body.z, body.half_size[2]);
            parted = simd::either(parted, unfused::dot(normal, middle) > (extent + width_) * S(1.0 + 1e-6));
        }
        return !parted;
    }

private:
    // Of the product of a and b. Where these are nearly in line it is not known well, and 0 parts nothing.
    GONIO_FORCE_INLINE void set(int i, const vec3<S>& normal, const vec3<S>& a, const vec3<S>& b) {
        const S length2 = unfused::dot(normal, normal);
        const auto is_known = length2 > S(1e-12) * unfused::dot(a, a) * unfused::dot(b, b);
        const S per_length = S(1) / simd::sqrt(simd::select(is_known, length2, S(1)));
        normals_[i] = normal * simd::select(is_known, per_length, S(0));
    }

    vec3<S> receiver_; // in the coordinates of the stage
    vec3<S> normals_[4];
    S width_ = S(0);
};

} // namespace gonio::detail
