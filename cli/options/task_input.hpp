// The task that a room or a grid is judged by, and the verdicts.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/figures/tasks.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../json_text.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gonio::cli {

inline constexpr std::array task_options{
    Option{"--task", "TASK",
           "judge the light by what a standard requires for a task: office.writing; exit status 1 if it fails",
           "tasks"},
    Option{"--tasks", "FILE", "tasks from a CSV table instead: name,mean_lx,uniformity,ugr,ra,… (gonio list tasks)"},
    Option{"--raised", "",
           "with --task, the raised mean illuminance, for people who see badly or work that must not fail"},
};

inline constexpr OptionGroup task_group{"task", task_options};

struct TaskInput {
    Task task;
    bool raised = false;
    std::vector<Verdict> verdicts; // once the light is known

    // The mean that it asks for, if any.
    std::optional<double> mean_lx() const { return raised && task.raised_mean_lx ? task.raised_mean_lx : task.mean_lx; }

    // Whether a requirement is not met.
    bool has_failed() const;
};

// Empty without --task. Fails (usage) on an unknown task, and on --raised and --tasks without one; io and malformed on
// the file.
Result<std::optional<TaskInput>> task_input(const Arguments& arguments);

// A line for each requirement: required, reached, pass or fail.
std::string verdicts_text(const TaskInput& task);

// {"task", "rule", "requirements": [{"key", "what", "at_least" or "at_most", "reached", "passes"}], "passes"}; null
// where it is not known whether one passes.
Json verdicts_json(const TaskInput& task);

} // namespace gonio::cli
