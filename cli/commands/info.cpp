#include <gonio/base/unit_text.hpp>
#include <gonio/light/far_field.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/profile/luminous_opening.hpp>
#include <gonio/profile/text_encoding.hpp>
#include <gonio/profile/tm33_light.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/radiometric.hpp>
#include <gonio/web/spacing.hpp>
#include <gonio/web/symmetry.hpp>
#include <gonio/web/zones.hpp>

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
#include <charconv>

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

struct Lamp {
    int count = 1;
    std::string type;
    std::optional<double> flux_lm; // of the lamp set
    std::optional<double> cct_k;
    std::string cri;
    std::optional<double> input_w;
};

// Everything that is reported about a profile, in the order of the report.
struct Facts {
    std::string file;
    std::string intensity_unit = "cd"; // of a radiometric profile what it states: "mW/sr"
    std::string flux_unit = "lm";
    const char* format = "";
    std::string version;
    char photometry = 'C';
    std::size_t planes = 0;
    std::size_t gammas = 0;
    Symmetry symmetry = Symmetry::none;
    Symmetry declared_symmetry = Symmetry::none;
    std::vector<Lamp> lamps;
    double flux_lm = 0.0; // this and all that is called lm or cd: in the units above
    double zonal_flux_lm = 0.0;
    std::optional<double> declared_flux_lm;
    Peak peak;
    std::optional<double> beam_deg;
    std::optional<double> field_deg;
    std::optional<double> beam_c90_deg;
    std::optional<double> field_c90_deg;
    std::optional<double> input_w;
    LuminousOpening opening;
    std::optional<double> point_distance_m; // from which on a point is within 1 %
    Candelas center_beam;
    std::optional<double> cie_beam_deg;
    std::optional<double> cie_beam_c90_deg;
    std::optional<int> nema_horizontal;
    std::optional<int> nema_vertical;
    std::array<Lumens, 18> zones;
    CieFluxCode cie_code;
    SpacingCriterion spacing;
    double street_side_c_deg = 0.0; // what front is in the next one
    LuminaireClassification classes;

    // The flux of the 10° zones that make up [low, high], both multiples of 10.
    double zone_lm(std::size_t low_deg, std::size_t high_deg) const {
        double sum = 0.0;
        for (std::size_t i = low_deg / 10; i < high_deg / 10; ++i)
            sum += zones[i].value;
        return sum;
    }
};

// The number at the start of a text: "3000K" is 3000. Empty for "nw".
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
        if (keyword.name == "LAMP") lamp.type = to_utf8(keyword.text);
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
        facts.lamps.push_back({std::abs(set.lamp_count), to_utf8(set.lamp_type), if_positive(set.flux_lm),
                               leading_number(set.color_temperature), to_utf8(set.color_rendering),
                               if_positive(set.input_watts)});
    facts.input_w = facts.lamps[static_cast<std::size_t>(lamp_set) - 1].input_w;
}

void add_file_facts(Facts& facts, const Tm33File& file) {
    facts.format = "TM-33";
    facts.version = edition(file);
    const Photometry photometry = photometry_of(file).value_or(Photometry::c);
    facts.photometry = photometry == Photometry::a ? 'A' : photometry == Photometry::b ? 'B' : 'C';
    double watts = 0.0;
    for (const Tm33Emitter& emitter : file.emitters) {
        if (emitter.intensity && facts.planes == 0) {
            facts.planes = emitter.intensity->horizontal_deg.size();
            facts.gammas = emitter.intensity->vertical_deg.size();
        }
        watts += emitter.input_watts.value_or(0.0);
        const double count = emitter.quantity.value_or(1.0);
        facts.lamps.push_back({count >= 1.0 && count <= 1e6 ? static_cast<int>(count) : 1, emitter.description,
                               if_positive(emitter.rated_lumens.value_or(0.0) * count), emitter.cct_k,
                               emitter.cri_ra ? fmt::format("{}", *emitter.cri_ra) : std::string(),
                               if_positive(emitter.input_watts.value_or(0.0))});
    }
    facts.input_w = if_positive(watts);
}

std::optional<double> in_degrees(const std::optional<Radians>& angle) {
    return angle ? std::optional(to_degrees(*angle)) : std::nullopt;
}

