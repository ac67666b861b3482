#include <gonio/base/file.hpp>
#include <gonio/base/file_scope.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/nearest.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/photometry.hpp>
#include <gonio/scene/rig.hpp>

#include "../arguments.hpp"
#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_writer.hpp"
#include "../options/common.hpp"
#include "../options/output.hpp"
#include "../options/rig_input.hpp"
#include "../options/values.hpp"
#include "../sky/request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::cli {

namespace {

constexpr std::array new_options{
    Option{"-o,--output", "FILE", "new, expand: the file to write; '-' is stdout (-)"},
};
constexpr std::array check_options{
    Option{"--allow-outside", "", "let the rig name pipes and files outside its folder"},
};
constexpr std::array groups{OptionGroup{"output", new_options}, OptionGroup{"input", check_options}, json_group,
                            threads_group, common_group};
constexpr std::array examples{
    Example{"gonio rig new -o room.json", "a rig to edit, with a comment for each key"},
    Example{"gonio rig check room.json", "whether every key, name and file is right"},
    Example{"gonio rig list room.json", "every light, those of arrays and groups too: lumens, position, direction"},
    Example{"gonio rig expand room.json -o single.json", "the same lights, each written out"},
    Example{"gonio preview --rig room.json -o room.png", "what it looks like"},
};

// Every key that a rig can have, once; one that this light cannot have is a comment.
constexpr std::string_view skeleton =
    R"json(// A rig: the lights of a scene, the stage that they are shown on, and the camera.
// World: right-handed, Z up; arrays are in metres. Comments like this one may stay.
{
  "schema": "gonio.rig/1",
  "lights": [
    {
      "name": "key",
      "shape": "rect:w=60cm,h=30cm",  // gonio list shapes; a profile is "ies:lamp.ies", beside this file
      "intensity": "2000lm",          // lm, cd, nt, lx@2m, 60W@90lm/W; a profile may leave it out
      "color": "4000K",               // also "#ffd9a0", "rgb(1,0.8,0.6)", "d65", "spectrum:led.csv"
      "position": [0, 0, 2.4],        // of its centre
      "direction": [0, 0, -1],        // along which it shines
      "up": [0, 1, 0],                // its height, and C90 of a profile, point there
      // "target": [0, 0.5, 0.8],     // instead of a direction: the point that it is aimed at
      "rotate": "0deg",               // about the direction
      // "smooth": "1deg",            // only of a profile: a curve through its table, so that no facets show
      // "dimming": "80%",            // or 0.8; that of a group multiplies
      // "maintenance": 0.8,          // what is left of its light between two cleanings; multiplies, too
      "range": "12m"                  // where it has faded to nothing; leave it out for no limit
    },
    { "name": "lamp", "shape": "sphere:r=3cm", "intensity": "800lm", "color": "2700K", "position": [-1.2, -0.5, 1.2] }
    // { "luminaire": "downlight", "position": [0, 0, 2.4], "array": { "count": [3, 2], "spacing": [0.8, 1] } },
    // { "name": "row", "position": [1, 0, 0], "rotate": "90deg", "lights": [ … ] }   // a group
  ],
  // "luminaires": { "downlight": { "shape": "ies:downlight.ies" } },   // what lights name instead of a shape
  // "maintenance": 0.8,              // of all lights
  // "sky": "500lx",                  // light from all around, gonio list skies; a closed room keeps it out
  "stage": "room",                    // gonio list stages
  // "emits": { "sphere": "500nt,color=3000K" },  // surfaces of the stage that emit light, beside what they reflect
  "camera": { "position": [0, -2.8, 1.5], "target": [0, 0, 1], "up": [0, 0, 1], "fov": "60deg" },
  "materials": { "floor": "lambert:albedo=0.3" }  // of surfaces of the stage; gonio list materials
}
)json";

