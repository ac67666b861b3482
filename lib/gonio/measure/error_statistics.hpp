// The errors of values against the truth.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace gonio::measure {

struct Spread {
    double median = 0.0;
    double p95 = 0.0; // 95 % of the errors are at most this
    double max = 0.0;
    std::size_t count = 0;
};

struct ErrorStatistics {
    Spread absolute;
    Spread relative; // only over the values where the truth is above the floor
};

// Order statistics of `errors`, by nearest rank. A NaN counts as infinite. Zeros for an empty span.
Spread spread_of(std::span<const double> errors);

// |value − truth|/truth of each value where the truth is above the floor. Both spans must have the same length.
std::vector<double> relative_errors(std::span<const double> values, std::span<const double> truth,
                                    double relative_floor);

// |value − truth| and |value − truth|/truth, the latter where truth > `relative_floor`. Both spans must have the same
// length.
ErrorStatistics compare(std::span<const double> values, std::span<const double> truth, double relative_floor);

} // namespace gonio::measure
