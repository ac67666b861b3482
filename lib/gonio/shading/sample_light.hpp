// Directions drawn towards an area light, each with its density over solid angle.
//
// There is one sampler for each shape, constructed once for a light and a receiver and used any number of times:
//
//   sample(u0, u1)      a unit direction within the light's outline, for two numbers in [0, 1), and its density [1/sr]
//   pdf(direction)      the density of sample() there; 0 outside the outline
//
// Densities integrate to 1 over the outline, whether the receiver's horizon cuts it or not. Each header states how
// uniform they are over the solid angle; the closer to uniform, the closer an estimate's variance is to that of the
// integrand. For float and double. Lengths are in metres from the receiver to the light's centre; axes are unit. Radii
// and lengths are > 0.
#pragma once

#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

namespace gonio::shading {

template<class S>
struct LightSample {
    vec3<S> direction; // unit
    S pdf;             // [1/sr]
};

namespace detail {

// Two unit vectors with x × y = z.
template<class S>
struct Across {
    vec3<S> x, y;

    explicit Across(vec3<S> z) {
        const vec3<S> seed = simd::abs(z.x) < S(0.6) ? vec3<S>{S(1), S(0), S(0)} : vec3<S>{S(0), S(1), S(0)};
        x = normalized(seed - z * dot(z, seed));
        y = cross(z, x);
    }
};

} // namespace detail

} // namespace gonio::shading
