#include <gonio/measure/timing.hpp>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

namespace gonio::measure {

namespace {

double sample_seconds(const std::function<void()>& work, std::size_t calls, const Clock& clock) {
    const double begin = clock();
    for (std::size_t i = 0; i < calls; ++i)
        work();
    return clock() - begin;
}

double seconds_of(clockid_t clock) {
    std::timespec now{};
    (void)clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

} // namespace

Clock steady_clock() {
    return [] { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); };
}

Clock thread_clock() {
    return [] { return seconds_of(CLOCK_THREAD_CPUTIME_ID); };
}

Clock process_clock() {
    return [] { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); };
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

namespace {

// The number of calls of `work` that take `wanted` seconds; 0 if most_calls calls take less. Doubling also warms up.
std::size_t calls_of(const std::function<void()>& work, double wanted, std::size_t most_calls, const Clock& clock) {
    std::size_t calls = 1;
    while (sample_seconds(work, calls, clock) < wanted) {
        if (calls >= most_calls) return 0;
        calls = std::min(calls * 2, most_calls);
    }
    return calls;
}

double median_of_sorted(const std::vector<double>& sorted) {
    const std::size_t middle = sorted.size() / 2;
    return sorted.size() % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2.0;
}

Timing summary(std::vector<double> ns, std::size_t calls) {
    std::sort(ns.begin(), ns.end());
    return {median_of_sorted(ns), ns.front(), ns.back(), ns.size(), calls};
}

// The least duration of a sample: one step of the clock is then at most 0.1 % of it.
Result<double> wanted_seconds(const TimingOptions& options, const Clock& clock) {
    const double step = resolution(clock);
    if (!(step > 0.0)) return fail(Failure::unsupported, "the clock does not advance");
    return std::max(options.sample_seconds, 1000.0 * step);
}

} // namespace

Result<Timing> time_work(const std::function<void()>& work, std::size_t items, const TimingOptions& options,
                         const Clock& clock) {
    const TimedWork one{work, items};
    Result<std::vector<std::optional<RelativeTiming>>> timings = time_in_turn({&one, 1}, 0, options, clock);
    if (!timings) return pass_on(timings);
    if (!timings->front())
        return fail(Failure::unsupported, "the work is too short for the clock",
                    "pass more items per call, or allow more calls per sample");
    return timings->front()->timing;
}

Result<std::vector<std::optional<RelativeTiming>>> time_in_turn(std::span<const TimedWork> works, std::size_t baseline,
                                                                const TimingOptions& options, const Clock& clock,
                                                                const std::function<bool()>& stop) {
    const bool empty = std::any_of(works.begin(), works.end(), [](const TimedWork& work) { return work.items == 0; });
    if (empty || options.samples == 0 || baseline >= works.size())
        return fail("USE0104", "timing needs at least one item and one sample");
    const Result<double> wanted = wanted_seconds(options, clock);
    if (!wanted) return Unexpected(wanted.error());
    const auto stopped = [&] { return stop && stop(); };

    std::vector<std::size_t> calls;
    std::vector<std::vector<double>> ns(works.size());
    for (const TimedWork& work : works) {
        if (stopped()) return fail(Failure::usage, "the timing was stopped");
        calls.push_back(calls_of(work.work, *wanted, options.max_calls_per_sample, clock));
    }
    for (std::size_t round = 0; round < options.samples; ++round)
        for (std::size_t i = 0; i < works.size(); ++i) {
            if (stopped()) return fail(Failure::usage, "the timing was stopped");
            if (calls[i] == 0) continue;
            const double per_item = 1e9 / (static_cast<double>(calls[i]) * static_cast<double>(works[i].items));
            ns[i].push_back(sample_seconds(works[i].work, calls[i], clock) * per_item);
        }

    std::vector<std::optional<RelativeTiming>> timings(works.size());
    for (std::size_t i = 0; i < works.size(); ++i) {
        if (calls[i] == 0 || calls[baseline] == 0) continue;
        std::vector<double> ratios;
        for (std::size_t round = 0; round < options.samples; ++round)
            ratios.push_back(ns[i][round] / ns[baseline][round]);
        std::sort(ratios.begin(), ratios.end());
        timings[i] = RelativeTiming{summary(ns[i], calls[i]), median_of_sorted(ratios)};
    }
    return timings;
}

} // namespace gonio::measure
