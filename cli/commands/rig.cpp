#include <gonio/base/file.hpp>
#include <gonio/scene/rig.hpp>

#include "../arguments.hpp"
#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../options/common.hpp"
#include "../options/output.hpp"
#include "../options/rig_input.hpp"
#include "../options/values.hpp"
#include "../sky/request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace gonio::cli {

namespace {

constexpr std::array new_options{
    Option{"-o,--output", "FILE", "new: the file to write; '-' is stdout (-)"},
};
constexpr std::array check_options{
    Option{"--allow-outside", "", "check: let the rig name pipes and files outside its folder"},
};
constexpr std::array groups{OptionGroup{"output", new_options}, OptionGroup{"input", check_options}, json_group,
                            threads_group, common_group};
constexpr std::array examples{
    Example{"gonio rig new -o room.json", "a rig to edit, with a comment for each key"},
    Example{"gonio rig check room.json", "whether every key, name and file is right"},
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
      "rotate": "0deg",               // about the direction
      // "smooth": "1deg",            // only of a profile: a curve through its table, so that no facets show
      "range": "12m"                  // where it has faded to nothing; leave it out for no limit
    },
    { "name": "lamp", "shape": "sphere:r=3cm", "intensity": "800lm", "color": "2700K", "position": [-1.2, -0.5, 1.2] }
  ],
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

Result<int> work(const Arguments& arguments, Console& console) {
    const std::vector<std::string>& words = arguments.positional();
    if (words.empty())
        return fail("USE0104", "new or check?", "gonio rig new prints a rig to edit, gonio rig check FILE checks one");
    if (words.front() == "new") return write_new(arguments);
    if (words.front() == "check") return check_all(arguments, console);
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
    "start a rig, the JSON file of a scene's lights, or check one",
    "new [-o FILE] | check RIG…",
    "A rig lists the lights of a scene, and if wanted its stage, camera, materials and the surfaces that emit. "
    "preview,\n"
    "probe and import take it. The smallest one is a shape and an amount:\n"
    "\n"
    "  { \"schema\": \"gonio.rig/1\",\n"
    "    \"lights\": [ { \"shape\": \"sphere:r=3cm\", \"intensity\": \"800lm\", \"position\": [0, 0, 2] } ] }\n"
    "\n"
    "'rig new' prints one with every key and a comment to each. Shapes, colours and materials are written as on the\n"
    "command line ('gonio list shapes'). Files are looked up beside the rig. The schema for editors is\n"
    "share/gonio/rig.schema.json of an installed gonio. 'rig check' reads all of it and its files.",
    groups,
    examples,
    run};

} // namespace gonio::cli
