#include "rig_input.hpp"

#include "light_input.hpp"
#include "values.hpp"

#include <fmt/format.h>

#include <utility>

namespace gonio::cli {

RigReadOptions rig_read_options(const Arguments& arguments) {
    RigReadOptions options;
    options.allow_outside = arguments.has("--allow-outside");
    options.outside_hint = "add --allow-outside if you trust the rig";
    if (arguments.offers("--jobs")) options.threads = thread_count(arguments).value_or(0); // refused elsewhere
    return options;
}

Result<LightsInput> rig_input(const std::string& rig_file, const Arguments& arguments) {
    Result<Rig> rig = read_rig_file(rig_file, rig_read_options(arguments));
    if (!rig) return pass_on(rig);
    LightsInput input;
    input.rig_file = rig_file;
    input.rig = std::move(*rig);
    input.files = input.rig.files;
    input.files.push_back(rig_file);
    return input;
}

Result<LightsInput> lights_input(const Arguments& arguments, const LightPlacement& placement,
                                 Diagnostics& diagnostics) {
    LightsInput input;
    const auto rig_file = arguments.value("--rig");
    if (!rig_file) {
        Result<std::vector<LightDescription>> lights = light_input(arguments, placement, diagnostics);
        if (!lights) return pass_on(lights);
        input.files = files_of(lights->front().shape);
        for (std::string& file : files_of_color(arguments.value("--color").value_or("")))
            input.files.push_back(std::move(file));
        input.rig.lights = std::move(*lights);
        return input;
    }
    if (const std::string_view option = given_light_option(arguments); !option.empty())
        return fail("USE0107", fmt::format("--rig and {} are both given", option), "a rig describes all of its lights");
    if (!arguments.positional().empty())
        return fail("USE0107", "--rig and a profile are both given", "name the profile in the rig");
    return rig_input(*rig_file, arguments);
}

Result<std::vector<Light>> resolve_input(LightsInput input, Diagnostics& diagnostics, unsigned threads) {
    std::vector<LightDescription> others = std::move(input.others);
    std::vector<Light> lights;
    if (!input.rig_file.empty()) {
        Result<std::vector<Light>> of_rig = resolve_lights(std::move(input.rig), diagnostics, threads);
        if (!of_rig) return pass_on(of_rig);
        lights = std::move(*of_rig);
        input.rig.lights.clear();
    }
    for (LightDescription& description : input.rig.lights) {
        if (!lights.empty()) description.shape = lights.front().shape; // its profile is read once
        Result<Light> light = resolve_light(std::move(description), diagnostics);
        if (!light) return pass_on(light);
        lights.push_back(std::move(*light));
    }
    if (Result<void> added = add_resolved(std::move(others), lights, diagnostics); !added) return pass_on(added);
    return lights;
}

} // namespace gonio::cli
