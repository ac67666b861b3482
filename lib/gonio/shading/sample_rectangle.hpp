// Directions towards a rectangle: even over its solid angle (C. Ureña, M. Fajardo, A. King, "An Area-Preserving
// Parametrization for Spherical Rectangles", Computer Graphics Forum 32(4), 2013).
//
// The solid angle is a sum of four angles, here arctangents, that cancels for far rectangles, and the map is
// ill-conditioned for those that fill their half of the sky. Both are drawn by area instead, with the density d²/(A
// cos) that this has: there it is even enough, and exact.
#pragma once

#include <gonio/shading/sample_light.hpp>

#include <numbers>

namespace gonio::shading {

template<class S>
class RectangleSampler {
public:
    // Of either side: the receiver is before whichever it sees. `width_direction` is perpendicular to the axis.
    RectangleSampler(vec3<S> center, vec3<S> axis, vec3<S> width_direction, S width, S height)
        : x_(width_direction), y_(cross(axis, width_direction)), z_(axis) {
        if (dot(center, z_) > S(0)) z_ = z_ * S(-1); // the frame may be left-handed; only lengths matter in it
        z0_ = dot(center, z_);                       // ≤ 0
        const S cx = dot(center, x_);
        const S cy = dot(center, y_);
        x0_ = cx - S(0.5) * width;
        x1_ = cx + S(0.5) * width;
        y0_ = cy - S(0.5) * height;
        y1_ = cy + S(0.5) * height;
        area_ = width * height;
        const S far = -z0_;
        const auto corner = [&](S x, S y) { // the solid angle between the foot and a corner
            return simd::atan2(x * y, far * simd::sqrt(x * x + y * y + far * far));
        };
        solid_angle_ = corner(x1_, y1_) - corner(x0_, y1_) - corner(x1_, y0_) + corner(x0_, y0_);
        b0_ = -y0_ / simd::sqrt(y0_ * y0_ + z0_ * z0_);
        b1_ = y1_ / simd::sqrt(y1_ * y1_ + z0_ * z0_);
        // 2π less the angles at the two corners of x0.
        k_ = S(std::numbers::pi) + corner(x0_, y1_) - corner(x0_, y0_);
        even_ = z0_ < S(0) && solid_angle_ > least_even && solid_angle_ < S(6.22);
    }

    // Of the rectangle, to about the last digits of 2π.
    S solid_angle() const { return solid_angle_; }

    LightSample<S> sample(S u0, S u1) const {
        if (!even_) return by_area(x0_ + u0 * (x1_ - x0_), y0_ + u1 * (y1_ - y0_));
        const S turn = u0 * solid_angle_ + k_;
        const S fu = (simd::cos(turn) * b0_ - b1_) / simd::sin(turn);
        const S cu = simd::min(simd::max(simd::copysign(S(1) / simd::sqrt(fu * fu + b0_ * b0_), fu), S(-1)), S(1));
        const S across = simd::sqrt(simd::max((S(1) - cu) * (S(1) + cu), S(1e-30)));
        const S x = simd::min(simd::max(-(cu * z0_) / across, x0_), x1_);
        const S d2 = x * x + z0_ * z0_;
        const S h0 = y0_ / simd::sqrt(d2 + y0_ * y0_);
        const S h1 = y1_ / simd::sqrt(d2 + y1_ * y1_);
        const S h = h0 + u1 * (h1 - h0);
        const S rest = simd::max((S(1) - h) * (S(1) + h), S(1e-30));
        const S y = simd::min(simd::max(h * simd::sqrt(d2 / rest), y0_), y1_);
        return {normalized(x_ * x + y_ * y + z_ * z0_), S(1) / solid_angle_};
    }

    bool contains(vec3<S> direction) const {
        const S down = dot(direction, z_);
        if (!(down < S(0)) || !(z0_ < S(0))) return false;
        const S t = z0_ / down;
        const S x = dot(direction, x_) * t;
        const S y = dot(direction, y_) * t;
        return x >= x0_ && x <= x1_ && y >= y0_ && y <= y1_;
    }

    S pdf(vec3<S> direction) const {
        if (!contains(direction)) return S(0);
        if (even_) return S(1) / solid_angle_;
        const S t = z0_ / dot(direction, z_);
        return area_pdf(t * t, direction);
    }

private:
    // What cancels in the solid angle is below 1e-3 of it in float, 1e-7 in double.
    static constexpr S least_even = __is_same(S, double) ? S(1e-8) : S(3e-4);

    S area_pdf(S distance2, vec3<S> direction) const {
        return distance2 / (area_ * simd::max(-dot(direction, z_), S(1e-30)));
    }

    LightSample<S> by_area(S x, S y) const {
        const vec3<S> p = x_ * x + y_ * y + z_ * z0_;
        const vec3<S> direction = normalized(p);
        return {direction, area_pdf(dot(p, p), direction)};
    }

    vec3<S> x_, y_, z_;
    S x0_, x1_, y0_, y1_, z0_;
    S area_, solid_angle_;
    S b0_, b1_, k_;
    bool even_;
};

} // namespace gonio::shading
