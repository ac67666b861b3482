// The errors of values against the truth.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace gonio::measure {

struct Spread {
    double median = 0.0;
    double p95 = 0.0; // 95 % of the errors are not larger
    double max = 0.0;
    std::size_t count = 0;
};

struct ErrorStatistics {
    Spread absolute;
    Spread relative; // over the values whose truth is above the floor only
};

// Order statistics of `errors`, by nearest rank. A NaN counts as infinite. Of nothing: zeros.
Spread spread_of(std::span<const double> errors);

// |value − truth|/truth of each value whose truth is above the floor. Both spans of one length.
std::vector<double> relative_errors(std::span<const double> values, std::span<const double> truth,
                                    double relative_floor);

// |value − truth| and |value − truth|/truth, the latter where truth > `relative_floor`. Both spans of one length.
ErrorStatistics compare(std::span<const double> values, std::span<const double> truth, double relative_floor);

} // namespace gonio::measure
