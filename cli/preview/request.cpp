#include "request.hpp"

#include <gonio/asset/stage_scene.hpp>

#include "../options/bounces.hpp"
#include "../options/files_in_use.hpp"
#include "../options/light_input.hpp"
#include "../options/output.hpp"
#include "../options/sky_input.hpp"
#include "../options/values.hpp"
#include "export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

Result<Shadows> read_shadows(const Arguments& arguments) {
    const auto kind = arguments.value("--shadows");
    if (arguments.has("--no-shadows")) {
        if (kind && *kind != "off")
            return fail("USE0107", fmt::format("--shadows {} and --no-shadows are both given", *kind),
                        "leave one of them out");
        return Shadows::off;
    }
    if (!kind || *kind == "soft") return Shadows::soft;
    if (*kind == "hard") return Shadows::hard;
    if (*kind == "off") return Shadows::off;
    return fail("USE0105", fmt::format("'{}' is not a kind of shadows", *kind), "off, hard or soft");
}

Result<void> read_picture(const Arguments& arguments, PreviewRequest& request) {
    if (const auto text = arguments.value("--size")) {
        Result<PixelSize> size = parse_size(*text);
        if (!size) return pass_on(size);
        request.render.width = size->width;
        request.render.height = size->height;
    }
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    Result<simd::InstructionSet> set = instruction_set(arguments);
    if (!set) return pass_on(set);
    request.render.threads = *threads;
    request.render.instruction_set = *set;
    Result<Shadows> shadows = read_shadows(arguments);
    if (!shadows) return pass_on(shadows);
    request.render.shadows = *shadows;
    request.render.shows_sky = arguments.has("--show-sky");
    // The library never reads the environment; the tool passes $OCIO on.
    const char* const config = std::getenv("OCIO");
    request.display.config = arguments.value("--ocio").value_or(config == nullptr ? "" : config);
    request.display.display = arguments.value("--display").value_or("");
    request.display.view = arguments.value("--view").value_or("");
    request.display.threads = *threads;
    return {};
}

Result<void> read_compared(const Arguments& arguments, PreviewRequest& request) {
    const auto text = arguments.value("--compare");
    if (!text) return {};
    if (arguments.has("--method"))
        return fail("USE0107", "--method and --compare are both given", "name every method in --compare");
    Result<std::vector<PictureMethod>> methods = parse_picture_methods(*text);
    if (!methods) return pass_on(methods);
    if (methods->size() < 2)
        return fail("USE0104", fmt::format("--compare {} names only one method", *text),
                    "name two or more, the one to compare with first: for example --compare exact,frostbite");
    request.compared = std::move(*methods);
    return {};
}

bool is_one_picture(const Arguments& arguments) {
    return std::none_of(several_pictures.begin(), several_pictures.end(),
                        [&](std::string_view option) { return arguments.has(option); });
}

Result<void> read_method(const Arguments& arguments, PreviewRequest& request) {
    if (Result<void> compared = read_compared(arguments, request); !compared) return compared;
    Result<PictureMethod> method = parse_picture_method(arguments.value("--method").value_or("exact"));
    if (!method) return pass_on(method);
    set_method(request.render, *method);
    if (has_local_probe(method->surroundings))
        for (const std::string_view option : {"--aov", "--sweep", "--sheet"})
            if (arguments.has(option))
                return fail("USE0107",
                            fmt::format("the method {} is for one picture, not for {}", to_text(*method), option),
                            "--compare shows it beside others");
    if (const auto at = arguments.value("--probe-at")) {
        const auto needs_it = [](const PictureMethod& m) { return has_local_probe(m.surroundings); };
        if (!needs_it(*method) && std::none_of(request.compared.begin(), request.compared.end(), needs_it))
            return fail("USE0107", "--probe-at is for the methods parallax-box and parallax-sphere",
                        "add one of them to --method or --compare, or leave --probe-at out");
        Result<glm::dvec3> place = parse_vector(*at, "--probe-at");
        if (!place) return pass_on(place);
        request.probe_at = *place;
    }
    const bool by_reference = method->light == IrradianceMethod::reference ||
                              std::any_of(request.compared.begin(), request.compared.end(), [](const PictureMethod& m) {
                                  return m.light == IrradianceMethod::reference;
                              });
    if (!is_one_picture(arguments)) {
        // Pictures that are compared, summed or shown side by side are computed by quadrature, without noise.
        Result<std::optional<double>> error = reference_error(arguments, by_reference);
        if (!error) return pass_on(error);
        if (*error) request.render.goal.relative_error = **error;
        if (arguments.has("--time")) return fail("USE0107", "--time is for a single picture", "use --error E");
    } else if (const bool by_exact = method->light == IrradianceMethod::exact || method->light == IrradianceMethod::ltc;
               by_exact && arguments.has("--error") && !arguments.has("--time")) {
        Result<std::optional<double>> error = reference_error(arguments, true);
        if (!error) return pass_on(error);
        request.render.error = **error;
    } else {
        Result<ReferenceBudget> budget = reference_budget(arguments, by_reference);
        if (!budget) return pass_on(budget);
        request.budget = *budget;
    }
    request.render.skip = !arguments.has("--no-skip");
    Result<int> bounces = read_bounces(arguments);
    if (!bounces) return pass_on(bounces);
    request.render.bounces = *bounces;
    request.bounces_given = arguments.has("--indirect");
    return {};
}

