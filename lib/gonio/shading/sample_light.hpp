// Directions drawn towards an area light, each with its density over solid angle.
//
// There is one sampler for each shape, constructed once for a light and a receiver and used any number of times:
//
//   sample(u0, u1)      a unit direction within the light's outline, for two numbers in [0, 1), and its density [1/sr]
//   pdf(direction)      the density of sample() there; 0 outside the outline
//
// Densities integrate to 1 over the outline, whether the receiver's horizon cuts it or not. Each header states how
// uniform they are over the solid angle; the closer to uniform, the closer an estimate's variance is to that of the
// integrand. For float, double, and a scalar that records what is computed with it (shader/). Lengths are in metres
// from the receiver to the light's centre; axes are unit. Radii and lengths are > 0.
#pragma once

#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

namespace gonio::shading {

template<class S>
struct LightSample {
    vec3<S> direction; // unit
    S pdf;             // [1/sr]
};

template<class S>
LightSample<S> select(simd::mask_of<S> condition, const LightSample<S>& if_true, const LightSample<S>& if_false) {
    return {select(condition, if_true.direction, if_false.direction),
            simd::select(condition, if_true.pdf, if_false.pdf)};
}

namespace detail {

// One of two results. Numbers compute the one alone; a scalar that records has both, and a choice between them.
template<class Mask, class IfTrue, class IfFalse>
auto chosen(const Mask& condition, const IfTrue& if_true, const IfFalse& if_false) {
    using shading::select;
    using simd::select;
    if (simd::all(condition)) return if_true();
    if (!simd::any(condition)) return if_false();
    return select(condition, if_true(), if_false());
}

// Two unit vectors with x × y = z.
template<class S>
struct Across {
    vec3<S> x, y;

    explicit Across(vec3<S> z) {
        const vec3<S> seed = select(simd::abs(z.x) < S(0.6), vec3<S>{S(1), S(0), S(0)}, vec3<S>{S(0), S(1), S(0)});
        x = normalized(seed - z * dot(z, seed));
        y = cross(z, x);
    }
};

} // namespace detail

} // namespace gonio::shading
