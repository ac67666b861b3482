// The part of a line on a light that an object hides: of all rays from a receiver to the points of a line, those that
// hit a convex object form one piece. Its ends are where the line begins or ends, where it enters or leaves the object,
// or where a ray is tangent to it: closed forms, without sampling. For objects that are apart from the light
// shadow_section.hpp has a shorter way.
//
// S is double or simd::doubles: a receiver in each lane, with lines of its own. All positions except those of
// ShadowBody are relative to the receiver. One-sided surfaces that the receiver touches and solids that it lies in hide
// nothing.
#pragma once

#include <gonio/scene/shadow_numbers.hpp>
#include <gonio/scene/spread.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/scalar.hpp>

#include <cstddef>

namespace gonio::detail {

using shading::vec3;

template<class S>
GONIO_FORCE_INLINE vec3<S> in_frame(const ShadowBody& body, const vec3<S>& v) {
    return {dot(spread<S>(body.x), v), dot(spread<S>(body.y), v), dot(spread<S>(body.z), v)};
}

// `off`: from its middle, in the axes of the box, or the other way.
template<class S>
GONIO_FORCE_INLINE simd::mask_of<S> is_outside_box(const ShadowBody& box, const vec3<S>& off) {
    const vec3<S> half = spread<S>(box.half_size);
    return simd::either(simd::either(simd::abs(off.x) >= half.x, simd::abs(off.y) >= half.y),
                        simd::abs(off.z) >= half.z);
}

// touching() of scene/detail/touching.hpp.
template<class S>
GONIO_FORCE_INLINE S touching_distance(const vec3<S>& point) {
    return S(touching_share) * (S(1) + length(point));
}

// From `low` to `high` along the line, both in [0, 1]; nothing where low ≥ high.
template<class S>
struct HiddenPiece {
    using mask = simd::mask_of<S>;

    S low = S(1);
    S high = S(0);

    GONIO_FORCE_INLINE void add(mask where, S t) {
        low = simd::select(where, simd::min(t, low), low);
        high = simd::select(where, simd::max(t, high), high);
    }
    GONIO_FORCE_INLINE mask is_there() const { return low < high; }
};

// A line of the light.
template<class S>
struct LightLineSeen {
    vec3<S> from;
    vec3<S> along;  // to its other end
    vec3<S> normal; // of the plane of the rays, from × along
    S normal_length;

    LightLineSeen() = default;
    GONIO_FORCE_INLINE LightLineSeen(const vec3<S>& begin, const vec3<S>& end)
        : from(begin), along(end - begin), normal(cross(from, along)), normal_length(length(normal)) {}
    GONIO_FORCE_INLINE LightLineSeen(const vec3<S>& begin, const vec3<S>& way, const vec3<S>& of_plane, S its_length)
        : from(begin), along(way), normal(of_plane), normal_length(its_length) {}

    GONIO_FORCE_INLINE vec3<S> at(S t) const { return from + along * t; }
    GONIO_FORCE_INLINE vec3<S> to() const { return from + along; }
};

// The real roots of a t² + 2 b t + c, without cancellation; a linear equation has only its finite root.
// take(where, root).
template<class S, class Take>
GONIO_FORCE_INLINE void for_roots(S a, S b, S c, const Take& take) {
    const S under = b * b - a * c;
    const auto is_real = under >= S(0);
    if (!simd::any(is_real)) return;
    const S q = -(b + simd::copysign(simd::sqrt(simd::max(under, S(0))), b));
    take(simd::both(is_real, !(q == S(0))), c / q);
    take(simd::both(is_real, !(a == S(0))), q / a);
}

template<class S>
GONIO_FORCE_INLINE simd::mask_of<S> is_on_line(S t) {
    return simd::both(t >= S(0), t <= S(1));
}

// A share of the way to a point of the line, as a fraction.
template<class S>
struct ShareOfWay {
    S part;
    S whole;

    GONIO_FORCE_INLINE simd::mask_of<S> is_before_line() const { return simd::both(part > S(0), part <= whole); }
};

// How rays pass a sphere, or an endless cylinder, which follows the same formulas in the plane across its axis.
template<class S>
struct Round {
    using mask = simd::mask_of<S>;

    vec3<S> center;
    S power; // of the receiver: |c|² − r²
    S radius2;

