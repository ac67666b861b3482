// Means of a web around the vertical.
#pragma once

#include <gonio/web/web.hpp>

#include <span>
#include <vector>

namespace gonio {

// The mean over C of the intensity at each γ [cd]: exact for type C, of 720 directions for types A and B. Where there
// is no plane, there is no light.
std::vector<double> mean_candela(const Web& web, std::span<const double> gammas_deg);

} // namespace gonio
