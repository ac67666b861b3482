#include <gonio/measure/stress.hpp>

#include "../interrupt.hpp"
#include "../json_text.hpp"
#include "../options/values.hpp"
#include "../progress.hpp"
#include "modes.hpp"
#include "standings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace gonio::cli {

namespace {

using measure::StressSubject;
using measure::StressTally;

struct Row {
    const StressSubject* subject;
    StressTally tally;
};

std::string row_text(const Row& row) {
    const StressTally& tally = row.tally;
    std::string text =
        fmt::format("{:<34}  {:>12}  {:>8}  {:>6}  {}\n", row.subject->name, tally.evaluations(),
                    tally.worst() > 0.0 ? fmt::format("{:.3f}", tally.worst()) : "", tally.broken(), row.subject->bar);
    for (const std::string& finding : tally.findings())
        text += fmt::format("    {}\n", finding);
    return text;
}

Json row_json(const Row& row) {
    Json findings = Json::array();
    for (const std::string& finding : row.tally.findings())
        findings.push_back(finding);
    return {{"subject", row.subject->name},           {"bar", row.subject->bar},
            {"evaluations", row.tally.evaluations()}, {"worst_share_of_bar", number_or_null(row.tally.worst())},
            {"worst_input", row.tally.worst_input()}, {"broken", row.tally.broken()},
            {"findings", std::move(findings)}};
}

} // namespace

Result<void> refuse_beside(std::string_view mode, std::span<const std::string_view> options,
                           const Arguments& arguments) {
    for (const std::string_view option : options)
        if (arguments.has(option))
            return fail("USE0107", fmt::format("{} cannot be combined with {}", mode, option),
                        "'gonio bench --help' shows which options go together");
    return {};
}

Result<int> bench_stress(const Arguments& arguments, Console& console) {
    constexpr std::array<std::string_view, 6> others{"--suite",    "--method", "--csv",
                                                     "--markdown", "--jsonl",  "--output"};
    Result<void> fine = refuse_beside("--stress", others, arguments);
    if (!fine) return pass_on(fine);
    measure::StressOptions options;
    if (arguments.has("--quick")) options.count = 1'000'000;
    if (const auto text = arguments.value("--count")) {
        Result<std::uint64_t> count = whole_number(*text, "--count");
        if (!count) return pass_on(count);
        if (*count == 0 || *count > 1'000'000'000'000U)
            return fail("USE0106", fmt::format("--count takes 1 to 1e12 evaluations, not {}", *text));
        options.count = *count;
    }
    if (const auto text = arguments.value("--seed")) {
        Result<std::uint64_t> seed = whole_number(*text, "--seed");
        if (!seed) return pass_on(seed);
        options.seed = *seed;
    }
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    options.threads = *threads;
    options.stop = interrupted;

    const bool json = arguments.has("--json");
    BenchRun run;
    run.seed = options.seed;
    if (!json)
        console.print(fmt::format("{}\n\n{:<34}  {:>12}  {:>8}  {:>6}  {}\n", run_text(run), "subject", "evaluations",
                                  "worst", "broken", "error bound; worst is a share of it"));
    listen_for_interrupt();
    double weights = 0.0;
    for (const StressSubject& subject : measure::stress_subjects())
        weights += subject.weight;
    Progress progress(measure::stress_subjects().size(), console.shows_progress());
    std::vector<Row> rows;
    int status = 0;
    std::uint64_t evaluations = 0;
    std::uint64_t broken = 0;
    for (const StressSubject& subject : measure::stress_subjects()) {
        if (interrupted()) break;
        progress.show(rows.size(), subject.name);
        rows.push_back({&subject, measure::stress(subject, subject.weight / weights, options)});
        evaluations += rows.back().tally.evaluations();
        broken += rows.back().tally.broken();
        progress.clear();
        if (!json) console.print(row_text(rows.back()));
        status = console.flush(status);
    }
    if (json) {
        Json report = run_json(run);
        report["schema"] = "gonio.bench-stress/1";
        report.erase("quick");
        report["complete"] = !interrupted();
        report["evaluations"] = evaluations;
        report["broken"] = broken;
        report["subjects"] = Json::array();
        for (const Row& row : rows)
            report["subjects"].push_back(row_json(row));
        report["diagnostics"] = Json::array();
        console.print(dump(report, 2));
    } else {
        console.print(fmt::format("\n{} evaluations of seed {}, {} broken\n", evaluations, options.seed, broken));
    }
    if (broken > 0) status = worse(status, 1);
    if (!interrupted()) return status;
    console.note(fmt::format("stopped by Ctrl-C in subject {} of {}", rows.size(), measure::stress_subjects().size()));
    return worse(status, interrupted_status);
}

} // namespace gonio::cli
