// The share of light that a surface reflects: a white furnace, by quadrature over half vectors.
#pragma once

#include <gonio/shading/brdf_sample.hpp>
#include <gonio/shading/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio::shading {

// ∫ f n·l dω of the three channels for a view at n·v = mu, in (0, 1]. `narrowest` is the α of the material's narrowest
// lobe; 1 for none. Shares no code with the samplers: the logarithm of the half vector's slope and its azimuth are
// sampled uniformly on a lattice, which covers lobes of any width. Errors are below 3e-5.
template<class Material>
vec3<double> directional_albedo(const Material& material, double mu, double narrowest, int slopes = 500,
                                int azimuths = 200) {
    const vec3<double> n{0.0, 0.0, 1.0};
    const vec3<double> v{std::sqrt((1.0 - mu) * (1.0 + mu)), 0.0, mu};
    const double low = std::log(std::clamp(narrowest, 1e-4, 1.0) * 3e-4);
    // A light on the same side as the view has half vectors as steep as the view is shallow.
    const double step = (std::log(3e3 / mu) - low) / slopes;
    vec3<double> sum{0.0, 0.0, 0.0};
    for (int k = 0; k < azimuths; ++k) {
        const double phi = std::numbers::pi * (k + 0.5) / azimuths;
        const double along = std::cos(phi);
        const double across = std::sin(phi);
        const double turns = (k + 0.5) / std::numbers::phi;
        for (int i = 0; i < slopes; ++i) {
            const double slope = std::exp(low + (i + turns - std::floor(turns)) * step);
            const double cosine = 1.0 / std::sqrt(1.0 + slope * slope);
            const double sine = slope * cosine;
            const double measure = sine * sine * cosine * step * (2.0 * std::numbers::pi / azimuths);
            const vec3<double> h{sine * along, sine * across, cosine};
            const double v_dot_h = dot(v, h);
            if (!(v_dot_h > 0.0)) continue;
            const vec3<double> l = h * (2.0 * v_dot_h) - v;
            if (!(l.z > 0.0)) continue;
            sum = sum + brdf(material, n, l, v) * (l.z * 4.0 * v_dot_h * measure);
        }
    }
    return sum;
}

} // namespace gonio::shading
