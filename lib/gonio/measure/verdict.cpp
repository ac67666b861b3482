#include <gonio/measure/verdict.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gonio::measure {

namespace {

bool counts(const Standing& row) {
    return row.time && std::isfinite(row.error.median);
}

// The rows of one method that are fastest and closest to the truth; empty if no row counts.
struct Best {
    const Standing* fastest = nullptr;
    const Standing* closest = nullptr;
};
Best best_of(const std::vector<Standing>& rows, const std::string& method) {
    Best best;
    for (const Standing& row : rows) {
        if (row.method != method || !counts(row)) continue;
        if (!best.fastest || row.time->timing.lowest_ns < best.fastest->time->timing.lowest_ns) best.fastest = &row;
        if (!best.closest || row.error.median < best.closest->error.median) best.closest = &row;
    }
    return best;
}

// Two timings of the same work differ by less than this factor.
constexpr double told_apart = 1.05;

bool clearly_beats(const Standing& a, const Standing& b) {
    return counts(a) && counts(b) && a.error.median <= b.error.median &&
           a.time->timing.lowest_ns * told_apart < b.time->timing.lowest_ns;
}

} // namespace

std::optional<Verdict> verdict_of(const Standings& standings) {
    const std::vector<Standing>& rows = standings.rows;
    const std::string& standard = standings.title.standard;
    const Best own = standard.empty() ? Best{} : best_of(rows, standard);
    if (!own.fastest) return std::nullopt;
    Verdict verdict{standard, false, {}};
    for (const Standing& row : rows) {
        if (row.method == standard) {
            const bool beaten = std::any_of(rows.begin(), rows.end(), [&](const Standing& other) {
                return other.method != standard && clearly_beats(other, row);
            });
            verdict.on_front = verdict.on_front || (counts(row) && !beaten);
            continue;
        }
        const bool seen = std::any_of(verdict.rivals.begin(), verdict.rivals.end(),
                                      [&](const Rival& rival) { return rival.method == row.method; });
        const Best other = best_of(rows, row.method);
        if (seen || !other.fastest) continue;
        const double times_as_fast = own.fastest->time->timing.lowest_ns / other.fastest->time->timing.lowest_ns;
        using enum Rival::Standing;
        const auto how = times_as_fast > told_apart                                ? cheaper
                         : other.closest->error.median < own.closest->error.median ? closer
                                                                                   : dominated;
        const Standing& told = how == closer ? *other.closest : *other.fastest;
        verdict.rivals.push_back({row.method, how, times_as_fast, told.error.median, told.error.p95});
    }
    return verdict;
}

} // namespace gonio::measure
