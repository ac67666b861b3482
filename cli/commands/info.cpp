#include <gonio/asset/facts_record.hpp>
#include <gonio/asset/figures_record.hpp>
#include <gonio/base/archive.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/figures/luminaire_figures.hpp>
#include <gonio/light/profile_facts.hpp>

#include "../arguments.hpp"
#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../csv_text.hpp"
#include "../facts_text.hpp"
#include "../figures_text.hpp"
#include "../gldf_text.hpp"
#include "../json_text.hpp"
#include "../options/common.hpp"
#include "../options/profile_input.hpp"
#include "../options/values.hpp"
#include "../polar_text.hpp"
#include "../spectra_text.hpp"

#include <fmt/format.h>

#include <array>

namespace gonio::cli {

namespace {

constexpr std::array report_options{
    Option{"--all", "", "also show NEMA type, CIE flux code, spacing criterion and the IES classification"},
    Option{
        "--figures", "",
        "also show what luminaires are planned by: UGR table, utilisation, luminances, BUG and other classes, and the "
        "quality of light of a spectrum"},
    Option{"--ugr-between", "WHAT",
           "UGR: what is linear between the measured directions, intensity or luminance (intensity)"},
    Option{"--csv", "", "a CSV table with a line for each file"},
    json_options[0],
    json_options[1],
};
constexpr std::array groups{OptionGroup{"report", report_options}, profile_input_group, threads_group, common_group};
constexpr std::array examples{
    Example{"gonio info lamp.ies", "format, angles, flux, peak, beam and field angle"},
    Example{"gonio info lamp.gldf --variant warm", "a luminaire with its variants, and the photometry of one"},
    Example{"gonio info office.ldt --figures", "its UGR table, utilisation factors, luminances and classes"},
    Example{"gonio info profiles --csv > profiles.csv", "a table of a folder, for a spreadsheet"},
    Example{"gonio info *.ldt --jsonl | jq -r 'select(.peak_cd > 5000).file'", "the bright profiles of a folder"},
};

// Two columns: the names and the values.
std::string text_of(const std::vector<FactLine>& lines) {
    std::string text;
    for (const FactLine& line : lines)
        text += fmt::format("  {:<12}{}\n", line.name, line.value);
    return text;
}

constexpr std::string_view csv_head = "file,format,planes,gammas,symmetry,flux_lm,declared_flux_lm,peak_cd,peak_c_deg,"
                                      "peak_gamma_deg,beam_angle_deg,field_angle_deg,input_W,intensity_unit,error\n";

std::string csv_line(const std::string& file, const ProfileFacts& facts) {
    const auto number = [](const std::optional<double>& value) { return value ? shortest(*value) : std::string(); };
    return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},\n", csv_field(file), facts.format, facts.planes,
                       facts.gammas, to_text(facts.symmetry), shortest(facts.flux_lm), number(facts.declared_flux_lm),
                       shortest(facts.peak.intensity.value), shortest(facts.peak.c_deg), shortest(facts.peak.gamma_deg),
                       number(facts.beam_deg), number(facts.field_deg), number(facts.input_w),
                       csv_field(facts.intensity_unit));
}

// A file that could not be read keeps its line.
std::string csv_line(const std::string& file, const Error& error) {
    return fmt::format("{},,,,,,,,,,,,,,{}\n", csv_field(file), csv_field(error.diagnostics.back().message));
}

std::string spectra_words(const Profile& profile, Diagnostics& diagnostics) {
    const Result<std::vector<ProfileSpectrum>> spectra = profile_spectra(profile);
    if (!spectra) return text_of({{"spectrum", "none: " + spectra.error().diagnostics.back().message}});
    for (const ProfileSpectrum& each : *spectra)
        diagnostics.insert(diagnostics.end(), each.quality.diagnostics.begin(), each.quality.diagnostics.end());
    return spectra_text(*spectra);
}

// As a figure, before the reasons for those that are missing; nothing for a profile without spectra.
void add_spectra(const Profile& profile, Json& report) {
    const Result<std::vector<ProfileSpectrum>> spectra = profile_spectra(profile);
    if (spectra && spectra->empty()) return;
    Json missing = std::move(report["missing_figures"]);
    report.erase("missing_figures");
    report["spectra"] = spectra ? spectra_json(*spectra) : Json(nullptr);
    if (!spectra) missing["spectra"] = spectra.error().diagnostics.back().message;
    report["missing_figures"] = std::move(missing);
}

