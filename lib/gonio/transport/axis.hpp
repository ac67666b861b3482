// The lines that divide one coordinate of a chart.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace gonio::detail {

class Axis {
public:
    Axis() = default;
    // At least two lines, strictly increasing.
    explicit Axis(std::vector<double> lines);

    std::uint32_t intervals() const { return last_ + 1; }
    bool has(const std::vector<double>& lines) const { return lines_ == lines; }
    double line(std::size_t index) const { return lines_[index]; }
    // The value at a share of an interval: 2.5 is the middle of the third.
    double at(double interval) const {
        const auto whole = static_cast<std::uint32_t>(std::clamp(interval, 0.0, static_cast<double>(last_)));
        return lines_[whole] + (interval - whole) * (lines_[whole + 1] - lines_[whole]);
    }

    // The interval that contains `x`, or the one at that end; any one for NaN.
    std::uint32_t index(double x) const {
        const double bucket = std::min(std::max(0.0, (x - low_) * per_), last_bucket_); // 0 for NaN
        std::uint32_t found = first_[static_cast<std::size_t>(bucket)];
        found += x >= ends_[found] ? 1U : 0U;
        while (is_crowded_ && x >= ends_[found])
            ++found;
        return found;
    }

private:
    std::vector<double> lines_{0.0, 1.0};
    std::vector<double> ends_{std::numeric_limits<double>::infinity()}; // of the intervals; the last has none
    // The interval in which each of many equal parts of the range begins.
    std::vector<std::uint16_t> first_{0};
    double low_ = 0.0, per_ = 1.0, last_bucket_ = 0.0;
    std::uint32_t last_ = 0;
    bool is_crowded_ = false; // more than one line in a bucket
};

} // namespace gonio::detail