    Round() = default;
    GONIO_FORCE_INLINE Round(const vec3<S>& middle, S radius)
        : center(middle), power(dot(middle, middle) - radius * radius), radius2(radius * radius) {}

    // Where rays to the line are tangent to it, with the share of the way there at which they touch:
    // take(where, t, share).
    template<class Take>
    GONIO_FORCE_INLINE void tangents(const vec3<S>& from, const vec3<S>& along, const Take& take) const {
        const S fc = dot(from, center);
        const S ac = dot(along, center);
        for_roots(ac * ac - power * dot(along, along), ac * fc - power * dot(from, along),
                  fc * fc - power * dot(from, from), [&](auto where, S t) {
                      const vec3<S> way = from + along * t;
                      take(simd::both(where, is_on_line(t)), t, ShareOfWay<S>{dot(way, center), dot(way, way)});
                  });
    }
    // Where the line enters and leaves it: take(where, t).
    template<class Take>
    GONIO_FORCE_INLINE void crossings(const vec3<S>& from, const vec3<S>& along, const Take& take) const {
        const vec3<S> off = from - center;
        for_roots(dot(along, along), dot(off, along), dot(off, off) - radius2,
                  [&](auto where, S t) { take(simd::both(where, is_on_line(t)), t); });
    }
    // The share of the way to a point at which the ray enters; above the whole where it misses.
    GONIO_FORCE_INLINE ShareOfWay<S> entry(const vec3<S>& way) const {
        const S middle = dot(way, center);
        const S length2 = dot(way, way);
        const S under = middle * middle - power * length2;
        const auto is_met = simd::both(under >= S(0), middle > S(0));
        return {simd::select(is_met, middle - simd::sqrt(simd::max(under, S(0))), S(2) * length2 + S(1)), length2};
    }
    // Whether the ray enters before that point, from a receiver outside.
    GONIO_FORCE_INLINE mask blocks(const vec3<S>& way) const {
        const S middle = dot(way, center);
        const S length2 = dot(way, way);
        const S under = middle * middle - power * length2;
        const S beyond = middle - length2;
        return simd::both(simd::both(under >= S(0), middle > S(0)),
                          simd::either(beyond <= S(0), beyond * beyond <= under));
    }
};

template<class S>
GONIO_FORCE_INLINE void add_ball(HiddenPiece<S>& hidden, const LightLineSeen<S>& line, const Round<S>& ball,
                                 simd::mask_of<S> where) {
    ball.tangents(line.from, line.along, [&](auto on_line, S t, const ShareOfWay<S>& share) {
        hidden.add(simd::both(where, simd::both(on_line, share.is_before_line())), t);
    });
    ball.crossings(line.from, line.along, [&](auto on_line, S t) { hidden.add(simd::both(where, on_line), t); });
    hidden.add(simd::both(where, ball.blocks(line.from)), S(0));
    hidden.add(simd::both(where, ball.blocks(line.to())), S(1));
}

// Where the plane of the rays cuts edges, if that point is in front of the line.
template<class S>
class CutEdges {
public:
    GONIO_FORCE_INLINE explicit CutEdges(const LightLineSeen<S>& line)
        : share_of_way_(cross(line.along, line.normal)),
          share_of_line_(cross(line.normal, line.from)),
          area_(dot(line.normal, line.normal)) {}

    // An edge between points at `side_a` and `side_b` along the normal.
    GONIO_FORCE_INLINE void add(HiddenPiece<S>& hidden, simd::mask_of<S> where, const vec3<S>& a, S side_a,
                                const vec3<S>& b, S side_b) const {
        const auto a_is_below = side_a < S(0);
        const auto b_is_below = side_b < S(0);
        const auto is_cut =
            simd::both(where, simd::either(simd::both(a_is_below, !b_is_below), simd::both(b_is_below, !a_is_below)));
        if (!simd::any(is_cut)) return;
        // cut = u from + v along, where u is the share of the way and v/u the position on the line.
        const vec3<S> cut = a + (b - a) * (side_a / (side_a - side_b));
        const S u = dot(cut, share_of_way_);
        const S v = dot(cut, share_of_line_);
        const auto is_before = simd::both(simd::both(u > S(0), u <= area_), simd::both(v >= S(0), v <= u));
        hidden.add(simd::both(is_cut, is_before), v / u);
    }

private:
    vec3<S> share_of_way_, share_of_line_; // both over the area
    S area_;
};

// What objects hide from receivers: hidden(line) is the piece of a line.

template<class S>
class HidingPlane {
public:
    using mask = simd::mask_of<S>;

