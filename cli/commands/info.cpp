#include <gonio/base/unit_text.hpp>
#include <gonio/profile/luminous_opening.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_text.hpp"
#include "../options/common.hpp"
#include "../options/profile_input.hpp"
#include "../polar_text.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>

namespace gonio::cli {

namespace {

constexpr std::array groups{profile_input_group, json_group, common_group};
constexpr std::array examples{
    Example{"gonio info lamp.ies", "format, angles, flux, peak, beam and field angle"},
    Example{"gonio info *.ldt --jsonl | jq -r 'select(.peak_cd > 5000).file'", "the bright ones of a folder"},
};

struct Lamp {
    int count = 1;
    std::string type;
    std::optional<double> flux_lm; // of the set
    std::optional<double> cct_k;
    std::string cri;
    std::optional<double> input_w;
};

// Everything that is reported of a profile, in the order of the report.
struct Facts {
    std::string file;
    const char* format = "";
    std::string version;
    char photometry = 'C';
    std::size_t planes = 0;
    std::size_t gammas = 0;
    Symmetry symmetry = Symmetry::none;
    Symmetry declared_symmetry = Symmetry::none;
    std::vector<Lamp> lamps;
    double flux_lm = 0.0;
    double zonal_flux_lm = 0.0;
    std::optional<double> declared_flux_lm;
    Peak peak;
    std::optional<double> beam_deg;
    std::optional<double> field_deg;
    std::optional<double> beam_c90_deg;
    std::optional<double> field_c90_deg;
    std::optional<double> input_w;
    LuminousOpening opening;
};

// The number that a text begins with: "3000K" is 3000. Nothing for "nw".
std::optional<double> leading_number(std::string_view text) {
    while (text.starts_with(' '))
        text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() ? std::optional(value) : std::nullopt;
}

std::optional<double> if_positive(double value) {
    return value > 0.0 ? std::optional(value) : std::nullopt;
}

void add_file_facts(Facts& facts, const IesFile& file) {
    facts.format = "IES";
    facts.version = to_text(file.version);
    facts.photometry = file.photometry == Photometry::a ? 'A' : file.photometry == Photometry::b ? 'B' : 'C';
    facts.planes = file.horizontal_deg.size();
    facts.gammas = file.vertical_deg.size();
    facts.input_w = if_positive(file.input_watts);
    Lamp lamp;
    lamp.count = file.lamp_count;
    for (const IesKeyword& keyword : file.keywords)
        if (keyword.name == "LAMP") lamp.type = keyword.text;
    if (file.lumens_per_lamp > 0.0) lamp.flux_lm = file.lumens_per_lamp * file.lamp_count;
    lamp.input_w = facts.input_w;
    facts.lamps.push_back(std::move(lamp));
}

void add_file_facts(Facts& facts, const LdtFile& file, int lamp_set) {
    facts.format = "LDT";
    facts.version = "EULUMDAT";
    facts.gammas = file.gammas_deg.size();
    facts.planes = facts.gammas == 0 ? 0 : file.candela_per_klm.size() / facts.gammas;
    for (const LdtLampSet& set : file.lamp_sets)
        facts.lamps.push_back({std::abs(set.lamp_count), set.lamp_type, if_positive(set.flux_lm),
                               leading_number(set.color_temperature), set.color_rendering,
                               if_positive(set.input_watts)});
    facts.input_w = facts.lamps[static_cast<std::size_t>(lamp_set) - 1].input_w;
}

std::optional<double> spread_deg(const Web& web, double c_deg, double fraction) {
    const std::optional<Radians> angle = spread_angle(web, c_deg, fraction);
    return angle ? std::optional(to_degrees(*angle)) : std::nullopt;
}

Facts facts_of(const std::string& file, const LoadedProfile& loaded, const ResolveOptions& options) {
    Facts facts;
    facts.file = file;
    if (const auto* ies = std::get_if<IesFile>(&loaded.profile.file))
        add_file_facts(facts, *ies);
    else
        add_file_facts(facts, std::get<LdtFile>(loaded.profile.file), options.lamp_set);
    const Web& web = loaded.web;
    facts.symmetry = detected_symmetry(web);
    facts.declared_symmetry = web.stored_symmetry();
    facts.flux_lm = flux(web).value;
    facts.zonal_flux_lm = zonal_flux(web).value;
    facts.declared_flux_lm = declared_flux_lm(loaded.profile, options);
    facts.peak = peak(web);
    facts.beam_deg = spread_deg(web, 0.0, 0.5);
    facts.field_deg = spread_deg(web, 0.0, 0.1);
    facts.beam_c90_deg = spread_deg(web, 90.0, 0.5);
    facts.field_c90_deg = spread_deg(web, 90.0, 0.1);
    facts.opening = luminous_opening(loaded.profile);
    return facts;
}

std::optional<double> efficacy(const Facts& facts) {
    return facts.input_w ? std::optional(facts.flux_lm / *facts.input_w) : std::nullopt;
}

Json to_json(const Facts& facts, const Diagnostics& diagnostics) {
    Json lamps = Json::array();
    for (const Lamp& lamp : facts.lamps)
        lamps.push_back({{"count", lamp.count},
                         {"type", lamp.type},
                         {"flux_lm", number_or_null(lamp.flux_lm)},
                         {"cct_K", number_or_null(lamp.cct_k)},
                         {"cri", lamp.cri.empty() ? Json(nullptr) : Json(lamp.cri)},
                         {"input_W", number_or_null(lamp.input_w)}});
    return {{"schema", "gonio.info/1"},
            {"file", facts.file},
            {"format", facts.format},
            {"version", facts.version},
            {"photometry", std::string(1, facts.photometry)},
            {"planes", facts.planes},
            {"gammas", facts.gammas},
            {"symmetry", to_text(facts.symmetry)},
            {"declared_symmetry", to_text(facts.declared_symmetry)},
            {"lamps", std::move(lamps)},
            {"flux_lm", facts.flux_lm},
            {"zonal_flux_lm", facts.zonal_flux_lm},
            {"declared_flux_lm", number_or_null(facts.declared_flux_lm)},
            {"absolute", !facts.declared_flux_lm},
            {"peak_cd", facts.peak.intensity.value},
            {"peak_c_deg", facts.peak.c_deg},
            {"peak_gamma_deg", facts.peak.gamma_deg},
            {"beam_angle_deg", number_or_null(facts.beam_deg)},
            {"field_angle_deg", number_or_null(facts.field_deg)},
            {"beam_angle_c90_deg", number_or_null(facts.beam_c90_deg)},
            {"field_angle_c90_deg", number_or_null(facts.field_c90_deg)},
            {"input_W", number_or_null(facts.input_w)},
            {"efficacy_lm_per_W", number_or_null(efficacy(facts))},
            {"luminous_opening",
             {{"shape", to_text(facts.opening.shape)},
              {"width_m", facts.opening.width_m},
              {"length_m", facts.opening.length_m},
              {"height_m", facts.opening.height_m}}},
            {"diagnostics", diagnostics_json(diagnostics)}};
}

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

std::string to_text(const Facts& facts) {
    std::string text = facts.file + "\n";
    const auto line = [&](std::string_view name, const std::string& value) {
        text += fmt::format("  {:<12}{}\n", name, value);
    };
    line("format", fmt::format("{} {}, type {}", facts.format, facts.version, facts.photometry));
    line("grid", fmt::format("{} C-planes × {} gamma angles", facts.planes, facts.gammas));
    line("symmetry", facts.symmetry == facts.declared_symmetry
                         ? std::string(to_text(facts.symmetry))
                         : fmt::format("{} (declared {})", to_text(facts.symmetry), to_text(facts.declared_symmetry)));
    line("flux", fmt::format("{} lm (zonal {} lm, declared {})", rounded(facts.flux_lm), rounded(facts.zonal_flux_lm),
                             facts.declared_flux_lm ? rounded(*facts.declared_flux_lm) + " lm"
                                                    : std::string("none: absolute photometry")));
    line("peak", fmt::format("{} cd at C {}°, gamma {}°", rounded(facts.peak.intensity.value),
                             rounded(facts.peak.c_deg), rounded(facts.peak.gamma_deg)));
    line("beam", fmt::format("{} in C0–C180, {} in C90–C270", degrees_or_none(facts.beam_deg),
                             degrees_or_none(facts.beam_c90_deg)));
    line("field", fmt::format("{} in C0–C180, {} in C90–C270", degrees_or_none(facts.field_deg),
                              degrees_or_none(facts.field_c90_deg)));
    for (const Lamp& lamp : facts.lamps) {
        std::string value = fmt::format("{} ×", lamp.count);
        if (!lamp.type.empty()) value += " " + lamp.type;
        if (lamp.flux_lm) value += fmt::format(", {} lm", rounded(*lamp.flux_lm));
        if (lamp.cct_k) value += fmt::format(", {} K", rounded(*lamp.cct_k));
        line("lamps", value);
    }
    if (facts.input_w)
        line("input", fmt::format("{} W, {} lm/W", rounded(*facts.input_w), rounded(*efficacy(facts), 4)));
    line("opening", opening_text(facts.opening));
    return text;
}

// A file that could not be read still has its place in a report of several.
Json failure_json(const std::string& file, const Error& error) {
    return {{"schema", "gonio.info/1"}, {"file", file}, {"diagnostics", diagnostics_json(error.diagnostics)}};
}

int run(const Arguments& arguments, Console& console) {
    Result<std::vector<std::string>> files = input_files(arguments);
    if (!files) return console.fail(files.error());
    Result<ProfileInputOptions> options = profile_input(arguments);
    if (!options) return console.fail(options.error());

    const bool lines = arguments.has("--jsonl");
    const bool json = arguments.has("--json");
    const bool plot = Console::output_is_terminal() && files->size() == 1;
    Json all = Json::array();
    int status = 0;
    std::size_t failed = 0;
    for (const std::string& file : *files) {
        Result<LoadedProfile> loaded = load(file, *options);
        Json report;
        if (!loaded) {
            status = worse(status, console.fail(loaded.error()));
            ++failed;
            report = failure_json(file, loaded.error());
        } else {
            console.say(loaded->diagnostics);
            const Facts facts = facts_of(file, *loaded, options->resolve);
            if (json || lines) {
                report = to_json(facts, loaded->diagnostics);
            } else {
                console.print(to_text(facts));
                if (plot) console.print(polar_text(loaded->web));
            }
        }
        if (lines) console.print(dump(report, -1));
        if (json && !lines) all.push_back(std::move(report));
    }
    if (json && !lines) console.print(dump(files->size() == 1 ? all[0] : all, 2));
    if (files->size() > 1 && failed > 0)
        console.note(fmt::format("{} of {} files could not be read", failed, files->size()));
    return status;
}

} // namespace

extern const Command info_command;
const Command info_command{"info",
                           "what a profile is: format, angles, symmetry, flux, peak, beam and field",
                           "FILE… [options]",
                           "FILE is an IES or EULUMDAT profile, '-' for standard input, @LIST for a list of files.",
                           groups,
                           examples,
                           run};

} // namespace gonio::cli
