#include <gonio/base/archive.hpp>
#include <gonio/base/codes/archive.hpp>
#include <gonio/base/file.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/profile/gldf.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/repetitions.hpp>

#include "../arguments.hpp"
#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_text.hpp"
#include "../options/common.hpp"
#include "../options/profile_input.hpp"
#include "../options/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::array groups{profile_input_group, json_group, threads_group, common_group};
constexpr std::array examples{
    Example{"gonio check lamp.ies", "errors of the file, and implausible light"},
    Example{"gonio check --strict library", "a folder, held to the letter of the standards"},
    Example{"gonio explain WEB0301", "the meaning of a code"},
};

struct Checked {
    Diagnostics diagnostics;
    int status = 0; // 0, 1, or that of a file that could not be read
    bool readable = true;
    int errors = 0;
    int warnings = 0;
    int notes = 0;
};

void count(Checked& checked, bool strict) {
    for (const Diagnostic& diagnostic : checked.diagnostics) {
        checked.errors += diagnostic.severity == Severity::error ? 1 : 0;
        checked.warnings += diagnostic.severity == Severity::warning ? 1 : 0;
        checked.notes += diagnostic.severity == Severity::note ? 1 : 0;
    }
    if (checked.errors > 0 || (strict && checked.warnings > 0)) checked.status = std::max(checked.status, 1);
}

Checked unreadable(const Error& error) {
    Checked checked;
    checked.diagnostics = error.diagnostics;
    checked.status = static_cast<int>(error.failure);
    checked.readable = false;
    return checked;
}

// Most files that strict reading refuses can still be read; only a file that lenient reading refuses is unreadable.
// `flux_lm`: the light of a readable file, if it is wanted.
Checked check(const std::string& bytes, const std::string& file, const ProfileInputOptions& options,
              ReadBeside read_beside, double* flux_lm = nullptr) {
    ReadOptions read = options.read;
    read.read_beside = std::move(read_beside);
    read.strict = false;
    Result<Profile> profile = read_profile(bytes, file, read);
    if (!profile) return unreadable(profile.error());
    Checked checked;
    checked.diagnostics = profile->diagnostics;
    if (options.read.strict) {
        read.strict = true;
        const Result<Profile> strict = read_profile(bytes, file, read);
        checked.diagnostics = strict ? strict->diagnostics : strict.error().diagnostics;
    }
    Result<ResolvedWeb> resolved = resolve_web(*profile, options.resolve);
    if (!resolved) {
        Error error = std::move(resolved.error());
        error.diagnostics.insert(error.diagnostics.begin(), checked.diagnostics.begin(), checked.diagnostics.end());
        return unreadable(error);
    }
    checked.diagnostics = report_of(std::move(checked.diagnostics), *profile, *resolved, options.resolve);
    if (flux_lm != nullptr) *flux_lm = flux(resolved->web).value;
    return checked;
}

// A photometric file of an archive.
Checked check_entry(const Archive& archive, const ArchiveEntry& entry, const ProfileInputOptions& options,
                    double* flux_lm) {
    const std::string name = archive.name_of(entry);
    if (entry.size > limit("profile-bytes").value)
        return unreadable(
            error_at("FIL0104", {name, 0, 0}, fmt::format("larger than {}", to_text(limit("profile-bytes")))));
    const Result<std::string> bytes = archive.read(entry);
    if (!bytes) return unreadable(bytes.error());
    if (is_archive(*bytes)) return unreadable(error_at("INP0101", {name, 0, 0}, "it is an archive itself"));
    return check(*bytes, name, options, reader_in(archive, entry.name), flux_lm);
}

