// What an object that is apart from a light hides of the light's lines: the directions that it covers in the plane of
// each line. The object is put into the frame of the lines (light_lines.hpp) once; a plane then cuts it with few
// products, and no depth is compared, since an object apart from the light is either before all of it or behind.
//
// put() writes what describes the object in the frame in D: double or simd::doubles, so that no digits are lost of what
// is near. These numbers, rounded to S (float, double or a pack), make the section.
#pragma once

#include <gonio/scene/light_lines.hpp>
#include <gonio/scene/shadow_line.hpp>
#include <gonio/scene/shadow_numbers.hpp>
#include <gonio/scene/unfused.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/scalar.hpp>

#include <cstddef>

namespace gonio::detail {

// Beyond the slopes of all lines.
inline constexpr float endless_slope = 1e30F;

// The slopes that are hidden; nothing where low ≥ high.
template<class S>
struct HiddenSlopes {
    S low = S(endless_slope);
    S high = S(-endless_slope);

    GONIO_FORCE_INLINE simd::mask_of<S> is_there() const { return low < high; }
};

// A direction in a plane, of any length.
template<class S>
struct PlaneDirection {
    S x;
    S y;

    // Positive if the other one is higher. They are less than 180° apart.
    GONIO_FORCE_INLINE S to(const PlaneDirection& other) const { return x * other.y - y * other.x; }

    GONIO_FORCE_INLINE static PlaneDirection select(simd::mask_of<S> where, const PlaneDirection& a,
                                                    const PlaneDirection& b) {
        return {simd::select(where, a.x, b.x), simd::select(where, a.y, b.y)};
    }
};

// The directions that a convex object covers in a plane.
template<class S>
class CoveredAngle {
public:
    using mask = simd::mask_of<S>;

    CoveredAngle() = default;
    GONIO_FORCE_INLINE CoveredAngle(mask where, const PlaneDirection<S>& low, const PlaneDirection<S>& high)
        : is_there_(where), low_(low), high_(high) {}

    GONIO_FORCE_INLINE void take(mask where, const PlaneDirection<S>& direction) {
        const auto is_first = !is_there_;
        const auto is_lower = simd::both(where, simd::either(is_first, low_.to(direction) < S(0)));
        const auto is_higher = simd::both(where, simd::either(is_first, high_.to(direction) > S(0)));
        low_ = PlaneDirection<S>::select(is_lower, direction, low_);
        high_ = PlaneDirection<S>::select(is_higher, direction, high_);
        is_there_ = simd::either(is_there_, where);
    }
    // Of the line, which is in front of the axis: a direction with x ≤ 0 is beyond one of its ends.
    GONIO_FORCE_INLINE HiddenSlopes<S> hidden(const LightLine<S>& line) const {
        const auto is_low_before = low_.x > S(0);
        const auto is_high_before = high_.x > S(0);
        const auto is_before = simd::both(is_there_, simd::either(is_low_before, is_high_before));
        const S low = simd::select(is_low_before, low_.y / low_.x, S(-endless_slope));
        const S high = simd::select(is_high_before, high_.y / high_.x, S(endless_slope));
        return {simd::select(is_before, simd::max(low, line.low), S(endless_slope)),
                simd::select(is_before, simd::min(high, line.high), S(-endless_slope))};
    }

private:
    mask is_there_ = S(1) < S(0);
    PlaneDirection<S> low_{S(0), S(0)};
    PlaneDirection<S> high_{S(0), S(0)};
};

// The end of an edge, and its place in a plane.
template<class S>
struct CutPoint {
    S height;
    S x;
    S y;

    CutPoint() = default;
    GONIO_FORCE_INLINE CutPoint(const LightLine<S>& line, const InLineFrame<S>& at)
        : height(line.height(at)), x(line.x(at)), y(at.above) {}

