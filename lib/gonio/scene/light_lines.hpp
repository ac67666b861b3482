// An area light as parallel lines over its visible part, as seen from a receiver. Where rays would sample the light's
// area, a line takes a whole stripe at once, since a convex object hides one piece of it (shadow_line.hpp).
//
// The lines lie in planes that turn about one axis through the receiver, and each ends where its plane leaves the
// light's outline. In terms of the sine s of the elevation towards that axis and the turn β, solid angle is ds dβ: the
// integral is exact along a piece of a line, and uses the midpoint of the stripe across it.
//
// A plane has the coordinates x, across the axis, and y, along it. Here y is measured from the light's middle, that is,
// from k x, where k is the slope at which the middle is seen. So the slopes y/x of a narrow light are small, and keep
// their digits where they are rounded to floats.
//
// S is double or simd::doubles for the frame of the lines, and float, double or a pack for the lines themselves.
#pragma once

#include <gonio/scene/shadow_line.hpp>
#include <gonio/scene/shadow_numbers.hpp>
#include <gonio/scene/unfused.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/doubles_math.hpp>

#include <cstddef>
#include <initializer_list>

namespace gonio::detail {

inline constexpr std::size_t light_line_count = 8;

// A point or a vector in the frame of the lines of one receiver.
template<class S>
struct InLineFrame {
    S forward; // across the axis, towards the middle of the light
    S side;    // across both
    S above;   // along the axis, from where the middle of the light is seen
};

// The axis about which the planes turn, and how the light lies to it.
template<class S>
struct LightFrame {
    vec3<S> axis; // unit, as are these two across it
    vec3<S> forward;
    vec3<S> side;
    S rise;                   // tangent of the elevation at which the middle of the light is seen
    S along;                  // of that middle: along the axis [m]
    S across;                 // and forward
    S before;                 // the receiver's distance from the plane of a flat light
    S half_length;            // of a long light, as it is seen
    simd::mask_of<S> is_seen; // false where the light is not visible, or where the receiver is inside

    static constexpr std::size_t numbers = 14;

    GONIO_FORCE_INLINE InLineFrame<S> in_frame(const vec3<S>& v) const {
        const S along_forward = unfused::dot(forward, v);
        return {along_forward, unfused::dot(side, v), unfused::dot(axis, v) - rise * along_forward};
    }
    // As numbers, and from them; `is_seen` is a mask and not among them.
    GONIO_FORCE_INLINE void put(S* to) const {
        for (const vec3<S>& v : {axis, forward, side}) {
            *to++ = v.x;
            *to++ = v.y;
            *to++ = v.z;
        }
        for (const S number : {rise, along, across, before, half_length})
            *to++ = number;
    }
    GONIO_FORCE_INLINE static LightFrame of(const S* n, simd::mask_of<S> is_seen) {
        return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}, n[9], n[10], n[11], n[12], n[13], is_seen};
    }
};

// A line and its plane. Slopes are those of rays from the receiver.
template<class S>
struct LightLine {
    S cosine; // of the turn of its plane, from forward towards the side
    S sine;
    S slope;         // k
    S low, high;     // slopes of its ends, which are on the light, or where rays are tangent to it
    S low_x, high_x; // of the ends [m]
    S low_sine;      // of the elevation of the lower end
    S width;         // from there to the sine of the upper end
    S turn;          // dβ of its stripe [rad]

    GONIO_FORCE_INLINE S solid_angle() const { return turn * width; }
    // Of a point, from the plane.
    GONIO_FORCE_INLINE S height(const InLineFrame<S>& v) const { return v.side * cosine - v.forward * sine; }
    GONIO_FORCE_INLINE S x(const InLineFrame<S>& v) const { return v.forward * cosine + v.side * sine; }

