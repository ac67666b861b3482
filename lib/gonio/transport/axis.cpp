#include <gonio/transport/axis.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gonio::detail {

Axis::Axis(std::vector<double> lines)
    : lines_(std::move(lines)), low_(lines_.front()), last_(static_cast<std::uint32_t>(lines_.size()) - 2) {
    const double length = lines_.back() - low_;
    double narrowest = length;
    for (std::size_t i = 0; i + 1 < lines_.size(); ++i)
        narrowest = std::min(narrowest, lines_[i + 1] - lines_[i]);
    constexpr double most = 4096.0;
    // Half as wide as the narrowest interval, so that no two lines share one.
    const double buckets = std::clamp(std::ceil(2.0 * length / narrowest), 1.0, most);
    per_ = buckets / length;
    last_bucket_ = buckets - 1.0;
    first_.resize(static_cast<std::size_t>(buckets));
    ends_.assign(lines_.begin() + 1, lines_.end());
    ends_.back() = std::numeric_limits<double>::infinity();
    std::uint32_t interval = 0;
    for (std::size_t bucket = 0; bucket < first_.size(); ++bucket) {
        // A little earlier, in case the division rounds a value into the next bucket.
        const double begin = low_ + (static_cast<double>(bucket) - 1e-6) / per_;
        const std::uint32_t before = interval;
        while (ends_[interval] <= begin)
            ++interval;
        is_crowded_ = is_crowded_ || interval > before + 1;
        first_[bucket] = static_cast<std::uint16_t>(interval);
    }
    is_crowded_ = is_crowded_ || last_ > first_.back() + 1U;
    steps_.clear();
    per_width_.clear();
    for (std::size_t i = 0; i + 1 < lines_.size(); ++i)
        per_width_.push_back(1.0 / (lines_[i + 1] - lines_[i]));
    for (std::size_t i = 0; i + 1 < lines_.size(); ++i)
        steps_.push_back({static_cast<float>(ends_[i]), static_cast<float>(lines_[i]),
                          static_cast<float>(at(static_cast<double>(i) + 1.0 - 0.5 / parts)),
                          static_cast<float>(parts / (lines_[i + 1] - lines_[i]))});
    middles_.clear();
    const auto width = [&](std::size_t i) { return lines_[i + 1] - lines_[i]; };
    const std::size_t count = lines_.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
        const double to_last = 2.0 / (width(i) + width(i > 0 ? i - 1 : count - 1));
        const double to_next = 2.0 / (width(i) + width(i + 1 < count ? i + 1 : 0));
        middles_.push_back({static_cast<float>(at(static_cast<double>(i) + 0.5)),
                            {static_cast<float>(-to_last), static_cast<float>(to_next)}});
    }
    fast_ = {static_cast<float>(low_), static_cast<float>(per_), static_cast<float>(last_bucket_)};
}

} // namespace gonio::detail
