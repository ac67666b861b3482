// How long a piece of work takes: warmed up, repeated, the median taken, and an error if the clock cannot resolve it.
#pragma once

#include <gonio/base/result.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

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

// Seconds by a clock that never goes back. A test can pass its own clock.
using Clock = std::function<double()>;
Clock steady_clock();
// The processor time of the calling thread, which excludes time taken by other programs. For work that uses no other
// threads.
Clock thread_clock();

// The processor time of all threads of the process together.
Clock process_clock();

// The smallest step observed of `clock` [s]; 0 if it stands still.
double resolution(const Clock& clock);

// Runs `work`, which handles `items` items (> 0) per call. Fails (usage) for no items or samples, and (unsupported) if
// a sample of max_calls_per_sample calls does not take at least 1000 times the clock's resolution, so that one step of
// the clock is at most 0.1 % of the reported time.
Result<Timing> time_work(const std::function<void()>& work, std::size_t items, const TimingOptions& options = {},
                         const Clock& clock = thread_clock());

struct TimedWork {
    std::function<void()> work;
    std::size_t items = 0; // per call
};

struct RelativeTiming {
    Timing timing;
    double ratio = 0.0; // median over the rounds of this work's time over the baseline's time in the same round
};

// Times several works in turn, one sample of each per round, so that anything that slows the machine down slows all of
// them alike and the ratios hold where the times do not. An entry is empty if the clock cannot resolve the work (for
// which time_work would fail) or the baseline. `stop` is called between samples; a stop before the end fails (usage).
// Fails as time_work does on options and on a clock that stands still.
Result<std::vector<std::optional<RelativeTiming>>> time_in_turn(std::span<const TimedWork> works, std::size_t baseline,
                                                                const TimingOptions& options = {},
                                                                const Clock& clock = thread_clock(),
                                                                const std::function<bool()>& stop = {});

} // namespace gonio::measure
