#include <gonio/light/light_color.hpp>
#include <gonio/media/module.hpp>
#include <gonio/preview/exposure.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/preview/ticks.hpp>

#include "../command.hpp"
#include "../console.hpp"
#include "../interrupt.hpp"
#include "../json_text.hpp"
#include "../options/common.hpp"
#include "../options/files_in_use.hpp"
#include "../options/light_input.hpp"
#include "../options/output.hpp"
#include "../preview/compare.hpp"
#include "../preview/contact_sheet.hpp"
#include "../preview/export.hpp"
#include "../preview/layers.hpp"
#include "../preview/picture.hpp"
#include "../preview/profile_sheet.hpp"
#include "../preview/refine.hpp"
#include "../preview/request.hpp"
#include "../preview/stats.hpp"
#include "../preview/sweep.hpp"
#include "../stopwatch.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <array>
#include <iterator>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

constexpr std::array groups{OptionGroup{"lights", rig_options},
                            light_group,
                            OptionGroup{"profiles", preview_profile_options},
                            OptionGroup{"stage", preview_stage_options},
                            OptionGroup{"picture", preview_picture_options},
                            OptionGroup{"evaluation", preview_method_options},
                            OptionGroup{"display mode", preview_look_options},
                            OptionGroup{"sheet", preview_sheet_options},
                            OptionGroup{"sweep", preview_sweep_options},
                            OptionGroup{"layers", preview_layer_options},
                            OptionGroup{"sheets, comparisons and sweeps", contact_sheet_options},
                            OptionGroup{"exposure", preview_exposure_options},
                            OptionGroup{"output", preview_output_options},
                            OptionGroup{"export", preview_export_options},
                            json_group,
                            light_common_group};
constexpr std::array examples{
    Example{"gonio preview lamp.ies --stage floor -s 512x512 -o lamp.png", "how a measured luminaire lights a room"},
    Example{"gonio preview --shape sphere:r=10cm --intensity 800lm -o bulb.png", "a globe"},
    Example{"gonio preview --rig room.json -o room.png", "all lights of a scene"},
    Example{"gonio preview lamp.ies --material 'kulla-conty:f0=rgb(1,0.77,0.34),alpha=0.2' -o gold.png",
            "its light on gold"},
    Example{"gonio preview lamp.ies --look falsecolour --scale 1lx:1000lx -o lux.png", "lux in false colour"},
    Example{"gonio preview --rig street.json --look isolux --levels 1lx,5lx,10lx -o lines.png", "lines of equal lux"},
    Example{"gonio preview lamp.ies --look falsecolour -o lux.exr", "the values in lux, one per pixel"},
    Example{"gonio preview lamp.ies --exposure lux:500lx -o office.png", "as an eye adapted to 500 lx sees it"},
    Example{"gonio preview lamp.ies --stage street --glare -o night.png", "the lamp as it dazzles an eye"},
    Example{"gonio preview --rig park.json --stats -o park.png", "print what the renderer skipped"},
    Example{"gonio preview --rig room.json --compare exact,frostbite -o methods.png",
            "how far a method is off, and where"},
    Example{"gonio preview --rig room.json --sweep cct=2000K:8000K:7 -o whites.png", "seven whites, from warm to cool"},
    Example{"gonio preview lamp.ies --sweep roughness=0.1:0.9:5 --sweep metallic=0,1 -o finish.png",
            "five finishes of paint and of metal"},
    Example{"gonio preview --rig room.json --aov lights -o room.exr", "a layer for each light, to mix them later"},
    Example{"gonio preview --shape rect:w=1m,h=1m --intensity 900lm --method reference --time 30s -o truth.exr",
            "the path-traced reference, for 30 seconds"},
    Example{"gonio preview --sheet catalogue -o sheet.png", "all profiles of a folder at a glance"},
    Example{"gonio preview --rig room.json --export room.py", "the same room for Blender's Cycles, as a check"},
    Example{"gonio preview lamp.ies -o - --to png | convert - lamp.jpg", "through a pipe, here to ImageMagick"},
};

// The values that a display mode other than beauty shows, in lux or cd/m².
Json values_json(const LookRequest& look, const EncodedPicture& picture) {
    Json values{{"quantity", to_text(look.quantity)},
                {"unit", look.quantity == PictureQuantity::illuminance ? "lx" : "cd/m2"},
                {"legend_unit", look.unit->symbol},
                {"greatest", picture.use.greatest}};
    if (picture.scale)
        values["scale"] = {{"kind", picture.scale->logarithmic ? "log" : "linear"},
                           {"low", picture.scale->low},
                           {"high", picture.scale->high},
                           {"below_share", picture.use.below_share},
                           {"above_share", picture.use.above_share}};
    if (look.look == Look::isolux) values["levels"] = picture.levels;
    return values;
}

