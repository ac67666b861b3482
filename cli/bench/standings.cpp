#include "standings.hpp"

#include <gonio/base/unit_text.hpp>
#include <gonio/measure/verdict.hpp>
#include <gonio/plot/log_log.hpp>

#include "../csv_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

using measure::Standing;
using measure::Standings;

std::string error_text(double error) {
    if (error == 0.0) return "0";
    return std::isfinite(error) ? fmt::format("{:.1e}", error) : "no value";
}

// Three digits: no clock and no machine is more repeatable than that.
std::string ns_text(const Standing& row) {
    return row.time ? rounded(row.time->timing.lowest_ns, 3) : "unresolved";
}

std::string ratio_text(const Standing& row) {
    return row.time ? rounded(row.time->ratio, 3) : "unresolved";
}

std::string title_text(const Standings& standings) {
    const measure::ContestTitle& title = standings.title;
    const std::string subset = title.subset == "all" ? std::string() : ", " + title.subset;
    return fmt::format("{}: {}{}", title.suite, title.cases, subset);
}

std::string says_text(const Standings& standings) {
    const measure::ContestTitle& title = standings.title;
    const Standing& baseline = standings.rows[standings.baseline];
    std::size_t values = 0;
    for (const Standing& row : standings.rows)
        values = std::max(values, row.error.count);
    return fmt::format("error {}, over {} values, against {}; time per {}, ratio to {} {}", title.error, values,
                       title.truth, title.item, baseline.method, baseline.code);
}

Mark mark_of(std::string_view code) {
    if (code == "double") return Mark::square;
    return code == "float" || code == "scalar" ? Mark::circle : Mark::triangle;
}

LogLogPanel panel_of(const Standings& standings) {
    LogLogPanel panel{title_text(standings),
                      fmt::format("time [ns] of one {}", standings.title.item),
                      "median error, " + standings.title.error,
                      {},
                      {}};
    for (const Standing& row : standings.rows) {
        if (!row.time) continue;
        auto series = std::find_if(panel.series.begin(), panel.series.end(),
                                   [&](const MarkedSeries& one) { return one.name == row.method; });
        if (series == panel.series.end()) series = panel.series.insert(series, {row.method, {}, false});
        MarkedPoint point{row.time->timing.lowest_ns, row.error.median, mark_of(row.code), row.on_front, {}};
        if (row.on_front) {
            // Among points of one method with similar error, only the fastest is labelled.
            const bool another = std::any_of(standings.rows.begin(), standings.rows.end(), [&](const Standing& other) {
                return other.method == row.method && other.on_front && other.time &&
                       other.time->timing.lowest_ns < row.time->timing.lowest_ns &&
                       other.error.median <= 2.0 * row.error.median;
            });
            if (!another) point.label = fmt::format("{} {}", row.method, row.code);
            panel.front.push_back(point);
        }
        series->points.push_back(std::move(point));
    }
    std::sort(panel.front.begin(), panel.front.end(),
              [](const MarkedPoint& a, const MarkedPoint& b) { return a.x < b.x; });
    return panel;
}

} // namespace

std::string run_text(const BenchRun& run) {
    return fmt::format("gonio {} ({}; {}{}{}) on {}, {} thread{}, {}; seed {}{}", run.build.version, commit,
                       run.build.compiler, run.build.optimized ? ", optimised" : ", not optimised",
                       run.build.checked ? ", with sanitizers" : "", run.machine.processor, run.machine.threads,
                       run.machine.threads == 1 ? "" : "s", run.machine.widest, run.seed, run.quick ? ", quick" : "");
}

std::string standings_text(const Standings& standings) {
    std::string text = fmt::format("{}\n  {}\n", title_text(standings), says_text(standings));
    std::size_t method = 6;
    std::size_t code = 4;
    for (const Standing& row : standings.rows) {
        method = std::max(method, row.method.size());
        code = std::max(code, row.code.size());
    }
    const auto line = [&](std::string_view mark, const std::array<std::string, 7>& cells) {
        text += fmt::format("{:1} {:<{}}  {:<{}}  {:>9}  {:>9}  {:>9}  {:>10}  {:>10}\n", mark, cells[0], method,
                            cells[1], code, cells[2], cells[3], cells[4], cells[5], cells[6]);
    };
    line("", {"method", "code", "median", "95 % below", "worst", "ns", "ratio"});
    for (const Standing& row : standings.rows)
        line(row.on_front ? "*" : "", {row.method, row.code, error_text(row.error.median), error_text(row.error.p95),
                                       error_text(row.error.max), ns_text(row), ratio_text(row)});
    if (const std::string verdict = verdict_text(standings); !verdict.empty()) text += fmt::format("  {}\n", verdict);
    return text;
}

std::string verdict_text(const Standings& standings) {
    const std::optional<measure::Verdict> verdict = measure::verdict_of(standings);
    if (!verdict) return {};
    std::string text =
        fmt::format("default: {}, {}", verdict->standard, verdict->on_front ? "on the front" : "not on the front");
    using enum measure::Rival::Standing;
    for (const auto& [how, name] : {std::pair{cheaper, "cheaper"}, {closer, "closer"}, {dominated, "dominated"}}) {
        std::string list;
        for (const measure::Rival& rival : verdict->rivals) {
            if (rival.standing != how) continue;
            list += list.empty() ? fmt::format("; {}: ", name) : ", ";
            list += rival.method;
            if (how == cheaper) list += fmt::format(" {} times as fast", rounded(rival.times_as_fast, 2));
            if (how == closer) list += fmt::format(" in {} times the time", rounded(1.0 / rival.times_as_fast, 2));
            if (how != dominated)
                list +=
                    fmt::format(" (off by {}, 95 % {})", error_text(rival.error_median), error_text(rival.error_p95));
        }
        text += list;
    }
    return text;
}

