#include <gonio/base/file_set.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/measure/suite.hpp>

#include "../arguments.hpp"
#include "../batch.hpp"
#include "../bench/modes.hpp"
#include "../bench/standings.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../interrupt.hpp"
#include "../json_writer.hpp"
#include "../options/common.hpp"
#include "../options/files_in_use.hpp"
#include "../options/output.hpp"
#include "../options/values.hpp"
#include "../progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace gonio::cli {

namespace {

using measure::Standings;

constexpr std::array suite_options{
    Option{"--suite", "NAME,...", "suites to measure, or all (all)", "suites"},
    Option{"--method", "NAME,...", "measure only these methods and the baseline of each table"},
    Option{"--quick", "", "fewer cases and samples: all suites within a minute"},
    Option{"--seed", "N", "random seed of the cases (1)"},
};
constexpr std::array stress_options{
    Option{"--stress", "", "test every numeric function against its error bound on adversarial and random input"},
    Option{"--count", "N", "with --stress: approximate number of evaluations in total (1e7)"},
};
constexpr std::array scaling_options{
    Option{"--scaling", "NAME,...", "measure time against size: lights, pixels, file-size, threads, or all",
           "scalings"},
};
constexpr std::array time_map_options{
    Option{"--profile", "NAME,...", "where the time of a command goes: preview, bake, import, info, or all"},
};
constexpr std::array report_options{
    Option{"--json", "", "one JSON object"},
    Option{"--jsonl", "", "one JSON object per line for each table"},
    Option{"--csv", "", "comma-separated values"},
    Option{"--markdown", "", "tables in Markdown"},
    Option{"-o,--output", "FILE", "also write a file: .svg (error against time), .csv, .md or .json", {}, true},
};
constexpr std::array groups{OptionGroup{"suites", suite_options},
                            OptionGroup{"stress", stress_options},
                            OptionGroup{"scaling", scaling_options},
                            OptionGroup{"time", time_map_options},
                            OptionGroup{"report", report_options},
                            threads_group,
                            common_group};
constexpr std::array examples{
    Example{"gonio bench --quick", "error and time of every method on this machine"},
    Example{"gonio bench --suite irradiance -o irradiance.svg", "one suite, with a chart of error against time"},
    Example{"gonio bench --stress --count 1e8", "search for inputs that break an error bound"},
    Example{"gonio bench --scaling lights -o lights.svg", "how time grows with the number of lights"},
    Example{"gonio bench --profile preview", "rays, lights, shadows, bounced light, display, writing"},
    Example{"gonio bench --suite specular --method ltc,specular-d --csv > specular.csv", "two methods as CSV"},
};

enum class Form { words, json, jsonl, csv, markdown };

struct Request {
    std::vector<const measure::Suite*> suites;
    std::vector<std::string> methods; // empty: all
    measure::SuiteOptions options;
    Form form = Form::words;
    std::vector<std::pair<std::string, std::string>> outputs; // file, extension
    bool chart_to_standard_output = false;
};

Result<Form> form_of(const Arguments& arguments) {
    constexpr std::array forms{std::pair{"--json", Form::json}, std::pair{"--jsonl", Form::jsonl},
                               std::pair{"--csv", Form::csv}, std::pair{"--markdown", Form::markdown}};
    std::string given;
    Form form = Form::words;
    for (const auto& [name, its_form] : forms) {
        if (!arguments.has(name)) continue;
        if (!given.empty())
            return fail("USE0107", fmt::format("{} and {} cannot be combined", given, name),
                        "write further formats to files: -o bench.csv -o bench.json");
        given = name;
        form = its_form;
    }
    return form;
}

Result<void> read_outputs(const Arguments& arguments, Request& request) {
    if (Result<void> free = check_outputs({}, arguments.values("--output")); !free) return free;
    for (const std::string& file : arguments.values("--output")) {
        if (file == "-") {
            if (request.form != Form::words) return both_to_standard_output("chart");
            request.chart_to_standard_output = true;
            continue;
        }
        const std::size_t point = file.rfind('.');
        const std::string extension = point == std::string::npos ? std::string() : file.substr(point);
        if (extension != ".svg" && extension != ".csv" && extension != ".md" && extension != ".json")
            return fail("USE0104", fmt::format("the name '{}' does not end in .svg, .csv, .md or .json", file));
        Result<void> fine = check_writable(file);
        if (!fine) return pass_on(fine);
        request.outputs.emplace_back(file, extension);
    }
    return {};
}

Result<Request> parse(const Arguments& arguments) {
    Request request;
    if (!arguments.positional().empty())
        return fail("USE0107", fmt::format("bench does not take the argument '{}'", arguments.positional().front()),
                    "name suites with --suite");
    Result<std::vector<const measure::Suite*>> suites =
        measure::parse_suites(arguments.value("--suite").value_or("all"));
    if (!suites) return pass_on(suites);
    request.suites = std::move(*suites);
    if (const auto list = arguments.value("--method")) {
        Result<std::vector<std::string>> methods = measure::parse_methods(*list, request.suites);
        if (!methods) return pass_on(methods);
        request.methods = std::move(*methods);
    }
    if (const auto text = arguments.value("--seed")) {
        Result<std::uint64_t> seed = whole_number(*text, "--seed");
        if (!seed) return pass_on(seed);
        request.options.seed = *seed;
    }
    request.options.quick = arguments.has("--quick");
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    request.options.threads = *threads;
    Result<Form> form = form_of(arguments);
    if (!form) return pass_on(form);
    request.form = *form;
    Result<void> outputs = read_outputs(arguments, request);
    if (!outputs) return pass_on(outputs);
    return request;
}

std::string json_of(const std::vector<Standings>& all, const BenchRun& run) {
    Json report = run_json(run);
    report["complete"] = run.complete;
    report["contests"] = Json::array();
    for (const Standings& standings : all)
        report["contests"].push_back(standings_json(standings));
    report["diagnostics"] = Json::array();
    return dump(report, 2);
}

Result<std::string> file_bytes(const std::string& extension, const std::vector<Standings>& all, const BenchRun& run) {
    if (extension == ".svg") return standings_chart(all, run);
    if (extension == ".json") return json_of(all, run);
    std::string text = extension == ".csv" ? standings_csv_header() : run_text(run) + "\n";
    for (const Standings& standings : all)
        text += extension == ".csv" ? standings_csv(standings, run) : "\n" + standings_markdown(standings);
    return text;
}

// Prints a table as soon as it is complete, in the forms that allow it.
void say(const Standings& standings, const Request& request, const BenchRun& run, Console& console) {
    if (request.chart_to_standard_output) return;
    switch (request.form) {
    case Form::words:
        console.print("\n" + standings_text(standings));
        break;
    case Form::markdown:
        console.print("\n" + standings_markdown(standings));
        break;
    case Form::csv:
        console.print(standings_csv(standings, run));
        break;
    case Form::jsonl: {
        Json line = run_json(run);
        line.update(standings_json(standings));
        line["diagnostics"] = Json::array();
        console.print(dump(line, -1));
        break;
    }
    case Form::json:
        break;
    }
}

struct Turn {
    const measure::Suite* suite;
    measure::ContestMaker maker;
};

// Measures one comparison after another until all are done or Ctrl-C is pressed.
Result<std::vector<Standings>> measure_all(const Request& request, BenchRun& run, Console& console, int& status) {
    std::vector<Turn> turns;
    for (const measure::Suite* suite : request.suites)
        for (measure::ContestMaker& maker : suite->contests(request.options))
            turns.push_back({suite, std::move(maker)});
    Progress progress(turns.size(), console.shows_progress());
    std::vector<Standings> all;
    for (std::size_t i = 0; i < turns.size() && !interrupted(); ++i) {
        progress.show(i, fmt::format("{} {}", turns[i].suite->name, turns[i].maker.cases));
        Result<measure::Contest> contest = turns[i].maker.make();
        if (!contest) return pass_on(contest);
        if (!request.methods.empty()) {
            const bool named =
                std::any_of(contest->contestants.begin(), contest->contestants.end(), [&](const auto& c) {
                    return std::find(request.methods.begin(), request.methods.end(), c.method) != request.methods.end();
                });
            if (!named) continue;
            keep_only(*contest, request.methods);
        }
        Result<Standings> standings =
            hold(*contest, measure::timing_of(request.options), measure::thread_clock(), interrupted);
        if (!standings && interrupted()) break;
        if (!standings) return pass_on(standings);
        progress.clear();
        say(*standings, request, run, console);
        status = console.flush(status);
        all.push_back(std::move(*standings));
    }
    progress.clear();
    run.complete = !interrupted();
    const bool words = request.form == Form::words || request.form == Form::markdown;
    if (const std::string summary = summary_text(all); all.size() > 1 && words && !request.chart_to_standard_output)
        if (!summary.empty()) console.print(fmt::format("\n{}\n", summary));
    return all;
}

Result<int> bench(const Arguments& arguments, Console& console) {
    constexpr std::array<std::string_view, 1> others{"--count"};
    Result<void> fine = refuse_beside("a table", others, arguments);
    if (!fine) return pass_on(fine);
    Result<Request> request = parse(arguments);
    if (!request) return pass_on(request);
    BenchRun run;
    run.seed = request->options.seed;
    run.quick = request->options.quick;
    if (!run.build.optimized || run.build.checked)
        console.note("warning: this build is not optimised, so its times mean little");
    const bool words = request->form == Form::words || request->form == Form::markdown;
    if (words && !request->chart_to_standard_output) console.print(run_text(run) + "\n");
    if (request->form == Form::csv) console.print(standings_csv_header());
    listen_for_interrupt();
    int status = 0;
    Result<std::vector<Standings>> all = measure_all(*request, run, console, status);
    if (!all) return pass_on(all);
    if (request->form == Form::json) console.print(json_of(*all, run));
    if (request->chart_to_standard_output && !all->empty()) {
        Result<std::string> chart = standings_chart(*all, run);
        if (!chart) return pass_on(chart);
        console.print(*chart);
    }
    for (const auto& [file, extension] : request->outputs) {
        if (all->empty()) break;
        Result<std::string> bytes = file_bytes(extension, *all, run);
        if (!bytes) return pass_on(bytes);
        Result<void> written = write_output(file, *bytes);
        if (!written) return pass_on(written);
    }
    if (run.complete) return status;
    console.note(fmt::format("stopped by Ctrl-C after {} tables", all->size()));
    return worse(status, interrupted_status);
}

int run(const Arguments& arguments, Console& console) {
    const auto mode = arguments.has("--profile")   ? bench_time_map
                      : arguments.has("--scaling") ? bench_scaling
                      : arguments.has("--stress")  ? bench_stress
                                                   : bench;
    const Result<int> status = mode(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command bench_command;
const Command bench_command{
    "bench",
    "measure run time and error of every method on this machine",
    "[--suite NAME] [--quick] | --stress [--count N] | --scaling NAME | --profile NAME",
    "Each table shows the methods of one kind on the same seeded cases: their error against a reference, the time per\n"
    "evaluation (the least of all samples) and the median ratio to a named baseline, measured in the same rounds.\n"
    "A star marks the Pareto front: no other row has both a smaller median error and a shorter time. The line below a\n"
    "table says whether the default method is on the front, and what the other methods gain or lose.\n"
    "--stress searches for input that breaks a function: it prints the greatest share of each error bound that was "
    "used\n"
    "and every broken bound with its input in hexadecimal floats, and exits with 1 if there is one.\n"
    "--profile prints the parts of a command's work: elapsed time, time of all processors, and the share that they "
    "wait.",
    groups,
    examples,
    run};

} // namespace gonio::cli
