#include <gonio/base/archive.hpp>
#include <gonio/base/codes/archive.hpp>
#include <gonio/base/codes/web.hpp>
#include <gonio/base/file.hpp>
#include <gonio/base/folder.hpp>
#include <gonio/base/path.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/profile_facts.hpp>
#include <gonio/profile/gldf.hpp>
#include <gonio/profile/text_encoding.hpp>
#include <gonio/profile/write.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/symmetry.hpp>
#include <gonio/web/to_profile.hpp>

#include "../arguments.hpp"
#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_text.hpp"
#include "../options/common.hpp"
#include "../options/files_in_use.hpp"
#include "../options/output.hpp"
#include "../options/profile_input.hpp"
#include "../options/profile_output.hpp"
#include "../options/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::array convert_options{
    Option{"-o,--output", "FILE", "write one output; '-' is stdout (with --to)"},
    Option{"-O,--output-dir", "DIR", "write one output per input into an existing folder (with --to)"},
    Option{"--to", "FORMAT", "ies, ldt, tm33 or gldf, if the output name does not show the format", "formats"},
    Option{"--extract", "", "with -O: write the photometric files and spectra of one GLDF as they are"},
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
    Example{"gonio convert luminaire.gldf -o lamp.ldt --variant warm", "the photometry of a variant"},
    Example{"gonio convert luminaire.gldf --extract -O files", "all its photometric files, unchanged"},
    Example{"gonio convert lamp.ldt -o lamp.gldf", "a minimal GLDF around the profile"},
    Example{"gonio convert - --to ldt -o - < lamp.ies", "through pipes"},
};

