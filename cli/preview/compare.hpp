// `gonio preview --compare`: the same lights by several methods, and how far each method is from the first.
#pragma once

#include <gonio/base/result.hpp>

#include "../arguments.hpp"
#include "../console.hpp"

namespace gonio::cli {

// A sheet with a row for each method after the first: the first method, that method, and the signed difference in
// colour; or an OpenEXR file with a layer for each method and for each difference. The figures are printed, in words or
// as JSON. Differences are in luminance in cd/m², only where no light itself is visible. Returns the exit status.
Result<int> preview_compare(const Arguments& arguments, Console& console);

} // namespace gonio::cli
