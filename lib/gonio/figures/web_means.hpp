// Means of a web around the vertical.
#pragma once

#include <gonio/web/web.hpp>

#include <vector>

namespace gonio {

// The mean over C of the intensity at any γ: exact for type C, of 720 directions for types A and B.
class MeanIntensity {
public:
    explicit MeanIntensity(const Web& web); // must outlive it

    double candela(double gamma_deg) const;

private:
    const Web& web_;
    std::vector<double> c_deg_;
    std::vector<double> weight_; // sum of 1, less where there is no plane
};

} // namespace gonio
