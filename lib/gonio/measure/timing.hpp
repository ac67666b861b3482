// How long a piece of work takes: warmed up, repeated, the median taken, and refused where the clock cannot tell.
#pragma once

#include <gonio/base/result.hpp>

#include <cstddef>
#include <functional>

namespace gonio::measure {

struct Timing {
    double ns_per_item = 0.0; // median over the samples
    double lowest_ns = 0.0;   // of all samples, per item
    double highest_ns = 0.0;
    std::size_t samples = 0;
    std::size_t calls_per_sample = 0;
};

struct TimingOptions {
    std::size_t samples = 11;
    double sample_seconds = 0.01; // each sample lasts at least this long
    std::size_t max_calls_per_sample = std::size_t{1} << 24U;
};

// Seconds by a clock that never goes back. A test hands in its own.
using Clock = std::function<double()>;
Clock steady_clock();

// The smallest step that `clock` was seen to make [s]; 0 where it stands still.
double resolution(const Clock& clock);

// Runs `work`, which handles `items` items (> 0) per call. Fails (usage) for no items or samples, and (unsupported)
// where a sample of max_calls_per_sample calls is not at least 1000 times the clock's resolution, so that one step of
// the clock is at most 0.1 % of what is reported.
Result<Timing> time_work(const std::function<void()>& work, std::size_t items, const TimingOptions& options = {},
                         const Clock& clock = steady_clock());

} // namespace gonio::measure
