#include "task_input.hpp"

#include <gonio/base/file.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/unit_text.hpp>

#include "../facts_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace gonio::cli {

namespace {

// "524 lx", "1.02 cd/m²", "0.71", "17.2"
std::string amount_of(const Verdict& verdict, double value) {
    const std::string amount =
        verdict.unit == "lx" ? amount_text(value) : fmt::format("{:.{}f}", value, verdict.decimals);
    return verdict.unit.empty() ? amount : fmt::format("{} {}", amount, verdict.unit);
}

} // namespace

bool TaskInput::has_failed() const {
    return std::any_of(verdicts.begin(), verdicts.end(),
                       [](const Verdict& verdict) { return verdict.passes() == std::optional(false); });
}

Result<std::optional<TaskInput>> task_input(const Arguments& arguments) {
    const auto name = arguments.value("--task");
    if (!name) {
        for (const std::string_view option : {"--tasks", "--raised"})
            if (arguments.has(option))
                return fail("USE0104", fmt::format("{} is given without --task", option),
                            "name the task: --task office.writing");
        return std::optional<TaskInput>();
    }
    TaskInput input;
    if (const auto file = arguments.value("--tasks")) {
        Result<std::string> text = read_file(*file, limit("list-bytes"));
        if (!text) return pass_on(text);
        Result<std::vector<Task>> tasks = parse_tasks(*text, *file);
        if (!tasks) return pass_on(tasks);
        auto found = find_named("task", *name, *tasks);
        if (!found) return pass_on(found);
        input.task = **found;
    } else {
        const std::span<const Task> tasks = known_tasks();
        auto found = find_named("task", *name, tasks);
        if (!found) return pass_on(found);
        input.task = **found;
    }
    input.raised = arguments.has("--raised");
    if (input.raised && !input.task.raised_mean_lx)
        return fail("USE0107", fmt::format("the task '{}' has no raised illuminance", input.task.name),
                    "leave --raised out");
    return std::optional(std::move(input));
}

std::string verdicts_text(const TaskInput& task) {
    std::string text = fmt::format("{}{}{}\n", task.task.name, task.task.title.empty() ? "" : ", " + task.task.title,
                                   task.task.rule.empty() ? "" : fmt::format(" ({})", task.task.rule));
    for (const Verdict& verdict : task.verdicts) {
        const std::optional<bool> passes = verdict.passes();
        text += fmt::format("  {:<28}{:<9}{:>10}  {:>10}  {}\n", verdict.what,
                            verdict.is_limit ? "at most" : "at least", amount_of(verdict, verdict.required),
                            verdict.reached ? amount_of(verdict, *verdict.reached) : std::string("-"),
                            !passes   ? "not known"
                            : *passes ? "pass"
                                      : "FAIL");
    }
    return text;
}

Json verdicts_json(const TaskInput& task) {
    Json requirements = Json::array();
    bool is_known = true;
    for (const Verdict& verdict : task.verdicts) {
        const std::optional<bool> passes = verdict.passes();
        is_known = is_known && passes;
        requirements.push_back({{"key", verdict.key},
                                {"what", verdict.what},
                                {verdict.is_limit ? "at_most" : "at_least", verdict.required},
                                {"reached", number_or_null(verdict.reached)},
                                {"passes", passes ? Json(*passes) : Json(nullptr)}});
    }
    return {{"task", task.task.name},
            {"rule", task.task.rule},
            {"requirements", std::move(requirements)},
            {"passes", task.has_failed() || is_known ? Json(!task.has_failed()) : Json(nullptr)}};
}

} // namespace gonio::cli
