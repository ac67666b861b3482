#include <gonio/base/file.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/light/presets.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../options/common.hpp"
#include "../units/program_table.hpp"
#include "../units/question.hpp"
#include "../units/units_report.hpp"

#include <fmt/format.h>

#include <array>

namespace gonio::cli {

namespace {

constexpr std::array unit_options{
    Option{"--shape", "SHAPE",
           "shape of the light (point), or of a surface that emits: box:w=20cm,h=10cm,d=5cm, panel:w=1m,h=50cm, "
           "capsule:r=2cm,l=30cm",
           "shapes"},
    Option{"--to", "UNIT,…",
           "units of the result: lm, cd, lx@DISTANCE, nt, ev, evlx@DISTANCE, fc@DISTANCE, fL, W@EFFICACY", "units"},
    Option{"--policy", "NAME,…", "read the value as this program does (physical); several, or 'all', are compared",
           "policies"},
    Option{"--for", "PROGRAM,…",
           "print what to type into these programs: unreal, unity-hdrp, godot, blender and others; 'all'", "programs"},
    Option{"--preset", "NAME", "use an everyday source instead of VALUE and --shape", "presets"},
    Option{"--solve", "LUX", "0.1lx: find the distance with this illuminance; 500lx@2m: find the flux that gives it"},
    Option{"--assume", "SHAPE", "assume this shape for the luminance of a light without size: sphere:r=1cm", "shapes"},
    Option{"--explain", "", "show the formulas and the steps"},
};
constexpr std::array report_options{
    Option{"--json", "", "one JSON object; an array for rows on stdin"},
    Option{"--jsonl", "", "one JSON object a line"},
    Option{"--csv", "", "CSV with a header line; needs --to"},
};
constexpr std::array groups{OptionGroup{"conversion", unit_options}, OptionGroup{"report", report_options},
                            common_group};
constexpr std::array examples{
    Example{"gonio units 800lm --shape sphere:r=3cm --to nt", "the luminance of an 800 lm bulb of 3 cm radius"},
    Example{"gonio units 300lx@2m --to lm,cd", "the point light that gives 300 lx at 2 m"},
    Example{"gonio units 800lm --shape spot:outer=40deg,inner=25deg --policy all", "what engines make of 800 lm"},
    Example{"gonio units 800lm --shape sphere:r=3cm --for unreal,blender", "what to type into Unreal and Blender"},
    Example{"gonio units 800lm --solve 0.1lx", "how far the light reaches: a range for culling"},
    Example{"gonio units 800lm --to W@khronos-177 --policy blender", "the watts to type into Blender"},
    Example{"gonio units - --to lm,cd --csv < lights.csv", "a table: rows of VALUE or VALUE,SHAPE"},
};

enum class Form { words, json, jsonl, csv };

Form form_of(const Arguments& arguments) {
    if (arguments.has("--csv")) return Form::csv;
    if (arguments.has("--jsonl")) return Form::jsonl;
    return arguments.has("--json") ? Form::json : Form::words;
}

// Answers and prints one row; the report of --json goes to `reports`.
Result<void> tell(std::string_view row, const UnitsRequest& request, Form form, Console& console, Json& reports) {
    Json report;
    Diagnostics diagnostics;
    if (!request.programs.empty()) {
        Result<ProgramTable> table = program_table(row, request);
        if (!table) return pass_on(table);
        diagnostics = table->question.diagnostics;
        if (form == Form::words)
            console.print(to_text(*table));
        else
            report = to_json(*table);
    } else if (request.policy == nullptr) {
        Result<PolicyTable> table = policy_table(row, request);
        if (!table) return pass_on(table);
        diagnostics = table->question.diagnostics;
        if (form == Form::words)
            console.print(to_text(*table));
        else
            report = to_json(*table);
    } else {
        Result<UnitsAnswer> answered = answer(row, request);
        if (!answered) return pass_on(answered);
        diagnostics = answered->diagnostics;
        if (form == Form::words)
            console.print(to_text(*answered, request.explain));
        else if (form == Form::csv)
            console.print(csv_line(*answered));
        else
            report = to_json(*answered, request.explain);
    }
    console.say(diagnostics);
    if (form == Form::jsonl) console.print(dump(report, -1));
    if (form == Form::json) reports.push_back(std::move(report));
    return {};
}

// Rows of stdin: a bad row is reported with its line number and does not stop the others.
int tell_rows(std::string_view text, const UnitsRequest& request, Form form, Console& console, Json& reports) {
    int status = 0;
    std::size_t rows = 0;
    std::size_t failed = 0;
    for (std::uint32_t line = 1; !text.empty(); ++line) {
        const std::size_t end = text.find('\n');
        std::string_view row = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (row.ends_with('\r')) row.remove_suffix(1);
        if (row.find_first_not_of(" \t") == std::string_view::npos) continue;
        ++rows;
        Result<void> told = tell(row, request, form, console, reports);
        if (told) continue;
        ++failed;
        if (form == Form::csv) console.print(csv_line(row, request.wanted.size(), told.error()));
        for (Diagnostic& diagnostic : told.error().diagnostics)
            if (diagnostic.location.file.empty()) diagnostic.location = {"-", line, 1};
        status = worse(status, console.fail(told.error()));
    }
    if (failed > 0) console.note(fmt::format("{} rows: {} converted, {} failed", rows, rows - failed, failed));
    return status;
}

Result<int> convert(const Arguments& arguments, Console& console) {
    std::vector<std::string> values = arguments.positional();
    Result<UnitsRequest> request = units_request(arguments);
    if (!request) return pass_on(request);
    if (const auto name = arguments.value("--preset")) {
        Result<const LightPreset*> preset = find_preset(*name);
        if (!preset) return pass_on(preset);
        if (!values.empty())
            return fail("USE0107", "a preset has its own value, but another one is given",
                        "leave the value out, or describe the light by --shape instead of --preset");
        values.emplace_back((*preset)->value);
        if (!arguments.has("--shape")) request->shape = (*preset)->shape;
    }
    if (values.empty())
        return fail("USE0104", "no value is given", "for example: gonio units 800lm --shape sphere:r=3cm --to nt");
    const Form form = form_of(arguments);
    if (form == Form::csv && (request->wanted.empty() || request->policy == nullptr))
        return fail("USE0104", "--csv needs the same columns in every row",
                    "name the units with --to, and one policy at a time");

    if (form == Form::csv) console.print(csv_head(request->wanted));
    Json reports = Json::array();
    int status = 0;
    const bool rows = values.size() == 1 && values.front() == "-";
    if (rows) {
        Result<std::string> text = read_standard_input();
        if (!text) return pass_on(text);
        status = tell_rows(*text, *request, form, console, reports);
    } else {
        for (const std::string& value : values) {
            Result<void> told = tell(value, *request, form, console, reports);
            if (told) continue;
            if (values.size() == 1) return pass_on(told);
            if (form == Form::csv) console.print(csv_line(value, request->wanted.size(), told.error()));
            status = worse(status, console.fail(told.error()));
        }
    }
    if (form == Form::json) console.print(dump(!rows && values.size() == 1 ? reports.front() : reports, 2));
    return status;
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = convert(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command units_command;
const Command units_command{
    "units",
    "convert lumens, candela, lux, nits and exposure values for the shape of a light",
    "VALUE… [--shape SHAPE] [--to UNIT,…] | -",
    "VALUE is a number with its unit: 800lm, 2.5klm, 1200cd, 300lx@2m, 20fc@6ft, 5000nt, 12ev, 60W@90lm/W;\n"
    "VALUE,SHAPE also names its shape. '-' reads such rows from stdin.",
    groups,
    examples,
    run};

} // namespace gonio::cli
