// Directions towards an oriented disk: its outline is a spherical ellipse.
//
// The bisector of the nearest and the farthest point of the rim is an axis of the oblique cone. A plane across it at
// the distance 1 cuts the cone in an ellipse with the half axes a and b and the points (a r cos φ, b r sin φ). Along r
// the map is uniform over solid angle in closed form, 1 − 1/√(1 + ρ²r²) with ρ² = a² cos²φ + b² sin²φ; a wedge dφ
// contains g(φ) = a b (1 − 1/√(1 + ρ²))/ρ². With tan φ = κ tan ψ, and κ such that g dφ/dψ is equal at both ends of a
// quarter, the remaining variation is within a few percent even if the ellipse is wide and long. ψ is drawn from a step
// function that follows this variation, so that the density is exact (I. Guillén et al., "Area-Preserving
// Parameterizations for Spherical Ellipses", Computer Graphics Forum 36(4), 2017, invert an elliptic integral instead).
//
// In the disk's plane: inside the rim the cone has opened to the hemisphere in front of the emitting side, and all its
// directions are drawn uniformly; on the rim and outside nothing is seen. −0 behaves as +0.
#pragma once

#include <gonio/shading/sample_light.hpp>

#include <cstddef>
#include <numbers>

namespace gonio::shading {

template<class S>
class DiskSampler {
public:
    // Either side: the receiver is in front of the side it sees; in the plane, of the side that `axis` points away
    // from.
    DiskSampler(vec3<S> center, vec3<S> axis, S radius) {
        vec3<S> w = axis * S(-1);
        S z = dot(w, center);
        w = select(z < S(0), axis, w);
        z = simd::abs(z); // makes −0 positive too
        const vec3<S> flat = center - w * z;
        const S x = length(flat);
        // Near the axis the remaining component along the disk is rounding error, and may not lie in the disk.
        const vec3<S> way = normalized(flat);
        const vec3<S> in_plane = way - w * dot(w, way);
        const vec3<S> u = detail::chosen(
            length(in_plane) > S(0.5), [&] { return normalized(in_plane); }, [&] { return detail::Across<S>(w).x; });
        short_ = cross(w, u);
        // The rim's nearest and farthest point in the plane of w and u, and their bisector. Inside the rim their
        // components along u have opposite signs and cancel; the remaining sum is computed over z.
        const S far = x + radius;
        const S near = x - radius;
        const S far_length = simd::sqrt(far * far + z * z);
        const S near_length = simd::sqrt(near * near + z * z);
        const S both = far_length + near_length;
        const auto over = near < S(0);
        axis_ = detail::chosen(
            over,
            [&] {
                return normalized(u * (S(4) * x * radius * z / (far * near_length - near * far_length)) + w * both);
            },
            [&] { return normalized(u * (far * near_length + near * far_length) + w * (z * both)); });
        long_ = cross(short_, axis_);
        // Sine and cosine of the angle between the two, times the product h of the lengths. The axis meets the disk
        // where it divides the chord in the ratio of the lengths, so h also gives the half chord across it: a = tan of
        // half the angle, b = √2 r/√(h + cosine).
        const S sine = S(2) * radius * z;
        const S cosine = near * far + z * z;
        const S h = far_length * near_length;
        const S root2_r = S(std::numbers::sqrt2) * radius;
        const auto wide = cosine < S(0);
        a_ = detail::chosen(
            wide, [&] { return (h - cosine) / sine; }, [&] { return sine / (h + cosine); });
        b_ = detail::chosen(
            wide, [&] { return root2_r * simd::sqrt(h - cosine) / sine; },
            [&] { return root2_r / simd::sqrt(h + cosine); });
        a_ = simd::min(a_, S(widest));
        b_ = simd::min(b_, S(widest));
        seen_ = simd::both(simd::either(z > S(0), over), a_ * b_ > S(least_seen));
        axis_ = detail::chosen(
            seen_, [&] { return axis_; }, [&] { return normalized(center); });
        if (!simd::any(seen_)) return;
        kappa_ = simd::sqrt(wedge_of(b_ * b_) / wedge_of(a_ * a_));
        S sum = S(0);
        for (std::size_t i = 0; i < steps; ++i) {
            sum = sum + wedge(direction_of((S(static_cast<double>(i)) + S(0.5)) / S(static_cast<double>(steps))));
            up_to_[i] = sum;
        }
        for (S& share : up_to_)
            share = share / sum;
    }