    GONIO_FORCE_INLINE simd::mask_of<S> is_below() const { return height < S(0); }
    // Where the edge from here, below the plane, to a point that is not below cuts it.
    GONIO_FORCE_INLINE PlaneDirection<S> rising_to(const CutPoint& b) const {
        return {x * b.height - b.x * height, y * b.height - b.y * height};
    }
};

// Where an edge cuts the plane.
template<class S>
struct EdgeCut {
    simd::mask_of<S> is_cut;
    PlaneDirection<S> direction;

    GONIO_FORCE_INLINE EdgeCut(const CutPoint<S>& a, const CutPoint<S>& b) {
        const auto a_is_below = a.is_below();
        const auto b_is_below = b.is_below();
        is_cut = simd::either(simd::both(a_is_below, !b_is_below), simd::both(b_is_below, !a_is_below));
        const PlaneDirection<S> rising = a.rising_to(b);
        direction = PlaneDirection<S>::select(a_is_below, rising, {-rising.x, -rising.y});
    }
};

template<class D>
GONIO_FORCE_INLINE void put_framed(const InLineFrame<D>& v, D* to) {
    to[0] = v.forward;
    to[1] = v.side;
    to[2] = v.above;
}
// The middle of a body and the first of its half axes, as all sections begin.
template<std::size_t half_axes, class D>
GONIO_FORCE_INLINE void put_extent(const ShadowBody& body, const vec3<D>& middle, const LightFrame<D>& frame, D* to) {
    const double(*const axes[3])[3] = {&body.x, &body.y, &body.z};
    put_framed(frame.in_frame(middle), to);
    for (std::size_t i = 0; i < half_axes; ++i)
        put_framed(frame.in_frame(spread<D>(*axes[i]) * spread<D>(body.half_size[i])), to + 3 * (i + 1));
}
template<class S>
GONIO_FORCE_INLINE InLineFrame<S> framed_at(const S* numbers) {
    return {numbers[0], numbers[1], numbers[2]};
}
template<class S>
GONIO_FORCE_INLINE InLineFrame<S> operator+(const InLineFrame<S>& a, const InLineFrame<S>& b) {
    return {a.forward + b.forward, a.side + b.side, a.above + b.above};
}
template<class S>
GONIO_FORCE_INLINE InLineFrame<S> operator-(const InLineFrame<S>& a, const InLineFrame<S>& b) {
    return {a.forward - b.forward, a.side - b.side, a.above - b.above};
}
template<class S>
GONIO_FORCE_INLINE InLineFrame<S> operator*(const InLineFrame<S>& a, S b) {
    return {a.forward * b, a.side * b, a.above * b};
}

// Planes through the receiver that have the light on one side of them: those of the first and the last line, between
// which it is, and one above and one below it.
template<class S>
class LightSides {
public:
    using mask = simd::mask_of<S>;

    GONIO_FORCE_INLINE explicit LightSides(const LightLines<S>& seen)
        : first_(seen.lines[0]), last_(seen.lines[light_line_count - 1]) {
        auto is_before = S(0) <= S(0);
        highest_ = S(-endless_slope);
        lowest_ = S(endless_slope);
        for (const LightLine<S>& line : seen.lines) {
            is_before = simd::both(is_before, line.cosine > S(0));
            const S per_cosine = S(1) / line.cosine;
            highest_ = simd::max(highest_, line.high * per_cosine);
            lowest_ = simd::min(lowest_, line.low * per_cosine);
        }
        // Over a light that is also behind the receiver there is none.
        highest_ = simd::select(is_before, highest_, S(endless_slope));
        lowest_ = simd::select(is_before, lowest_, S(-endless_slope));
        const S highest = highest_ + seen.frame.rise;
        const S lowest = lowest_ + seen.frame.rise;
        highest_length_ = simd::sqrt(S(1) + highest * highest);
        lowest_length_ = simd::sqrt(S(1) + lowest * lowest);
    }