std::optional<int> nema_of(const std::optional<double>& field_deg) {
    return field_deg ? std::optional(nema_type(degrees(*field_deg))) : std::nullopt;
}

// "mW/sr" is mW over the sphere. What a unit without "/sr" is over the sphere is not known.
std::string flux_unit_of(std::string_view intensity_unit) {
    constexpr std::string_view per_steradian = "/sr";
    if (!intensity_unit.ends_with(per_steradian)) return fmt::format("{}·sr", intensity_unit);
    intensity_unit.remove_suffix(per_steradian.size());
    return std::string(intensity_unit);
}

// The facts that the short report does not show cost more than all the others: `all` asks for them.
Facts facts_of(const std::string& file, const LoadedProfile& loaded, const ResolveOptions& options, bool all) {
    Facts facts;
    facts.file = file;
    if (const std::string unit = radiometric_unit(loaded.profile); !unit.empty() && !options.as_candela) {
        facts.intensity_unit = unit;
        facts.flux_unit = flux_unit_of(unit);
    }
    if (const auto* ies = std::get_if<IesFile>(&loaded.profile.file))
        add_file_facts(facts, *ies);
    else if (const auto* tm33 = std::get_if<Tm33File>(&loaded.profile.file))
        add_file_facts(facts, *tm33);
    else
        add_file_facts(facts, std::get<LdtFile>(loaded.profile.file), options.lamp_set);
    const Web& web = loaded.web;
    facts.symmetry = detected_symmetry(web);
    facts.declared_symmetry = web.stored_symmetry();
    facts.flux_lm = flux(web).value;
    facts.zonal_flux_lm = zonal_flux(web).value;
    facts.declared_flux_lm = declared_flux_lm(loaded.profile, options);
    facts.peak = peak(web);
    facts.beam_deg = in_degrees(spread_angle(web, 0.0, 0.5));
    facts.field_deg = in_degrees(spread_angle(web, 0.0, 0.1));
    facts.beam_c90_deg = in_degrees(spread_angle(web, 90.0, 0.5));
    facts.field_c90_deg = in_degrees(spread_angle(web, 90.0, 0.1));
    facts.opening = luminous_opening(loaded.profile);
    if (const auto body = LuminousBody::of(opening_of(loaded.profile), web))
        facts.point_distance_m = point_distance(*body, web, 0.01).value;
    facts.nema_horizontal = nema_of(facts.field_deg);
    facts.nema_vertical = nema_of(facts.field_c90_deg);
    facts.zones = ten_degree_zones(web);
    if (!all) return facts;
    facts.center_beam = center_beam(web);
    facts.cie_beam_deg = in_degrees(cie_beam_angle(web, 0.0));
    facts.cie_beam_c90_deg = in_degrees(cie_beam_angle(web, 90.0));
    facts.cie_code =
        cie_flux_code(web, facts.declared_flux_lm ? std::optional(Lumens(*facts.declared_flux_lm)) : std::nullopt);
    facts.spacing = spacing_criterion(web);
    facts.street_side_c_deg = street_side_c_deg(loaded.profile, web);
    facts.classes = luminaire_classification(web, facts.street_side_c_deg);
    return facts;
}

std::optional<double> efficacy(const Facts& facts) {
    return facts.input_w && facts.flux_unit == "lm" ? std::optional(facts.flux_lm / *facts.input_w) : std::nullopt;
}

Json zones_json(const Facts& facts) {
    Json zones = Json::object();
    constexpr std::array<std::array<std::size_t, 2>, 7> bands{
        {{0, 30}, {0, 40}, {0, 60}, {60, 90}, {0, 90}, {90, 180}, {0, 180}}};
    for (const auto& [low, high] : bands)
        zones[fmt::format("{}-{}", low, high)] = facts.zone_lm(low, high);
    return zones;
}

Json ten_degree_json(const Facts& facts) {
    Json zones = Json::array();
    for (const Lumens lumens : facts.zones)
        zones.push_back(lumens.value);
    return zones;
}