    // The sine of the elevation of a slope, above that of the lower end. With a and b for the tangents of both, and
    // A = √(1 + a²): a/A − b/B = (a − b)(1 + AB − ab)/((A + B) AB), which keeps the digits of a − b, and
    // AB − ab = (1 + a² + b²)/(AB + ab) where both are on one side.
    GONIO_FORCE_INLINE S sine_above_low(S of_slope) const {
        const S a = of_slope + slope;
        const S b = low + slope;
        const S square = S(1) + a * a;
        const S root_a = simd::sqrt(square);
        const S root_b = simd::sqrt(S(1) + b * b);
        const S roots = root_a * root_b;
        const S product = a * b;
        const S sum = roots + simd::abs(product);
        const S over = sum + simd::select(product > S(0), square + b * b, sum * sum);
        return (of_slope - low) * over / (sum * (root_a + root_b) * roots);
    }
    // From all else. Ends in line with the axis are seen at an endless slope; what is between those and the bounds is
    // not there in a float's digits of the sine.
    GONIO_FORCE_INLINE void set_sines() {
        constexpr float steepest = 1e7F;
        low = simd::max(simd::min(low, S(steepest)), S(-steepest));
        high = simd::max(simd::min(high, S(steepest)), S(-steepest));
        const S b = low + slope;
        low_sine = b / simd::sqrt(S(1) + b * b);
        width = sine_above_low(high);
    }
};

template<class S>
struct LightLines {
    LightFrame<S> frame;
    LightLine<S> lines[light_line_count];

    // Of a point of the line's plane.
    GONIO_FORCE_INLINE vec3<S> position(const LightLine<S>& line, S x, S of_slope) const {
        return (across(line) + frame.axis * (of_slope + line.slope)) * x;
    }
    GONIO_FORCE_INLINE vec3<S> direction(const LightLine<S>& line, S sine) const {
        return frame.axis * sine + across(line) * simd::sqrt(simd::max((S(1) - sine) * (S(1) + sine), S(0)));
    }

private:
    GONIO_FORCE_INLINE vec3<S> across(const LightLine<S>& line) const {
        return frame.forward * line.cosine + frame.side * line.sine;
    }
};

// The axis is as close to the direction `hint` (of any length) as the shape allows, for a tube along the tube.
template<class S>
class LightFrameOf {
public:
    GONIO_FORCE_INLINE LightFrameOf(const LinedLight& light, const vec3<S>& receiver, const vec3<S>& hint)
        : light_(light), center_(spread<S>(light.center) - receiver), hint_(hint) {}

    // Lights without a surface at a finite distance are not seen.
    LightFrame<S> operator()() const {
        switch (light_.kind) {
        case LinedLight::Kind::none:
            return about(center_, across(center_), S(0), S(1) < S(0));
        case LinedLight::Kind::ball: {
            const S distance = unfused::length(center_);
            return about(center_, across(center_ * shading::reciprocal_or_zero(distance)), S(0),
                         distance > spread<S>(light_.radius));
        }
        case LinedLight::Kind::tube:
            return tube();
        case LinedLight::Kind::disk:
        case LinedLight::Kind::ellipse:
        case LinedLight::Kind::rectangle: {
            // They emit along −Z.
            const vec3<S> z = spread<S>(light_.z);
            const S before = unfused::dot(center_, z);
            const auto is_seen = light_.is_two_sided ? simd::abs(before) > S(0) : before > S(0);
            LightFrame<S> frame = about(center_, across(z), S(0), is_seen);
            frame.before = simd::abs(before);
            return frame;
        }
        case LinedLight::Kind::cylinder:
            break;
        }
        const vec3<S> a = spread<S>(light_.x);
        return about(center_, a, spread<S>(light_.half_size[0]),
                     unfused::length(center_ - a * unfused::dot(center_, a)) > spread<S>(light_.radius));
    }

private:
    using mask = simd::mask_of<S>;

    // Any unit vector perpendicular to a unit vector.
    static vec3<S> any_across(const vec3<S>& z) {
        const auto is_level = simd::abs(z.x) < S(0.6);
        const vec3<S> seed{simd::select(is_level, S(1), S(0)), simd::select(is_level, S(0), S(1)), S(0)};
        return shading::normalized(seed - z * unfused::dot(z, seed));
    }

    // The component of the hint perpendicular to a unit vector.
    vec3<S> across(const vec3<S>& z) const {
        const vec3<S> part = hint_ - z * unfused::dot(hint_, z);
        const S length2 = unfused::dot(part, part);
        const auto is_enough = length2 > S(1e-12F) * unfused::dot(hint_, hint_);
        const S root = simd::sqrt(simd::select(is_enough, length2, S(1)));
        const vec3<S> along = part * (S(1) / root);
        return simd::all(is_enough) ? along : shading::select<S>(is_enough, along, any_across(z));
    }