    // Whether all of a body is on the other side of one of them. From its middle it extends as far as its half axes do
    // together, and by the radius.
    template<std::size_t half_axes>
    GONIO_FORCE_INLINE mask is_beside(const S* middle_and_axes, S radius) const {
        const auto extent = [&](const auto& of) {
            Extent all{of(framed_at(middle_and_axes)), S(0)};
            for (std::size_t i = 1; i <= half_axes; ++i)
                all.size = all.size + simd::abs(of(framed_at(middle_and_axes + 3 * i)));
            return all;
        };
        const Extent first = extent([&](const InLineFrame<S>& v) { return first_.height(v); });
        const Extent last = extent([&](const InLineFrame<S>& v) { return last_.height(v); });
        const Extent above = extent([&](const InLineFrame<S>& v) { return v.above - highest_ * v.forward; });
        const Extent below = extent([&](const InLineFrame<S>& v) { return lowest_ * v.forward - v.above; });
        const auto on_one_side = simd::both(first.middle > first.size + radius, last.middle > last.size + radius);
        const auto on_the_other = simd::both(-first.middle > first.size + radius, -last.middle > last.size + radius);
        const auto beyond = simd::either(above.middle > above.size + radius * highest_length_,
                                         below.middle > below.size + radius * lowest_length_);
        return simd::either(simd::either(on_one_side, on_the_other), beyond);
    }

private:
    struct Extent {
        S middle; // along the normal of a plane
        S size;   // to both sides
    };

    const LightLine<S>& first_;
    const LightLine<S>& last_;
    S highest_, lowest_;               // above, over forward
    S highest_length_, lowest_length_; // of the planes' normals
};

// Of a plane nothing else counts than on which side of it the receiver is.
template<class S>
class PlaneSection {
public:
    static constexpr std::size_t numbers = 0;
    static constexpr std::size_t half_axes = 0;

    // Whether the body may hide anything: the receiver does not touch it, and is not inside.
    template<class D>
    GONIO_FORCE_INLINE static simd::mask_of<D> put(const ShadowBody& plane, const vec3<D>& receiver,
                                                   const LightFrame<D>& /*frame*/, D* /*to*/) {
        const D height = unfused::dot(receiver - spread<D>(plane.middle), spread<D>(plane.z));
        return simd::abs(height) > touching_distance(receiver);
    }

    GONIO_FORCE_INLINE PlaneSection(const ShadowBody& /*plane*/, const S* /*from*/, S /*rise*/) {}
    GONIO_FORCE_INLINE HiddenSlopes<S> hidden(const LightLine<S>& line) const { return {line.low, line.high}; }
};

template<class S>
class PanelSection {
public:
    static constexpr std::size_t numbers = 9; // the middle first, then the half axes, as of all bodies
    static constexpr std::size_t half_axes = 2;

    template<class D>
    GONIO_FORCE_INLINE static simd::mask_of<D> put(const ShadowBody& panel, const vec3<D>& receiver,
                                                   const LightFrame<D>& frame, D* to) {
        const vec3<D> middle = spread<D>(panel.middle) - receiver;
        put_extent<half_axes>(panel, middle, frame, to);
        return simd::abs(unfused::dot(middle, spread<D>(panel.z))) > touching_distance(receiver);
    }

