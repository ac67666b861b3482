#include <gonio/measure/error_statistics.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace gonio::measure {

Spread spread_of(std::span<const double> errors) {
    if (errors.empty()) return {};
    std::vector<double> sorted(errors.begin(), errors.end());
    for (double& error : sorted)
        if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
    std::sort(sorted.begin(), sorted.end());
    // Nearest rank: the smallest value that is not below that share of all values.
    const auto rank = [&](std::size_t percent) { return sorted[(percent * sorted.size() + 99) / 100 - 1]; };
    return {rank(50), rank(95), sorted.back(), sorted.size()};
}

std::vector<double> relative_errors(std::span<const double> values, std::span<const double> truth,
                                    double relative_floor) {
    std::vector<double> relative;
    for (std::size_t i = 0; i < std::min(values.size(), truth.size()); ++i)
        if (truth[i] > relative_floor) relative.push_back(std::fabs(values[i] - truth[i]) / truth[i]);
    return relative;
}

ErrorStatistics compare(std::span<const double> values, std::span<const double> truth, double relative_floor) {
    std::vector<double> absolute;
    for (std::size_t i = 0; i < std::min(values.size(), truth.size()); ++i)
        absolute.push_back(std::fabs(values[i] - truth[i]));
    return {spread_of(absolute), spread_of(relative_errors(values, truth, relative_floor))};
}

} // namespace gonio::measure
