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
    double line(std::size_t index) const { return lines_[index]; }
    // The value at a share of an interval: 2.5 is the middle of the third.
    double at(double interval) const {
        const auto whole = static_cast<std::uint32_t>(std::clamp(interval, 0.0, static_cast<double>(last_)));
        return lines_[whole] + (interval - whole) * (lines_[whole + 1] - lines_[whole]);
    }

    // Where in an interval a value lies: 0 and 1 are its lines.
    double share(std::size_t interval, double x) const { return (x - lines_[interval]) * per_width_[interval]; }

    // The interval that contains `x`, or the one at that end; any one for NaN.
    std::uint32_t index(double x) const {
        const double bucket = std::min(std::max(0.0, (x - low_) * per_), last_bucket_); // 0 for NaN
        std::uint32_t found = first_[static_cast<std::size_t>(bucket)];
        found += x >= ends_[found] ? 1U : 0U;
        while (is_crowded_ && x >= ends_[found])
            ++found;
        return found;
    }

    // The same for many values, and in which of `parts` equal parts of the interval it lies.
    static constexpr std::uint32_t parts = 16;
    struct Spot {
        std::uint32_t interval, part;
    };
    Spot spot(float x) const {
        const std::uint32_t found = fast_index(x);
        const Step& step = steps_[found];
        const float part = (std::min(std::max(step.begin, x), step.last) - step.begin) * step.per;
        return {found, static_cast<std::uint32_t>(static_cast<std::int32_t>(part))};
    }

    // Between the middles of two intervals: the one that contains x, and the one beside it with its share, 0 at the
    // ends of an axis that does not go round.
    struct Between {
        std::uint32_t in, beside;
        float share;
    };
    Between between(float x, bool goes_round) const {
        const std::uint32_t in = fast_index(x);
        const Middle& middle = middles_[in];
        const std::uint32_t above = x >= middle.at ? 1U : 0U; // at random, so without a branch
        const float share = std::min((x - middle.at) * middle.to_beside[above], 1.0F);
        const std::uint32_t beside = in + 2U * above - 1U;
        if (beside <= last_) return {in, beside, share};
        return {in, goes_round ? last_ - in : in, goes_round ? share : 0.0F};
    }

private:
    std::uint32_t fast_index(float x) const {
        const float bucket = std::min(std::max(0.0F, (x - fast_.low) * fast_.per), fast_.last_bucket); // 0 for NaN
        std::uint32_t found = first_[static_cast<std::size_t>(static_cast<std::int32_t>(bucket))];
        found += x >= steps_[found].end ? 1U : 0U;
        while (is_crowded_ && x >= steps_[found].end)
            ++found;
        return found;
    }

    std::vector<double> lines_{0.0, 1.0};
    std::vector<double> per_width_{1.0};                                // of the intervals
    std::vector<double> ends_{std::numeric_limits<double>::infinity()}; // of the intervals; the last has none
    // The interval in which each of many equal parts of the range begins.
    std::vector<std::uint16_t> first_{0};
    double low_ = 0.0, per_ = 1.0, last_bucket_ = 0.0;
    std::uint32_t last_ = 0;
    // Of the intervals, for spot(): `per` times the distance from the beginning is a part; `last` lies in the last one.
    struct Step {
        float end, begin, last, per;
    };
    std::vector<Step> steps_{{std::numeric_limits<float>::infinity(), 0.0F, 1.0F, static_cast<float>(parts)}};
    // For between(): one over the distances to the middles beside it, negative to the last one. Those at the ends are
    // beside each other.
    struct Middle {
        float at;
        float to_beside[2];
    };
    std::vector<Middle> middles_{{0.5F, {-1.0F, 1.0F}}};
    struct Fast {
        float low = 0.0F, per = 1.0F, last_bucket = 0.0F;
    };
    Fast fast_;
    bool is_crowded_ = false; // more than one line in a bucket
};

} // namespace gonio::detail
