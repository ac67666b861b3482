#include <gonio/base/unit_text.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/symmetry.hpp>
#include <gonio/web/to_profile.hpp>

#include "../arguments.hpp"
#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_text.hpp"
#include "../options/common.hpp"
#include "../options/output.hpp"
#include "../options/profile_input.hpp"
#include "../options/profile_output.hpp"
#include "../options/values.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>

namespace gonio::cli {

namespace {

constexpr std::array convert_options{
    Option{"-o,--output", "FILE", "write one output; '-' is stdout (with --to)"},
    Option{"-O,--output-dir", "DIR", "write one output per input into an existing folder (with --to)"},
    Option{"--to", "FORMAT", "ies, ldt or tm33, if the output name does not show the format", "formats"},
    Option{"--dialect", "NAME",
           "IES dialect: lm-63-1995, lm-63-2002, lm-63-2019, portable (that of the source, else lm-63-2002)",
           "dialects"},
    Option{"--compact", "FRACTION",
           "leave out planes that a symmetry restores within this fraction of the peak; 0: exactly (keep all)"},
    mirror_option,
    Option{"-u,--update", "", "with -O: write only outputs that are older than their input"},
    Option{"--overwrite", "", "with -O: replace existing files"},
    Option{"-n,--dry-run", "", "print what would be written, but write nothing"},
    durable_option,
};

constexpr std::array groups{OptionGroup{"output", convert_options}, profile_input_group, json_group, threads_group,
                            common_group};
constexpr std::array examples{
    Example{"gonio convert lamp.ldt -o lamp.ies", "EULUMDAT to LM-63-2002; losses are reported"},
    Example{"gonio convert *.ies -O game --dialect portable", "IES files that every engine reads the same way"},
    Example{"gonio convert lamp.ies -o small.ies --compact 1e-3",
            "leave out planes that are symmetric within 0.1 % of the peak"},
    Example{"gonio convert - --to ldt -o - < lamp.ies", "through pipes"},
};

struct Request {
    ProfileTarget target;
    ProfileInputOptions input;
    std::optional<double> compact; // tolerance
};

struct Converted {
    Profile profile;
    double source_flux_lm = 0.0;
    double flux_lm = 0.0;
    ConversionError error;
    Diagnostics diagnostics;
};

// From the table as it was changed in reading, not from the file.
Result<MadeProfile> convert_web(const LoadedProfile& loaded, const Request& request) {
    return to_profile(request.compact ? compacted(loaded.web, *request.compact) : loaded.web,
                      header_of(loaded.profile, request.input.resolve), request.target);
}

// Reads, converts, writes, and reads the written bytes again: the reported error is that of the bytes.
Result<Converted> convert(const Job& job, const Request& request) {
    const auto& [target, input, compact] = request;
    Result<LoadedProfile> loaded = load(job.input, input);
    if (!loaded) return pass_on(loaded);
    Result<MadeProfile> made = input.smooth_deg ? convert_web(*loaded, request)
                               : compact        ? convert_compacted(loaded->profile, target, *compact, input.resolve)
                                                : convert_profile(loaded->profile, target, input.resolve);
    if (!made) return pass_on(made);
    const std::string bytes = write_profile(made->profile, target);
    Result<Profile> again = read_profile(bytes, job.output);
    Result<ResolvedWeb> web = again ? resolve_web(*again) : Result<ResolvedWeb>(pass_on(again));
    if (!web) {
        const std::string reason = web.error().diagnostics.empty() ? "" : web.error().diagnostics.back().message;
        return fail(Failure::internal, fmt::format("the written profile cannot be read back: {}", reason), {},
                    job.input);
    }
    Converted converted;
    converted.profile = std::move(*again);
    converted.source_flux_lm = flux(loaded->web).value;
    converted.flux_lm = flux(web->web).value;
    converted.error = conversion_error(loaded->web, web->web);
    converted.diagnostics = std::move(loaded->diagnostics);
    converted.diagnostics.insert(converted.diagnostics.end(), made->diagnostics.begin(), made->diagnostics.end());
    const Result<void> written = write_output(job.output, bytes);
    if (!written) return Unexpected(written.error());
    return converted;
}

const char* format_of(const Profile& profile) {
    if (std::holds_alternative<Tm33File>(profile.file)) return "TM-33";
    return std::holds_alternative<IesFile>(profile.file) ? "IES" : "LDT";
}

const char* version_of(const Profile& profile) {
    if (const auto* tm33 = std::get_if<Tm33File>(&profile.file)) return edition(*tm33);
    const auto* ies = std::get_if<IesFile>(&profile.file);
    return ies != nullptr ? to_text(ies->version) : "EULUMDAT";
}

Json to_json(const Job& job, const Converted& converted, ProfileTarget target) {
    return {{"schema", "gonio.convert/1"},
            {"file", job.input},
            {"output", job.name},
            {"format", format_of(converted.profile)},
            {"version", version_of(converted.profile)},
            {"portable", target == ProfileTarget::portable},
            {"source_flux_lm", converted.source_flux_lm},
            {"flux_lm", converted.flux_lm},
            {"max_error_cd", converted.error.max.value},
            {"max_error_relative", converted.error.relative},
            {"max_error_c_deg", converted.error.c_deg},
            {"max_error_gamma_deg", converted.error.gamma_deg},
            {"diagnostics", diagnostics_json(converted.diagnostics)}};
}

Outcome outcome_of(const Job& job, const Request& request, ReportKind kind) {
    Outcome outcome;
    Result<Converted> converted = convert(job, request);
    if (!converted) {
        outcome.error = std::move(converted.error());
        return outcome;
    }
    outcome.remarks.push_back(fmt::format("{} -> {}: {}, greatest difference {:.3g} of the peak", job.input, job.output,
                                          version_of(converted->profile), converted->error.relative));
    if (kind != ReportKind::words) outcome.report = to_json(job, *converted, request.target);
    outcome.diagnostics = std::move(converted->diagnostics);
    return outcome;
}

Result<std::optional<double>> compact_tolerance(const Arguments& arguments) {
    const auto text = arguments.value("--compact");
    if (!text) return std::optional<double>();
    const std::optional<double> value = parse_number(*text);
    if (!value || *value < 0.0 || *value >= 1.0)
        return fail("USE0105", fmt::format("--compact takes a fraction from 0 to below 1, not '{}'", *text),
                    "for example 1e-3");
    return value;
}

Result<int> convert_all(const Arguments& arguments, Console& console) {
    Result<std::vector<std::string>> inputs = input_files(arguments);
    if (!inputs) return pass_on(inputs);
    Result<ProfileInputOptions> input = profile_input(arguments);
    if (!input) return pass_on(input);
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    if (arguments.has("--output-dir") && !arguments.has("--to") && !arguments.has("--dialect"))
        return fail("USE0104", "-O needs a format", "add --to ies, --to ldt, --to tm33 or --dialect NAME");
    const std::string format = arguments.value("--to").value_or("ies");
    Result<std::vector<Job>> jobs = plan_outputs(arguments, *inputs, format == "tm33" ? "xml" : format);
    if (!jobs) return pass_on(jobs);
    std::vector<std::string> outputs;
    for (const Job& job : *jobs)
        outputs.push_back(job.output);
    console.say(names_that_differ_by_case(outputs));
    const Result<ProfileTarget> target = profile_target(arguments, jobs->front().output);
    if (!target) return Unexpected(target.error());
    const Result<std::optional<double>> compact = compact_tolerance(arguments);
    if (!compact) return Unexpected(compact.error());
    const Request request{*target, *input, *compact};
    const ReportKind kind = report_kind(arguments);
    if (kind != ReportKind::words && jobs->front().output == "-") return both_to_standard_output("profile");
    std::erase_if(*jobs, [](const Job& job) { return job.skip; });
    std::vector<std::string> names;
    for (const Job& job : *jobs)
        names.push_back(job.input);
    if (arguments.has("--dry-run")) {
        for (const Job& job : *jobs)
            console.print(fmt::format("{} -> {}\n", job.input, job.output));
        return 0;
    }
    return run_batch({names, "gonio.convert/1", "converted", *threads}, kind, console,
                     [&](std::size_t index) { return outcome_of((*jobs)[index], request, kind); });
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = convert_all(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command convert_command;
const Command convert_command{
    "convert",
    "write a profile in another format or dialect, and report what is lost",
    "FILE… -o OUT | -O DIR [options]",
    "FILE is an IES, EULUMDAT or TM-33 profile, a folder of profiles, '-' for stdin, or @LIST\n"
    "for a list of files.",
    groups,
    examples,
    run};

} // namespace gonio::cli
