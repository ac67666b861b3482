#include "capture.hpp"

#include <gonio/preview/capture.hpp>

#include "../options/bounces.hpp"
#include "../options/values.hpp"
#include "../preview/stage_input.hpp"
#include "convert.hpp"
#include "environment_output.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

constexpr int usual_side = 256; // of a face

// The side of the faces that are rendered: as fine as the image that is asked for.
Result<int> face_side(const Arguments& arguments) {
    const auto size = arguments.value("--size");
    if (!size) return usual_side;
    Result<EnvironmentLayout> layout = output_layout(arguments, EnvironmentLayout::cube_strip);
    if (!layout) return pass_on(layout);
    Result<EnvironmentGrid> grid = environment_size(*layout, *size);
    if (!grid) return pass_on(grid);
    return side_like(grid->layout(), grid->side(), EnvironmentLayout::cube_strip);
}

} // namespace

Result<Json> capture_sky(const SkyRequest& request, const Arguments& arguments, Diagnostics& diagnostics) {
    // Before the stage is rendered, which takes longer.
    if (Result<EnvironmentStorage> storage = environment_storage(arguments, arguments.value("--output").value_or(""));
        !storage)
        return pass_on(storage);
    if (arguments.has("--with-sun"))
        return fail("USE0107", "--with-sun is for the sun of daylight, not for 'sky capture'",
                    "the sun lights the stage, and is too small to be seen");
    const auto at = arguments.value("--at");
    if (!at) return fail("USE0104", "no point is given", "add --at X,Y,Z, for example --at 0,0,1.2");
    Result<glm::dvec3> position = parse_vector(*at, "--at");
    if (!position) return pass_on(position);
    Result<int> side = face_side(arguments);
    if (!side) return pass_on(side);
    RenderOptions options;
    options.threads = request.threads;
    options.shows_lights = !arguments.has("--hide-lights");
    Result<int> bounces = read_bounces(arguments);
    if (!bounces) return pass_on(bounces);
    options.bounces = *bounces;

    LightsInput input;
    const auto rig_file = arguments.value("--rig");
    if (rig_file) {
        Result<LightsInput> of_rig = rig_input(*rig_file, arguments);
        if (!of_rig) return pass_on(of_rig);
        input = std::move(*of_rig);
    }
    const auto named = arguments.value("--stage");
    if (!named && !input.rig.stage && input.rig.emits.empty())
        return fail("USE0104", rig_file ? "the rig has no stage" : "there is no stage to capture",
                    "add --stage, for example --stage room");
    Result<Stage> stage = named ? make_stage(*named) : stage_of(input.rig);
    if (!stage) return pass_on(stage);
    if (Result<void> given = give_materials(arguments, input.rig, *stage, diagnostics); !given) return pass_on(given);
    if (Result<void> emits = read_emits(arguments, *stage, input, diagnostics); !emits) return pass_on(emits);
    Result<SkyInput> sky = sky_input(arguments, input.rig, diagnostics);
    if (!sky) return pass_on(sky);
    if (sky->sun) input.others.push_back(*sky->sun);
    if (sky->sky.is_dark() && input.rig.lights.empty() && input.others.empty())
        return fail("USE0104", "nothing lights the stage", "add --rig FILE, --sky SKY or --emits SURFACE=AMOUNT");
    options.sky = std::move(sky->sky);
    std::vector<std::string> inputs = input.files;
    inputs.insert(inputs.end(), sky->files.begin(), sky->files.end());
    Result<std::vector<Light>> lights = resolve_input(std::move(input), diagnostics, options.threads);
    if (!lights) return pass_on(lights);

    Result<EnvironmentMap> map = capture(*stage, *lights, *position, *side, options);
    if (!map) return pass_on(map);
    if (map->light(options.threads) == glm::dvec3(0.0))
        return fail("USE0106", fmt::format("no light reaches the point {} of the stage '{}'", *at, stage->name),
                    "choose a point that the lit surfaces can be seen from");
    LoadedSky loaded;
    loaded.kind = "image";
    loaded.image = LoadedImage{};
    loaded.image->map = std::make_shared<const EnvironmentMap>(std::move(*map));
    Result<Sky> as_sky = resolve_sky({ImageSkyKind{}, {}, glm::dvec3(1.0), {}, 0.0}, loaded.image->map);
    if (!as_sky) return pass_on(as_sky);
    loaded.sky = std::move(*as_sky);
    const std::string source = fmt::format("{} from {}", rig_file.value_or("the stage " + stage->name), *at);
    return convert_sky({source, std::move(inputs)}, loaded, request, arguments);
}

} // namespace gonio::cli
