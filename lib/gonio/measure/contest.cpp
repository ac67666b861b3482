#include <gonio/measure/contest.hpp>
#include <gonio/measure/pareto.hpp>

#include <algorithm>
#include <limits>

namespace gonio::measure {

Result<Standings> hold(const Contest& contest, const TimingOptions& options, const Clock& clock,
                       const std::function<bool()>& stop) {
    std::vector<TimedWork> works;
    for (const Contestant& contestant : contest.contestants)
        works.push_back(contestant.timed);
    Result<std::vector<std::optional<RelativeTiming>>> times =
        time_in_turn(works, contest.baseline, options, clock, stop);
    if (!times) return pass_on(times);

    Standings standings{contest.title, contest.baseline, {}};
    std::vector<ErrorAndTime> points;
    for (std::size_t i = 0; i < works.size(); ++i) {
        const Contestant& contestant = contest.contestants[i];
        const std::optional<RelativeTiming>& time = (*times)[i];
        standings.rows.push_back({contestant.method, contestant.code, spread_of(contestant.errors()), time, false});
        // The least time: other programs on the machine can only add time.
        points.push_back({standings.rows.back().error.median,
                          time ? time->timing.lowest_ns : std::numeric_limits<double>::infinity()});
    }
    const std::vector<bool> front = pareto_front(points);
    for (std::size_t i = 0; i < front.size(); ++i)
        standings.rows[i].on_front = front[i];
    return standings;
}

void keep_only(Contest& contest, const std::vector<std::string>& methods) {
    std::vector<Contestant> kept;
    std::size_t baseline = 0;
    for (std::size_t i = 0; i < contest.contestants.size(); ++i) {
        const bool named = std::find(methods.begin(), methods.end(), contest.contestants[i].method) != methods.end();
        if (i == contest.baseline) baseline = kept.size();
        if (named || i == contest.baseline) kept.push_back(std::move(contest.contestants[i]));
    }
    contest.contestants = std::move(kept);
    contest.baseline = baseline;
}

} // namespace gonio::measure
