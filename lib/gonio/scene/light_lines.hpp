// An area light as parallel lines over its visible part, as seen from a receiver. Where rays would sample the light's
// area, a line takes a whole stripe at once, since a convex object hides one piece of it (shadow_line.hpp).
//
// The lines lie in planes that turn about one axis through the receiver, and each ends where its plane leaves the
// light's outline. In terms of the sine s of the elevation towards that axis and the turn β, solid angle is ds dβ: the
// integral is exact along a piece of a line, and uses the midpoint of the stripe across it.
//
// S is double or simd::doubles: a receiver in each lane.
#pragma once

#include <gonio/scene/shadow_line.hpp>
#include <gonio/scene/shadow_numbers.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/doubles_math.hpp>

#include <cstddef>

namespace gonio::detail {

inline constexpr std::size_t light_line_count = 8;

template<class S>
struct LightLine {
    vec3<S> from; // the ends, relative to the receiver [m]: on the light, or where rays are tangent to it
    vec3<S> to;
    vec3<S> across; // unit: in the line's plane, perpendicular to the axis
    S low;          // sines of the elevation, of `from` and of `to`
    S high;
    S turn; // dβ of its stripe [rad]

    GONIO_FORCE_INLINE S solid_angle() const { return turn * (high - low); }
};

template<class S>
struct LightLines {
    vec3<S> axis; // unit
    LightLine<S> lines[light_line_count];
    simd::mask_of<S> is_seen = S(1) < S(0); // false where the light is not visible, or where the receiver is inside

    GONIO_FORCE_INLINE S sine_of(const vec3<S>& point) const { return dot(axis, point) / length(point); }
    GONIO_FORCE_INLINE vec3<S> direction(const LightLine<S>& line, S sine) const {
        return axis * sine + line.across * simd::sqrt((S(1) - sine) * (S(1) + sine));
    }
};

// The lines run as close to the direction `along` (of any length) as the shape allows, for a tube along the tube, each
// in the middle of its stripe. Lights without a surface at a finite distance have none.
template<class S>
class LightLinesOf {
public:
    GONIO_FORCE_INLINE LightLinesOf(const LinedLight& light, const vec3<S>& receiver, const vec3<S>& along)
        : light_(light), center_(spread<S>(light.center) - receiver), hint_(along) {}

    LightLines<S> operator()() const {
        switch (light_.kind) {
        case LinedLight::Kind::none:
            return {};
        case LinedLight::Kind::ball: {
            const S distance = length(center_);
            return capsule<1>(center_, across(center_ * shading::reciprocal_or_zero(distance)), S(0),
                              distance > S(light_.radius));
        }
        case LinedLight::Kind::tube:
            return tube();
        case LinedLight::Kind::disk:
            return disk();
        case LinedLight::Kind::ellipse:
            return ellipse();
        case LinedLight::Kind::rectangle:
            return rectangle();
        case LinedLight::Kind::cylinder:
            break;
        }
        return cylinder();
    }

private:
    using mask = simd::mask_of<S>;

    static constexpr double step = 3.14159265358979323846 / static_cast<double>(light_line_count);

    // Cosine and sine of θ = π (i + 1/2) / 8, at which lines of round lights are.
    static constexpr double cosines[light_line_count] = {
        0.98078528040323044913,  0.83146961230254523708,  0.55557023301960222474,  0.19509032201612826785,
        -0.19509032201612826785, -0.55557023301960222474, -0.83146961230254523708, -0.98078528040323044913};
    GONIO_FORCE_INLINE static S cosine_at(std::size_t i) { return S(cosines[i]); }
    GONIO_FORCE_INLINE static S sine_at(std::size_t i) {
        return S(cosines[i < light_line_count / 2 ? light_line_count / 2 - 1 - i : i - light_line_count / 2]);
    }

    // Any unit vector perpendicular to a unit vector.
    static vec3<S> any_across(const vec3<S>& z) {
        const auto is_level = simd::abs(z.x) < S(0.6);
        const vec3<S> seed{simd::select(is_level, S(1), S(0)), simd::select(is_level, S(0), S(1)), S(0)};
        return shading::normalized(seed - z * dot(z, seed));
    }

    // The component of the hint perpendicular to a unit vector.
    vec3<S> across(const vec3<S>& z) const {
        const vec3<S> part = hint_ - z * dot(hint_, z);
        const S length2 = dot(part, part);
        const auto is_enough = length2 > S(1e-12) * dot(hint_, hint_);
        const S root = simd::sqrt(simd::select(is_enough, length2, S(1)));
        const vec3<S> along = part * (S(1) / root);
        return simd::all(is_enough) ? along : shading::select<S>(is_enough, along, any_across(z));
    }

