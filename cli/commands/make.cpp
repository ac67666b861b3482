#include <gonio/base/file.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/lobe.hpp>
#include <gonio/light/shape.hpp>
#include <gonio/web/author.hpp>
#include <gonio/web/author_csv.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/transform.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_text.hpp"
#include "../options/common.hpp"
#include "../options/files_in_use.hpp"
#include "../options/output.hpp"
#include "../options/profile_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::array light_options{
    Option{"--lumens", "FLUX", "flux of the luminaire: 1200lm (1000lm; csv: that of the table)"},
    Option{"--watts", "POWER", "input power: 12W (none)"},
    Option{"--absolute", "", "absolute photometry: declare no lamp flux"},
    Option{"--opening", "SHAPE", "luminous opening: point, disk:d=15cm, rect:w=30cm,l=1.2m, box:w=,l=,h=, tube:d=,l="},
};
constexpr std::array table_options{
    Option{"--planes", "STEP", "step between C-planes or horizontal angles (5deg)"},
    Option{"--gammas", "STEP", "step between vertical angles (2.5deg)"},
    Option{"--type", "TYPE", "type of goniometer of the table: A, B or C (C)"},
};
constexpr std::array text_options{
    Option{"--name", "TEXT", "name of the luminaire (its shape)"},
    Option{"--number", "TEXT", "catalogue number of the luminaire"},
    Option{"--lamp", "TEXT", "name of the lamp"},
    Option{"--keyword", "NAME=TEXT", "any other keyword, for example _CCT=3000", {}, true},
};
constexpr std::array groups{OptionGroup{"light", light_options},
                            OptionGroup{"table", table_options},
                            OptionGroup{"texts", text_options},
                            profile_output_group,
                            json_group,
                            common_group};
constexpr std::array examples{
    Example{"gonio make spot:outer=25deg,inner=15deg --lumens 800lm -o spot.ies", "a cone with a soft edge"},
    Example{"gonio make downlight:beam=36deg --lumens 1200lm --watts 12W --opening disk:d=15cm -o down.ldt",
            "a recessed downlight as EULUMDAT"},
    Example{"gonio make csv:table.csv -o lamp.ies", "a table of candela from a spreadsheet"},
};

// A spot is parsed as the light shape of the library.
Result<AuthoredShape> shape_of(const std::string& text) {
    if (!text.starts_with("spot:")) {
        Result<AuthoredShape> shape = parse_authored(text);
        if (!shape && text.find(':') == std::string::npos)
            error_hint(shape.error(), "there are: spot, cosine, gaussian, downlight, batwing, wall-washer, street, "
                                      "tube, csv:FILE");
        return shape;
    }
    Result<Shape> parsed = parse_shape(text);
    if (!parsed) return pass_on(parsed);
    const auto& spot = std::get<SpotShape>(*parsed);
    if (!spot.mask_file.empty()) return fail("USE0107", "make does not take a mask for a spot");
    return AuthoredShape{[spot](double, double gamma) { return lobe(spot, degrees(gamma)); }, Symmetry::axial, 90.0};
}

Result<double> positive(const Arguments& arguments, std::string_view option, Dimension dimension, double standard) {
    const auto text = arguments.value(option);
    if (!text) return standard;
    Result<double> value = parse_amount(*text, dimension, option);
    if (!value) return pass_on(value);
    if (*value > 0.0) return *value;
    return fail("USE0106", fmt::format("{} must be greater than 0, not {}", option, *text));
}

Result<double> step(const Arguments& arguments, std::string_view option, double standard_deg) {
    Result<double> rad = positive(arguments, option, Dimension::angle, degrees(standard_deg).value);
    if (!rad) return rad;
    return std::round(to_degrees(Radians(*rad)) * 1e9) / 1e9;
}

Result<Photometry> type_of(const Arguments& arguments) {
    constexpr std::array types{Named{"A", Photometry::a}, Named{"B", Photometry::b}, Named{"C", Photometry::c}};
    const std::string name = arguments.value("--type").value_or("C");
    Result<Photometry> type = find_value("goniometer", to_upper(name), types);
    return type ? type : find_value("goniometer", name, types);
}

