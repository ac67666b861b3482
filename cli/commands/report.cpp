#include <gonio/base/codes/result.hpp>
#include <gonio/base/path.hpp>
#include <gonio/base/unit_text.hpp>

#include "../arguments.hpp"
#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_text.hpp"
#include "../options/common.hpp"
#include "../options/files_in_use.hpp"
#include "../options/output.hpp"
#include "../options/profile_input.hpp"
#include "../options/rig_input.hpp"
#include "../options/values.hpp"
#include "../preview/profile_stages.hpp"
#include "../preview/stage_input.hpp"
#include "../report/report_page.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

constexpr std::array content_options{
    Option{"--title", "TEXT", "title of the report (Photometric report)"},
    Option{"--paper", "SIZE", "paper that it prints on: a4 or letter (a4)"},
    Option{"--height", "LENGTH", "height of the light above the plane, for isolux and cone (3m)"},
    Option{"--stage", "STAGE", "stage of the pictures (floor; for a rig, its own)", "stages"},
    Option{"--no-picture", "", "leave out the pictures"},
};
constexpr std::array page_options{
    Option{"--page", "FILE", "gonio's page for browsers, to look at the profiles in (gonio.html, if it is installed)"},
    Option{"--no-page", "", "leave it out: a report without scripts"},
};
constexpr std::array write_options{
    Option{"-o,--output", "FILE", "the report, HTML; '-' is stdout"},
    Option{"-n,--dry-run", "", "check the options, and write nothing"},
    durable_option,
};
constexpr std::array groups{OptionGroup{"report", content_options},
                            OptionGroup{"rig", rig_options},
                            OptionGroup{"interactive page", page_options},
                            OptionGroup{"output", write_options},
                            profile_input_group,
                            json_group,
                            threads_group,
                            common_group};
constexpr std::array examples{
    Example{"gonio report lamp.ies -o lamp.html", "facts, diagrams, picture and diagnostics of a profile"},
    Example{"gonio report catalogue --paper letter -o catalogue.html", "a folder, to print on US letter"},
    Example{"gonio report --rig room.json lamps/*.ldt -o room.html", "the lights of a rig, and some profiles"},
    Example{"gonio report catalogue --no-picture --no-page -o small.html", "a smaller file"},
};

struct ReportRequest {
    std::vector<std::string> files;
    std::optional<std::string> rig;
    std::string output;
    std::string title;
    Paper paper = Paper::a4;
    double height_m = 3.0;
    bool has_pictures = true;
    bool has_chosen_stage = false;
    ProfileInputOptions input;
    unsigned threads = 0;
    std::optional<InteractivePage> page;
};

Result<void> read_content(const Arguments& arguments, ReportRequest& request) {
    request.title = arguments.value("--title").value_or("Photometric report");
    if (const auto paper = arguments.value("--paper")) {
        if (*paper != "a4" && *paper != "letter")
            return fail("USE0103", fmt::format("unknown paper '{}'", *paper), "a4 or letter");
        request.paper = *paper == "a4" ? Paper::a4 : Paper::letter;
    }
    if (const auto text = arguments.value("--height")) {
        Result<double> height = parse_amount(*text, Dimension::length, "--height");
        if (!height) return pass_on(height);
        if (!(*height > 0.0))
            return fail("USE0105", fmt::format("--height takes a length greater than 0, not '{}'", *text));
        request.height_m = *height;
    }
    request.has_pictures = !arguments.has("--no-picture");
    request.has_chosen_stage = arguments.has("--stage");
    return {};
}

Result<ReportRequest> parse(const Arguments& arguments) {
    ReportRequest request;
    if (Result<void> content = read_content(arguments, request); !content) return pass_on(content);
    request.rig = arguments.value("--rig");
    if (!request.rig || !arguments.positional().empty()) {
        Result<std::vector<std::string>> files = input_files(arguments);
        if (!files) return pass_on(files);
        request.files = std::move(*files);
    }
    Result<ProfileInputOptions> input = profile_input(arguments);
    if (!input) return pass_on(input);
    request.input = *input;
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    request.threads = *threads;
    const auto output = arguments.value("--output");
    if (!output) return fail("USE0104", "no output is given", "use -o FILE, for example -o report.html");
    request.output = *output;
    if (*output == "-" && report_kind(arguments) != ReportKind::words) return both_to_standard_output("HTML");
    Result<std::optional<InteractivePage>> page = interactive_page(arguments);
    if (!page) return pass_on(page);
    request.page = std::move(*page);
    std::vector<std::string> inputs = request.files;
    if (request.rig) inputs.push_back(*request.rig);
    if (request.page) inputs.push_back(request.page->file);
    if (Result<void> free = check_outputs(inputs, {&request.output, 1}); !free) return pass_on(free);
    return request;
}

// File names without their folders, if these are not needed to tell two apart.
std::vector<std::string> labels_of(const std::vector<std::string>& files) {
    std::vector<std::string> names;
    std::set<std::string> distinct;
    for (const std::string& file : files) {
        names.push_back(file == "-" ? "stdin" : file_name(file));
        distinct.insert(names.back());
    }
    return distinct.size() == files.size() ? names : files;
}

struct ReportResult {
    std::vector<ProfilePart> profiles;
    std::optional<RigPart> rig;
    Diagnostics diagnostics; // about the whole
    int status = 0;
};

