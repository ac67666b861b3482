// Many inputs: processed in parallel, reported in the order in which they were given.
//
// Every input is tried, the highest exit status wins, and a final line on stderr counts the failures. Results in words
// and --jsonl are printed as soon as all earlier inputs are printed; --json waits for the last input, because the
// report is one array (for one input: one object). A progress bar is shown on stderr if that is a terminal and the work
// takes over a second.
#pragma once

#include "arguments.hpp"
#include "console.hpp"
#include "json_text.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::cli {

enum class ReportKind { words, json, jsonl };

ReportKind report_kind(const Arguments& arguments);

// The outcome of one input.
// NOLINTNEXTLINE(bugprone-exception-escape): moving a Json is noexcept, and throws nothing
struct Outcome {
    std::optional<Error> error;       // why it failed; only these diagnostics are reported then
    int status = 0;                   // of an input that did not fail
    bool unchanged = false;           // its result existed already; counted separately
    std::string words;                // the result in words; of an input that failed, its line of a table
    Json report;                      // the result as an object; null: no report
    Diagnostics diagnostics;          // printed; expected to be in the report too
    std::vector<std::string> remarks; // printed if verbose
};

struct Batch {
    std::span<const std::string> inputs;
    std::string_view schema; // of one report: "gonio.info/1"
    std::string_view done;   // what happened to inputs that did not fail: "read", "baked"
    unsigned threads = 0;    // 0: all processors
};

// Calls `work` once for each input, on several threads, and prints what it returns. An exception from `work` is the
// error of that input alone. Returns the exit status.
int run_batch(const Batch& batch, ReportKind kind, Console& console, const std::function<Outcome(std::size_t)>& work);

} // namespace gonio::cli