struct OpeningKind {
    std::string_view name;
    OpeningShape shape;
    std::array<std::string_view, 3> keys; // width, length, height; "d" fills every size it is given for
};

constexpr std::array opening_kinds{
    OpeningKind{"point", OpeningShape::point, {}},
    OpeningKind{"disk", OpeningShape::disk, {"d", "d", ""}},
    OpeningKind{"rect", OpeningShape::rectangle, {"w", "l", ""}},
    OpeningKind{"box", OpeningShape::box, {"w", "l", "h"}},
    OpeningKind{"tube", OpeningShape::horizontal_cylinder, {"d", "l", "d"}},
    OpeningKind{"cylinder", OpeningShape::vertical_cylinder, {"d", "d", "h"}},
    OpeningKind{"sphere", OpeningShape::sphere, {"d", "d", "d"}},
};

Result<LuminousOpening> opening_of(const Arguments& arguments) {
    const auto text = arguments.value("--opening");
    if (!text) return LuminousOpening{};
    Result<KindText> parsed = parse_kind_text(*text);
    if (!parsed) return pass_on(parsed);
    Result<const OpeningKind*> found = find_named("opening", parsed->kind, opening_kinds);
    if (!found) return pass_on(found);
    const OpeningKind& kind = **found;
    std::vector<std::string_view> keys;
    for (const std::string_view key : kind.keys)
        if (!key.empty() && std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
    if (Result<void> only = only_keys(*parsed, keys); !only) return pass_on(only);
    LuminousOpening opening{kind.shape, 0.0, 0.0, 0.0};
    const std::array sizes{&opening.width_m, &opening.length_m, &opening.height_m};
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (kind.keys[i].empty()) continue;
        const std::string* const value = parsed->value(kind.keys[i]);
        if (value == nullptr) return fail("USE0104", fmt::format("the opening '{}' needs {}", kind.name, kind.keys[i]));
        Result<double> meters = parse_amount(*value, Dimension::length, kind.keys[i]);
        if (!meters) return pass_on(meters);
        if (!(*meters > 0.0)) return fail("USE0106", fmt::format("{}={} is not greater than 0", kind.keys[i], *value));
        *sizes[i] = *meters;
    }
    return opening;
}

Result<ProfileHeader> header_for(const Arguments& arguments, const std::string& shape, double lumens,
                                 ProfileTarget target) {
    ProfileHeader header;
    header.source = shape;
    for (const std::string& text : arguments.values("--keyword")) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0)
            return fail("USE0105", fmt::format("'{}' is not a keyword", text), "write --keyword NAME=TEXT");
        header.keywords.push_back({text.substr(0, equals), text.substr(equals + 1)});
    }
    // Adds what the standard requires and a formula does not have.
    const auto add_missing = [&](std::string_view name, std::string_view text) {
        if (keyword_text(header, name).empty()) set_keyword(header, name, text);
    };
    add_missing("TEST", "computed, not measured");
    if (target != ProfileTarget::eulumdat) {
        add_missing("TESTLAB", "none");
        add_missing("ISSUEDATE", "none");
    }
    add_missing("MANUFAC", "none");
    if (const auto text = arguments.value("--number")) set_keyword(header, "LUMCAT", *text);
    set_keyword(header, "LUMINAIRE", arguments.value("--name").value_or(shape));
    if (const auto text = arguments.value("--lamp")) set_keyword(header, "LAMP", *text);
    Result<double> watts = positive(arguments, "--watts", Dimension::power, 0.0);
    if (!watts) return pass_on(watts);
    header.input_watts = *watts;
    Result<LuminousOpening> opening = opening_of(arguments);
    if (!opening) return pass_on(opening);
    header.opening = *opening;
    if (!arguments.has("--absolute")) header.lamp_flux_lm = lumens;
    return header;
}