// An exported scene includes the exposure too; all other picture options are refused.
Result<void> read_without_picture(const Arguments& arguments, PreviewRequest& request) {
    for (const std::string_view option : {"--look", "--to", "--stats", "--ticks", "--tone-map"})
        if (arguments.has(option))
            return fail("USE0107", fmt::format("{} is for a picture, but no picture is asked for", option),
                        "add -o FILE, for example -o lamp.png");
    Result<ExposureRequest> exposure = read_exposure(arguments, *media::find_image_format("a.png"));
    if (!exposure) return pass_on(exposure);
    request.exposure = *exposure;
    return {};
}

Result<void> read_output(const Arguments& arguments, PreviewRequest& request) {
    auto output = arguments.value("--output");
    if (arguments.has("--output-dir")) {
        if (!arguments.has("--sweep"))
            return fail("USE0107", "-O is only for --sweep", "use -o FILE, for example -o lamp.png");
        if (output) return fail("USE0107", "-o and -O are both given", "-o writes a sheet, -O a file for each picture");
        output = "picture.png"; // unless --to names another format
    }
    request.export_file = arguments.value("--export").value_or("");
    if (arguments.has("--export"))
        if (Result<void> checked = check_export(request.export_file); !checked) return checked;
    if (!output && arguments.has("--export")) return read_without_picture(arguments, request);
    if (!output) return fail("USE0104", "no output is given", "use -o FILE, for example -o lamp.png");
    request.output = *output;
    if (*output == "-" && (arguments.has("--json") || arguments.has("--jsonl"))) return both_to_standard_output();
    Result<const media::ImageFormat*> format = picture_format(arguments.value("--to"), *output);
    if (!format) return pass_on(format);
    request.format = *format;
    Result<LookRequest> look = read_look(arguments, **format);
    if (!look) return pass_on(look);
    request.look = std::move(*look);
    request.render.illuminance =
        request.look.look != Look::beauty && request.look.quantity == PictureQuantity::illuminance;
    Result<ExposureRequest> exposure = read_exposure(arguments, **format);
    if (!exposure) return pass_on(exposure);
    request.exposure = *exposure;
    return {};
}

Result<void> add_sky(SkyInput sky, PreviewRequest& request) {
    if (request.render.shows_sky && !sky.is_given)
        return fail("USE0104", "--show-sky shows the sky of --sky", "add --sky 500lx, or another sky");
    request.render.sky = std::move(sky.sky);
    request.sky_source = std::move(sky.source);
    const std::vector<PictureMethod> methods =
        request.compared.empty() ? std::vector<PictureMethod>{method_of(request.render)} : request.compared;
    if (request.render.bounces == 0 && request.render.sky.is_dark())
        for (const PictureMethod& method : methods)
            if (has_local_probe(method.surroundings))
                return fail("USE0107",
                            fmt::format("the method {} is about reflections, and --indirect off leaves them out",
                                        to_text(method)),
                            "leave --indirect off out, or add a sky");
    return check_sky(methods, request.render.sky);
}

} // namespace

Result<PreviewRequest> parse_without_lights(const Arguments& arguments) {
    PreviewRequest request;
    Result<void> read = read_picture(arguments, request);
    if (read) read = read_method(arguments, request);
    if (read) read = read_output(arguments, request);
    if (!read) return pass_on(read);
    if (arguments.has("--emits"))
        return fail("USE0107", "sheets show the light of profiles, and surfaces that emit would add theirs",
                    "leave --emits out");
    Result<Stage> stage = named_stage(arguments);
    if (!stage) return pass_on(stage);
    stage = stage_input(arguments, {}, *stage, request.diagnostics);
    if (!stage) return pass_on(stage);
    request.stage = std::move(*stage);
    Result<SkyInput> sky = sky_input(arguments, Rig(), request.diagnostics);
    if (!sky) return pass_on(sky);
    if (sky->sun)
        return fail("USE0107", "sheets show the light of profiles, and the sky of --sky has a sun",
                    "name a sky without one: weather=overcast, or a kind of cie");
    if (read = add_sky(std::move(*sky), request); !read) return pass_on(read);
    return request;
}

Result<PreviewRequest> parse_preview(const Arguments& arguments) {
    PreviewRequest request;
    Result<void> read = read_picture(arguments, request);
    if (read) read = read_method(arguments, request);
    if (read) read = read_output(arguments, request);
    if (!read) return pass_on(read);
    // Tick lines would be read as values.
    if (arguments.has("--ticks") && request.look.look != Look::beauty && request.look.look != Look::isolux)
        return fail("USE0107", "--ticks cannot be drawn into a picture of values",
                    "add --look isolux, or leave --look out");
    Result<Stage> stage = named_stage(arguments);
    if (!stage) return pass_on(stage);
    Result<LightsAndSky> lit = lights_and_sky(arguments, stage->light, ProfileSize::declared, request.diagnostics);
    if (!lit) return pass_on(lit);
    request.lights = std::move(lit->lights);
    const bool has_sky = lit->sky.is_given;
    if (read = add_sky(std::move(lit->sky), request); !read) return pass_on(read);
    stage = stage_input(arguments, request.lights.rig, *stage, request.diagnostics);
    if (!stage) return pass_on(stage);
    if (read = read_emits(arguments, *stage, request.lights, request.diagnostics); !read) return pass_on(read);
    if (read = require_any_light(request.lights, *stage, has_sky); !read) return pass_on(read);
    if (const auto ocio = arguments.value("--ocio")) request.lights.files.push_back(*ocio);
    std::vector<std::string> outputs;
    for (const std::string& output : {request.output, request.export_file})
        if (!output.empty()) outputs.push_back(output);
    if (read = check_outputs(request.lights.files, outputs); !read) return pass_on(read);
    request.stage = std::move(*stage);
    return request;
}

} // namespace gonio::cli
