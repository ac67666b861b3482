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
        if (z < S(0)) w = axis;
        z = simd::abs(z); // makes −0 positive too
        const vec3<S> flat = center - w * z;
        const S x = length(flat);
        // Near the axis the remaining component along the disk is rounding error, and may not lie in the disk.
        const vec3<S> way = normalized(flat);
        const vec3<S> in_plane = way - w * dot(w, way);
        const vec3<S> u = length(in_plane) > S(0.5) ? normalized(in_plane) : detail::Across<S>(w).x;
        short_ = cross(w, u);
        // The rim's nearest and farthest point in the plane of w and u, and their bisector. Inside the rim their
        // components along u have opposite signs and cancel; the remaining sum is computed over z.
        const S far = x + radius;
        const S near = x - radius;
        const S far_length = simd::sqrt(far * far + z * z);
        const S near_length = simd::sqrt(near * near + z * z);
        const S both = far_length + near_length;
        axis_ = near < S(0)
                    ? normalized(u * (S(4) * x * radius * z / (far * near_length - near * far_length)) + w * both)
                    : normalized(u * (far * near_length + near * far_length) + w * (z * both));
        long_ = cross(short_, axis_);
        // Sine and cosine of the angle between the two, times the product h of the lengths. The axis meets the disk
        // where it divides the chord in the ratio of the lengths, so h also gives the half chord across it: a = tan of
        // half the angle, b = √2 r/√(h + cosine).
        const S sine = S(2) * radius * z;
        const S cosine = near * far + z * z;
        const S h = far_length * near_length;
        const S root2_r = S(std::numbers::sqrt2) * radius;
        a_ = simd::min(cosine < S(0) ? (h - cosine) / sine : sine / (h + cosine), widest);
        b_ = simd::min(cosine < S(0) ? root2_r * simd::sqrt(h - cosine) / sine : root2_r / simd::sqrt(h + cosine),
                       widest);
        seen_ = (z > S(0) || near < S(0)) && a_ * b_ > least_seen;
        if (!seen_) {
            axis_ = normalized(center);
            return;
        }
        kappa_ = simd::sqrt(wedge_of(b_ * b_) / wedge_of(a_ * a_));
        S sum = S(0);
        for (std::size_t i = 0; i < steps; ++i) {
            sum += wedge(direction_of((S(static_cast<double>(i)) + S(0.5)) / S(static_cast<double>(steps))));
            up_to_[i] = sum;
        }
        for (S& share : up_to_)
            share = share / sum;
    }

    // Where nothing is seen, the density is 0 and the direction is that to the centre.
    LightSample<S> sample(S u0, S u1) const {
        if (!seen_) return {axis_, S(0)};
        // Chooses a quarter, then a step of it.
        const S four = S(4) * u0;
        const S quarter = four < S(1) ? S(0) : four < S(2) ? S(1) : four < S(3) ? S(2) : S(3);
        const S u = four - quarter;
        std::size_t i = 0;
        while (i + 1 < steps && u >= up_to_[i])
            ++i;
        const S before = i > 0 ? up_to_[i - 1] : S(0);
        const S within = simd::min((u - before) / share(i), S(1));
        const Turned at = direction_of((S(static_cast<double>(i)) + within) / S(static_cast<double>(steps)));
        // Mirrored into its quarter.
        const S c = quarter == S(1) || quarter == S(2) ? -at.c : at.c;
        const S s = quarter > S(1) ? -at.s : at.s;
        const S rho2 = square(a_ * c) + square(b_ * s);
        const S fallen = u1 * fall(rho2);
        const S left = S(1) - fallen;
        const S r = rho2 > S(0) ? simd::sqrt(simd::max(fallen * (S(2) - fallen) / rho2, S(0))) / left : S(0);
        return {normalized(axis_ + long_ * (a_ * c * r) + short_ * (b_ * s * r)), density(i, at)};
    }

    S pdf(vec3<S> direction) const {
        if (!seen_) return S(0);
        const S along = dot(direction, axis_);
        if (!(along > S(0))) return S(0);
        const S c = dot(direction, long_) / (a_ * along);
        const S s = dot(direction, short_) / (b_ * along);
        const S r2 = c * c + s * s;
        if (!(r2 <= S(1))) return S(0);
        const S psi = simd::atan2(simd::abs(s), kappa_ * simd::abs(c));
        const S at = psi * S(2.0 * std::numbers::inv_pi) * S(static_cast<double>(steps));
        std::size_t i = 0;
        while (i + 1 < steps && at >= S(static_cast<double>(i + 1)))
            ++i;
        if (!(r2 > S(0))) return density(0, {S(1), S(0)});
        const S inverse = S(1) / simd::sqrt(r2);
        return density(i, {c * inverse, s * inverse});
    }

private:
    static constexpr std::size_t steps = 16; // per quarter
    // Limit of a and b: cuts off a share of 1/widest of a hemisphere.
    static constexpr S widest = __is_same(S, double) ? S(1e12) : S(1e6);
    // Limit of a b, below which densities would overflow.
    static constexpr S least_seen = __is_same(S, double) ? S(1e-280) : S(1e-30);

    struct Turned {
        S c, s; // of φ
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
    S share(std::size_t i) const { return i > 0 ? up_to_[i] - up_to_[i - 1] : up_to_[0]; }
    S density(std::size_t i, Turned at) const {
        const S per_radian = share(i) * S(static_cast<double>(steps)) * S(0.5 * std::numbers::inv_pi);
        return per_radian / (a_ * b_ * wedge(at));
    }

    vec3<S> axis_, long_, short_;
    S a_, b_, kappa_;
    bool seen_; // if false, only axis_ is meaningful
    S up_to_[steps];
};

} // namespace gonio::shading