    GONIO_FORCE_INLINE PanelSection(const ShadowBody& /*panel*/, const S* from, S /*rise*/) {
        const InLineFrame<S> middle = framed_at(from);
        const InLineFrame<S> right = framed_at(from + 3);
        const InLineFrame<S> up = framed_at(from + 6);
        corners_[0] = middle - right - up;
        corners_[1] = middle + right - up;
        corners_[2] = middle + right + up;
        corners_[3] = middle - right + up;
    }
    GONIO_FORCE_INLINE HiddenSlopes<S> hidden(const LightLine<S>& line) const {
        CutPoint<S> at[4];
        for (int i = 0; i < 4; ++i)
            at[i] = CutPoint<S>(line, corners_[i]);
        const S lowest = simd::min(simd::min(at[0].height, at[1].height), simd::min(at[2].height, at[3].height));
        const S highest = simd::max(simd::max(at[0].height, at[1].height), simd::max(at[2].height, at[3].height));
        const auto is_cut = simd::both(lowest < S(0), highest >= S(0));
        if (!simd::any(is_cut)) return {};
        // One edge rises through the plane and one falls.
        PlaneDirection<S> rising{S(0), S(0)};
        PlaneDirection<S> falling{S(0), S(0)};
        for (int i = 0; i < 4; ++i) {
            const CutPoint<S>& a = at[i];
            const CutPoint<S>& b = at[(i + 1) % 4];
            const auto rises = simd::both(a.is_below(), !b.is_below());
            const auto falls = simd::both(b.is_below(), !a.is_below());
            if (!simd::any(simd::either(rises, falls))) continue;
            const PlaneDirection<S> cut = a.rising_to(b);
            rising = PlaneDirection<S>::select(rises, cut, rising);
            falling = PlaneDirection<S>::select(falls, {-cut.x, -cut.y}, falling);
        }
        const auto is_falling_higher = rising.to(falling) > S(0);
        return CoveredAngle<S>(is_cut, PlaneDirection<S>::select(is_falling_higher, rising, falling),
                               PlaneDirection<S>::select(is_falling_higher, falling, rising))
            .hidden(line);
    }

private:
    InLineFrame<S> corners_[4]; // in their order
};

template<class S>
class BoxSection {
public:
    static constexpr std::size_t numbers = 12;
    static constexpr std::size_t half_axes = 3;

    template<class D>
    GONIO_FORCE_INLINE static simd::mask_of<D> put(const ShadowBody& box, const vec3<D>& receiver,
                                                   const LightFrame<D>& frame, D* to) {
        const vec3<D> middle = spread<D>(box.middle) - receiver;
        put_extent<half_axes>(box, middle, frame, to);
        return is_outside_box(box, in_frame(box, middle));
    }

    GONIO_FORCE_INLINE BoxSection(const ShadowBody& /*box*/, const S* from, S /*rise*/)
        : middle_(framed_at(from)), x_(framed_at(from + 3)), y_(framed_at(from + 6)), z_(framed_at(from + 9)) {}

    HiddenSlopes<S> hidden(const LightLine<S>& line) const {
        // Of the corners, the plane is nearest to and farthest from the middle by this much.
        const S middle = line.height(middle_);
        const S reach = simd::abs(line.height(x_)) + simd::abs(line.height(y_)) + simd::abs(line.height(z_));
        if (!simd::any(simd::abs(middle) <= reach)) return {};
        CutPoint<S> corners[8];
        for (unsigned i = 0; i < 8; ++i) {
            const InLineFrame<S> level = (i & 1U) != 0 ? middle_ + x_ : middle_ - x_;
            const InLineFrame<S> side = (i & 2U) != 0 ? level + y_ : level - y_;
            corners[i] = CutPoint<S>(line, (i & 4U) != 0 ? side + z_ : side - z_);
        }
        CoveredAngle<S> covered;
        for (unsigned i = 0; i < 8; ++i)
            for (unsigned bit = 1; bit < 8; bit *= 2)
                if ((i & bit) == 0) {
                    const EdgeCut<S> edge(corners[i], corners[i | bit]);
                    if (simd::any(edge.is_cut)) covered.take(edge.is_cut, edge.direction);
                }
        return covered.hidden(line);
    }

private:
    InLineFrame<S> middle_, x_, y_, z_; // the half axes
};

// A circle of a ball in a plane. A ray that touches the ball has the same length to it in all planes.
template<class S>
class BallSection {
public:
    static constexpr std::size_t numbers = 4;
    static constexpr std::size_t half_axes = 0;