int run(const Arguments& arguments, Console& console) {
    Result<std::vector<std::string>> files = input_files(arguments);
    if (!files) return console.fail(files.error());
    Result<ProfileInputOptions> options = profile_input(arguments);
    if (!options) return console.fail(options.error());
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return console.fail(threads.error());

    const ReportKind kind = report_kind(arguments);
    const bool csv = arguments.has("--csv");
    const bool figures = arguments.has("--figures");
    const bool all = figures || arguments.has("--all");
    if (csv && (kind != ReportKind::words || all))
        return console.fail(fail("USE0107", "--csv takes neither --all, --figures, --json nor --jsonl").value());
    FiguresOptions figures_options;
    if (const auto name = arguments.value("--ugr-between")) {
        constexpr std::array quantities{Named{"intensity", UgrInterpolation::intensity},
                                        Named{"luminance", UgrInterpolation::luminance}};
        Result<UgrInterpolation> named = find_value("quantity", *name, quantities);
        if (!named) return console.fail(named.error());
        figures_options.ugr_interpolation = *named;
    }
    const bool plot = Console::output_is_terminal() && files->size() == 1;
    const FactsExtent extent = csv                                ? FactsExtent::brief
                               : all || kind != ReportKind::words ? FactsExtent::all
                                                                  : FactsExtent::report;
    if (csv) console.print(csv_head);
    const auto figures_of = [&](const LoadedProfile& loaded) {
        return luminaire_figures(loaded.profile, loaded.web, options->resolve, figures_options);
    };
    return run_batch({*files, "gonio.info/1", "read", *threads}, kind, console, [&](std::size_t index) {
        const std::string& file = (*files)[index];
        Outcome outcome;
        Result<LoadedProfile> loaded = load(file, *options);
        if (!loaded) {
            if (csv) outcome.words = csv_line(file, loaded.error());
            outcome.error = std::move(loaded.error());
            return outcome;
        }
        std::optional<Gldf> gldf;
        if (is_archive(loaded->bytes)) {
            Result<Gldf> read = read_gldf(loaded->bytes, file);
            if (read) gldf = std::move(*read);
        }
        const ProfileFacts facts = profile_facts(loaded->profile, loaded->web, options->resolve, extent);
        if (csv) {
            outcome.words = csv_line(file, facts);
        } else if (kind == ReportKind::words) {
            outcome.words = file + "\n";
            if (gldf)
                outcome.words +=
                    gldf_text(*gldf) + text_of({{"photometry", loaded->profile.source.substr(file.size() + 1)}});
            outcome.words += text_of(fact_lines(facts));
            if (all) outcome.words += text_of(more_fact_lines(facts));
            if (figures)
                outcome.words +=
                    figures_text(figures_of(*loaded)) + spectra_words(loaded->profile, loaded->diagnostics);
            if (plot) outcome.words += polar_text(loaded->web);
        } else {
            outcome.report = detail::facts_json(file, facts, loaded->diagnostics);
            Json diagnostics = std::move(outcome.report["diagnostics"]);
            outcome.report.erase("diagnostics");
            outcome.report.update(detail::figures_json(figures_of(*loaded)));
            add_spectra(loaded->profile, outcome.report);
            if (gldf) {
                outcome.report["gldf"] = gldf_json(*gldf);
                outcome.report["photometry_file"] = loaded->profile.source;
            }
            outcome.report["diagnostics"] = std::move(diagnostics);
        }
        outcome.diagnostics = std::move(loaded->diagnostics);
        return outcome;
    });
}

} // namespace

extern const Command info_command;
const Command info_command{
    "info",
    "show the format, angles, symmetry, flux, peak, beam and field of a profile",
    "FILE… [options]",
    "FILE is an IES, EULUMDAT, TM-33 or GLDF profile, a folder of profiles, '-' for stdin, or @LIST\n"
    "for a list of files.",
    groups,
    examples,
    run};

} // namespace gonio::cli
