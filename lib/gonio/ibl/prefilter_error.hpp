// The error of prefiltered levels as they are stored, against quadrature.
#pragma once

#include <gonio/ibl/prefilter.hpp>

#include <span>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// The error of one level against quadrature.
struct PrefilterError {
    double mean_nt = 0.0; // luminance of the level at the texels that were checked
    double rms = 0.0;     // of all channels, relative to that mean; 0 for black
    double greatest = 0.0;
    int texels = 0; // how many were checked: 0 for a level of roughness 0, which is no lobe
};

// Of at most `per_level` texels of each level, spread over its picture, in one pass over the source
// (prefiltered_by_quadrature()). 0 threads: all.
std::vector<PrefilterError> prefilter_errors(const EnvironmentMap& source, std::span<const PrefilteredLevel> levels,
                                             int per_level, unsigned threads = 0);

} // namespace gonio
#pragma GCC visibility pop
