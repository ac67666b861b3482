// Directions towards a rectangle: uniform over its solid angle (C. Ureña, M. Fajardo, A. King, "An Area-Preserving
// Parametrization for Spherical Rectangles", Computer Graphics Forum 32(4), 2013).
//
// The solid angle is a sum of four angles, here arctangents, that cancel for far rectangles. Those are sampled by area
// instead, with the resulting density d²/(A cos), which is nearly uniform there, and exact. The map is ill-conditioned
// for rectangles that fill their half of the sky. Those are sampled about their foot, uniformly in azimuth and then in
// solid angle up to the edge, which is within 4 % of uniform, and exact.
//
// In the rectangle's plane: inside the outline it is the hemisphere in front of the emitting side, and its directions
// are drawn uniformly; on the outline and outside nothing is seen. −0 behaves as +0.
#pragma once

#include <gonio/shading/sample_light.hpp>

#include <numbers>

namespace gonio::shading {

// `Digits` is the number that limits are made for: RectangleSampler<double, float> chooses its map as floats do.
template<class S, class Digits = S>
class RectangleSampler {
public:
    // Either side: the receiver is in front of the side it sees; in the plane, of the emitting side. `width_direction`
    // is perpendicular to the axis.
    RectangleSampler(vec3<S> center, vec3<S> axis, vec3<S> width_direction, S width, S height)
        : x_(width_direction), y_(cross(axis, width_direction)), z_(axis) {
        z_ = select(dot(center, z_) > S(0), z_ * S(-1), z_); // the frame may be left-handed; only lengths matter in it
        z0_ = -simd::abs(dot(center, z_));                   // ≤ 0
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
        // 2π minus the angles at the two corners of x0.
        k_ = S(std::numbers::pi) + corner(x0_, y1_) - corner(x0_, y0_);
        const auto spans_0 = [](S low, S high) {
            const auto begins_below = low < S(0);
            return simd::both(begins_below, high > S(0));
        };
        const auto over = simd::both(spans_0(x0_, x1_), spans_0(y0_, y1_));
        const S reach = simd::max(simd::max(x1_, -x0_), simd::max(y1_, -y0_));
        const auto part = solid_angle_ < S(most_even); // of the half of the sky
        about_foot_ = simd::both(over, !part);
        nothing_ = simd::both(!about_foot_, !(far > S(least_slope) * reach));
        even_ = simd::both(simd::both(solid_angle_ > S(least_even), part), !nothing_);
    }

    // The rectangle's solid angle, accurate to about the last digits of 2π.
    S solid_angle() const { return solid_angle_; }
    // How often it is to be chosen among several lights: the solid angle, and where that has lost its digits, the area
    // times the cosine over the squared distance of its middle.
    S weight() const {
        const auto by_middle = [&] {
            const S x = S(0.5) * (x0_ + x1_);
            const S y = S(0.5) * (y0_ + y1_);
            const S d2 = simd::max(x * x + y * y + z0_ * z0_, S(1e-30));
            return simd::min(area_ * -z0_ / (d2 * simd::sqrt(d2)), S(2.0 * std::numbers::pi));
        };
        return detail::chosen(
            solid_angle_ > S(least_even), [&] { return solid_angle_; }, by_middle);
    }

    // Where nothing is seen, the density is 0 and the direction is that to the middle.
    LightSample<S> sample(S u0, S u1) const {
        const auto not_over = [&] {
            return detail::chosen(
                even_, [&] { return by_solid_angle(u0, u1); },
                [&] { return by_area(x0_ + u0 * (x1_ - x0_), y0_ + u1 * (y1_ - y0_)); });
        };
        const auto seen = [&] {
            return detail::chosen(
                about_foot_, [&] { return about_the_foot(u0, u1); }, not_over);
        };
        return detail::chosen(
            nothing_,
            [&] {
                return LightSample<S>{to_middle(), S(0)};
            },
            seen);
    }