Result<int> write_new(const Arguments& arguments) {
    if (arguments.positional().size() > 1)
        return fail("USE0107", "'rig new' takes no file", "add -o FILE to write one");
    const std::string output = arguments.value("--output").value_or("-");
    if (output != "-" && file_exists(output))
        return fail("USE0108", fmt::format("'{}' exists", output), "remove it first, or give another name");
    Result<void> written = write_output(output, skeleton);
    if (!written) return pass_on(written);
    return 0;
}

std::string counted(std::size_t number, std::string_view what) {
    return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

// That emit these lights; a box emits six.
std::size_t surfaces_of(const std::vector<LightDescription>& emitted) {
    return static_cast<std::size_t>(std::count_if(
        emitted.begin(), emitted.end(), [](const LightDescription& light) { return light.emitted_by->face == 0; }));
}

Outcome check(const std::string& file, const RigReadOptions& options, const SkyRequest& request) {
    Outcome outcome;
    Result<Rig> rig = read_rig_file(file, options);
    if (!rig) {
        outcome.error = std::move(rig.error());
        return outcome;
    }
    Diagnostics diagnostics;
    if (rig->sky) {
        Result<LoadedSky> sky = load_sky(*rig, request);
        if (!sky) {
            outcome.error = std::move(sky.error());
            return outcome;
        }
        diagnostics = std::move(sky->diagnostics);
    }
    Result<std::vector<LightDescription>> emitted = emissive_lights(*rig);
    if (!emitted) {
        outcome.error = std::move(emitted.error());
        return outcome;
    }
    const std::size_t surfaces = surfaces_of(*emitted);
    std::vector<Light> of_surfaces;
    if (Result<void> added = add_resolved(std::move(*emitted), of_surfaces, diagnostics); !added) {
        outcome.error = std::move(added.error());
        return outcome;
    }
    const std::size_t files = rig->files.size();
    const std::string stage = rig->stage ? fmt::format(", stage '{}'", rig->stage->name) : std::string();
    Result<std::vector<Light>> lights = resolve_lights(std::move(*rig), diagnostics, 1);
    if (!lights) {
        outcome.error = std::move(lights.error());
        return outcome;
    }
    const std::string emitting =
        surfaces > 0 ? fmt::format(", {} that emit{}", counted(surfaces, "surface"), surfaces == 1 ? "s" : "")
                     : std::string();
    outcome.words = fmt::format("{}: {}{}, {}{}\n", file, counted(lights->size(), "light"), emitting,
                                counted(files, "file"), stage);
    outcome.report = {
        {"schema", "gonio.rig-check/1"}, {"file", file},   {"lights", lights->size()},
        {"emitting_surfaces", surfaces}, {"files", files}, {"diagnostics", diagnostics_json(diagnostics)}};
    outcome.diagnostics = std::move(diagnostics);
    return outcome;
}

Result<int> check_all(const Arguments& arguments, Console& console) {
    if constexpr (is_for_page) return fail("UNS0101", "this page does not check rigs", "the command-line tool does");
    const std::vector<std::string> files(arguments.positional().begin() + 1, arguments.positional().end());
    if (files.empty()) return fail("USE0104", "no rig is given", "for example: gonio rig check room.json");
    if (arguments.has("--output")) return fail("USE0107", "'rig check' writes no file", "leave -o out");
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    const RigReadOptions options = rig_read_options(arguments);
    Result<SkyRequest> sky = plain_sky_request(arguments);
    if (!sky) return pass_on(sky);
    sky->threads = 1; // rigs are checked side by side
    const ReportKind kind = report_kind(arguments);
    return run_batch({files, "gonio.rig-check/1", "checked", *threads}, kind, console, [&](std::size_t index) {
        Outcome outcome = check(files[index], options, *sky);
        if (kind == ReportKind::words) outcome.report = nullptr;
        return outcome;
    });
}

// The rig and its path, for actions that take one.
Result<std::string> only_rig(const Arguments& arguments, std::string_view action) {
    if (arguments.positional().size() == 2) return arguments.positional()[1];
    return fail(arguments.positional().size() < 2 ? Cause("USE0104") : Cause("USE0107"),
                fmt::format("'rig {}' takes one rig", action),
                fmt::format("for example: gonio rig {} room.json", action));
}

// File names in a rig are relative to its folder.
Result<void> check_folder(const std::string& rig, const std::string& output, bool names_files) {
    if (!names_files || output == "-" || folder_of_file(rig) == folder_of_file(output)) return {};
    return fail("USE0107", fmt::format("'{}' is not in the folder of the rig, which names files", output),
                "they are relative to the rig: write it beside '" + rig + "'");
}

Result<int> expand(const Arguments& arguments, Console& console) {
    Result<std::string> file = only_rig(arguments, "expand");
    if (!file) return pass_on(file);
    for (const std::string_view option : {"--json", "--jsonl"})
        if (arguments.has(option))
            return fail("USE0107", fmt::format("'rig expand' has no {}", option), "it writes a rig, which is JSON");
    Result<std::string> text =
        *file == "-" ? read_standard_input(limit("rig-bytes")) : read_file(*file, limit("rig-bytes"));
    if (!text) return pass_on(text);
    // All of it is checked first, so that what is written is sound.
    Result<Rig> rig = read_rig(*text, *file, folder_of_file(*file), rig_read_options(arguments));
    if (!rig) return pass_on(rig);
    const std::string output = arguments.value("--output").value_or("-");
    if (output == *file && output != "-")
        return fail("USE0108", fmt::format("'{}' would replace the rig itself", output), "give another name");
    if (Result<void> fits = check_folder(*file, output, !rig->files.empty()); !fits) return pass_on(fits);
    Result<std::string> expanded = expand_rig(*text, *file);
    if (!expanded) return pass_on(expanded);
    if (Result<void> written = write_output(output, *expanded); !written) return pass_on(written);
    console.say(rig->diagnostics);
    return 0;
}

Json vector_json(const glm::dvec3& v) {
    return Json::array({v.x + 0.0, v.y + 0.0, v.z + 0.0}); // without the sign of −0
}

std::string vector_text(const glm::dvec3& v) {
    constexpr double no_sign = 0.0; // −0 + 0 is 0
    return fmt::format("{},{},{}", rounded(v.x + no_sign, 4), rounded(v.y + no_sign, 4), rounded(v.z + no_sign, 4));
}

// Nothing where the shape has no such quantity.
std::optional<double> flux_lm(const Light& light) {
    Result<ShapePhotometry> photometry = ShapePhotometry::of(light.shape);
    const Result<PhotometricUnit> lumen = parse_photometric_unit("lm");
    if (!photometry || !lumen) return std::nullopt;
    const Result<double> flux = photometry->express({light.intensity, light.luminance, light.illuminance}, *lumen);
    return flux ? std::optional(*flux) : std::nullopt;
}

Result<int> list(const Arguments& arguments, Console& console) {
    if constexpr (is_for_page) return fail("UNS0101", "this page does not list lights", "the command-line tool does");
    Result<std::string> file = only_rig(arguments, "list");
    if (!file) return pass_on(file);
    if (arguments.has("--output")) return fail("USE0107", "'rig list' writes no file", "leave -o out");
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    Result<Rig> rig = read_rig_file(*file, rig_read_options(arguments));
    if (!rig) return pass_on(rig);
    std::vector<double> levels;
    for (const LightDescription& light : rig->lights)
        levels.push_back(light.level);
    Diagnostics diagnostics;
    Result<std::vector<Light>> lights = resolve_lights(std::move(*rig), diagnostics, *threads);
    if (!lights) return pass_on(lights);
    const ReportKind kind = report_kind(arguments);
    double sum_lm = 0.0;
    std::optional<JsonWriter> json;
    if (kind != ReportKind::words) {
        json.emplace(console, kind == ReportKind::json);
        json->member("schema", "gonio.rig-list/1");
        json->member("file", *file);
        json->begin_array("lights");
    }
    const auto width_of = [](const std::string& text) { return text.size(); };
    std::size_t name_width = 4;
    for (const Light& light : *lights)
        name_width = std::clamp<std::size_t>(width_of(light.name) + 2, name_width, 40);
    for (std::size_t i = 0; i < lights->size(); ++i) {
        const Light& light = (*lights)[i];
        const std::optional<double> lm = flux_lm(light);
        sum_lm += lm.value_or(0.0);
        if (json) {
            Json one{{"name", light.name}, {"shape", kind_of(light.shape)}};
            if (lm) one["flux_lm"] = *lm;
            one["level"] = levels[i];
            one["position"] = vector_json(light.frame.origin);
            one["direction"] = vector_json(-light.frame.z);
            one["up"] = vector_json(light.frame.y);
            json->element(one);
            continue;
        }
        console.print(fmt::format("{:<{}}{:<9}{:>12}  at {:<22} towards {}\n", light.name, name_width,
                                  kind_of(light.shape), lm ? fmt::format("{} lm", rounded(*lm)) : std::string("-"),
                                  vector_text(light.frame.origin), vector_text(-light.frame.z)));
    }
    if (json) {
        json->end_array();
        json->member("flux_lm", sum_lm);
        json->member("diagnostics", diagnostics_json(diagnostics));
        json->end();
    } else {
        console.print(fmt::format("{}, {} lm\n", counted(lights->size(), "light"), rounded(sum_lm)));
    }
    console.say(diagnostics);
    return 0;
}

struct Action {
    std::string_view name;
    Result<int> (*work)(const Arguments& arguments, Console& console);
};

constexpr std::array actions{
    Action{"new", [](const Arguments& arguments, Console& /*console*/) { return write_new(arguments); }},
    Action{"check", check_all},
    Action{"list", list},
    Action{"expand", expand},
};

Result<int> work(const Arguments& arguments, Console& console) {
    const std::vector<std::string>& words = arguments.positional();
    if (words.empty())
        return fail("USE0104", "new, check, list or expand?",
                    "gonio rig new prints a rig to edit, gonio rig check FILE checks one");
    for (const Action& action : actions)
        if (action.name == words.front()) return action.work(arguments, console);
    std::vector<std::string_view> names;
    for (const Action& action : actions)
        names.push_back(action.name);
    if (!nearest(words.front(), names).empty()) return unknown_name("action", words.front(), names);
    return fail("USE0103", fmt::format("unknown action '{}'", words.front()),
                fmt::format("write gonio rig new, or gonio rig check '{}'", words.front()));
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = work(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command rig_command;
const Command rig_command{
    "rig",
    "start a rig, the JSON file of a scene's lights, check, list or expand one",
    "new [-o FILE] | check RIG… | list RIG | expand RIG [-o FILE]",
    "A rig lists the lights of a scene, and if wanted its stage, camera, materials and the surfaces that emit. "
    "preview,\n"
    "probe and import take it. The smallest one is a shape and an amount:\n"
    "\n"
    "  { \"schema\": \"gonio.rig/1\",\n"
    "    \"lights\": [ { \"shape\": \"sphere:r=3cm\", \"intensity\": \"800lm\", \"position\": [0, 0, 2] } ] }\n"
    "\n"
    "'rig new' prints one with every key and a comment to each. Shapes, colours and materials are written as on the\n"
    "command line ('gonio list shapes'). Files are looked up beside the rig. The schema for editors is\n"
    "share/gonio/rig.schema.json of an installed gonio. 'rig check' reads all of it and its files.\n"
    "\n"
    "Lights that repeat have a luminaire by name, an array, positions, or groups; every command takes the single\n"
    "lights that they stand for. 'rig list' prints those, and 'rig expand' writes them as a rig.",
    groups,
    examples,
    run};

} // namespace gonio::cli