    static LightFrame<S> about(const vec3<S>& middle, const vec3<S>& axis, S half_length, mask is_seen) {
        LightFrame<S> frame;
        frame.is_seen = is_seen;
        frame.axis = axis;
        frame.along = unfused::dot(middle, axis);
        const vec3<S> away = middle - axis * frame.along;
        frame.across = unfused::length(away);
        const S per_across = S(1) / frame.across;
        frame.forward = away * per_across;
        frame.side = unfused::cross(axis, frame.forward);
        frame.rise = frame.along * per_across;
        frame.before = S(0);
        frame.half_length = half_length;
        return frame;
    }

    // Within the prolonged tube only the nearer end is visible, or the receiver is inside.
    LightFrame<S> tube() const {
        const vec3<S> a = spread<S>(light_.x);
        const S radius = spread<S>(light_.radius);
        const S half = spread<S>(light_.half_size[0]);
        const S along = unfused::dot(center_, a);
        const auto is_beside = unfused::length(center_ - a * along) > radius;
        if (simd::all(is_beside)) return about(center_, a, half, is_beside);
        const vec3<S> end = center_ - a * simd::copysign(half, along);
        const S distance = unfused::length(end);
        const auto is_seen = simd::either(is_beside, simd::both(simd::abs(along) > half, distance > radius));
        return about(shading::select<S>(is_beside, center_, end),
                     shading::select<S>(is_beside, a, across(end * shading::reciprocal_or_zero(distance))),
                     simd::select(is_beside, half, S(0)), is_seen);
    }

    const LinedLight& light_;
    vec3<S> center_; // relative to the receiver
    vec3<S> hint_;
};

template<class S>
GONIO_FORCE_INLINE LightFrame<S> light_frame(const LinedLight& light, const vec3<S>& receiver, const vec3<S>& hint) {
    return LightFrameOf<S>(light, receiver, hint)();
}

// The lines, each in the middle of its stripe.
template<class S>
class LightLinesOf {
public:
    GONIO_FORCE_INLINE LightLinesOf(const LinedLight& light, LightLines<S>& seen)
        : light_(light), frame_(seen.frame), lines_(seen.lines) {}

    void operator()() {
        switch (light_.kind) {
        case LinedLight::Kind::none:
            for (LightLine<S>& line : lines_)
                line = {S(1), S(0), S(0), S(0), S(0), S(1), S(1), S(0), S(0), S(0)};
            return;
        case LinedLight::Kind::ball:
            return capsule<1>();
        case LinedLight::Kind::tube:
            return capsule<2>();
        case LinedLight::Kind::disk:
            return disk();
        case LinedLight::Kind::ellipse:
            return ellipse();
        case LinedLight::Kind::rectangle:
            return rectangle();
        case LinedLight::Kind::cylinder:
            return cylinder();
        }
    }

private:
    static constexpr double step = 3.14159265358979323846 / static_cast<double>(light_line_count);

    // Cosine and sine of θ = π (i + 1/2) / 8, at which lines of round lights are.
    static constexpr double cosines[light_line_count] = {
        0.98078528040323044913,  0.83146961230254523708,  0.55557023301960222474,  0.19509032201612826785,
        -0.19509032201612826785, -0.55557023301960222474, -0.83146961230254523708, -0.98078528040323044913};
    GONIO_FORCE_INLINE static S cosine_at(std::size_t i) { return spread<S>(cosines[i]); }
    GONIO_FORCE_INLINE static S sine_at(std::size_t i) {
        return spread<S>(cosines[i < light_line_count / 2 ? light_line_count / 2 - 1 - i : i - light_line_count / 2]);
    }

    // Chords of the disk, placed by the angle at which they end on the rim, where a chord's length and its stripe's
    // width fall to 0 together.
    void disk() {
        const InLineFrame<S> other = frame_.in_frame(unfused::cross(spread<S>(light_.z), frame_.axis));
        const S radius = spread<S>(light_.radius);
        for (std::size_t i = 0; i < light_line_count; ++i) {
            const S half = radius * sine_at(i);
            set_flat(lines_[i], other, radius * cosine_at(i), -half, half, half * spread<S>(step));
        }
    }