    // Within the prolonged tube only the nearer end is visible, or the receiver is inside.
    LightLines<S> tube() const {
        const vec3<S> a = spread<S>(light_.x);
        const S radius(light_.radius);
        const S half(light_.half_size[0]);
        const S along = dot(center_, a);
        const auto is_beside = length(center_ - a * along) > radius;
        if (simd::all(is_beside)) return capsule<2>(center_, a, half, is_beside);
        const vec3<S> end = center_ - a * simd::copysign(half, along);
        const S distance = length(end);
        const auto is_seen = simd::either(is_beside, simd::both(simd::abs(along) > half, distance > radius));
        return capsule<2>(shading::select<S>(is_beside, center_, end),
                          shading::select<S>(is_beside, a, across(end * shading::reciprocal_or_zero(distance))),
                          simd::select(is_beside, half, S(0)), is_seen);
    }

    // Chords of the disk, placed by the angle at which they end on the rim, where a chord's length and its stripe's
    // width fall to 0 together.
    LightLines<S> disk() const {
        LightLines<S> seen = flat();
        const vec3<S> other = cross(spread<S>(light_.z), seen.axis);
        const S radius(light_.radius);
        for (std::size_t i = 0; i < light_line_count; ++i) {
            const S half = radius * sine_at(i);
            set_flat(seen, i, other * (radius * cosine_at(i)), -half, half, half * S(step));
        }
        return seen;
    }

    // The same chords of the circle that stretches to the ellipse: along the direction e they are 2 sin θ/k long,
    // k = |(e_x/a, e_y/b)|, and their middles lie on the conjugate diameter.
    LightLines<S> ellipse() const {
        LightLines<S> seen = flat();
        const S a(light_.half_size[0]);
        const S b(light_.half_size[1]);
        const vec3<S> x = spread<S>(light_.x);
        const vec3<S> y = spread<S>(light_.y);
        const S e_x = dot(seen.axis, x) / a;
        const S e_y = dot(seen.axis, y) / b;
        const S k = simd::sqrt(e_x * e_x + e_y * e_y);
        const vec3<S> conjugate = y * (b * e_x / k) - x * (a * e_y / k);
        for (std::size_t i = 0; i < light_line_count; ++i) {
            const S half = sine_at(i) / k;
            set_flat(seen, i, conjugate * cosine_at(i), -half, half, a * b * k * sine_at(i) * S(step));
        }
        return seen;
    }

    // Uniform in the turn.
    LightLines<S> rectangle() const {
        LightLines<S> seen = flat();
        const vec3<S> x = spread<S>(light_.x);
        const vec3<S> y = spread<S>(light_.y);
        const vec3<S> z = spread<S>(light_.z);
        const vec3<S> other = cross(z, seen.axis);
        const S half_x(light_.half_size[0]);
        const S half_y(light_.half_size[1]);
        const S axis_x = dot(seen.axis, x);
        const S axis_y = dot(seen.axis, y);
        const S half_width = half_x * simd::abs(axis_y) + half_y * simd::abs(axis_x);
        const S height = simd::abs(dot(center_, z));
        const S middle = dot(center_, other);
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
        for (std::size_t i = 0; i < light_line_count; ++i) {
            const S off =
                simd::max(simd::min(height * (towards.sine / towards.cosine) - middle, half_width), -half_width);
            towards = towards * whole_step;
            const vec3<S> from_center = other * off;
            S low(-1e300);
            S high(1e300);
            const auto clip = [&](S along, S at, S half) {
                const auto cuts = simd::abs(along) >= S(1e-12);
                const S per_along = S(1) / simd::select(cuts, along, S(1));
                const S end = simd::copysign(half, along);
                low = simd::select(cuts, simd::max(low, (-end - at) * per_along), low);
                high = simd::select(cuts, simd::min(high, (end - at) * per_along), high);
            };
            clip(axis_x, dot(from_center, x), half_x);
            clip(axis_y, dot(from_center, y), half_y);
            set_flat(seen, i, from_center, low, simd::max(low, high), S(1));
            seen.lines[i].turn = turn;
        }
        return seen;
    }