Json preview_json(const PreviewRequest& request, const std::vector<Light>& lights, const EncodedPicture& picture,
                  const Diagnostics& diagnostics) {
    Json report{{"schema", "gonio.preview/1"},       {"output", request.output},    {"width", request.render.width},
                {"height", request.render.height},   {"file_width", picture.width}, {"stage", request.stage.name},
                {"look", to_text(request.look.look)}};
    if (request.look.look != Look::beauty) report["values"] = values_json(request.look, picture);
    report["exposure_ev100"] = picture.exposure.value;
    report["exposure"] = {{"mode", to_text(request.exposure.mode)},
                          {"white_nt", white_luminance(picture.exposure).value},
                          {"card_lx", card_illuminance(picture.exposure).value}};
    report["method"] = to_text(method_of(request.render));
    report["tone_map"] = to_text(request.exposure.tone_map);
    if (const std::optional<Eye>& eye = request.exposure.glare)
        report["glare"] = {{"age_years", eye->age_years}, {"pigment", eye->pigment}};
    if (!request.lights.rig_file.empty())
        report["rig"] = request.lights.rig_file;
    else if (!request.lights.rig.lights.empty())
        report["intensity_cd"] = lights.front().intensity.value;
    if (!request.render.sky.is_dark())
        report["sky"] = {
            {"horizontal_lx", glm::dot(request.render.sky.irradiance(glm::dvec3(0.0, 0.0, 1.0), request.render.threads),
                                       rec709_luminance)}};
    report["lights"] = lights.size();
    report["diagnostics"] = diagnostics_json(diagnostics);
    return report;
}

// In passes with the method reference, else in one go.
Result<RefinedPicture> picture_of(const PreviewRequest& request, std::span<const Light> lights,
                                  const Console& console) {
    if (request.render.method == IrradianceMethod::reference) return refine(request, lights, console);
    RenderOptions options = request.render;
    const PictureMethod method = method_of(options);
    if (Result<void> ready = prepare(options, {&method, 1}, request.stage, lights, request.probe_at); !ready)
        return pass_on(ready);
    Result<Rendering> rendered = render(request.stage, lights, request.stage.camera, options);
    if (!rendered) return pass_on(rendered);
    return RefinedPicture{std::move(*rendered)};
}

std::vector<std::string> names_in(std::span<const OutputFile> files) {
    std::vector<std::string> names;
    for (const OutputFile& file : files)
        names.push_back(file.name);
    return names;
}

Json names_of(std::span<const OutputFile> files) {
    return names_in(files);
}

// Appends the files of the scene, and reports anything the scene format cannot store.
Result<void> add_export(const PreviewRequest& request, const std::vector<Light>& lights, std::optional<Nits> white,
                        Console& console, Diagnostics& diagnostics, std::vector<OutputFile>& files) {
    Result<ExportedScene> exported = export_scene(request, lights, white);
    if (!exported) return pass_on(exported);
    console.say(exported->diagnostics);
    diagnostics.insert(diagnostics.end(), exported->diagnostics.begin(), exported->diagnostics.end());
    std::move(exported->files.begin(), exported->files.end(), std::back_inserter(files));
    return {};
}

Result<int> export_alone(const PreviewRequest& request, const std::vector<Light>& lights, Diagnostics diagnostics,
                         const Arguments& arguments, Console& console) {
    std::optional<Nits> white; // an automatic exposure follows from the picture, so without one it is unknown
    if (request.exposure.mode != ExposureMode::automatic) white = white_luminance(request.exposure.ev);
    std::vector<OutputFile> files;
    Result<void> done = add_export(request, lights, white, console, diagnostics, files);
    if (done) done = check_outputs(request.lights.files, names_in(files));
    if (done) done = write_outputs(files);
    if (!done) return Unexpected(done.error());
    if (!arguments.has("--json") && !arguments.has("--jsonl")) return 0;
    Json report{{"schema", "gonio.preview/1"},     {"output", nullptr},           {"width", request.render.width},
                {"height", request.render.height}, {"stage", request.stage.name}, {"lights", lights.size()}};
    report["export"] = names_of(files);
    report["diagnostics"] = diagnostics_json(diagnostics);
    console.print(dump(report, arguments.has("--jsonl") ? -1 : 2));
    return 0;
}