// In per cent, as CIE 52 writes them.
Json cie_code_json(const CieFluxCode& code) {
    Json numbers = Json::array();
    const auto add = [&](const std::optional<double>& part) {
        numbers.push_back(number_or_null(part ? std::optional(100.0 * *part) : std::nullopt));
    };
    for (const std::optional<double>& part : code.within)
        add(part);
    add(code.downward);
    add(code.light_output_ratio);
    return numbers;
}

Json classes_json(const LuminaireClassification& classes) {
    constexpr std::array names{"L", "M", "H", "VH"};
    Json json = Json::object();
    for (std::size_t i = 0; i < names.size(); ++i)
        json[std::string("F") + names[i]] = classes.front[i].value;
    for (std::size_t i = 0; i < names.size(); ++i)
        json[std::string("B") + names[i]] = classes.back[i].value;
    json["UL"] = classes.up_low.value;
    json["UH"] = classes.up_high.value;
    return json;
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
            {"intensity_unit", facts.intensity_unit},
            {"flux_unit", facts.flux_unit},
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
            {"point_distance_m", number_or_null(facts.point_distance_m)},
            {"center_beam_cd", facts.center_beam.value},
            {"beam_angle_cie_deg", number_or_null(facts.cie_beam_deg)},
            {"beam_angle_cie_c90_deg", number_or_null(facts.cie_beam_c90_deg)},
            {"nema_horizontal", facts.nema_horizontal ? Json(*facts.nema_horizontal) : Json(nullptr)},
            {"nema_vertical", facts.nema_vertical ? Json(*facts.nema_vertical) : Json(nullptr)},
            {"zones_lm", zones_json(facts)},
            {"ten_degree_zones_lm", ten_degree_json(facts)},
            {"cie_flux_code_percent", cie_code_json(facts.cie_code)},
            {"spacing_criterion",
             {{"c0_180", number_or_null(facts.spacing.along_c0)},
              {"c90_270", number_or_null(facts.spacing.along_c90)},
              {"diagonal", number_or_null(facts.spacing.diagonal)}}},
            {"lcs_front_c_deg", facts.street_side_c_deg},
            {"lcs_lm", classes_json(facts.classes)},
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

std::string line_of(std::string_view name, const std::string& value) {
    return fmt::format("  {:<12}{}\n", name, value);
}

std::string to_text(const Facts& facts) {
    std::string text = facts.file + "\n";
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
    for (const Lamp& lamp : facts.lamps) {
        std::string value = fmt::format("{} ×", lamp.count);
        if (!lamp.type.empty()) value += " " + lamp.type;
        if (lamp.flux_lm) value += fmt::format(", {} {}", rounded(*lamp.flux_lm), facts.flux_unit);
        if (lamp.cct_k) value += fmt::format(", {} K", rounded(*lamp.cct_k));
        line("lamps", value);
    }
    if (const std::optional<double> of_input = efficacy(facts))
        line("input", fmt::format("{} W, {} lm/W", rounded(*facts.input_w), rounded(*of_input, 4)));
    else if (facts.input_w)
        line("input", fmt::format("{} W", rounded(*facts.input_w)));
    line("opening", opening_text(facts.opening));
    if (facts.point_distance_m)
        line("far field", fmt::format("a point is within 1 % from {} m on", rounded(*facts.point_distance_m, 2)));
    return text;
}

// What --all adds.
std::string more_text(const Facts& facts) {
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

std::string csv_line(const Facts& facts) {
    const auto number = [](const std::optional<double>& value) { return value ? shortest(*value) : std::string(); };
    return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},\n", csv_field(facts.file), facts.format,
                       facts.planes, facts.gammas, to_text(facts.symmetry), shortest(facts.flux_lm),
                       number(facts.declared_flux_lm), shortest(facts.peak.intensity.value), shortest(facts.peak.c_deg),
                       shortest(facts.peak.gamma_deg), number(facts.beam_deg), number(facts.field_deg),
                       number(facts.input_w), csv_field(facts.intensity_unit));
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
        const Facts facts = facts_of(file, *loaded, options->resolve, all || kind != ReportKind::words);
        if (csv) {
            outcome.words = csv_line(facts);
        } else if (kind == ReportKind::words) {
            outcome.words = to_text(facts) + (all ? more_text(facts) : std::string());
            if (plot) outcome.words += polar_text(loaded->web);
        } else {
            outcome.report = to_json(facts, loaded->diagnostics);
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