    GONIO_FORCE_INLINE HidingPlane(const ShadowBody& plane, const vec3<S>& receiver)
        : normal_(spread<S>(plane.z)),
          height_(dot(receiver - spread<S>(plane.middle), normal_)),
          is_free_(simd::abs(height_) > touching_distance(receiver)) {}

    GONIO_FORCE_INLINE HiddenPiece<S> hidden(const LightLineSeen<S>& line) const {
        HiddenPiece<S> piece;
        const S from = height_ + dot(line.from, normal_);
        const S to = from + dot(line.along, normal_);
        piece.add(simd::both(is_free_, from * to < S(0)), from / (from - to));
        piece.add(simd::both(is_free_, height_ * from < S(0)), S(0));
        piece.add(simd::both(is_free_, height_ * to < S(0)), S(1));
        return piece;
    }

private:
    vec3<S> normal_;
    S height_;     // of the receiver
    mask is_free_; // the receiver does not touch it
};

// The corners of a panel in their order, relative to the receiver.
template<class S>
struct PanelCorners {
    vec3<S> at[4];

    GONIO_FORCE_INLINE PanelCorners(const ShadowBody& panel, const vec3<S>& middle) {
        const vec3<S> right = spread<S>(panel.x) * spread<S>(panel.half_size[0]);
        const vec3<S> up = spread<S>(panel.y) * spread<S>(panel.half_size[1]);
        at[0] = middle - right - up;
        at[1] = middle + right - up;
        at[2] = middle + right + up;
        at[3] = middle - right + up;
    }
};

template<class S>
class HidingPanel {
public:
    using mask = simd::mask_of<S>;

    GONIO_FORCE_INLINE HidingPanel(const ShadowBody& panel, const vec3<S>& receiver)
        : x_(spread<S>(panel.x)),
          y_(spread<S>(panel.y)),
          z_(spread<S>(panel.z)),
          middle_(spread<S>(panel.middle) - receiver),
          half_width_(panel.half_size[0]),
          half_height_(panel.half_size[1]),
          height_(-dot(middle_, z_)),
          is_free_(simd::abs(height_) > touching_distance(receiver)),
          corners_(panel, middle_) {}

    GONIO_FORCE_INLINE HiddenPiece<S> hidden(const LightLineSeen<S>& line) const {
        HiddenPiece<S> piece;
        S side[4];
        for (int i = 0; i < 4; ++i)
            side[i] = dot(line.normal, corners_.at[i]);
        const S lowest = simd::min(simd::min(side[0], side[1]), simd::min(side[2], side[3]));
        const S highest = simd::max(simd::max(side[0], side[1]), simd::max(side[2], side[3]));
        const auto where = simd::both(is_free_, simd::both(lowest <= S(0), highest >= S(0)));
        if (!simd::any(where)) return piece;
        const CutEdges<S> edges(line);
        for (int i = 0; i < 4; ++i)
            edges.add(piece, where, corners_.at[i], side[i], corners_.at[(i + 1) % 4], side[(i + 1) % 4]);
        const S from = height_ + dot(line.from, z_);
        const S to = from + dot(line.along, z_);
        const S crossing = from / (from - to);
        piece.add(simd::both(where, simd::both(from * to < S(0), is_within(line.at(crossing)))), crossing);
        piece.add(simd::both(where, is_passed(from, line.from)), S(0));
        piece.add(simd::both(where, is_passed(to, line.to())), S(1));
        return piece;
    }

private:
    GONIO_FORCE_INLINE mask is_within(const vec3<S>& point) const {
        const vec3<S> off = point - middle_;
        return simd::both(simd::abs(dot(off, x_)) <= half_width_, simd::abs(dot(off, y_)) <= half_height_);
    }
    // Whether the way to a point at `end` above the plane goes through it.
    GONIO_FORCE_INLINE mask is_passed(S end, const vec3<S>& way) const {
        return simd::both(height_ * end < S(0), is_within(way * (height_ / (height_ - end))));
    }

    vec3<S> x_, y_, z_, middle_;
    S half_width_, half_height_;
    S height_;     // of the receiver
    mask is_free_; // the receiver does not touch it
    PanelCorners<S> corners_;
};

template<class S>
class HidingBall {
public:
    using mask = simd::mask_of<S>;

