// A comparison of several methods on the same cases: errors against the truth, and times taken in the same rounds.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/measure/error_statistics.hpp>
#include <gonio/measure/method.hpp>
#include <gonio/measure/timing.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gonio::measure {

// What is measured, in words.
struct ContestTitle {
    std::string suite;  // "irradiance"
    std::string cases;  // "disk"
    std::string subset; // "straddling"; "all"
    std::string error;  // "relative to E/L"
    std::string item;   // what a time is per: "receiver"
    std::string truth;  // the source of the truth
    // The default method; empty if there is none.
    std::string standard{};
};

struct Contestant {
    std::string method; // "frostbite"
    std::string code;   // "double", "float", or an instruction set: "avx2"
    TimedWork timed;
    // One error per case; NaN or infinite where the method gives no number.
    std::function<std::vector<double>()> errors;
};

struct Contest {
    ContestTitle title;
    std::size_t baseline = 0; // index of the contestant that the time ratios refer to
    std::vector<Contestant> contestants;
};

struct Standing {
    std::string method;
    std::string code;
    Spread error;
    std::optional<RelativeTiming> time; // empty if the clock cannot resolve it
    bool on_front = false;              // no other method beats it in both median error and least time
};

struct Standings {
    ContestTitle title;
    std::size_t baseline = 0;
    std::vector<Standing> rows; // in the order of the contestants
};

// Measures errors and times. Fails as time_in_turn does.
Result<Standings> hold(const Contest& contest, const TimingOptions& options, const Clock& clock = thread_clock(),
                       const std::function<bool()>& stop = {});

// Removes the contestants whose method is not among `methods`, except the baseline.
void keep_only(Contest& contest, const std::vector<std::string>& methods);

// The comparison of `methods` on `cases`, with errors relative to `truth` where that is above `relative_floor`.
template<class Cases>
Contest contest_of(ContestTitle title, const std::vector<Method<Cases>>& methods, std::size_t baseline, Cases cases,
                   std::vector<double> truth, double relative_floor) {
    const auto shared = std::make_shared<const Cases>(std::move(cases));
    const auto known = std::make_shared<const std::vector<double>>(std::move(truth));
    Contest contest{std::move(title), baseline, {}};
    for (const Method<Cases>& method : methods) {
        const auto single = std::make_shared<std::vector<float>>(method.evaluate ? shared->size() : 0);
        const auto wide = std::make_shared<std::vector<double>>(method.evaluate ? 0 : shared->size());
        const auto work = [method, shared, single, wide] {
            if (method.evaluate_double) {
                method.evaluate_double(*shared, *wide);
            } else {
                method.evaluate(*shared, *single);
            }
        };
        const auto errors = [method, shared, known, relative_floor] {
            return relative_errors(evaluated(method, *shared), *known, relative_floor);
        };
        contest.contestants.push_back({method.name, method.precision, {work, shared->size()}, errors});
    }
    return contest;
}

} // namespace gonio::measure