    template<class D>
    GONIO_FORCE_INLINE static simd::mask_of<D> put(const ShadowBody& ball, const vec3<D>& receiver,
                                                   const LightFrame<D>& frame, D* to) {
        const vec3<D> center = spread<D>(ball.middle) - receiver;
        put_extent<half_axes>(ball, center, frame, to);
        const D power = unfused::dot(center, center) - spread<D>(ball.radius) * spread<D>(ball.radius);
        to[3] = simd::sqrt(simd::max(power, D(0)));
        return power > D(0);
    }

    BallSection() = default;
    GONIO_FORCE_INLINE BallSection(const ShadowBody& ball, const S* from, S rise)
        : BallSection(framed_at(from), from[3], spread<S>(ball.radius), rise) {}
    GONIO_FORCE_INLINE BallSection(const InLineFrame<S>& center, S tangent, S radius, S rise)
        : center_(center), tangent_(tangent), radius_(radius), rise_(rise) {}

    GONIO_FORCE_INLINE HiddenSlopes<S> hidden(const LightLine<S>& line) const {
        PlaneDirection<S> low, high;
        const auto is_cut = cut(line, low, high);
        if (!simd::any(is_cut)) return {};
        return CoveredAngle<S>(is_cut, low, high).hidden(line);
    }
    GONIO_FORCE_INLINE void take(CoveredAngle<S>& covered, const LightLine<S>& line) const {
        PlaneDirection<S> low, high;
        const auto is_cut = cut(line, low, high);
        if (!simd::any(is_cut)) return;
        covered.take(is_cut, low);
        covered.take(is_cut, high);
    }

private:
    // Where the line's plane cuts the ball, and the tangents to the circle: its middle turned by the angle whose sine
    // is the circle's radius over the distance. They are set if any plane cuts it.
    GONIO_FORCE_INLINE simd::mask_of<S> cut(const LightLine<S>& line, PlaneDirection<S>& low,
                                            PlaneDirection<S>& high) const {
        const S height = line.height(center_);
        const auto is_cut = simd::abs(height) <= radius_;
        if (!simd::any(is_cut)) return is_cut;
        const S circle = simd::sqrt(simd::max((radius_ - height) * (radius_ + height), S(0)));
        const S x = line.x(center_);
        const S above = center_.above - rise_ * line.sine * height; // of the middle, put onto the plane
        const S y = above + line.slope * x;
        const S along = x * tangent_;
        const S up = above * tangent_;
        const S bend = circle * (x + line.slope * y);
        low = {along + y * circle, up - bend};
        high = {along - y * circle, up + bend};
        return is_cut;
    }

    InLineFrame<S> center_;
    S tangent_; // length of a ray to where it touches the ball
    S radius_;
    S rise_;
};

// Its outline is that of the balls at its ends, and two straight lines where rays touch its side.
template<class S>
class CapsuleSection {
public:
    static constexpr std::size_t numbers = 8;
    static constexpr std::size_t half_axes = 1;

    template<class D>
    GONIO_FORCE_INLINE static simd::mask_of<D> put(const ShadowBody& capsule, const vec3<D>& receiver,
                                                   const LightFrame<D>& frame, D* to) {
        const vec3<D> center = spread<D>(capsule.middle) - receiver;
        const vec3<D> axis = spread<D>(capsule.x);
        const D half = spread<D>(capsule.half_size[0]);
        const D along = unfused::dot(center, axis);
        const vec3<D> across = center - axis * along;
        const D power = unfused::dot(across, across) - spread<D>(capsule.radius * capsule.radius);
        put_extent<half_axes>(capsule, center, frame, to);
        to[6] = along;
        to[7] = power;                                             // of the receiver, to the endless cylinder
        const D beyond = simd::max(simd::abs(along) - half, D(0)); // of its nearest end
        return power + beyond * beyond > D(0);
    }

