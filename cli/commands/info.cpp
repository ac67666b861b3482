#include <gonio/asset/facts_record.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/profile_facts.hpp>

#include "../arguments.hpp"
#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../csv_text.hpp"
#include "../json_text.hpp"
#include "../options/common.hpp"
#include "../options/profile_input.hpp"
#include "../options/values.hpp"
#include "../polar_text.hpp"

#include <fmt/format.h>

#include <array>

namespace gonio::cli {

namespace {

constexpr std::array report_options{
    Option{"--all", "", "also show NEMA type, CIE flux code, spacing criterion and the IES classification"},
    Option{"--csv", "", "a CSV table with a line for each file"},
    json_options[0],
    json_options[1],
};
constexpr std::array groups{OptionGroup{"report", report_options}, profile_input_group, threads_group, common_group};
constexpr std::array examples{
    Example{"gonio info lamp.ies", "format, angles, flux, peak, beam and field angle"},
    Example{"gonio info profiles --csv > profiles.csv", "a table of a folder, for a spreadsheet"},
    Example{"gonio info *.ldt --jsonl | jq -r 'select(.peak_cd > 5000).file'", "the bright profiles of a folder"},
};

std::string degrees_or_none(const std::optional<double>& angle) {
    return angle ? fmt::format("{:.1f}°", *angle) : std::string("none");
}

// "disk, 0.12 m", "rectangle, 0.6 × 1.2 m"
std::string opening_text(const LuminousOpening& opening) {
    std::string text = to_text(opening.shape);
    const char* separator = ", ";
    for (const double size : {opening.width_m, opening.length_m, opening.height_m}) {
        if (size == 0.0) continue;
        text += separator + rounded(size);
        separator = " × ";
    }
    return opening.shape == OpeningShape::point ? text : text + " m";
}

std::string line_of(std::string_view name, const std::string& value) {
    return fmt::format("  {:<12}{}\n", name, value);
}

std::string to_text(const std::string& file, const ProfileFacts& facts) {
    std::string text = file + "\n";
    const auto line = [&](std::string_view name, const std::string& value) { text += line_of(name, value); };
    line("format", fmt::format("{} {}, type {}", facts.format, facts.version, facts.photometry));
    line("grid", facts.photometry == 'C'
                     ? fmt::format("{} C-planes × {} gamma angles", facts.planes, facts.gammas)
                     : fmt::format("{} horizontal × {} vertical angles", facts.planes, facts.gammas));
    line("symmetry", facts.symmetry == facts.declared_symmetry
                         ? std::string(to_text(facts.symmetry))
                         : fmt::format("{} (declared {})", to_text(facts.symmetry), to_text(facts.declared_symmetry)));
    const std::string& lm = facts.flux_unit;
    line("flux",
         fmt::format("{} {} (zonal {} {}, declared {})", rounded(facts.flux_lm), lm, rounded(facts.zonal_flux_lm), lm,
                     facts.declared_flux_lm ? fmt::format("{} {}", rounded(*facts.declared_flux_lm), lm)
                                            : std::string("none: absolute photometry")));
    line("peak", fmt::format("{} {} at C {}°, gamma {}°", rounded(facts.peak.intensity.value), facts.intensity_unit,
                             rounded(facts.peak.c_deg), rounded(facts.peak.gamma_deg)));
    line("beam", fmt::format("{} in C0–C180, {} in C90–C270", degrees_or_none(facts.beam_deg),
                             degrees_or_none(facts.beam_c90_deg)));
    line("field", fmt::format("{} in C0–C180, {} in C90–C270", degrees_or_none(facts.field_deg),
                              degrees_or_none(facts.field_c90_deg)));
    if (facts.photometry != 'C' && facts.nema_horizontal && facts.nema_vertical)
        line("NEMA", fmt::format("type {}H × {}V", *facts.nema_horizontal, *facts.nema_vertical));
    if (facts.flux_lm > 0.0) {
        const auto percent = [&](std::size_t low, std::size_t high) {
            return fmt::format("{:.0f} %", std::abs(100.0 * facts.zone_lm(low, high) / facts.flux_lm));
        };
        line("zones", fmt::format("0–30° {}, 30–60° {}, 60–90° {}, above 90° {}", percent(0, 30), percent(30, 60),
                                  percent(60, 90), percent(90, 180)));
    }
    for (const DeclaredLamps& lamp : facts.lamps) {
        std::string value = fmt::format("{} ×", lamp.count);
        if (!lamp.type.empty()) value += " " + lamp.type;
        if (lamp.flux_lm) value += fmt::format(", {} {}", rounded(*lamp.flux_lm), facts.flux_unit);
        if (lamp.cct_k) value += fmt::format(", {} K", rounded(*lamp.cct_k));
        line("lamps", value);
    }
    if (const std::optional<double> of_input = facts.efficacy_lm_per_w())
        line("input", fmt::format("{} W, {} lm/W", rounded(*facts.input_w), rounded(*of_input, 4)));
    else if (facts.input_w)
        line("input", fmt::format("{} W", rounded(*facts.input_w)));
    line("opening", opening_text(facts.opening));
    if (facts.point_distance_m)
        line("far field", fmt::format("a point is within 1 % from {} m on", rounded(*facts.point_distance_m, 2)));
    return text;
}

// What --all adds.
std::string more_text(const ProfileFacts& facts) {
    std::string text;
    const auto line = [&](std::string_view name, const std::string& value) { text += line_of(name, value); };
    const auto number = [](const std::optional<double>& value, int digits) {
        return value ? rounded(*value, digits) : std::string("none");
    };
    line("centre beam", fmt::format("{} {}", rounded(facts.center_beam.value), facts.intensity_unit));
    line("CIE beam", fmt::format("{} in C0–C180, {} in C90–C270", degrees_or_none(facts.cie_beam_deg),
                                 degrees_or_none(facts.cie_beam_c90_deg)));
    if (facts.photometry == 'C' && facts.nema_horizontal && facts.nema_vertical)
        line("NEMA", fmt::format("type {}H × {}V", *facts.nema_horizontal, *facts.nema_vertical));
    std::string code;
    const auto add = [&](const std::optional<double>& part) {
        code += (code.empty() ? "" : " ") + (part ? fmt::format("{:.0f}", 100.0 * *part) : std::string("-"));
    };
    for (const std::optional<double>& part : facts.cie_code.within)
        add(part);
    add(facts.cie_code.downward);
    add(facts.cie_code.light_output_ratio);
    line("CIE code", code);
    line("spacing",
         fmt::format("{} along C0, {} along C90, {} diagonal (times the height)", number(facts.spacing.along_c0, 3),
                     number(facts.spacing.along_c90, 3), number(facts.spacing.diagonal, 3)));
    const auto zones = [&](std::string_view side, const std::array<Lumens, 4>& lumens) {
        constexpr std::array names{"L", "M", "H", "VH"};
        std::string list;
        for (std::size_t i = 0; i < names.size(); ++i)
            list += fmt::format("{}{}{} {}", i == 0 ? "" : ", ", side, names[i], rounded(lumens[i].value, 4));
        return list;
    };
    line("LCS front", fmt::format("{} {}, on the side of C{}", zones("F", facts.classes.front), facts.flux_unit,
                                  rounded(facts.street_side_c_deg)));
    line("LCS back", fmt::format("{} {}", zones("B", facts.classes.back), facts.flux_unit));
    line("LCS up", fmt::format("UL {}, UH {} {}", rounded(facts.classes.up_low.value, 4),
                               rounded(facts.classes.up_high.value, 4), facts.flux_unit));
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

int run(const Arguments& arguments, Console& console) {
    Result<std::vector<std::string>> files = input_files(arguments);
    if (!files) return console.fail(files.error());
    Result<ProfileInputOptions> options = profile_input(arguments);
    if (!options) return console.fail(options.error());
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return console.fail(threads.error());

    const ReportKind kind = report_kind(arguments);
    const bool csv = arguments.has("--csv");
    const bool all = arguments.has("--all");
    if (csv && (kind != ReportKind::words || all))
        return console.fail(fail("USE0107", "--csv takes neither --all nor --json or --jsonl").value());
    const bool plot = Console::output_is_terminal() && files->size() == 1;
    if (csv) console.print(csv_head);
    return run_batch({*files, "gonio.info/1", "read", *threads}, kind, console, [&](std::size_t index) {
        const std::string& file = (*files)[index];
        Outcome outcome;
        Result<LoadedProfile> loaded = load(file, *options);
        if (!loaded) {
            if (csv) outcome.words = csv_line(file, loaded.error());
            outcome.error = std::move(loaded.error());
            return outcome;
        }
        const bool more = all || kind != ReportKind::words;
        const ProfileFacts facts = profile_facts(loaded->profile, loaded->web, options->resolve, more);
        if (csv) {
            outcome.words = csv_line(file, facts);
        } else if (kind == ReportKind::words) {
            outcome.words = to_text(file, facts) + (all ? more_text(facts) : std::string());
            if (plot) outcome.words += polar_text(loaded->web);
        } else {
            outcome.report = detail::facts_json(file, facts, loaded->diagnostics);
        }
        outcome.diagnostics = std::move(loaded->diagnostics);
        return outcome;
    });
}

} // namespace

extern const Command info_command;
const Command info_command{"info",
                           "show the format, angles, symmetry, flux, peak, beam and field of a profile",
                           "FILE… [options]",
                           "FILE is an IES, EULUMDAT or TM-33 profile, a folder of profiles, '-' for stdin, or @LIST\n"
                           "for a list of files.",
                           groups,
                           examples,
                           run};

} // namespace gonio::cli
