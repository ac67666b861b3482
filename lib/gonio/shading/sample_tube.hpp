// Directions towards a capsule: a mixture of its ends' cones and the visible part of its side.
//
// The great arcs of the outline join the touching points of two tangent planes. These points are the corners of a flat
// rectangle, and the visible part is that rectangle and both ends. Each of the three is sampled uniformly, in
// proportion to its solid angle, of which a far rectangle's is an estimate. The density is therefore the number of them
// that a direction meets, divided by the sum of their solid angles: between one and three times a uniform density.
#pragma once

#include <gonio/shading/sample_rectangle.hpp>
#include <gonio/shading/sample_sphere.hpp>

#include <cstddef>

namespace gonio::shading {

// `Digits` is the number that the side's limits are made for (sample_rectangle.hpp).
template<class S, class Digits = S>
class TubeSampler {
public:
    TubeSampler(vec3<S> center, vec3<S> axis, S radius, S length_m)
        : ends_{SphereSampler<S>(center - axis * (S(0.5) * length_m), radius),
                SphereSampler<S>(center + axis * (S(0.5) * length_m), radius)},
          side_(side(center, axis, radius, length_m)) {
        const S along = dot(axis, center);
        const vec3<S> to_line = center - axis * along;
        const S d = length(to_line);
        const S half = S(0.5) * length_m;
        const auto beside = d > radius;
        const auto beyond = simd::both(!beside, simd::either(along > half, along < -half));
        const auto within = !simd::either(beside, beyond);
        // Inside the first end's sphere: all directions. On the side: the directions in front of the tangent plane.
        ends_[0] = detail::chosen(
            within,
            [&] {
                return detail::chosen(
                    d < radius, [&] { return SphereSampler<S>::all_around(); },
                    [&] { return SphereSampler<S>::hemisphere(to_line * (S(1) / d)); });
            },
            [&] { return ends_[0]; });
        // Within the prolonged tube the nearer end hides the rest.
        const auto hides_first = simd::both(beyond, !(along > S(0)));
        const auto hides_second = simd::either(within, simd::both(beyond, along > S(0)));
        weights_[0] = simd::select(hides_first, S(0), ends_[0].solid_angle());
        weights_[1] = simd::select(hides_second, S(0), ends_[1].solid_angle());
        weights_[2] = simd::select(beside, side_.weight(), S(0));
        const S sum = weights_[0] + weights_[1] + weights_[2];
        for (S& weight : weights_)
            weight = simd::max(weight, S(0)) / sum;
    }

    LightSample<S> sample(S u0, S u1) const {
        // The end 0, the end 1 or the side, and how far u0 is within its part.
        const auto past_first = simd::either(u0 >= weights_[0], !(weights_[0] > S(0)));
        const S of_second = simd::select(past_first, u0 - weights_[0], u0);
        const auto past_second = simd::both(past_first, simd::either(of_second >= weights_[1], !(weights_[1] > S(0))));
        const S u = simd::select(past_second, of_second - weights_[1], of_second);
        const auto by_side = simd::both(past_second, weights_[2] > S(0));
        const auto by_first =
            simd::either(!past_first, simd::both(simd::both(past_second, !by_side), weights_[0] > S(0)));
        const auto by_end = simd::select(by_first, weights_[0], weights_[1]);
        const S weight = simd::select(by_side, weights_[2], by_end);
        const S part = simd::min(simd::max(u / weight, S(0)), S(below_1));
        const LightSample<S> drawn = detail::chosen(
            by_side, [&] { return side_.sample(part, u1); },
            [&] {
                return detail::chosen(
                           by_first, [&] { return ends_[0]; }, [&] { return ends_[1]; })
                    .sample(part, u1);
            });
        // A sampled direction belongs to its part even if rounding puts it outside the outline.
        const auto by_second = !simd::either(by_side, by_first);
        S pdf_here = weight * drawn.pdf;
        pdf_here = pdf_here + part_pdf(!by_first, ends_[0], weights_[0], drawn.direction);
        pdf_here = pdf_here + part_pdf(!by_second, ends_[1], weights_[1], drawn.direction);
        pdf_here = pdf_here + part_pdf(!by_side, side_, weights_[2], drawn.direction);
        return {drawn.direction, pdf_here};
    }

    S pdf(vec3<S> direction) const {
        const auto of = [&](const auto& part, S weight) { return part_pdf(weight > S(0), part, weight, direction); };
        return of(ends_[0], weights_[0]) + of(ends_[1], weights_[1]) + of(side_, weights_[2]);
    }

private:
    static constexpr double below_1 = __is_same(S, double) ? 0x1.fffffffffffffp-1 : 0x1.fffffep-1;

    // The rectangle between the lines where the tangent planes touch; arbitrary where they do not.
    static RectangleSampler<S, Digits> side(vec3<S> center, vec3<S> axis, S radius, S length_m) {
        const vec3<S> to_line = center - axis * dot(axis, center);
        const S d = length(to_line);
        const auto at_lines = [&] {
            const S apart = simd::select(d > radius, d, S(1));
            const vec3<S> f = to_line * (S(1) / apart);
            const S s = radius / apart;
            const S kappa = simd::sqrt(simd::max((apart - radius) * (apart + radius), S(0))) / apart;
            return RectangleSampler<S, Digits>(center - f * (s * radius), f * S(-1), axis, length_m,
                                               S(2) * kappa * radius);
        };
        if (simd::any(d > radius)) return at_lines();
        return RectangleSampler<S, Digits>(center, axis, detail::Across<S>(axis).x, S(1), S(1));
    }

    // What a part adds to the density, if it is asked.
    template<class Part>
    static S part_pdf(simd::mask_of<S> asked, const Part& part, S weight, vec3<S> direction) {
        return detail::chosen(
            simd::both(asked, weight > S(0)), [&] { return weight * part.pdf(direction); }, [] { return S(0); });
    }

    SphereSampler<S> ends_[2];
    RectangleSampler<S, Digits> side_;  // arbitrary where its weight is 0
    S weights_[3] = {S(0), S(0), S(0)}; // of the ends and the side, their sum 1
};

} // namespace gonio::shading