Result<Web> web_for(const Arguments& arguments, const std::string& shape, double lumens, const std::string& output) {
    if (shape.starts_with("csv:")) {
        for (const std::string_view option : {"--planes", "--gammas", "--type"})
            if (arguments.has(option))
                return fail("USE0107", fmt::format("{} does not apply to a table that lists its angles", option));
        const std::string file = shape.substr(4);
        if (Result<void> free = check_outputs({&file, 1}, {&output, 1}); !free) return pass_on(free);
        Result<std::string> text =
            file == "-" ? read_standard_input(limit("table-bytes")) : read_file(file, limit("table-bytes"));
        if (!text) return pass_on(text);
        Result<Web> web = web_from_csv(*text, file);
        if (!web || !arguments.has("--lumens")) return web;
        return scaled_to(*web, Lumens(lumens));
    }
    AuthorOptions options;
    options.flux = Lumens(lumens);
    Result<Photometry> type = type_of(arguments);
    if (!type) return pass_on(type);
    options.photometry = *type;
    Result<double> planes = step(arguments, "--planes", 5.0);
    if (!planes) return pass_on(planes);
    options.horizontal_step_deg = *planes;
    Result<double> gammas = step(arguments, "--gammas", 2.5);
    if (!gammas) return pass_on(gammas);
    options.vertical_step_deg = *gammas;
    Result<AuthoredShape> authored_shape = shape_of(shape);
    if (!authored_shape) return pass_on(authored_shape);
    return authored(*authored_shape, options);
}

Result<int> make(const Arguments& arguments, Console& console) {
    if (arguments.positional().size() != 1)
        return fail("USE0107", fmt::format("make takes one shape, not {}", arguments.positional().size()),
                    "for example: gonio make downlight:beam=36deg -o down.ies");
    const std::string& shape = arguments.positional().front();
    Result<ProfileOutput> output = profile_output(arguments);
    if (!output) return pass_on(output);
    const bool lines = arguments.has("--jsonl");
    const bool json = lines || arguments.has("--json");
    if (json && output->file == "-") return both_to_standard_output("profile");
    Result<double> lumens = positive(arguments, "--lumens", Dimension::luminous_flux, 1000.0);
    if (!lumens) return pass_on(lumens);
    Result<Web> web = web_for(arguments, shape, *lumens, output->file);
    if (!web) return pass_on(web);
    const bool declares = !shape.starts_with("csv:") || arguments.has("--lumens");
    Result<ProfileHeader> header =
        header_for(arguments, shape, declares ? *lumens : std::round(flux(*web).value * 1e3) / 1e3, output->target);
    if (!header) return pass_on(header);
    Result<WrittenProfile> written = write_luminaire({std::move(*web), std::move(*header)}, *output);
    if (!written) return pass_on(written);
    console.say(written->diagnostics);
    if (json) {
        const Json report{{"schema", "gonio.make/1"},
                          {"shape", shape},
                          {"output", output->file},
                          {"flux_lm", written->flux_lm},
                          {"peak_cd", written->peak_cd},
                          {"max_error_cd", written->max_error_cd},
                          {"diagnostics", diagnostics_json(written->diagnostics)}};
        console.print(dump(report, lines ? -1 : 2));
    }
    return 0;
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = make(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command make_command;
const Command make_command{
    "make",
    "create a profile from a formula or a table: spot, beam, batwing, wall-washer, street light",
    "SHAPE -o OUT [options]",
    "SHAPE is spot:outer=…,inner=…,falloff=… or one of these; the values shown are the defaults:\n"
    "  cosine:power=1,up=0                      cos^p of gamma; up: this factor upwards\n"
    "  gaussian:beam=30deg                      half of the peak at the beam angle\n"
    "  downlight:beam=30deg,spill=0.05          a beam with soft spill light\n"
    "  batwing:reach=45deg,across=45deg,edge=0.25  uniform illuminance inside an ellipse on the floor\n"
    "  wall-washer:lean=35deg,height=18deg,width=32deg,spill=0.03  a lobe towards a wall at C0\n"
    "  street:throw=60deg,out=20deg,width=20deg  two lobes along C0–C180, turned to the street at C90\n"
    "  tube:r=13mm,l=1.2m                       a bare Lambertian tube along C0\n"
    "  csv:FILE                                 first row: gamma angles; then rows of C and its candela",
    groups,
    examples,
    run};

} // namespace gonio::cli