    // Where nothing is seen, the density is 0 and the direction is that to the centre.
    LightSample<S> sample(S u0, S u1) const {
        if (!simd::any(seen_)) return {axis_, S(0)};
        // Chooses a quarter, then a step of it.
        const S four = S(4) * u0;
        const auto in_first = four < S(1);
        const auto in_left = simd::both(!in_first, four < S(3)); // the second or the third
        const auto in_lower = !(four < S(2));                    // the third or the fourth
        const S upper = simd::select(in_first, S(0), S(1));
        const S lower = simd::select(four < S(3), S(2), S(3));
        const S u = four - simd::select(in_lower, lower, upper);
        const Step step = step_where([&](std::size_t i) { return u >= up_to_[i]; });
        const S within = simd::min((u - step.before) / step.share, S(1));
        const Turned at = direction_of((step.place + within) / S(static_cast<double>(steps)));
        // Mirrored into its quarter.
        const S c = simd::select(in_left, -at.c, at.c);
        const S s = simd::select(in_lower, -at.s, at.s);
        const S rho2 = square(a_ * c) + square(b_ * s);
        const S fallen = u1 * fall(rho2);
        const S left = S(1) - fallen;
        const auto is_wide = rho2 > S(0);
        const S r2 = fallen * (S(2) - fallen) / simd::select(is_wide, rho2, S(1));
        const S r = simd::select(is_wide, simd::sqrt(simd::max(r2, S(0))) / left, S(0));
        const vec3<S> direction = normalized(axis_ + long_ * (a_ * c * r) + short_ * (b_ * s * r));
        return select(seen_, LightSample<S>{direction, density(step.share, at)}, LightSample<S>{axis_, S(0)});
    }

    S pdf(vec3<S> direction) const {
        if (!simd::any(seen_)) return S(0);
        const S along = dot(direction, axis_);
        const auto ahead = simd::both(seen_, along > S(0));
        if (!simd::any(ahead)) return S(0);
        const S c = dot(direction, long_) / (a_ * along);
        const S s = dot(direction, short_) / (b_ * along);
        const S r2 = c * c + s * s;
        const auto within = simd::both(ahead, r2 <= S(1));
        if (!simd::any(within)) return S(0);
        const S psi = simd::atan2(simd::abs(s), kappa_ * simd::abs(c));
        const S at = psi * S(2.0 * std::numbers::inv_pi) * S(static_cast<double>(steps));
        const auto off_axis = r2 > S(0);
        const Step step =
            step_where([&](std::size_t i) { return simd::both(off_axis, at >= S(static_cast<double>(i + 1))); });
        const S inverse = S(1) / simd::sqrt(simd::select(off_axis, r2, S(1)));
        const Turned turned{simd::select(off_axis, c * inverse, S(1)), simd::select(off_axis, s * inverse, S(0))};
        return simd::select(within, density(step.share, turned), S(0));
    }

private:
    static constexpr std::size_t steps = 16; // per quarter
    // Limit of a and b: cuts off a share of 1/widest of a hemisphere.
    static constexpr double widest = __is_same(S, double) ? 1e12 : 1e6;
    // Limit of a b, below which densities would overflow.
    static constexpr double least_seen = __is_same(S, double) ? 1e-280 : 1e-30;

    struct Turned {
        S c, s; // of φ
    };
    // A step of a quarter: the share of the quarter before it, its own share, and its place.
    struct Step {
        S before, share, place;
    };

    static S square(S x) { return x * x; }
    // 1 − 1/√(1 + ρ²).
    static S fall(S rho2) {
        const S root = simd::sqrt(S(1) + rho2);
        return rho2 / (root * (root + S(1)));
    }
    // g divided by a b.
    static S wedge_of(S rho2) {
        const S root = simd::sqrt(S(1) + rho2);
        return S(1) / (root * (root + S(1)));
    }
    // The direction at ψ, given as a share of a quarter turn.
    Turned direction_of(S share) const {
        const S psi = S(0.5 * std::numbers::pi) * share;
        const S c = simd::cos(psi);
        const S s = kappa_ * simd::sin(psi);
        const S inverse = S(1) / simd::sqrt(c * c + s * s);
        return {c * inverse, s * inverse};
    }
    // g dφ/dψ divided by a b.
    S wedge(Turned at) const {
        return wedge_of(square(a_ * at.c) + square(b_ * at.s)) * (square(kappa_ * at.c) + square(at.s)) / kappa_;
    }
    // The step that follows all those that `is_before` holds for, or the last one.
    template<class IsBefore>
    Step step_where(const IsBefore& is_before) const {
        Step step{S(0), up_to_[0], S(0)};
        for (std::size_t i = 0; i + 1 < steps; ++i) {
            const auto passed = is_before(i);
            if (simd::all(!passed)) break; // the shares ascend
            step.before = simd::select(passed, up_to_[i], step.before);
            step.share = simd::select(passed, up_to_[i + 1] - up_to_[i], step.share);
            step.place = simd::select(passed, S(static_cast<double>(i + 1)), step.place);
        }
        return step;
    }
    S density(S share, Turned at) const {
        const S per_radian = share * S(static_cast<double>(steps)) * S(0.5 * std::numbers::inv_pi);
        return per_radian / (a_ * b_ * wedge(at));
    }

    vec3<S> axis_, long_, short_;
    S a_, b_, kappa_;
    simd::mask_of<S> seen_; // if false, only axis_ is meaningful
    S up_to_[steps];
};

} // namespace gonio::shading
