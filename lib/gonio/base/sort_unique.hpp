// Lists of angles: ascending, each once.
#pragma once

#include <algorithm>
#include <vector>

namespace gonio {

// Sorts, and keeps one of equal values. No NaN.
inline void sort_unique(std::vector<double>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

} // namespace gonio
