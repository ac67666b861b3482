// Many inputs: the work side by side, what is said of them in the order they were named.
//
// Every input is tried, the highest exit status wins, and a closing line on standard error counts what failed. Results
// in words and --jsonl go out as soon as their turn has come; --json waits for the last, being one array (one input:
// one object). A progress bar stands on standard error where that is a terminal and the work takes over a second.
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

// What became of one input.
// NOLINTNEXTLINE(bugprone-exception-escape): moving a Json is noexcept, and throws nothing
struct Outcome {
    std::optional<Error> error;       // why it failed; its diagnostics are the only ones then
    int status = 0;                   // of an input that did not fail
    bool unchanged = false;           // its result was there already, and counts by itself
    std::string words;                // the result in words
    Json report;                      // the result as an object; null: nothing to report
    Diagnostics diagnostics;          // said, and expected to be in the report
    std::vector<std::string> remarks; // said when verbose
};

struct Batch {
    std::span<const std::string> inputs;
    std::string_view schema; // of one report: "gonio.info/1"
    std::string_view done;   // what happened to those that did not fail: "read", "baked"
    unsigned threads = 0;    // 0: all processors
};

// Calls `work` once for each input, on several threads, and says what it returns. What it throws is the error of that
// input alone. Returns the exit status.
int run_batch(const Batch& batch, ReportKind kind, Console& console, const std::function<Outcome(std::size_t)>& work);

} // namespace gonio::cli
