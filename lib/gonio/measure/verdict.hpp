// The result of a comparison for its default method: whether it is on the front, and at what price other methods are
// cheaper or closer to the truth.
#pragma once

#include <gonio/measure/contest.hpp>

#include <optional>
#include <string>
#include <vector>

namespace gonio::measure {

struct Rival {
    // cheaper: its fastest row takes less time than the standard's fastest, by more than the timing noise (5 %).
    // closer: not cheaper, and some row has a smaller median error than all of the standard's. dominated: neither.
    enum class Standing { dominated, cheaper, closer };

    std::string method;
    Standing standing = Standing::dominated;
    double times_as_fast = 1.0; // fastest row to fastest row
    double error_median = 0.0;  // of its fastest row, or of its closest row if it is closer
    double error_p95 = 0.0;
};

struct Verdict {
    std::string standard;
    bool on_front = false; // for one of its rows, no other method has as small an error in 5 % less time
    std::vector<Rival> rivals;
};

// Empty if the comparison has no standard, or if none of the standard's rows was timed. Rivals without a timed row and
// without a value are left out.
std::optional<Verdict> verdict_of(const Standings& standings);

} // namespace gonio::measure
