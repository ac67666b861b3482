// `gonio preview --compare`: the same lights by several methods, and how far each is from the first.
#pragma once

#include <gonio/base/result.hpp>

#include "../arguments.hpp"
#include "../console.hpp"

namespace gonio::cli {

// A sheet with a row for each method after the first: the first, that one, and its signed difference by colour; or an
// OpenEXR file with a layer for each method and for each difference. The figures are printed, in words or as JSON.
// Differences are of luminance in cd/m², where no light itself is seen. Returns the exit status.
Result<int> preview_compare(const Arguments& arguments, Console& console);

} // namespace gonio::cli
