// Directions towards the side of a cylinder without caps.
//
// In half planes through the receiver and parallel to the axis, at the azimuth α, the visible side spans an interval of
// the elevation β, and solid angle is d(sin β) dα. So sin β is drawn uniformly from its interval, and α from a step
// function of 64 steps, each as high as the interval in its middle: the density is exact by construction, and uniform
// but for how the interval changes within a step, which is most beside the surface.
#pragma once

#include <gonio/shading/sample_light.hpp>

#include <cstddef>

namespace gonio::shading {

template<class S>
class CylinderSampler {
public:
    CylinderSampler(vec3<S> center, vec3<S> axis, S radius, S length_m) : axis_(axis), r_(radius) {
        const S along = dot(axis, center);
        const vec3<S> once = center - axis * along;
        const vec3<S> to_line = once - axis * dot(axis, once);
        z0_ = along - S(0.5) * length_m;
        z1_ = along + S(0.5) * length_m;
        length_ = length_m;
        d_ = length(to_line);
        if (!(d_ > radius)) return; // from within the prolonged cylinder nothing is seen
        f_ = to_line * (S(1) / d_);
        g_ = cross(axis_, f_);
        widest_ = simd::asin(radius / d_);
        S sum = S(0);
        for (std::size_t i = 0; i < steps; ++i) {
            sum = sum + span(azimuth(S(static_cast<double>(i)) + S(0.5)));
            up_to_[i] = sum;
        }
        seen_ = sum > S(0);
        if (!seen_) return;
        for (S& share : up_to_)
            share = share / sum;
    }

    // Where nothing is seen, the density is 0.
    LightSample<S> sample(S u0, S u1) const {
        if (!seen_) return {axis_, S(0)};
        std::size_t i = 0;
        while (i + 1 < steps && u0 >= up_to_[i])
            ++i;
        const S within = simd::min(simd::max((u0 - before(i)) / share(i), S(0)), S(1));
        const S alpha = azimuth(S(static_cast<double>(i)) + within);
        const Ends ends = ends_at(alpha);
        const S sine = ends.low + u1 * ends.span;
        const S cosine = simd::sqrt(simd::max((S(1) - sine) * (S(1) + sine), S(0)));
        const vec3<S> across = f_ * simd::cos(alpha) + g_ * simd::sin(alpha);
        return {normalized(axis_ * sine + across * cosine), density(i, ends.span)};
    }

    S pdf(vec3<S> direction) const {
        if (!seen_) return S(0);
        const S alpha = simd::atan2(dot(direction, g_), dot(direction, f_));
        if (!(simd::abs(alpha) <= widest_)) return S(0);
        const S sine = dot(direction, axis_);
        const Ends ends = ends_at(alpha);
        if (!(sine >= ends.low && sine <= ends.low + ends.span)) return S(0);
        const S at = (alpha / widest_ + S(1)) * S(0.5 * steps);
        std::size_t i = 0;
        while (i + 1 < steps && at >= S(static_cast<double>(i + 1)))
            ++i;
        return density(i, ends.span);
    }

private:
    static constexpr std::size_t steps = 64;

    struct Ends {
        S low, span; // of sin β
    };

    S azimuth(S step) const { return widest_ * (step * S(2.0 / steps) - S(1)); }
    S before(std::size_t i) const { return i > 0 ? up_to_[i - 1] : S(0); }
    S share(std::size_t i) const { return up_to_[i] - before(i); }
    S density(std::size_t i, S span) const {
        return share(i) / simd::max(span * widest_ * S(2.0 / steps), S(__is_same(S, double) ? 1e-280 : 1e-30));
    }
    S span(S alpha) const { return ends_at(alpha).span; }

    Ends ends_at(S alpha) const {
        const S sine = d_ * simd::sin(alpha);
        const S inside = simd::sqrt(simd::max((r_ - sine) * (r_ + sine), S(0)));
        const S rho = (d_ - r_) * (d_ + r_) / (d_ * simd::cos(alpha) + inside); // of the near side
        const S h0 = simd::sqrt(rho * rho + z0_ * z0_);
        const S h1 = simd::sqrt(rho * rho + z1_ * z1_);
        // sin β1 − sin β0, without cancellation where both have one sign.
        const S apart = z0_ * z1_ > S(0) ? rho * rho * length_ * simd::abs(z0_ + z1_) /
                                               (h0 * h1 * (simd::abs(z1_) * h0 + simd::abs(z0_) * h1))
                                         : z1_ / h1 - z0_ / h0;
        return {z0_ / h0, apart};
    }

    vec3<S> axis_;
    vec3<S> f_{S(1), S(0), S(0)}, g_{S(0), S(1), S(0)};
    S r_, d_ = S(0), z0_ = S(0), z1_ = S(0), length_ = S(0), widest_ = S(0);
    S up_to_[steps] = {};
    bool seen_ = false;
};

} // namespace gonio::shading