// A report without pictures is better than none where the package that makes them is not installed.
Result<void> check_pictures(ReportRequest& request, const PreviewRequest& picture, ReportResult& result,
                            Console& console) {
    if (!request.has_pictures) return {};
    Result<void> tried = try_pictures(picture, console);
    if (tried) return {};
    const Diagnostic& reason = tried.error().diagnostics.back();
    if (reason.code != "UNS0102") return tried;
    request.has_pictures = false;
    result.diagnostics.push_back(result_diagnostic("RES0209",
                                                   fmt::format("the report has no pictures: {}", reason.message),
                                                   "install the package gonio-media, or add --no-picture"));
    console.say(result.diagnostics);
    return {};
}

int add_profiles(const ReportRequest& request, const std::vector<std::string>& labels, PreviewRequest picture,
                 ReportResult& result, Console& console) {
    ProfileStages stages(picture.stage, request.has_chosen_stage);
    const std::size_t count = request.files.size();
    // Several profiles are made side by side, and one on all processors.
    picture.render.threads = picture.display.threads = count > 1 ? 1 : request.threads;
    ProfilePartOptions options;
    options.input = request.input;
    options.mounting_height_m = request.height_m;
    options.picture = request.has_pictures ? &picture : nullptr;
    options.stages = &stages;
    options.keeps_bytes = request.page.has_value();
    const Batch batch{request.files, "gonio.report/1", "read", request.threads};
    return run_batch(batch, ReportKind::words, console, [&](std::size_t index) {
        const std::string& file = request.files[index];
        Outcome outcome;
        result.profiles[index] = failed_part(file, labels[index], index + 1, Error(), {}); // kept after an exception
        result.profiles[index] =
            profile_part(file, labels[index], index + 1, options, console, outcome.diagnostics, outcome.error);
        return outcome;
    });
}

Json report_json(const ReportRequest& request, const ReportResult& result, std::size_t bytes) {
    Json profiles = Json::array();
    std::size_t pictures = result.rig && result.rig->has_picture ? 1 : 0;
    for (const ProfilePart& profile : result.profiles) {
        profiles.push_back(profile.report);
        pictures += profile.has_picture ? 1 : 0;
    }
    return {{"schema", "gonio.report/1"},
            {"output", request.output},
            {"size_bytes", bytes},
            {"paper", request.paper == Paper::a4 ? "a4" : "letter"},
            {"pictures", pictures},
            {"page", request.page ? Json(request.page->file) : Json()},
            {"profiles", std::move(profiles)},
            {"rig", result.rig ? result.rig->report : Json()},
            {"diagnostics", diagnostics_json(result.diagnostics)}};
}

Result<int> report(const Arguments& arguments, Console& console) {
    Result<ReportRequest> request = parse(arguments);
    if (!request) return pass_on(request);
    Result<Stage> stage = named_stage(arguments);
    if (!stage) return pass_on(stage);
    Result<PreviewRequest> picture = picture_request(arguments, request->threads);
    if (!picture) return pass_on(picture);
    picture->stage = std::move(*stage);
    if (arguments.has("--dry-run")) {
        console.print(request->output + "\n");
        return 0;
    }
    ReportResult result;
    result.profiles.resize(request->files.size());
    if (Result<void> checked = check_pictures(*request, *picture, result, console); !checked) return pass_on(checked);
    if (request->rig) {
        const RigPartOptions options{request->has_pictures, request->page.has_value()};
        result.rig = rig_part(*request->rig, arguments, *picture, options, console);
        if (Result<void> free = check_outputs(result.rig->files, {&request->output, 1}); !free) return pass_on(free);
        if (result.rig->error)
            result.status = console.fail(*result.rig->error);
        else
            console.say(result.rig->diagnostics);
    }
    const std::vector<std::string> labels = labels_of(request->files);
    if (!request->files.empty())
        result.status = worse(result.status, add_profiles(*request, labels, *picture, result, console));

    ReportParts parts;
    parts.title = request->title;
    parts.paper = request->paper;
    // Without the folders of this machine, which the diagnostic names.
    if (!result.diagnostics.empty())
        parts.remark = "Pictures are left out: the package gonio-media was missing where this report was made.";
    parts.profiles = result.profiles;
    parts.names = labels;
    parts.rig = result.rig ? &*result.rig : nullptr;
    parts.page = request->page ? &*request->page : nullptr;
    const std::string html = report_html(parts);
    const Result<void> written = write_output(request->output, html);
    if (!written) return Unexpected(written.error());
    const ReportKind kind = report_kind(arguments);
    if (kind != ReportKind::words)
        console.print(dump(report_json(*request, result, html.size()), kind == ReportKind::json ? 2 : -1));
    return result.status;
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = report(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command report_command;
const Command report_command{
    "report",
    "write a report of profiles and of a rig, as an HTML file to read and print",
    "FILE… [--rig RIG] -o OUT.html",
    "FILE is an IES, EULUMDAT or TM-33 profile, a folder of profiles, '-' for stdin, or @LIST\n"
    "for a list of files. The report is one file that needs no network and no other file: a table of\n"
    "all profiles, and for each a page with its facts, diagrams, a picture, and what check says.\n"
    "A profile that cannot be read has a page with the reason; the others are reported all the same.",
    groups,
    examples,
    run};

} // namespace gonio::cli
