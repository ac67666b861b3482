// How `gonio bench` reports comparisons: in words, Markdown, CSV, JSON and as a chart.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/measure/contest.hpp>
#include <gonio/measure/machine.hpp>

#include "../json_text.hpp"
#include "../revision.hpp"

#include <cstdint>
#include <span>
#include <string>

namespace gonio::cli {

struct BenchRun {
    measure::Machine machine = measure::this_machine();
    measure::Build build = measure::this_build();
    std::uint64_t seed = 1;
    bool quick = false;
    bool complete = true; // not ended by Ctrl-C
};

// "gonio 0.1.0 (b23e719f3a50; g++ 12.2.0, optimised) on AMD EPYC, 2 threads, avx512; seed 1, quick".
std::string run_text(const BenchRun& run);

// The rows of one comparison.
std::string standings_text(const measure::Standings& standings);
std::string standings_markdown(const measure::Standings& standings);
std::string standings_csv_header();
std::string standings_csv(const measure::Standings& standings, const BenchRun& run);
// "default: exact, on the front; cheaper: frostbite 1.2 times as fast, off by 2e-07 (95 %: 8e-03); dominated: point";
// empty where there is no default.
std::string verdict_text(const measure::Standings& standings);
// "the default is on the front of 20 of 21 tables; not of: …"; empty where no table has one.
std::string summary_text(std::span<const measure::Standings> all);
Json standings_json(const measure::Standings& standings);

// schema, tool, machine, seed: the members before the comparisons.
Json run_json(const BenchRun& run);

// Error against time, with a panel for each comparison. Fails if no row has both.
Result<std::string> standings_chart(std::span<const measure::Standings> all, const BenchRun& run);

} // namespace gonio::cli
