// Directions towards a capsule: a mixture of its ends' cones and the visible part of its side.
//
// The great arcs of the outline join the touching points of two tangent planes. These points are the corners of a flat
// rectangle, and the visible part is that rectangle and both ends. Each of the three is sampled uniformly, in
// proportion to its solid angle. The density is therefore the number of them that a direction meets, divided by the sum
// of their solid angles: between one and three times a uniform density.
#pragma once

#include <gonio/shading/sample_rectangle.hpp>
#include <gonio/shading/sample_sphere.hpp>

#include <cstddef>

namespace gonio::shading {

template<class S>
class TubeSampler {
public:
    TubeSampler(vec3<S> center, vec3<S> axis, S radius, S length_m)
        : ends_{SphereSampler<S>(center - axis * (S(0.5) * length_m), radius),
                SphereSampler<S>(center + axis * (S(0.5) * length_m), radius)},
          side_(center, axis, detail::Across<S>(axis).x, S(1), S(1)) {
        const S along = dot(axis, center);
        const vec3<S> to_line = center - axis * along;
        const S d = length(to_line);
        const S half = S(0.5) * length_m;
        weights_[0] = ends_[0].solid_angle();
        weights_[1] = ends_[1].solid_angle();
        if (d > radius) {
            const vec3<S> f = to_line * (S(1) / d);
            const S s = radius / d;
            const S kappa = simd::sqrt((d - radius) * (d + radius)) / d;
            side_ = RectangleSampler<S>(center - f * (s * radius), f * S(-1), axis, length_m, S(2) * kappa * radius);
            weights_[2] = side_.solid_angle();
        } else if (along > half || along < -half) {
            weights_[along > S(0) ? 1 : 0] = S(0); // within the prolonged tube the nearer end hides the rest
        } else {
            // Inside the first end's sphere: all directions. On the side: the directions in front of the tangent plane.
            weights_[1] = S(0);
            ends_[0] = d < radius ? SphereSampler<S>({S(0), S(0), S(0)}, radius)
                                  : SphereSampler<S>::hemisphere(to_line * (S(1) / d));
            weights_[0] = ends_[0].solid_angle();
        }
        const S sum = weights_[0] + weights_[1] + weights_[2];
        for (S& weight : weights_)
            weight = simd::max(weight, S(0)) / sum;
    }

    LightSample<S> sample(S u0, S u1) const {
        S u = u0;
        std::size_t part = 0;
        while (part < 2 && (u >= weights_[part] || !(weights_[part] > S(0)))) {
            u = u - weights_[part];
            ++part;
        }
        if (!(weights_[part] > S(0))) part = weights_[0] > S(0) ? 0 : 1;
        const S within = simd::min(simd::max(u / weights_[part], S(0)), S(below_1));
        const LightSample<S> drawn = part < 2 ? ends_[part].sample(within, u1) : side_.sample(within, u1);
        // A sampled direction belongs to its part even if rounding puts it outside the outline.
        S pdf_here = weights_[part] * drawn.pdf;
        for (std::size_t other = 0; other < 3; ++other)
            if (other != part) pdf_here = pdf_here + part_pdf(other, drawn.direction);
        return {drawn.direction, pdf_here};
    }

    S pdf(vec3<S> direction) const { return part_pdf(0, direction) + part_pdf(1, direction) + part_pdf(2, direction); }

private:
    static constexpr double below_1 = __is_same(S, double) ? 0x1.fffffffffffffp-1 : 0x1.fffffep-1;

    S part_pdf(std::size_t part, vec3<S> direction) const {
        if (!(weights_[part] > S(0))) return S(0);
        if (part == 2) return weights_[2] * side_.pdf(direction);
        return weights_[part] * ends_[part].pdf(direction);
    }

    SphereSampler<S> ends_[2];
    RectangleSampler<S> side_;          // arbitrary where its weight is 0
    S weights_[3] = {S(0), S(0), S(0)}; // of the ends and the side, their sum 1
};

} // namespace gonio::shading