// The document and every photometry in it, as strictly as a profile.
Checked check_gldf(const std::string& bytes, const std::string& file, const ProfileInputOptions& options) {
    const Result<Archive> archive = Archive::open(bytes, file);
    if (!archive) return unreadable(archive.error());
    Result<Gldf> gldf = read_gldf(*archive);
    if (!gldf) return unreadable(gldf.error());
    Checked checked;
    checked.diagnostics = gldf->diagnostics;
    if (options.read.strict) {
        const Result<Gldf> strict = read_gldf(*archive, true);
        if (!strict) checked.diagnostics = strict.error().diagnostics;
    }
    std::map<std::string, std::optional<double>> fluxes; // of entries, if they can be read
    for (const GldfFile& one : gldf->files) {
        if (one.entry.empty() || !one.content_type.starts_with("ldc")) continue;
        const auto [at, is_new] = fluxes.try_emplace(one.entry);
        if (!is_new) continue;
        double flux_lm = 0.0;
        Checked of = check_entry(*archive, *archive->find(one.entry), options, &flux_lm);
        if (of.readable) {
            at->second = flux_lm;
        } else {
            Diagnostic said = of.diagnostics.empty() ? Diagnostic{} : of.diagnostics.back();
            const ArchiveCode code = "GLD0211";
            said.code = code->code;
            said.severity = code->severity;
            said.message = fmt::format("the photometric file is not readable: {}", said.message);
            of.diagnostics = {std::move(said)};
        }
        checked.diagnostics.insert(checked.diagnostics.end(), of.diagnostics.begin(), of.diagnostics.end());
    }
    std::size_t off = 0;
    constexpr std::size_t most = 8;
    for (const GldfEmitter& emitter : gldf->emitters)
        for (const GldfLight& light : emitter.lights) {
            if (!light.flux_lm || light.kind == "changeable" || !light.photometry) continue;
            const std::optional<std::size_t> of = gldf->photometries[*light.photometry].file;
            const auto found = of ? fluxes.find(gldf->files[*of].entry) : fluxes.end();
            if (found == fluxes.end() || !found->second) continue;
            const double flux_lm = *found->second;
            constexpr double tolerance = 0.01;
            if (std::abs(flux_lm - *light.flux_lm) <= tolerance * std::max(flux_lm, *light.flux_lm)) continue;
            if (++off > most) continue;
            const ArchiveCode code = "GLD0208";
            checked.diagnostics.push_back({std::string(code->code),
                                           code->severity,
                                           light.location,
                                           fmt::format("the emitter states {} lm, and its photometry has {} lm",
                                                       rounded(*light.flux_lm), rounded(flux_lm)),
                                           {}});
        }
    if (off > most) checked.diagnostics.back().message += fmt::format(" (and {} emitters more)", off - most);
    return checked;
}

std::string counted(int number, std::string_view what) {
    return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

std::string verdict(const Checked& checked) {
    std::string text;
    for (const auto& [number, what] :
         {std::pair{checked.errors, "error"}, std::pair{checked.warnings, "warning"}, std::pair{checked.notes, "note"}})
        if (number > 0) text += (text.empty() ? "" : ", ") + counted(number, what);
    if (text.empty()) return "no problems found";
    return checked.readable ? text : "unreadable, " + text;
}

Json to_json(const std::string& file, const Checked& checked) {
    return {{"schema", "gonio.check/1"},    {"file", file},
            {"readable", checked.readable}, {"passed", checked.status == 0},
            {"errors", checked.errors},     {"warnings", checked.warnings},
            {"notes", checked.notes},       {"diagnostics", diagnostics_json(checked.diagnostics)}};
}

int run(const Arguments& arguments, Console& console) {
    Result<std::vector<std::string>> files = input_files(arguments);
    if (!files) return console.fail(files.error());
    Result<ProfileInputOptions> options = profile_input(arguments);
    if (!options) return console.fail(options.error());
    if (options->smooth_deg)
        return console.fail(fail("USE0107", "check judges the file as it is, so --smooth has no effect").value());
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return console.fail(threads.error());

    const ReportKind kind = report_kind(arguments);
    std::atomic<std::size_t> clean = 0;
    std::atomic<std::size_t> passed = 0;
    std::atomic<std::size_t> failed = 0;
    std::atomic<std::size_t> not_read = 0;
    const int status = run_batch({*files, "gonio.check/1", "checked", *threads}, kind, console, [&](std::size_t index) {
        const std::string& file = (*files)[index];
        Outcome outcome;
        Result<std::string> bytes =
            file == "-" ? read_standard_input(limit("archive-bytes")) : read_file(file, limit_of_profile(file));
        if (!bytes) {
            outcome.error = std::move(bytes.error());
            return outcome;
        }
        Checked checked = is_archive(*bytes)
                              ? check_gldf(*bytes, file, *options)
                              : check(*bytes, file, *options, file == "-" ? ReadBeside() : reader_beside(file));
        count(checked, options->read.strict);
        (checked.diagnostics.empty() ? clean
         : !checked.readable         ? not_read
         : checked.status == 0       ? passed
                                     : failed) += 1;
        outcome.status = checked.status;
        if (kind == ReportKind::words)
            outcome.words = fmt::format("{}: {}\n", file, verdict(checked));
        else
            outcome.report = to_json(file, checked);
        outcome.diagnostics = std::move(checked.diagnostics);
        return outcome;
    });
    if (files->size() > 1)
        console.note(fmt::format("{} without problems, {} passed with remarks, {} did not pass, {} unreadable",
                                 clean.load(), passed.load(), failed.load(), not_read.load()));
    return status;
}

} // namespace

extern const Command check_command;
const Command check_command{
    "check",
    "validate the text, the numbers and the physics of profiles",
    "FILE… [options]",
    "FILE is an IES, EULUMDAT, TM-33 or GLDF profile, a folder of profiles, '-' for stdin, or @LIST\n"
    "for a list of files. Exit status: 0 passed; 1 an error, or with --strict a warning;\n"
    "4 unreadable.",
    groups,
    examples,
    run};

} // namespace gonio::cli
