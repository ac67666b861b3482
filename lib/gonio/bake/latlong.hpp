// The means of latitude-longitude texels of a type C web, in closed form: the interpolant is a sum of products of a
// piecewise linear function of C and one of γ, so a mean is a product of two weights, and the integral over the texels
// is the web's flux at every size, to rounding. Cost: O(planes × H + W × H).
#pragma once

#include <gonio/web/separable.hpp>
#include <gonio/web/web.hpp>

#include <span>
#include <vector>

namespace gonio {

class LatlongMeans {
public:
    // Column i of `width` covers C in [i, i+1]/width·360°. `web` is of type C and outlives this.
    LatlongMeans(const Web& web, int width);

    // The mean intensity [cd] of each texel of the row that covers γ in [low, high]; `out` holds `width` values.
    void row(double low_deg, double high_deg, std::span<double> out) const;

private:
    const Web& web_;
    std::vector<Terms> columns_; // per texel column
};

} // namespace gonio