    // In each plane through the receiver and along the axis the near side is one line.
    LightLines<S> cylinder() const {
        const vec3<S> a = spread<S>(light_.x);
        const S radius(light_.radius);
        const S half(light_.half_size[0]);
        const S along = dot(center_, a);
        const auto is_beside = length(center_ - a * along) > radius;
        return about_axis(center_, a, is_beside, [&](const LightLines<S>& seen, LightLine<S>& line, const Stripe& at) {
            const S s = radius / at.distance;
            const S away = at.distance * (S(1) - s) * (S(1) + s) / (at.cosine + s * at.sine_of_theta);
            line.from = line.across * away + a * (along - half);
            line.to = line.across * away + a * (along + half);
            line.low = seen.sine_of(line.from);
            line.high = seen.sine_of(line.to);
        });
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

    // Flat lights emit along −Z.
    LightLines<S> flat() const {
        LightLines<S> seen;
        const vec3<S> z = spread<S>(light_.z);
        const S before = dot(center_, z);
        seen.is_seen = light_.is_two_sided ? simd::abs(before) > S(0) : before > S(0);
        seen.axis = across(z);
        return seen;
    }

    GONIO_FORCE_INLINE void set_flat(LightLines<S>& seen, std::size_t i, const vec3<S>& from_center, S low, S high,
                                     S width) const {
        LightLine<S>& line = seen.lines[i];
        const vec3<S> middle = center_ + from_center;
        line.from = middle + seen.axis * low;
        line.to = middle + seen.axis * high;
        const vec3<S> across_axis = middle - seen.axis * dot(middle, seen.axis);
        const S distance2 = dot(across_axis, across_axis);
        line.across = across_axis * (S(1) / simd::sqrt(distance2));
        line.turn = width * simd::abs(dot(center_, spread<S>(light_.z))) / distance2;
        line.low = seen.sine_of(line.from);
        line.high = seen.sine_of(line.to);
    }

    // Of a body about an axis: a plane through the receiver and the axis' direction, at the sine (r/D) cos θ.
    struct Stripe {
        S distance; // D, of the receiver from the axis
        S sine_of_theta;
        S cosine; // of the turn from the axis
    };

    // Planes that are uniform in θ; set(seen, line, stripe) gives the ends of each line.
    template<class Set>
    GONIO_FORCE_INLINE LightLines<S> about_axis(const vec3<S>& at, const vec3<S>& axis, mask is_seen,
                                                const Set& set) const {
        LightLines<S> seen;
        seen.axis = axis;
        seen.is_seen = is_seen;
        const vec3<S> to_line = at - axis * dot(at, axis);
        const S distance = length(to_line);
        const vec3<S> f = to_line * (S(1) / distance);
        const vec3<S> g = cross(axis, f);
        const S s = S(light_.radius) / distance;
        for (std::size_t i = 0; i < light_line_count; ++i) {
            LightLine<S>& line = seen.lines[i];
            const S sine = s * cosine_at(i);
            const S cosine = simd::sqrt((S(1) - sine) * (S(1) + sine));
            line.across = f * cosine + g * sine;
            line.turn = s * sine_at(i) / cosine * S(step);
            set(seen, line, Stripe{distance, sine_at(i), cosine});
        }
        return seen;
    }

    // A plane through the receiver and along the axis cuts the capsule in two circles and the part between them; one
    // circle if `half` is 0.
    template<int ends>
    LightLines<S> capsule(const vec3<S>& at, const vec3<S>& axis, S half, mask is_seen) const {
        const S along = dot(at, axis);
        return about_axis(at, axis, is_seen, [&](const LightLines<S>&, LightLine<S>& line, const Stripe& stripe) {
            // More than the circles' radius, as the receiver is outside.
            const S away = stripe.distance * stripe.cosine;
            const S circle = S(light_.radius) * stripe.sine_of_theta;
            for (int i = 0; i < ends; ++i) {
                const S end = i == 0 ? along - half : along + half;
                const S to_middle2 = end * end + away * away;
                const S to_middle = simd::sqrt(to_middle2);
                const S tangent = simd::sqrt(simd::max((to_middle - circle) * (to_middle + circle), S(0)));
                // Elevation of the middle, minus and plus the half angle of the circle.
                const S low = (end * tangent - away * circle) / to_middle2;
                const S high = (end * tangent + away * circle) / to_middle2;
                const vec3<S> from =
                    (line.across * ((away * tangent + end * circle) / to_middle2) + axis * low) * tangent;
                const vec3<S> to =
                    (line.across * ((away * tangent - end * circle) / to_middle2) + axis * high) * tangent;
                if (i == 0) {
                    line.from = from;
                    line.to = to;
                    line.low = low;
                    line.high = high;
                    continue;
                }
                const auto is_lower = low < line.low;
                line.from = shading::select<S>(is_lower, from, line.from);
                line.low = simd::select(is_lower, low, line.low);
                const auto is_higher = high > line.high;
                line.to = shading::select<S>(is_higher, to, line.to);
                line.high = simd::select(is_higher, high, line.high);
            }
        });
    }

    const LinedLight& light_;
    vec3<S> center_; // relative to the receiver
    vec3<S> hint_;
};

template<class S>
GONIO_FORCE_INLINE LightLines<S> light_lines(const LinedLight& light, const vec3<S>& receiver, const vec3<S>& along) {
    return LightLinesOf<S>(light, receiver, along)();
}

} // namespace gonio::detail
