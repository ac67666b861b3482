// Directions towards an oriented disk, whose outline is a spherical ellipse.
//
// The bisector of the nearest and the farthest point of the rim is an axis of the oblique cone; a plane across it at
// the distance 1 cuts the cone in an ellipse with the half axes a and b, whose points are (a r cos φ, b r sin φ). Along
// r the map is even over solid angle in closed form, 1 − 1/√(1 + ρ²r²) with ρ² = a² cos²φ + b² sin²φ; what a wedge dφ
// holds is g(φ) = a b (1 − 1/√(1 + ρ²))/ρ². φ is drawn from a step function that follows g, so that the density,
// step/g, is exact, and even within a few percent (I. Guillén et al., "Area-Preserving Parameterizations for Spherical
// Ellipses", Computer Graphics Forum 36(4), 2017, invert an elliptic integral for the rest).
#pragma once

#include <gonio/shading/sample_light.hpp>

#include <cstddef>
#include <numbers>

namespace gonio::shading {

template<class S>
class DiskSampler {
public:
    // Of either side. From its plane a disk has no outline: then it is the hemisphere before it.
    DiskSampler(vec3<S> center, vec3<S> axis, S radius) {
        vec3<S> w = axis * S(-1);
        S z = dot(w, center);
        if (z < S(0)) {
            w = axis;
            z = -z;
        }
        const vec3<S> flat = center - w * z;
        const S x = length(flat);
        // Near the axis what is left of the way along the disk is rounding, and need not lie in it.
        const vec3<S> way = normalized(flat);
        const vec3<S> in_plane = way - w * dot(w, way);
        const vec3<S> u = length(in_plane) > S(0.5) ? normalized(in_plane) : detail::Across<S>(w).x;
        long_ = u;
        short_ = cross(w, u);
        // The rim's nearest and farthest point in the plane of w and u, and their bisector.
        const S far = x + radius;
        const S near = x - radius;
        const S far_length = simd::sqrt(far * far + z * z);
        const S near_length = simd::sqrt(near * near + z * z);
        axis_ = normalized(u * (far / far_length + near / near_length) + w * (z / far_length + z / near_length));
        long_ = cross(short_, axis_);
        const S angle = S(0.5) * simd::atan2(S(2) * radius * z, near * far + z * z);
        a_ = simd::min(simd::sin(angle) / simd::cos(angle), S(1e6));
        // Where the axis meets the disk: half the chord across, by its distance.
        const S t = z / simd::max(dot(axis_, w), S(1e-20));
        const S off = t * dot(axis_, u) - x;
        b_ = simd::sqrt(simd::max((radius - off) * (radius + off), S(0))) / simd::max(t, S(1e-30));
        S sum = S(0);
        for (std::size_t i = 0; i < steps; ++i) {
            sum +=
                wedge(S(0.5 * std::numbers::pi) * (S(static_cast<double>(i)) + S(0.5)) / S(static_cast<double>(steps)));
            up_to_[i] = sum;
        }
        for (S& share : up_to_)
            share = share / sum;
    }

    LightSample<S> sample(S u0, S u1) const {
        // A quarter, then a step of it.
        const S four = S(4) * u0;
        const S quarter = four < S(1) ? S(0) : four < S(2) ? S(1) : four < S(3) ? S(2) : S(3);
        const S u = four - quarter;
        std::size_t i = 0;
        while (i + 1 < steps && u >= up_to_[i])
            ++i;
        const S before = i > 0 ? up_to_[i - 1] : S(0);
        const S within = simd::min((u - before) / share(i), S(1));
        const S psi = S(0.5 * std::numbers::pi) * (S(static_cast<double>(i)) + within) / S(static_cast<double>(steps));
        // Mirrored into its quarter.
        const S c = quarter == S(1) || quarter == S(2) ? -simd::cos(psi) : simd::cos(psi);
        const S s = quarter > S(1) ? -simd::sin(psi) : simd::sin(psi);
        const S rho2 = square(a_ * c) + square(b_ * s);
        const S fallen = u1 * fall(rho2);
        const S left = S(1) - fallen;
        const S r = rho2 > S(0) ? simd::sqrt(simd::max(fallen * (S(2) - fallen) / rho2, S(0))) / left : S(0);
        return {normalized(axis_ + long_ * (a_ * c * r) + short_ * (b_ * s * r)), density(i, rho2)};
    }

    S pdf(vec3<S> direction) const {
        const S along = dot(direction, axis_);
        if (!(along > S(0))) return S(0);
        const S c = dot(direction, long_) / (a_ * along);
        const S s = dot(direction, short_) / (b_ * along);
        const S r2 = c * c + s * s;
        if (!(r2 <= S(1))) return S(0);
        const S psi = simd::atan2(simd::abs(s), simd::abs(c));
        const S at = psi * S(2.0 * std::numbers::inv_pi) * S(static_cast<double>(steps));
        std::size_t i = 0;
        while (i + 1 < steps && at >= S(static_cast<double>(i + 1)))
            ++i;
        if (!(r2 > S(0))) return density(i, square(a_));
        return density(i, (square(a_ * c) + square(b_ * s)) / r2);
    }

private:
    static constexpr std::size_t steps = 16; // of a quarter

    static S square(S x) { return x * x; }
    // 1 − 1/√(1 + ρ²).
    static S fall(S rho2) {
        const S root = simd::sqrt(S(1) + rho2);
        return rho2 / (root * (root + S(1)));
    }
    // g over a b.
    static S wedge_of(S rho2) {
        const S root = simd::sqrt(S(1) + rho2);
        return S(1) / (root * (root + S(1)));
    }
    S wedge(S phi) const { return wedge_of(square(a_ * simd::cos(phi)) + square(b_ * simd::sin(phi))); }
    S share(std::size_t i) const { return i > 0 ? up_to_[i] - up_to_[i - 1] : up_to_[0]; }
    S density(std::size_t i, S rho2) const {
        const S per_radian = share(i) * S(static_cast<double>(steps)) * S(0.5 * std::numbers::inv_pi);
        return per_radian / (a_ * b_ * wedge_of(rho2));
    }

    vec3<S> axis_, long_, short_;
    S a_, b_;
    S up_to_[steps];
};

} // namespace gonio::shading