Result<int> preview(const Arguments& arguments, Console& console) {
    if (arguments.has("--export"))
        for (const std::string_view option : several_pictures)
            if (arguments.has(option))
                return fail("USE0107", fmt::format("--export is for one picture, {} for several", option),
                            "export without it");
    if (arguments.has("--aov")) return preview_layers(arguments, console);
    if (arguments.has("--sweep")) return preview_sweep(arguments, console);
    if (arguments.has("--sheet")) return preview_sheet(arguments, console);
    if (arguments.has("--compare")) return preview_compare(arguments, console);
    if (Result<void> plain = no_sheet_options(arguments); !plain) return pass_on(plain);
    Result<PreviewRequest> request = parse_preview(arguments);
    if (!request) return pass_on(request);
    Diagnostics diagnostics = request->diagnostics;
    Result<std::vector<Light>> lights = resolve_input(request->lights, diagnostics, request->render.threads);
    if (!lights) return pass_on(lights);
    console.say(diagnostics);
    if (arguments.has("--dry-run")) {
        for (const std::string& file : {request->output, request->export_file})
            if (!file.empty()) console.print(fmt::format("{}\n", file));
        return 0;
    }
    if (request->output.empty()) return export_alone(*request, *lights, diagnostics, arguments, console);
    const Stopwatch rendering;
    Result<RefinedPicture> pictured = picture_of(*request, *lights, console);
    if (!pictured) return pass_on(pictured);
    const double render_ms = rendering.milliseconds();
    Rendering& rendered = pictured->rendering;
    const RenderStats stats = rendered.stats;
    Diagnostics odd;
    if (has_pixel(*request->format, media::Pixel::float32)) warn_of_ceiling(rendered.luminance_nt, odd);
    warn_of_black(rendered.luminance_nt, *request, *lights, odd);
    console.say(odd);
    diagnostics.insert(diagnostics.end(), odd.begin(), odd.end());
    if (arguments.has("--ticks"))
        draw_ticks(rendered.luminance_nt, request->stage, *lights, request->stage.camera, request->render.threads);
    console.remark(fmt::format("rendered {}x{} pixels in {:.1f} ms, {} code", request->render.width,
                               request->render.height, render_ms, simd::to_text(request->render.instruction_set)));
    const Stopwatch encoding;
    Result<EncodedPicture> picture = encode_picture(std::move(rendered), *request, *lights, console);
    if (!picture) return pass_on(picture);
    console.remark(fmt::format("display transform and encoding: {:.1f} ms", encoding.milliseconds()));
    std::vector<OutputFile> files;
    files.push_back({request->output, std::move(picture->bytes)});
    if (!request->export_file.empty()) {
        const Result<void> exported =
            add_export(*request, *lights, white_luminance(picture->exposure), console, diagnostics, files);
        if (!exported) return Unexpected(exported.error());
        const Result<void> free = check_outputs(request->lights.files, names_in(files));
        if (!free) return Unexpected(free.error());
    }
    const Result<void> written = write_outputs(files);
    if (!written) return Unexpected(written.error());
    const bool as_json = arguments.has("--json") || arguments.has("--jsonl");
    if (as_json) {
        Json report = preview_json(*request, *lights, *picture, diagnostics);
        if (files.size() > 1) report["export"] = names_of(std::span(files).subspan(1));
        if (request->render.method == IrradianceMethod::reference)
            report["reference"] = {{"passes", pictured->passes},
                                   {"error_estimate", pictured->error_estimate},
                                   {"complete", !pictured->interrupted}};
        if (arguments.has("--stats")) report["stats"] = stats_json(stats, render_ms, media::opened_modules());
        console.print(dump(report, arguments.has("--jsonl") ? -1 : 2));
    } else if (arguments.has("--stats")) {
        // If the picture goes to stdout, the statistics go to stderr.
        const std::string text = stats_text(stats, render_ms, media::opened_modules());
        if (request->output == "-")
            console.note(text);
        else
            console.print(text);
    }
    return pictured->interrupted ? interrupted_status : 0;
}

int run(const Arguments& arguments, Console& console) {
    if constexpr (is_for_page) // it draws with these options by itself
        return console.fail(fail("UNS0101", "this page writes no pictures", "the command-line tool does").value());
    const Result<int> status = preview(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command preview_command;
const Command preview_command{
    "preview",
    "render how lights fall on a stage",
    "FILE | --rig RIG | --shape SHAPE … | --sheet FILE… -o OUT | -O DIR | --export SCENE",
    "FILE is an IES, EULUMDAT or TM-33 profile. A rig is a JSON file of schema gonio.rig/1, which\n"
    "may also name the stage, camera, materials and surfaces that emit. Options override the rig.",
    groups,
    examples,
    run,
    true};

} // namespace gonio::cli
