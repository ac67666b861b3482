#include "request.hpp"

#include <gonio/base/unit_text.hpp>
#include <gonio/scene/material_charts.hpp>
#include <gonio/transport/receiver_light.hpp>

#include "../options/files_in_use.hpp"
#include "../options/method_list.hpp"
#include "../options/output.hpp"
#include "../options/rig_input.hpp"
#include "../options/values.hpp"
#include "../preview/stage_input.hpp"
#include "sum_while_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace gonio::cli {

namespace {

// What is added on a stage or under a sky is added to the illuminance of one method.
Result<void> fits_one_illuminance(const Arguments& arguments, std::string_view given, std::string_view hint = {}) {
    for (const std::string_view option : {"--compare", "--view"})
        if (arguments.has(option))
            return fail("USE0107", fmt::format("{} and {} are both given", given, option),
                        hint.empty() ? fmt::format("{} adds illuminance to one method", given) : std::string(hint));
    return {};
}

// Before anything is read.
Result<void> fits_stage(const Arguments& arguments) {
    for (const std::string_view option : {"--sky", "--indirect"})
        if (arguments.has(option)) return fits_one_illuminance(arguments, option);
    return {};
}

// Surfaces that emit are lights without --indirect and --sky, too.
Result<void> read_lights_of_stage(const Arguments& arguments, LightsInput& input, ProbeRequest& request) {
    if (request.stage) return read_emits(arguments, *request.stage, input, request.diagnostics);
    if (arguments.has("--emits"))
        return fail("USE0104", "--emits needs a stage with this surface", "add --stage room, or a stage to the rig");
    if (input.rig.emits.empty()) return {};
    Result<Stage> stage = stage_of(input.rig);
    if (!stage) return pass_on(stage);
    if (Result<void> read = read_emits(arguments, *stage, input, request.diagnostics); !read) return read;
    request.stage = std::move(*stage);
    return {};
}

// What the quantity means the points to face.
void turn_receivers(ProbeRequest& request) {
    if (request.kind == IlluminanceKind::planar || needs_direction(request.kind)) return;
    for (Receiver& receiver : request.points.receivers)
        receiver.normal = {0.0, 0.0, 1.0};
}

Result<void> read_lights(const Arguments& arguments, ProbeRequest& request) {
    turn_receivers(request); // those of a work plane are placed below
    Result<bool> summed = sum_while_reading(arguments, request);
    if (!summed) return pass_on(summed);
    if (*summed) return {};
    LightPlacement placement{glm::dvec3(0.0)};
    if (const auto name = arguments.value("--stage")) {
        Result<Stage> stage = make_stage(*name);
        if (!stage) return pass_on(stage);
        placement = stage->light;
        request.stage = std::move(*stage);
    }
    request.indirect = arguments.has("--indirect");
    Result<LightsAndSky> lit = lights_and_sky(arguments, placement, ProfileSize::unsaid, request.diagnostics);
    if (!lit) return pass_on(lit);
    LightsInput& input = lit->lights;
    request.rig = input.rig_file;
    if (request.drawing)
        if (Result<void> free = check_outputs(input.files, {&request.drawing->output, 1}); !free) return free;
    if (lit->sky.is_given)
        if (Result<void> fits = fits_one_illuminance(arguments, "a sky of the rig",
                                                     "it adds illuminance to one method: take \"sky\" out of the rig");
            !fits)
            return fits;
    if (!request.indirect && !lit->sky.is_given && !arguments.has("--emits") && input.rig.emits.empty() &&
        !request.points.workplane && arguments.has("--stage"))
        return fail("USE0104", "--stage needs --indirect, --sky, --emits or --workplane",
                    "without them, a stage neither reflects nor blocks light, nor emits any");
    request.sky = std::move(lit->sky.sky);
    if (!request.stage) request.stage = input.rig.stage;
    if (request.points.workplane) {
        if (!request.stage)
            return fail("USE0104", "--workplane needs a stage with walls", "add --stage room, or a stage to the rig");
        if (Result<void> placed = place_on(*request.stage, request.points); !placed) return placed;
        turn_receivers(request);
    }
    if (Result<void> read = read_lights_of_stage(arguments, input, request); !read) return read;
    if (request.indirect || lit->sky.is_given) {
        if (!request.stage && request.indirect)
            return fail("USE0104", "--indirect needs a stage that reflects the light",
                        "add --stage room, or a stage to the rig");
        // Without a stage there is nothing to give the materials to.
        if (request.stage)
            if (Result<void> given = give_materials(arguments, input.rig, *request.stage, request.diagnostics); !given)
                return given;
        if (!request.stage) request.stage = Stage();
    } else {
        request.stage.reset();
    }
    Result<std::vector<Light>> lights = resolve_input(std::move(input), request.diagnostics, request.options.threads);
    if (!lights) return pass_on(lights);
    request.lights = std::move(*lights);
    if (request.stage) {
        const Diagnostics misplaced = check_receivers(*request.stage, request.points.receivers);
        request.diagnostics.insert(request.diagnostics.end(), misplaced.begin(), misplaced.end());
    }
    return {};
}

Result<void> read_error(const Arguments& arguments, ProbeRequest& request) {
    const bool by_reference =
        std::find(request.methods.begin(), request.methods.end(), IrradianceMethod::reference) != request.methods.end();
    Result<std::optional<double>> error = reference_error(arguments, by_reference);
    if (!error) return pass_on(error);
    if (*error) request.options.goal.relative_error = **error;
    return {};
}

Result<void> read_methods(const Arguments& arguments, ProbeRequest& request) {
    const auto compare = arguments.value("--compare");
    const auto method = arguments.value("--method");
    if (compare && method)
        return fail("USE0107", "--method and --compare are both given", "name every method in --compare");
    request.compare = compare.has_value();
    // The reference value is the quadrature for luminance, and the closed form for illuminance.
    if (request.compare)
        request.methods.push_back(arguments.has("--view") ? IrradianceMethod::reference : IrradianceMethod::exact);
    Result<std::vector<IrradianceMethod>> named = method_list(compare ? *compare : method.value_or("exact"));
    if (!named) return pass_on(named);
    if (!compare && named->size() > 1) return fail("USE0107", "--method takes one method", "use --compare for several");
    for (const IrradianceMethod each : *named)
        if (std::find(request.methods.begin(), request.methods.end(), each) == request.methods.end())
            request.methods.push_back(each);
    return read_error(arguments, request);
}

Result<void> read_view(const Arguments& arguments, ProbeRequest& request) {
    const auto view = arguments.value("--view");
    const auto material = arguments.value("--material");
    if (!view && (!material || arguments.has("--indirect"))) return {}; // those of the stage
    if (!view)
        return fail("USE0104", "--material is given without --view",
                    "luminance needs both; with --indirect it is the material of a surface of the stage");
    if (!material) return fail("USE0104", "--view is given without --material", "luminance needs both");
    if (arguments.values("--material").size() > 1)
        return fail("USE0107", "--material is given twice", "with --view there is one surface, that of the points");
    if (names_surface(*material))
        return fail("USE0104", fmt::format("--material '{}' names a surface", *material),
                    "with --view there is one surface, that of the points: write the material alone");
    constexpr std::string_view place = "at:";
    const bool is_place = view->starts_with(place);
    Result<glm::dvec3> vector = parse_vector(is_place ? view->substr(place.size()) : *view, "--view");
    if (!vector) return pass_on(vector);
    if (!is_place && !unit_vector(*vector))
        return fail("USE0106", "--view is zero", "it points from the surface to the eye");
    Result<Material> parsed = parse_material(*material);
    if (!parsed) return pass_on(parsed);
    const Diagnostics judged = check_charts(*parsed);
    request.diagnostics.insert(request.diagnostics.end(), judged.begin(), judged.end());
    request.options.view = ProbeView{*vector, *parsed};
    if (is_place) request.options.view->eye = *vector;
    return {};
}

Result<void> read_quantity(const Arguments& arguments, ProbeRequest& request) {
    const auto name = arguments.value("--quantity");
    if (!name) return {};
    Result<IlluminanceKind> kind = parse_illuminance_kind(*name);
    if (!kind) return pass_on(kind);
    request.kind = *kind;
    if (request.kind == IlluminanceKind::planar) return {};
    if (!request.is_planar()) {
        for (const std::string_view option : {"--view", "--compare"})
            if (arguments.has(option))
                return fail("USE0107", fmt::format("{} and --quantity {} are both given", option, *name),
                            "both are of a flat surface: leave one of them out");
        if (request.methods != std::vector{IrradianceMethod::exact})
            return fail("USE0107", fmt::format("--quantity {} has one method", *name), "leave --method out");
    }
    if (!needs_direction(request.kind) && request.points.has_normals)
        return fail("USE0107", fmt::format("--normal and --quantity {} are both given", *name),
                    "it has no direction: leave --normal out");
    if (!needs_direction(request.kind)) return {};
    if (!request.points.has_normals && !arguments.has("--points"))
        return fail("USE0104", fmt::format("--quantity {} needs a direction", *name), "add --normal, such as 0,-1,0");
    for (const Receiver& receiver : request.points.receivers)
        if (!(std::abs(unit_vector(receiver.normal)->z) < 1e-9))
            return fail("USE0106", fmt::format("--quantity {} faces a horizontal direction", *name),
                        "give --normal, or the normals of --points, a Z of 0");
    return {};
}

Result<void> read_drawing(const Arguments& arguments, ProbeRequest& request) {
    const auto output = arguments.value("--output");
    if (!output) {
        for (const std::string_view option : {"--size", "--title", "--to"})
            if (arguments.has(option))
                return fail("USE0104", fmt::format("{} needs -o", option), "it is for the drawing of a grid");
        return {};
    }
    if (!request.points.grid && !request.points.workplane)
        return fail("USE0107", "-o draws a grid, but single points are given", "use --grid, --polygon or --workplane");
    if (request.options.view || request.compare)
        return fail("USE0107", fmt::format("-o and {} are both given", request.compare ? "--compare" : "--view"),
                    "-o draws the illuminance");
    Result<GridDrawing> drawing = grid_drawing(arguments);
    if (!drawing) return pass_on(drawing);
    request.drawing = std::move(*drawing);
    return {};
}

Result<void> read_glare(const Arguments& arguments, ProbeRequest& request) {
    request.glare = arguments.has("--glare");
    if (!request.glare) return {};
    if (!arguments.has("--indirect"))
        return fail("USE0104", "--glare needs --indirect", "UGR compares the luminaires with what the room reflects");
    if (request.kind != IlluminanceKind::planar || request.points.grid || request.points.workplane)
        return fail("USE0107", "--glare is for eyes at single points",
                    "use --at and --normal, or --points with normals");
    if (!request.points.has_normals && !arguments.has("--points"))
        return fail("USE0104", "--glare needs the direction in which the eyes look", "add --normal, such as 0,1,0");
    for (const Receiver& receiver : request.points.receivers)
        if (!(std::abs(unit_vector(receiver.normal)->z) < 1.0 - 1e-9))
            return fail("USE0106", "--glare is not defined for eyes that look straight up or down",
                        "give --normal the direction of view");
    return {};
}

Result<void> read_task(const Arguments& arguments, ProbeRequest& request) {
    Result<std::optional<TaskInput>> task = task_input(arguments);
    if (!task) return pass_on(task);
    request.task = std::move(*task);
    if (!request.task) return {};
    if (!request.points.grid && !request.points.workplane)
        return fail("USE0107", "--task is for a grid, but single points are given",
                    "use --workplane 75cm, --grid or --polygon");
    if (request.compare || request.kind == IlluminanceKind::modelling)
        return fail("USE0107", "--task judges one illuminance", "leave --compare and --quantity modelling out");
    return {};
}

Result<void> read_form(const Arguments& arguments, ProbeRequest& request) {
    const std::array given{arguments.has("--json"), arguments.has("--jsonl"), arguments.has("--csv")};
    if (std::count(given.begin(), given.end(), true) > 1)
        return fail("USE0107", "more than one of --json, --jsonl and --csv is given");
    request.form = given[0]   ? ProbeForm::json
                   : given[1] ? ProbeForm::json_line
                   : given[2] ? ProbeForm::csv
                              : ProbeForm::text;
    return {};
}

} // namespace

Result<ProbeRequest> parse_probe(const Arguments& arguments) {
    ProbeRequest request;
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    request.options.threads = *threads;
    if (arguments.value("--rig") == "-" && arguments.value("--points") == "-")
        return fail("USE0108", "stdin cannot be both the rig and the points");
    Result<void> read = read_form(arguments, request);
    if (read) read = read_methods(arguments, request);
    if (read) read = read_view(arguments, request);
    if (read) read = fits_stage(arguments);
    if (!read) return pass_on(read);
    Result<Points> points = points_input(arguments);
    if (!points) return pass_on(points);
    request.points = std::move(*points);
    read = read_quantity(arguments, request);
    if (read) read = read_glare(arguments, request);
    if (read) read = read_task(arguments, request);
    if (read) read = read_drawing(arguments, request);
    if (!read) return pass_on(read);
    if (Result<void> lights = read_lights(arguments, request); !lights) return pass_on(lights);
    return request;
}

} // namespace gonio::cli
