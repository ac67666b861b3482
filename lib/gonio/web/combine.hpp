// Several luminaires as one.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/web/web.hpp>

#include <span>

namespace gonio {

struct WeightedWeb {
    const Web* web;
    double weight; // ≥ 0
};

// Σ weightᵢ · webᵢ, with aims and C0 aligned. Exact on the union of all grids; where a table ends at a non-zero value,
// the sum has a ramp 0.0001° wide. Symmetry is that of the sum. Webs of types A and B are resampled to type C first,
// unless all webs are of the same type; `max_error_cd` is the greatest resampling error in any direction [cd]. Fails
// (usage) without webs.
struct CombinedWeb {
    Web web;
    double max_error_cd = 0.0;
};

Result<CombinedWeb> combined(std::span<const WeightedWeb> webs);

} // namespace gonio