    // The same chords of the circle that stretches to the ellipse: along the direction e they are 2 sin θ/k long,
    // k = |(e_x/a, e_y/b)|, and their middles lie on the conjugate diameter.
    void ellipse() {
        const S a = spread<S>(light_.half_size[0]);
        const S b = spread<S>(light_.half_size[1]);
        const vec3<S> x = spread<S>(light_.x);
        const vec3<S> y = spread<S>(light_.y);
        const S e_x = unfused::dot(frame_.axis, x) / a;
        const S e_y = unfused::dot(frame_.axis, y) / b;
        const S k = simd::sqrt(e_x * e_x + e_y * e_y);
        const InLineFrame<S> conjugate = frame_.in_frame(y * (b * e_x / k) - x * (a * e_y / k));
        for (std::size_t i = 0; i < light_line_count; ++i) {
            const S half = sine_at(i) / k;
            set_flat(lines_[i], conjugate, cosine_at(i), -half, half, a * b * k * sine_at(i) * spread<S>(step));
        }
    }

    // Uniform in the turn.
    void rectangle() {
        const vec3<S> x = spread<S>(light_.x);
        const vec3<S> y = spread<S>(light_.y);
        const vec3<S> other = unfused::cross(spread<S>(light_.z), frame_.axis);
        const InLineFrame<S> other_in_frame = frame_.in_frame(other);
        const S other_x = unfused::dot(other, x);
        const S other_y = unfused::dot(other, y);
        const S half_x = spread<S>(light_.half_size[0]);
        const S half_y = spread<S>(light_.half_size[1]);
        const S axis_x = unfused::dot(frame_.axis, x);
        const S axis_y = unfused::dot(frame_.axis, y);
        const S half_width = half_x * simd::abs(axis_y) + half_y * simd::abs(axis_x);
        const S height = frame_.before;
        const S middle = frame_.across * other_in_frame.forward;
        const S side = middle - half_width;
        // The angle between the sides, as cosine and sine without cancellation, halved down to half a step.
        Turn angle{height * height + side * (middle + half_width), S(2) * half_width * height};
        const S size = simd::sqrt(angle.cosine * angle.cosine + angle.sine * angle.sine);
        angle = {angle.cosine / size, angle.sine / size};
        const Turn whole_step = angle.halved().halved().halved();
        const Turn half_step = whole_step.halved();
        const S turn = S(2) * simd::arc_sine(half_step.sine);
        // The direction to that side, turned step by step.
        Turn towards = Turn{height, side} * half_step;
        for (LightLine<S>& line : lines_) {
            const S off =
                simd::max(simd::min(height * (towards.sine / towards.cosine) - middle, half_width), -half_width);
            towards = towards * whole_step;
            S low(-1e30F);
            S high(1e30F);
            const auto clip = [&](S along, S at, S half) {
                const auto cuts = simd::abs(along) >= S(1e-6F); // else by rounding
                const S per_along = S(1) / simd::select(cuts, along, S(1));
                const S end = simd::copysign(half, along);
                low = simd::select(cuts, simd::max(low, (-end - at) * per_along), low);
                high = simd::select(cuts, simd::min(high, (end - at) * per_along), high);
            };
            clip(axis_x, off * other_x, half_x);
            clip(axis_y, off * other_y, half_y);
            set_flat(line, other_in_frame, off, low, simd::max(low, high), S(1));
            line.turn = turn;
        }
    }

    // In each plane through the receiver and along the axis the near side is one line.
    void cylinder() {
        const S s = spread<S>(light_.radius) / frame_.across;
        for (std::size_t i = 0; i < light_line_count; ++i) {
            LightLine<S>& line = lines_[i];
            set_stripe(line, i, s);
            const S per_away = S(1) / (line.cosine + s * sine_at(i));
            const S away = frame_.across * (S(1) - s) * (S(1) + s) * per_away;
            // along − k away, without the difference.
            const S middle = frame_.along * s * (sine_at(i) + s * line.cosine) * per_away;
            set_upright(line, away, S(1) / away, middle - frame_.half_length, middle + frame_.half_length);
        }
    }