    GONIO_FORCE_INLINE HidingBall(const ShadowBody& ball, const vec3<S>& receiver)
        : radius_(ball.radius), round_(spread<S>(ball.middle) - receiver, radius_), is_outside_(round_.power > S(0)) {}

    GONIO_FORCE_INLINE HiddenPiece<S> hidden(const LightLineSeen<S>& line) const {
        HiddenPiece<S> piece;
        const auto where =
            simd::both(is_outside_, simd::abs(dot(line.normal, round_.center)) <= radius_ * line.normal_length);
        if (simd::any(where)) add_ball(piece, line, round_, where);
        return piece;
    }

private:
    S radius_;
    Round<S> round_;
    mask is_outside_;
};

template<class S>
class HidingCapsule {
public:
    using mask = simd::mask_of<S>;

    GONIO_FORCE_INLINE HidingCapsule(const ShadowBody& capsule, const vec3<S>& receiver)
        : center_(spread<S>(capsule.middle) - receiver),
          axis_(spread<S>(capsule.x)),
          half_length_(capsule.half_size[0]),
          radius_(capsule.radius),
          side_(across(center_), radius_) {
        end_[0] = Round<S>(center_ - axis_ * half_length_, radius_);
        end_[1] = Round<S>(center_ + axis_ * half_length_, radius_);
        const S along = -dot(center_, axis_);
        const S place = simd::max(simd::min(along, half_length_), -half_length_);
        is_outside_ = !(length(center_ + axis_ * place) < radius_);
    }

    HiddenPiece<S> hidden(const LightLineSeen<S>& line) const {
        HiddenPiece<S> piece;
        // An object that the plane of the rays misses hides nothing, and takes almost no time.
        const S reach = radius_ * line.normal_length;
        const S heights[2] = {dot(line.normal, end_[0].center), dot(line.normal, end_[1].center)};
        const auto where = simd::both(is_outside_, simd::both(simd::min(heights[0], heights[1]) <= reach,
                                                              simd::max(heights[0], heights[1]) >= -reach));
        if (!simd::any(where)) return piece;
        for (int i = 0; i < 2; ++i) {
            const auto met = simd::both(where, simd::abs(heights[i]) <= reach);
            if (simd::any(met)) add_ball(piece, line, end_[i], met);
        }
        // The side between the ends.
        const vec3<S> from = across(line.from);
        const vec3<S> along = across(line.along);
        side_.tangents(from, along, [&](auto on_line, S t, const ShareOfWay<S>& share) {
            piece.add(simd::both(where, simd::both(on_line, is_on_side(line.at(t), share))), t);
        });
        side_.crossings(from, along, [&](auto on_line, S t) {
            piece.add(simd::both(where, simd::both(on_line, is_on_side(line.at(t), {S(1), S(1)}))), t);
        });
        piece.add(simd::both(where, is_on_side(line.from, side_.entry(from))), S(0));
        piece.add(simd::both(where, is_on_side(line.to(), side_.entry(from + along))), S(1));
        return piece;
    }

private:
    GONIO_FORCE_INLINE vec3<S> across(const vec3<S>& v) const { return v - axis_ * dot(v, axis_); }
    GONIO_FORCE_INLINE mask is_on_side(const vec3<S>& way, const ShareOfWay<S>& share) const {
        const S height = dot(axis_, way) * share.part - dot(axis_, center_) * share.whole;
        return simd::both(share.is_before_line(), simd::abs(height) <= half_length_ * share.whole);
    }

    vec3<S> center_, axis_;
    S half_length_, radius_;
    Round<S> side_;
    Round<S> end_[2];
    mask is_outside_;
};

// In the axes of the box.
template<class S>
class HidingBox {
public:
    using mask = simd::mask_of<S>;

    GONIO_FORCE_INLINE HidingBox(const ShadowBody& box, const vec3<S>& receiver)
        : box_(box),
          receiver_(in_frame(box, receiver - spread<S>(box.middle))),
          half_(spread<S>(box.half_size)),
          is_outside_(is_outside_box(box, receiver_)) {}

