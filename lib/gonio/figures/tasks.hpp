// Tasks: what a standard requires of the light for them, and whether a room or a grid reaches it.
//
// The table is a selection that public descriptions of the standards state; a file can replace it. Requirements are of
// maintained values.
#pragma once

#include <gonio/base/result.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// Requirements of a task; empty: none.
struct Task {
    std::string name;  // "office.writing"
    std::string title; // "writing, reading, data processing"
    std::string rule;  // the standard, with its edition
    std::optional<double> mean_lx{};
    std::optional<double> raised_mean_lx{}; // where people see badly or errors are costly
    std::optional<double> least_lx{};
    std::optional<double> uniformity{}; // least/mean
    std::optional<double> ugr{};        // at most
    std::optional<double> ra{};
    std::optional<double> cylindrical_lx{};
    std::optional<double> wall_lx{};
    std::optional<double> ceiling_lx{};
    std::optional<double> greatest_mean_lx{};        // a mean of more is another class
    std::optional<double> mean_nt{};                 // of a road's surface [cd/m²]
    std::optional<double> luminance_uniformity{};    // least/mean
    std::optional<double> longitudinal_uniformity{}; // least/greatest along a lane
    std::optional<double> ti_percent{};              // threshold increment, at most
    std::optional<double> edge_ratio{};              // edge illuminance ratio
    std::optional<double> gr{};                      // glare rating of sports outdoors, at most
};

// The table of the library.
std::span<const Task> known_tasks();

// A table as CSV: a line of column names, among them "name", then a line for each task; columns are named as the
// members of Task, an empty field is no requirement. Messages call the text `source`. Fails (malformed, with line and
// column) on unknown columns, on numbers that are not greater than 0, and on names that are missing or repeated.
Result<std::vector<Task>> parse_tasks(std::string_view text, const std::string& source);

// What was reached; empty: not known.
struct ReachedLight {
    std::optional<double> mean_lx{};
    std::optional<double> least_lx{};
    std::optional<double> uniformity{};
    std::optional<double> ugr{}; // the greatest
    std::optional<double> ra{};
    std::optional<double> cylindrical_lx{};
    std::optional<double> wall_lx{};
    std::optional<double> ceiling_lx{};
    std::optional<double> mean_nt{}; // of the lane that has the least, and so on
    std::optional<double> luminance_uniformity{};
    std::optional<double> longitudinal_uniformity{};
    std::optional<double> ti_percent{};
    std::optional<double> edge_ratio{};
    std::optional<double> gr{};
};

// One requirement and what was reached.
struct Verdict {
    std::string_view key;  // "mean_lx"
    std::string_view what; // "mean illuminance"
    std::string_view unit; // "lx", "cd/m²", "%"; empty for ratios and indices
    double required = 0.0;
    bool is_limit = false; // at most, else at least
    std::optional<double> reached{};

    int decimals = 0; // by which it is stated

    // Whether it is met; empty where nothing is known. Figures are compared as they are stated: lux from 10 on, Ra and
    // threshold increments as whole numbers, UGR, GR and fewer lux to one decimal, luminances and ratios to two.
    std::optional<bool> passes() const;
};

// A verdict for each requirement of the task, in their order; `raised`: with the raised mean, if there is one.
std::vector<Verdict> verdicts(const Task& task, const ReachedLight& reached, bool raised = false);

} // namespace gonio
#pragma GCC visibility pop