std::string summary_text(std::span<const Standings> all) {
    std::size_t with_default = 0;
    std::size_t on_front = 0;
    std::string others;
    for (const Standings& standings : all) {
        const std::optional<measure::Verdict> verdict = measure::verdict_of(standings);
        if (!verdict) continue;
        ++with_default;
        if (verdict->on_front)
            ++on_front;
        else
            others += fmt::format("{} {}", others.empty() ? "; not of" : ",", title_text(standings));
    }
    if (with_default == 0) return {};
    return fmt::format("the default is on the front of {} of {} tables{}", on_front, with_default, others);
}

std::string standings_markdown(const Standings& standings) {
    std::string text = fmt::format("**{}** ({})\n\n| method | code | median error | 95 % below | worst | ns | ratio | "
                                   "front |\n|---|---|---|---|---|---|---|---|\n",
                                   title_text(standings), says_text(standings));
    for (const Standing& row : standings.rows)
        text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", row.method, row.code,
                            error_text(row.error.median), error_text(row.error.p95), error_text(row.error.max),
                            ns_text(row), ratio_text(row), row.on_front ? "★" : "");
    if (const std::string verdict = verdict_text(standings); !verdict.empty()) text += fmt::format("\n{}\n", verdict);
    return text;
}

std::string standings_csv_header() {
    return "suite,cases,subset,error,item,method,code,error_median,error_p95,error_max,error_count,time_ns,"
           "time_median_ns,time_highest_ns,samples,ratio_to_baseline,baseline_method,baseline_code,on_front,seed,"
           "processor,gonio,commit,"
           "compiler\n";
}

std::string standings_csv(const Standings& standings, const BenchRun& run) {
    const measure::ContestTitle& title = standings.title;
    const Standing& baseline = standings.rows[standings.baseline];
    const std::string where = fmt::format("{},{},{},{},{}", run.seed, csv_field(run.machine.processor),
                                          run.build.version, commit, csv_field(run.build.compiler));
    std::string text;
    for (const Standing& row : standings.rows) {
        std::string time = ",,,,";
        if (row.time)
            time = fmt::format("{},{},{},{},{}", shortest(row.time->timing.lowest_ns),
                               shortest(row.time->timing.ns_per_item), shortest(row.time->timing.highest_ns),
                               row.time->timing.samples, shortest(row.time->ratio));
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", title.suite, csv_field(title.cases),
                            csv_field(title.subset), csv_field(title.error), csv_field(title.item), row.method,
                            row.code, shortest(row.error.median), shortest(row.error.p95), shortest(row.error.max),
                            row.error.count, time, baseline.method, baseline.code, row.on_front, where);
    }
    return text;
}

Json standings_json(const Standings& standings) {
    const measure::ContestTitle& title = standings.title;
    const Standing& baseline = standings.rows[standings.baseline];
    Json rows = Json::array();
    for (const Standing& row : standings.rows) {
        Json json{{"method", row.method},
                  {"code", row.code},
                  {"error_median", number_or_null(row.error.median)},
                  {"error_p95", number_or_null(row.error.p95)},
                  {"error_max", number_or_null(row.error.max)},
                  {"error_count", row.error.count}};
        const auto time = [&](const char* key, double (*of)(const measure::RelativeTiming&)) {
            json[key] = row.time ? Json(of(*row.time)) : Json(nullptr);
        };
        time("time_ns", [](const measure::RelativeTiming& t) { return t.timing.lowest_ns; });
        time("time_median_ns", [](const measure::RelativeTiming& t) { return t.timing.ns_per_item; });
        time("time_highest_ns", [](const measure::RelativeTiming& t) { return t.timing.highest_ns; });
        json["samples"] = row.time ? row.time->timing.samples : 0;
        time("ratio_to_baseline", [](const measure::RelativeTiming& t) { return t.ratio; });
        json["on_front"] = row.on_front;
        rows.push_back(std::move(json));
    }
    return {{"suite", title.suite},
            {"cases", title.cases},
            {"subset", title.subset},
            {"error", title.error},
            {"item", title.item},
            {"truth", title.truth},
            {"baseline", {{"method", baseline.method}, {"code", baseline.code}}},
            {"default", title.standard.empty() ? Json(nullptr) : Json(title.standard)},
            {"rows", std::move(rows)}};
}

Json run_json(const BenchRun& run) {
    return {{"schema", "gonio.bench/1"},
            {"tool",
             {{"version", run.build.version},
              {"commit", commit},
              {"compiler", run.build.compiler},
              {"optimized", run.build.optimized},
              {"sanitizers", run.build.checked}}},
            {"machine",
             {{"processor", run.machine.processor},
              {"threads", run.machine.threads},
              {"instruction_set", run.machine.widest}}},
            {"seed", run.seed},
            {"quick", run.quick}};
}

Result<std::string> standings_chart(std::span<const Standings> all, const BenchRun& run) {
    std::vector<LogLogPanel> panels;
    for (const Standings& standings : all)
        panels.push_back(panel_of(standings));
    LogLogOptions options;
    options.title = "Error against time: filled and joined, what no other method beats in both";
    options.note = "square: double, circle: float, triangle: instruction set. " + run_text(run);
    return log_log_panels(panels, options);
}

} // namespace gonio::cli
