#include <gonio/light/shape_traits.hpp>
#include <gonio/scene/light_lines.hpp>

#include <glm/vec2.hpp>

#include <algorithm>
#include <numbers>
#include <variant>

namespace gonio::detail {

namespace {

constexpr double pi = std::numbers::pi;

// Any unit vector perpendicular to a unit vector.
glm::dvec3 any_across(const glm::dvec3& z) {
    const glm::dvec3 seed = std::abs(z.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return glm::normalize(seed - glm::dot(z, seed) * z);
}

// By the angle of another vector, of unit length.
glm::dvec2 turned(const glm::dvec2& v, const glm::dvec2& by) {
    return {v.x * by.x - v.y * by.y, v.x * by.y + v.y * by.x};
}

struct Seen {
    const Frame& frame;
    glm::dvec3 center; // relative to the receiver
    const glm::dvec3& hint;

    // The position of a line in the unit interval.
    static double place(std::size_t i) {
        return (static_cast<double>(i) + 0.5) / static_cast<double>(light_line_count);
    }

    LightLines operator()(const SphereShape& sphere) const { return ball(center, sphere.radius.value); }

    LightLines operator()(const TubeShape& tube) const {
        const glm::dvec3& a = frame.x;
        const double radius = tube.radius.value;
        const double half = 0.5 * tube.length.value;
        const double along = glm::dot(center, a);
        if (glm::length(center - along * a) > radius) return capsule(center, a, radius, half);
        // Within the prolonged tube: only the nearer end is visible, or the receiver is inside.
        if (std::abs(along) <= half) return {};
        return ball(center - std::copysign(half, along) * a, radius);
    }

    // Chords of the disk, placed by the angle at which they end on the rim, where a chord's length and its stripe's
    // width fall to 0 together.
    LightLines operator()(const DiskShape& disk) const {
        LightLines seen = flat(disk.two_sided);
        if (seen.count == 0) return seen;
        const glm::dvec3 other = glm::cross(frame.z, seen.axis);
        for (std::size_t i = 0; i < light_line_count; ++i) {
            const double theta = pi * place(i);
            const double half = disk.radius.value * std::sin(theta);
            set_flat(seen, i, disk.radius.value * std::cos(theta) * other, -half, half,
                     half * pi / static_cast<double>(light_line_count));
        }
        return seen;
    }

    // The same chords of the circle that stretches to the ellipse: along the direction e they are 2 sin θ/k long,
    // k = |(e_x/a, e_y/b)|, and their middles lie on the conjugate diameter.
    LightLines operator()(const EllipseShape& ellipse) const {
        LightLines seen = flat(ellipse.two_sided);
        if (seen.count == 0) return seen;
        const double a = 0.5 * ellipse.width.value;
        const double b = 0.5 * ellipse.height.value;
        const double e_x = glm::dot(seen.axis, frame.x) / a;
        const double e_y = glm::dot(seen.axis, frame.y) / b;
        const double k = std::hypot(e_x, e_y);
        const glm::dvec3 conjugate = (b * e_x / k) * frame.y - (a * e_y / k) * frame.x;
        for (std::size_t i = 0; i < light_line_count; ++i) {
            const double theta = pi * place(i);
            const double half = std::sin(theta) / k;
            set_flat(seen, i, std::cos(theta) * conjugate, -half, half,
                     a * b * k * std::sin(theta) * pi / static_cast<double>(light_line_count));
        }
        return seen;
    }

    // Uniform in the turn.
    LightLines operator()(const RectShape& rect) const {
        LightLines seen = flat(rect.two_sided);
        if (seen.count == 0) return seen;
        const glm::dvec3 other = glm::cross(frame.z, seen.axis);
        const double half_x = 0.5 * rect.width.value;
        const double half_y = 0.5 * rect.height.value;
        const double axis_x = glm::dot(seen.axis, frame.x);
        const double axis_y = glm::dot(seen.axis, frame.y);
        const double half_width = half_x * std::abs(axis_y) + half_y * std::abs(axis_x);
        const double height = std::abs(glm::dot(center, frame.z));
        const double middle = glm::dot(center, other);
        // The angle between the sides without cancellation.
        const double side = middle - half_width;
        const double angle = std::atan2(2.0 * half_width * height, height * height + side * (middle + half_width));
        // The direction to that side, turned step by step.
        const double half_step = 0.5 * angle / static_cast<double>(light_line_count);
        const glm::dvec2 half_turn(std::cos(half_step), std::sin(half_step));
        const glm::dvec2 whole_turn = turned(half_turn, half_turn);
        glm::dvec2 towards = turned({height, side}, half_turn);
        for (std::size_t i = 0; i < light_line_count; ++i) {
            const double off = std::clamp(height * (towards.y / towards.x) - middle, -half_width, half_width);
            towards = turned(towards, whole_turn);
            const glm::dvec3 from_center = off * other;
            double low = -1e300;
            double high = 1e300;
            const auto clip = [&](double along, double at, double half) {
                if (std::abs(along) < 1e-12) return;
                low = std::max(low, (-std::copysign(half, along) - at) / along);
                high = std::min(high, (std::copysign(half, along) - at) / along);
            };
            clip(axis_x, glm::dot(from_center, frame.x), half_x);
            clip(axis_y, glm::dot(from_center, frame.y), half_y);
            set_flat(seen, i, from_center, low, std::max(low, high), 1.0);
            seen.lines[i].turn = angle / static_cast<double>(light_line_count);
        }
        return seen;
    }

    // In each plane through the receiver and along the axis the near side is one line.
    LightLines operator()(const CylinderShape& cylinder) const {
        const glm::dvec3& a = frame.x;
        const double radius = cylinder.radius.value;
        const double half = 0.5 * cylinder.length.value;
        const double along = glm::dot(center, a);
        if (!(glm::length(center - along * a) > radius)) return {};
        return about_axis(center, a, radius, [&](const LightLines& seen, LightLine& line, const Stripe& stripe) {
            const double s = radius / stripe.distance;
            const double away = stripe.distance * (1.0 - s) * (1.0 + s) / (stripe.cosine + s * std::sin(stripe.theta));
            line.from = away * line.across + (along - half) * a;
            line.to = away * line.across + (along + half) * a;
            line.low = seen.sine_of(line.from);
            line.high = seen.sine_of(line.to);
        });
    }

    LightLines operator()(const SunShape& /*no surface at a finite distance*/) const { return {}; }
    template<PunctualShape Kind>
    LightLines operator()(const Kind& /*no surface*/) const {
        return {};
    }

private:
    // The component of the hint perpendicular to a unit vector.
    glm::dvec3 across(const glm::dvec3& z) const {
        const glm::dvec3 part = hint - glm::dot(hint, z) * z;
        const double length2 = glm::dot(part, part);
        return length2 > 1e-12 * glm::dot(hint, hint) ? part / std::sqrt(length2) : any_across(z);
    }

    LightLines flat(bool two_sided) const {
        LightLines seen;
        // The light emits along −Z.
        const double before = glm::dot(center, frame.z);
        if (!(before > 0.0) && !(two_sided && before < 0.0)) return seen;
        seen.axis = across(frame.z);
        seen.count = light_line_count;
        return seen;
    }

    void set_flat(LightLines& seen, std::size_t i, const glm::dvec3& from_center, double low, double high,
                  double width) const {
        LightLine& line = seen.lines[i];
        const glm::dvec3 middle = center + from_center;
        line.from = middle + low * seen.axis;
        line.to = middle + high * seen.axis;
        const glm::dvec3 across = middle - glm::dot(middle, seen.axis) * seen.axis;
        const double distance2 = glm::dot(across, across);
        line.across = across / std::sqrt(distance2);
        line.turn = width * std::abs(glm::dot(center, frame.z)) / distance2;
        line.low = seen.sine_of(line.from);
        line.high = seen.sine_of(line.to);
    }

    static LightLines none() { return {}; }

    LightLines ball(const glm::dvec3& at, double radius) const {
        const double distance = glm::length(at);
        if (!(distance > radius)) return none();
        return capsule(at, across(at / distance), radius, 0.0);
    }

    // Of a body about an axis: a plane through the receiver and the axis' direction, at the sine (r/D) cos θ.
    struct Stripe {
        double distance; // D, of the receiver from the axis
        double theta;
        double cosine; // of the turn from the axis
    };

    // Planes that are uniform in θ; set(seen, line, stripe) gives the ends of each line.
    template<class Set>
    static LightLines about_axis(const glm::dvec3& at, const glm::dvec3& axis, double radius, const Set& set) {
        LightLines seen;
        seen.axis = axis;
        seen.count = light_line_count;
        const glm::dvec3 to_line = at - glm::dot(at, axis) * axis;
        const double distance = glm::length(to_line);
        const glm::dvec3 f = to_line / distance;
        const glm::dvec3 g = glm::cross(axis, f);
        const double s = radius / distance;
        for (std::size_t i = 0; i < light_line_count; ++i) {
            LightLine& line = seen.lines[i];
            const double theta = pi * place(i);
            const double sine = s * std::cos(theta);
            const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
            line.across = cosine * f + sine * g;
            line.turn = s * std::sin(theta) / cosine * pi / static_cast<double>(light_line_count);
            set(seen, line, Stripe{distance, theta, cosine});
        }
        return seen;
    }

    // A plane through the receiver and along the axis cuts the capsule in two circles and the part between them.
    LightLines capsule(const glm::dvec3& at, const glm::dvec3& axis, double radius, double half) const {
        const double along = glm::dot(at, axis);
        return about_axis(at, axis, radius, [&](const LightLines& /*seen*/, LightLine& line, const Stripe& stripe) {
            // More than the circles' radius, as the receiver is outside.
            const double away = stripe.distance * stripe.cosine;
            const double circle = radius * std::sin(stripe.theta);
            line.low = 1.0;
            line.high = -1.0;
            for (const double end : {along - half, along + half}) {
                const double to_middle2 = end * end + away * away;
                const double to_middle = std::sqrt(to_middle2);
                const double tangent = std::sqrt(std::max((to_middle - circle) * (to_middle + circle), 0.0));
                // Elevation of the middle, minus and plus the half angle of the circle.
                const double low = (end * tangent - away * circle) / to_middle2;
                const double high = (end * tangent + away * circle) / to_middle2;
                if (low < line.low) {
                    line.low = low;
                    line.from = tangent * ((away * tangent + end * circle) / to_middle2 * line.across + low * axis);
                }
                if (high > line.high) {
                    line.high = high;
                    line.to = tangent * ((away * tangent - end * circle) / to_middle2 * line.across + high * axis);
                }
                if (half == 0.0) break;
            }
        });
    }
};

} // namespace

LightLines light_lines(const Light& light, const glm::dvec3& receiver, const glm::dvec3& along) {
    return std::visit(Seen{light.frame, light.frame.origin - receiver, along}, light.shape);
}

} // namespace gonio::detail