    GONIO_FORCE_INLINE CapsuleSection(const ShadowBody& capsule, const S* from, S rise) {
        const InLineFrame<S> middle = framed_at(from);
        const InLineFrame<S> half_axis = framed_at(from + 3);
        const S half = spread<S>(capsule.half_size[0]);
        const S radius = spread<S>(capsule.radius);
        const S along = from[6];
        const S power = from[7];
        const S radius2 = radius * radius;
        has_side_ = power > S(0);
        for (int i = 0; i < 2; ++i) {
            const S to_end = i == 0 ? along - half : along + half;
            const S tangent = simd::sqrt(simd::max(power + to_end * to_end, S(0)));
            ends_[i] = BallSection<S>(i == 0 ? middle - half_axis : middle + half_axis, tangent, radius, rise);
        }
        // A ray across the axis, from its middle on: r²/d² of it short of the axis, and turned to the sides.
        const InLineFrame<S> axis = half_axis * spread<S>(1.0 / capsule.half_size[0]);
        const InLineFrame<S> towards = middle - axis * along;
        const S per_distance2 = S(1) / simd::select(has_side_, power + radius2, S(1));
        const S aside = radius * simd::sqrt(simd::max(power, S(0))) * per_distance2;
        const InLineFrame<S> touched = middle - towards * (radius2 * per_distance2);
        const InLineFrame<S> sideways = across(axis, towards, rise) * aside;
        for (int i = 0; i < 2; ++i) {
            const InLineFrame<S> at = i == 0 ? touched - sideways : touched + sideways;
            edges_[i][0] = at - half_axis;
            edges_[i][1] = at + half_axis;
        }
    }

    HiddenSlopes<S> hidden(const LightLine<S>& line) const {
        const EdgeCut<S> first(CutPoint<S>(line, edges_[0][0]), CutPoint<S>(line, edges_[0][1]));
        const EdgeCut<S> second(CutPoint<S>(line, edges_[1][0]), CutPoint<S>(line, edges_[1][1]));
        CoveredAngle<S> covered(simd::both(has_side_, first.is_cut), first.direction, first.direction);
        covered.take(simd::both(has_side_, second.is_cut), second.direction);
        for (const BallSection<S>& end : ends_)
            end.take(covered, line);
        return covered.hidden(line);
    }

private:
    // The product of two vectors across both.
    GONIO_FORCE_INLINE static InLineFrame<S> across(const InLineFrame<S>& a, const InLineFrame<S>& b, S rise) {
        const S a_up = a.above + rise * a.forward;
        const S b_up = b.above + rise * b.forward;
        const S forward = a.side * b_up - a_up * b.side;
        return {forward, a_up * b.forward - a.forward * b_up, a.forward * b.side - a.side * b.forward - rise * forward};
    }

    simd::mask_of<S> has_side_; // the receiver is outside of the endless cylinder
    BallSection<S> ends_[2];
    InLineFrame<S> edges_[2][2];
};

// Calls work(Section) with the type of the body's section, a pointer that is null.
template<class S, class Work>
GONIO_FORCE_INLINE auto with_section(const ShadowBody& body, const Work& work) {
    switch (body.kind) {
    case ShadowBody::Kind::plane:
        return work(static_cast<const PlaneSection<S>*>(nullptr));
    case ShadowBody::Kind::panel:
        return work(static_cast<const PanelSection<S>*>(nullptr));
    case ShadowBody::Kind::ball:
        return work(static_cast<const BallSection<S>*>(nullptr));
    case ShadowBody::Kind::box:
        return work(static_cast<const BoxSection<S>*>(nullptr));
    case ShadowBody::Kind::capsule:
        break;
    }
    return work(static_cast<const CapsuleSection<S>*>(nullptr));
}

// Whether the receiver is on the body's side of the plane between it and the light.
template<class D>
GONIO_FORCE_INLINE simd::mask_of<D> is_before_light(const ShadowBody& body, const vec3<D>& receiver) {
    return unfused::dot(receiver - spread<D>(body.between), spread<D>(body.to_light)) < D(0);
}

} // namespace gonio::detail