    simd::mask_of<S> contains(vec3<S> direction) const {
        const S down = dot(direction, z_);
        const auto ahead = simd::both(down < S(0), !nothing_);
        const S t = z0_ / simd::select(ahead, down, S(-1));
        const S x = dot(direction, x_) * t;
        const S y = dot(direction, y_) * t;
        const auto within = simd::both(simd::both(x >= x0_, x <= x1_), simd::both(y >= y0_, y <= y1_));
        return simd::both(ahead, within);
    }

    S pdf(vec3<S> direction) const {
        const auto by_foot = [&] {
            const S x = dot(direction, x_);
            const S y = dot(direction, y_);
            const S across = simd::sqrt(x * x + y * y);
            const auto aside = across > S(0);
            const S safe = simd::select(aside, across, S(1));
            return foot_pdf(fall(simd::select(aside, x / safe, S(1)), simd::select(aside, y / safe, S(0))));
        };
        const auto at_place = [&] {
            const S t = z0_ / dot(direction, z_);
            return area_pdf(t * t, direction);
        };
        const auto within = [&] {
            return detail::chosen(
                even_, [&] { return S(1) / solid_angle_; },
                [&] { return detail::chosen(about_foot_, by_foot, at_place); });
        };
        return detail::chosen(contains(direction), within, [] { return S(0); });
    }

private:
    static constexpr bool is_double = __is_same(Digits, double);
    // Above it, the cancellation error of the solid angle is below 1e-3 of it in float, 1e-7 in double.
    static constexpr double least_even = is_double ? 1e-8 : 3e-4;
    static constexpr double most_even = 6.22;
    // Limit of the height over the plane relative to the distance along it, below which densities would overflow.
    static constexpr double least_slope = is_double ? 1e-280 : 1e-30;

    vec3<S> to_middle() const { return normalized(x_ * (S(0.5) * (x0_ + x1_)) + y_ * (S(0.5) * (y0_ + y1_))); }

    LightSample<S> by_solid_angle(S u0, S u1) const {
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

    S area_pdf(S distance2, vec3<S> direction) const {
        return distance2 / (area_ * simd::max(-dot(direction, z_), S(1e-30)));
    }

    LightSample<S> by_area(S x, S y) const {
        const vec3<S> p = x_ * x + y_ * y + z_ * z0_;
        const vec3<S> direction = normalized(p);
        return {direction, area_pdf(dot(p, p), direction)};
    }

    // 1 − cos of the angle from the foot to the edge in the direction (c, s) along the rectangle.
    S fall(S c, S s) const {
        S edge2 = S(-1); // squared distance to the edge
        const auto nearer = [&](S to, S along) {
            const auto meets = !(along == S(0));
            const S way = to / simd::select(meets, along, S(1));
            const auto is_nearer = simd::either(edge2 < S(0), way * way < edge2);
            edge2 = simd::select(simd::both(meets, is_nearer), way * way, edge2);
        };
        nearer(simd::select(c > S(0), x1_, x0_), c);
        nearer(simd::select(s > S(0), y1_, y0_), s);
        const S slant = simd::sqrt(edge2 + z0_ * z0_);
        return edge2 / (slant * (slant - z0_));
    }

    S foot_pdf(S fall_there) const { return S(0.5 * std::numbers::inv_pi) / fall_there; }

    LightSample<S> about_the_foot(S u0, S u1) const {
        const S phi = S(2.0 * std::numbers::pi) * u0;
        const S c = simd::cos(phi);
        const S s = simd::sin(phi);
        const S there = fall(c, s);
        const S fallen = u1 * there;
        const S across = simd::sqrt(simd::max(fallen * (S(2) - fallen), S(0)));
        return {normalized(x_ * (c * across) + y_ * (s * across) - z_ * (S(1) - fallen)), foot_pdf(there)};
    }

    vec3<S> x_, y_, z_;
    S x0_, x1_, y0_, y1_, z0_;
    S area_, solid_angle_;
    S b0_, b1_, k_;
    // Which map: about the foot, evenly over the solid angle, or, if none of the three, by area.
    simd::mask_of<S> about_foot_, nothing_, even_;
};

} // namespace gonio::shading