    HiddenPiece<S> hidden(const LightLineSeen<S>& of_stage) const {
        HiddenPiece<S> piece;
        const vec3<S> normal = in_frame(box_, of_stage.normal);
        // Of the corners, the plane of the rays is nearest to and farthest from the middle by this much.
        const S middle = -dot(normal, receiver_);
        const vec3<S> off{normal.x * half_.x, normal.y * half_.y, normal.z * half_.z};
        const S reach = simd::abs(off.x) + simd::abs(off.y) + simd::abs(off.z);
        const auto where = simd::both(is_outside_, simd::abs(middle) <= reach);
        if (!simd::any(where)) return piece;
        const LightLineSeen<S> line{in_frame(box_, of_stage.from), in_frame(box_, of_stage.along), normal,
                                    of_stage.normal_length};
        // Where the plane of the rays cuts its edges.
        vec3<S> corner[8];
        S side[8];
        for (unsigned i = 0; i < 8; ++i) {
            const bool right = (i & 1U) != 0;
            const bool back = (i & 2U) != 0;
            const bool up = (i & 4U) != 0;
            corner[i] = {(right ? half_.x : -half_.x) - receiver_.x, (back ? half_.y : -half_.y) - receiver_.y,
                         (up ? half_.z : -half_.z) - receiver_.z};
            side[i] = middle + (right ? off.x : -off.x) + (back ? off.y : -off.y) + (up ? off.z : -off.z);
        }
        const CutEdges<S> edges(line);
        for (unsigned i = 0; i < 8; ++i)
            for (unsigned bit = 1; bit < 8; bit *= 2)
                if ((i & bit) == 0) edges.add(piece, where, corner[i], side[i], corner[i | bit], side[i | bit]);
        // Where the line itself and the rays to its ends enter the box.
        const Slabs passed(half_, receiver_ + line.from, line.along);
        const auto is_met = simd::both(simd::both(where, passed.is_met(passed.entry <= passed.exit)),
                                       simd::both(passed.exit >= S(0), passed.entry <= S(1)));
        piece.add(is_met, simd::max(passed.entry, S(0)));
        piece.add(is_met, simd::min(passed.exit, S(1)));
        piece.add(simd::both(where, is_entered(line.from)), S(0));
        piece.add(simd::both(where, is_entered(line.to())), S(1));
        return piece;
    }

private:
    // Where a line is between the planes of all three pairs of faces.
    struct Slabs {
        S entry = S(-1e300);
        S exit = S(1e300);
        mask is_between = S(0) <= S(1); // those that it is parallel to

        GONIO_FORCE_INLINE Slabs(const vec3<S>& half, const vec3<S>& origin, const vec3<S>& direction) {
            cut(half.x, origin.x, direction.x);
            cut(half.y, origin.y, direction.y);
            cut(half.z, origin.z, direction.z);
        }
        GONIO_FORCE_INLINE mask is_met(mask in_order) const { return simd::both(is_between, in_order); }

    private:
        GONIO_FORCE_INLINE void cut(S half, S origin, S direction) {
            const auto is_parallel = direction == S(0);
            const S towards = simd::copysign(half, direction);
            const S per_direction = simd::select(is_parallel, S(1), direction);
            entry = simd::select(is_parallel, entry, simd::max(entry, (-towards - origin) / per_direction));
            exit = simd::select(is_parallel, exit, simd::min(exit, (towards - origin) / per_direction));
            is_between = simd::both(is_between, simd::either(!is_parallel, simd::abs(origin) < half));
        }
    };

    GONIO_FORCE_INLINE mask is_entered(const vec3<S>& way) const {
        const Slabs passed(half_, receiver_, way);
        return simd::both(passed.is_met(passed.entry < passed.exit),
                          simd::both(passed.exit > S(0), passed.entry <= S(1)));
    }

    const ShadowBody& box_;
    vec3<S> receiver_; // from the middle of the box
    vec3<S> half_;
    mask is_outside_;
};

// Calls work(object) with what the body is to the receivers.
template<class S, class Work>
GONIO_FORCE_INLINE auto with_hiding(const ShadowBody& body, const vec3<S>& receiver, const Work& work) {
    switch (body.kind) {
    case ShadowBody::Kind::plane:
        return work(HidingPlane<S>(body, receiver));
    case ShadowBody::Kind::panel:
        return work(HidingPanel<S>(body, receiver));
    case ShadowBody::Kind::ball:
        return work(HidingBall<S>(body, receiver));
    case ShadowBody::Kind::box:
        return work(HidingBox<S>(body, receiver));
    case ShadowBody::Kind::capsule:
        break;
    }
    return work(HidingCapsule<S>(body, receiver));
}

} // namespace gonio::detail