struct Request {
    ProfileTarget target;
    ProfileInputOptions input;
    std::optional<double> compact; // tolerance
    bool to_gldf = false;          // instead of `target`
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

Diagnostic remark_of(const DiagnosticCode& code, const std::string& source, std::string message) {
    Diagnostic said;
    said.code = code.code;
    said.severity = code.severity;
    said.location = {source, 0, 0};
    said.message = std::move(message);
    return said;
}

// What a GLDF says about the profile in it. What the profile does not state is said to be missing.
GldfProduct product_of(const LoadedProfile& loaded, const ProfileInputOptions& input, Diagnostics& diagnostics) {
    const ProfileHeader header = header_of(loaded.profile, input.resolve);
    const ProfileFacts facts = profile_facts(loaded.profile, loaded.web, input.resolve, FactsExtent::brief);
    GldfProduct product;
    product.manufacturer = to_utf8(keyword_text(header, "MANUFAC"));
    product.name = to_utf8(luminaire_name(header));
    product.number = to_utf8(keyword_text(header, "LUMCAT"));
    product.flux_lm = facts.flux_lm;
    product.input_w = facts.input_w;
    if (!facts.lamps.empty()) {
        const DeclaredLamps& lamp = facts.lamps.front();
        constexpr double least_kelvin = 500.0;
        if (lamp.cct_k && *lamp.cct_k >= least_kelvin) product.cct_k = lamp.cct_k;
        const std::optional<double> cri = parse_number(lamp.cri);
        constexpr double group = 4.0; // EULUMDAT's groups of colour rendering are 1 to 4
        if (cri && *cri > group && *cri <= 100.0) product.cri = cri;
    }
    std::string missing;
    for (const auto& [text, what] : {std::pair{&product.manufacturer, "manufacturer"}, std::pair{&product.name, "name"},
                                     std::pair{&product.number, "number"}})
        if (text->empty()) missing += fmt::format("{}{}", missing.empty() ? "" : ", ", what);
    if (!missing.empty()) {
        const ArchiveCode code = "GLD0301";
        diagnostics.push_back(
            remark_of(*code, loaded.profile.source, fmt::format("the profile states no {}: '-' is written", missing)));
    }
    return product;
}

// A profile goes into a GLDF as it is; of a GLDF the photometry that is chosen.
Result<Converted> convert_to_gldf(const Job& job, const Request& request) {
    if constexpr (is_for_page)
        return fail("UNS0101", "this page does not write luminaires", "the command-line tool does");
    ProfileInputOptions input = request.input;
    input.photometric = true;
    Result<LoadedProfile> loaded = load(job.input, input);
    if (!loaded) return pass_on(loaded);
    std::string inside = std::move(loaded->bytes);
    if (is_archive(inside)) {
        const Result<Archive> archive = Archive::open(inside, job.input);
        if (!archive) return Unexpected(archive.error());
        Result<GldfProfile> chosen = gldf_profile(*archive, input.read.choice);
        if (!chosen) return pass_on(chosen);
        inside = std::move(chosen->bytes);
    }
    Converted converted;
    converted.diagnostics = std::move(loaded->diagnostics);
    // A GLDF has one photometric file for a light: what stands beside it would be lost.
    if (std::optional<std::string> with_factors = write_with_tilt_factors(loaded->profile)) {
        const WebCode code = "WEB0217";
        converted.diagnostics.push_back(
            remark_of(*code, loaded->profile.source,
                      fmt::format("the factors of TILT={} are written as TILT=INCLUDE",
                                  shown_text(std::get<IesFile>(loaded->profile.file).tilt_keyword))));
        inside = *std::move(with_factors);
    }
    GldfProduct product = product_of(*loaded, input, converted.diagnostics);
    const std::string stem = without_extension(file_name(job.output == "-" ? job.input : job.output));
    product.file =
        fmt::format("{}.{}", stem.empty() || stem == "-" ? "profile" : stem, profile_ending(loaded->profile));
    const std::string bytes = write_gldf(inside, product);
    Result<Profile> again = read_profile(bytes, job.output);
    Result<ResolvedWeb> web = again ? resolve_web(*again, input.resolve) : Result<ResolvedWeb>(pass_on(again));
    if (!web) return fail(Failure::internal, "the written GLDF cannot be read back", {}, job.input);
    converted.source_flux_lm = flux(loaded->web).value;
    converted.flux_lm = flux(web->web).value;
    converted.error = conversion_error(loaded->web, web->web);
    converted.profile = std::move(*again);
    if (Result<void> written = write_output(job.output, bytes); !written) return pass_on(written);
    return converted;
}

// Reads, converts, writes, and reads the written bytes again: the reported error is that of the bytes.
Result<Converted> convert(const Job& job, const Request& request) {
    if (request.to_gldf) return convert_to_gldf(job, request);
    const auto& [target, input, compact, to_gldf] = request;
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

Json to_json(const Job& job, const Converted& converted, const Request& request) {
    return {{"schema", "gonio.convert/1"},
            {"file", job.input},
            {"output", job.name},
            {"format", request.to_gldf ? "GLDF" : format_of(converted.profile)},
            {"version", request.to_gldf ? "1.0" : version_of(converted.profile)},
            {"portable", !request.to_gldf && request.target == ProfileTarget::portable},
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
                                          request.to_gldf ? "GLDF" : version_of(converted->profile),
                                          converted->error.relative));
    if (kind != ReportKind::words) outcome.report = to_json(job, *converted, request);
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

// The photometric files and spectra of a GLDF, unchanged: all of them or none.
Result<int> extract(const Arguments& arguments, const std::vector<std::string>& inputs, Console& console) {
    if constexpr (is_for_page)
        return fail("UNS0101", "this page does not unpack luminaires", "the command-line tool does");
    for (const std::string_view option :
         {"--to", "--dialect", "--compact", "--smooth", "--output", "--update", "--mirror", "--variant", "--emitter",
          "--from", "--lamp-set", "--tilt", "--azimuth", "--as-candela", "--json", "--jsonl", "--jobs"})
        if (arguments.has(option))
            return fail("USE0107", fmt::format("--extract and {} are both given", option),
                        "--extract writes the files as they are");
    const auto folder = arguments.value("--output-dir");
    if (!folder) return fail("USE0104", "--extract needs -O DIR", "-O . is the current folder");
    if (inputs.size() != 1) return fail("USE0107", "--extract takes one GLDF", "run it once for each");
    if (!is_folder(*folder))
        return fail("FIL0101", "there is no such folder", fmt::format("create it: mkdir -p '{}'", *folder), *folder);
    const std::string& input = inputs.front();
    const Result<std::string> bytes =
        input == "-" ? read_standard_input(limit("archive-bytes")) : read_file(input, limit("archive-bytes"));
    if (!bytes) return Unexpected(bytes.error());
    const Result<Archive> archive = Archive::open(*bytes, input);
    if (!archive) return Unexpected(archive.error());
    const Result<Gldf> gldf = read_gldf(*archive, arguments.has("--strict"));
    if (!gldf) return Unexpected(gldf.error());
    std::vector<OutputFile> files;
    std::vector<std::string> outputs;
    std::set<std::string> entries; // each once, whatever identifiers name it
    std::set<std::string> names;
    std::map<std::string, std::size_t> numbers; // the last one, by a name that was taken
    std::string said;
    for (const GldfFile& file : gldf->files) {
        if (file.entry.empty() || !(file.content_type.starts_with("ldc") || file.content_type.starts_with("spectrum")))
            continue;
        if (!entries.insert(file.entry).second) continue;
        std::string name = file_name(file.entry);
        if (!names.insert(to_lower(name)).second) {
            name = file.entry;
            std::replace(name.begin(), name.end(), '/', '.');
            const std::string taken = name;
            const std::string ending(extension_of(taken));
            for (std::size_t& number = numbers.try_emplace(to_lower(taken), 1).first->second;
                 !names.insert(to_lower(name)).second;)
                name = fmt::format("{}-{}{}{}", without_extension(taken), ++number, ending.empty() ? "" : ".", ending);
        }
        const std::string output = *folder + "/" + name;
        if (file_exists(output) && !arguments.has("--overwrite"))
            return fail("USE0108", fmt::format("'{}' exists", output), "add --overwrite");
        Result<std::string> inside = archive->read(*archive->find(file.entry));
        if (!inside) return pass_on(inside);
        outputs.push_back(output);
        files.push_back({output, std::move(*inside)});
        said += fmt::format("{}/{} -> {}\n", input, file.entry, output);
    }
    if (files.empty()) return fail("INP0101", "the GLDF has no photometric file and no spectrum", {}, input);
    if (Result<void> free = check_outputs(inputs, outputs); !free) return pass_on(free);
    if (!arguments.has("--dry-run"))
        if (Result<void> written = write_outputs(files); !written) return pass_on(written);
    console.print(said);
    console.say(gldf->diagnostics);
    return 0;
}

Result<int> convert_all(const Arguments& arguments, Console& console) {
    Result<std::vector<std::string>> inputs = input_files(arguments);
    if (!inputs) return pass_on(inputs);
    if (arguments.has("--extract")) return extract(arguments, *inputs, console);
    Result<ProfileInputOptions> input = profile_input(arguments);
    if (!input) return pass_on(input);
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    if (arguments.has("--output-dir") && !arguments.has("--to") && !arguments.has("--dialect"))
        return fail("USE0104", "-O needs a format", "add --to ies, --to ldt, --to tm33, --to gldf or --dialect NAME");
    const std::string format = arguments.value("--to").value_or("ies");
    Result<std::vector<Job>> jobs = plan_outputs(arguments, *inputs, format == "tm33" ? "xml" : format);
    if (!jobs) return pass_on(jobs);
    std::vector<std::string> outputs;
    for (const Job& job : *jobs)
        outputs.push_back(job.output);
    console.say(names_that_differ_by_case(outputs));
    const auto named = arguments.value("--to");
    const bool to_gldf = equals_any_case(named ? *named : std::string(extension_of(jobs->front().output)), "gldf");
    for (const std::string_view option : {"--dialect", "--compact", "--smooth", "--azimuth"})
        if (to_gldf && arguments.has(option))
            return fail("USE0107", fmt::format("a profile goes into a GLDF as it is: {} has no effect", option),
                        "convert it to a profile first");
    const Result<ProfileTarget> target =
        to_gldf ? Result<ProfileTarget>(ProfileTarget::lm63) : profile_target(arguments, jobs->front().output);
    if (!target) return Unexpected(target.error());
    const Result<std::optional<double>> compact = compact_tolerance(arguments);
    if (!compact) return Unexpected(compact.error());
    const Request request{*target, *input, *compact, to_gldf};
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
    "FILE is an IES, EULUMDAT, TM-33 or GLDF profile, a folder of profiles, '-' for stdin, or @LIST\n"
    "for a list of files.",
    groups,
    examples,
    run};

} // namespace gonio::cli