    // A plane through the receiver and along the axis cuts the capsule in two circles and the part between them; one
    // circle if it has one end.
    template<int ends>
    void capsule() {
        const S s = spread<S>(light_.radius) / frame_.across;
        for (std::size_t i = 0; i < light_line_count; ++i) {
            LightLine<S>& line = lines_[i];
            set_stripe(line, i, s);
            // More than the circles' radius, as the receiver is outside.
            const S away = frame_.across * line.cosine;
            const S circle = spread<S>(light_.radius) * sine_at(i);
            for (int end = 0; end < ends; ++end) {
                const S off = end == 0 ? -frame_.half_length : frame_.half_length;
                const S up = frame_.along + off;
                const S distance2 = up * up + away * away;
                const S distance = simd::sqrt(distance2);
                const S tangent = simd::sqrt(simd::max((distance - circle) * (distance + circle), S(0)));
                // The middle's direction turned by the half angle of the circle; y from k x, without the difference.
                const S share = tangent / distance2;
                const S above = (off + frame_.along * line.sine * line.sine) * tangent;
                const S bend = circle * (away + line.slope * up);
                const S low_x = away * tangent + up * circle;
                const S high_x = away * tangent - up * circle;
                const S low = (above - bend) / low_x;
                const S high = (above + bend) / high_x;
                if (end == 0) {
                    line.low = low;
                    line.low_x = low_x * share;
                    line.high = high;
                    line.high_x = high_x * share;
                    continue;
                }
                const auto is_lower = low < line.low;
                line.low = simd::select(is_lower, low, line.low);
                line.low_x = simd::select(is_lower, low_x * share, line.low_x);
                const auto is_higher = high > line.high;
                line.high = simd::select(is_higher, high, line.high);
                line.high_x = simd::select(is_higher, high_x * share, line.high_x);
            }
            line.set_sines();
        }
    }

    // Planes that are uniform in θ, at the sine s cos θ of the turn.
    GONIO_FORCE_INLINE void set_stripe(LightLine<S>& line, std::size_t i, S s) const {
        line.sine = s * cosine_at(i);
        line.cosine = simd::sqrt(simd::max((S(1) - line.sine) * (S(1) + line.sine), S(0)));
        line.slope = frame_.rise * line.cosine;
        line.turn = s * sine_at(i) / line.cosine * spread<S>(step);
    }
    // A line along the axis.
    GONIO_FORCE_INLINE static void set_upright(LightLine<S>& line, S x, S per_x, S low, S high) {
        line.low = low * per_x;
        line.high = high * per_x;
        line.low_x = x;
        line.high_x = x;
        line.set_sines();
    }
    // A line through center + v off, from `low` to `high` along the axis.
    GONIO_FORCE_INLINE void set_flat(LightLine<S>& line, const InLineFrame<S>& v, S off, S low, S high, S width) const {
        const S forward = frame_.across + v.forward * off;
        const S side = v.side * off;
        const S distance2 = forward * forward + side * side;
        const S distance = simd::sqrt(distance2);
        const S per_distance = S(1) / distance;
        line.cosine = forward * per_distance;
        line.sine = side * per_distance;
        line.slope = frame_.rise * line.cosine;
        line.turn = width * frame_.before * per_distance * per_distance;
        const S above = v.above * off;
        set_upright(line, distance, per_distance, above + low, above + high);
    }

    // The cosine and sine of an angle, or a vector at that angle.
    struct Turn {
        S cosine, sine;

        // By another angle.
        GONIO_FORCE_INLINE friend Turn operator*(const Turn& v, const Turn& by) {
            return {v.cosine * by.cosine - v.sine * by.sine, v.cosine * by.sine + v.sine * by.cosine};
        }
        // Of an angle in [0, π].
        GONIO_FORCE_INLINE Turn halved() const {
            const S root_of_sum = simd::sqrt(S(0.5) * (S(1) + simd::abs(cosine)));
            const S other = S(0.5) * sine / root_of_sum;
            const auto is_acute = cosine >= S(0);
            return {simd::select(is_acute, root_of_sum, other), simd::select(is_acute, other, root_of_sum)};
        }
    };

    const LinedLight& light_;
    const LightFrame<S>& frame_;
    LightLine<S> (&lines_)[light_line_count];
};

// For the frame of `seen`.
template<class S>
GONIO_FORCE_INLINE void find_light_lines(const LinedLight& light, LightLines<S>& seen) {
    LightLinesOf<S>(light, seen)();
}

} // namespace gonio::detail
