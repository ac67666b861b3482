// The midpoint rule over the facets of an anisotropic surface: over their slopes (α_x r cos φ, α_y r sin φ), with
// r² = s/(1 − s), so that D of every α is even over s and φ.
#pragma once

#include <gonio/shading/ggx_anisotropic.hpp>

#include "poses.hpp"

#include <cmath>
#include <numbers>

namespace facet_rule {

// Calls work(h, dh) for steps² normals h, in the frame of the surface, and the solid angle of each.
template<class Work>
void each(gonio::shading::AnisotropicAlpha<double> alphas, int steps, const Work& work) {
    for (int i = 0; i < steps; ++i)
        for (int k = 0; k < steps; ++k) {
            const double s = (i + 0.5) / steps;
            const double r = std::sqrt(s / (1.0 - s));
            const double phi = 2.0 * std::numbers::pi * (k + 0.5) / steps;
            const poses::Vec h = poses::unit({alphas.x * r * std::cos(phi), alphas.y * r * std::sin(phi), 1.0});
            // dh = n·h³ dslope, dslope = α_x α_y r dr dφ, r dr = ds/(2 (1 − s)²).
            const double slopes = alphas.x * alphas.y * std::numbers::pi / ((1.0 - s) * (1.0 - s)) / (steps * steps);
            work(h, h.z * h.z * h.z * slopes);
        }
}

} // namespace facet_rule
