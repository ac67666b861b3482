#include <gonio/measure/timing.hpp>

#include <algorithm>
#include <chrono>
#include <vector>

namespace gonio::measure {

namespace {

double sample_seconds(const std::function<void()>& work, std::size_t calls, const Clock& clock) {
    const double begin = clock();
    for (std::size_t i = 0; i < calls; ++i)
        work();
    return clock() - begin;
}

} // namespace

Clock steady_clock() {
    return [] { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); };
}

double resolution(const Clock& clock) {
    constexpr int wanted_steps = 20;
    constexpr int patience = 1 << 20;
    double least = 0.0;
    int steps = 0;
    double last = clock();
    for (int i = 0; i < patience && steps < wanted_steps; ++i) {
        const double now = clock();
        if (now > last) {
            least = steps == 0 ? now - last : std::min(least, now - last);
            ++steps;
            last = now;
        }
    }
    return least;
}

Result<Timing> time_work(const std::function<void()>& work, std::size_t items, const TimingOptions& options,
                         const Clock& clock) {
    if (items == 0 || options.samples == 0)
        return fail(Failure::usage, "timing needs at least one item and one sample");
    const double step = resolution(clock);
    if (!(step > 0.0)) return fail(Failure::unsupported, "the clock stands still");

    // Doubling until a sample is long enough is the warm-up too.
    const double wanted = std::max(options.sample_seconds, 1000.0 * step);
    std::size_t calls = 1;
    while (sample_seconds(work, calls, clock) < wanted) {
        if (calls >= options.max_calls_per_sample)
            return fail(Failure::unsupported, "the work is too short for the clock",
                        "hand in more items per call, or allow more calls per sample");
        calls = std::min(calls * 2, options.max_calls_per_sample);
    }

    std::vector<double> ns;
    const double per_item = 1e9 / (static_cast<double>(calls) * static_cast<double>(items));
    for (std::size_t i = 0; i < options.samples; ++i)
        ns.push_back(sample_seconds(work, calls, clock) * per_item);
    std::sort(ns.begin(), ns.end());
    const std::size_t middle = ns.size() / 2;
    const double median = ns.size() % 2 == 1 ? ns[middle] : (ns[middle - 1] + ns[middle]) / 2.0;
    return Timing{median, ns.front(), ns.back(), ns.size(), calls};
}

} // namespace gonio::measure
