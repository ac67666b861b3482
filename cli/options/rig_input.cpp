#include "rig_input.hpp"

#include "light_input.hpp"

#include <fmt/format.h>

#include <utility>

namespace gonio::cli {

RigReadOptions rig_read_options(const Arguments& arguments) {
    return {arguments.has("--allow-outside"), "add --allow-outside if you trust the rig"};
}

Result<LightsInput> lights_input(const Arguments& arguments, const LightPlacement& placement,
                                 Diagnostics& diagnostics) {
    LightsInput input;
    const auto rig_file = arguments.value("--rig");
    if (!rig_file) {
        Result<LightDescription> light = light_input(arguments, placement, diagnostics);
        if (!light) return pass_on(light);
        input.files = files_of(light->shape);
        for (std::string& file : files_of_color(arguments.value("--color").value_or("")))
            input.files.push_back(std::move(file));
        input.rig.lights.push_back(std::move(*light));
        return input;
    }
    if (const std::string_view option = given_light_option(arguments); !option.empty())
        return fail("USE0107", fmt::format("--rig and {} are both given", option), "a rig describes all of its lights");
    if (!arguments.positional().empty())
        return fail("USE0107", "--rig and a profile are both given", "name the profile in the rig");
    input.rig_file = *rig_file;
    Result<Rig> rig = read_rig_file(*rig_file, rig_read_options(arguments));
    if (!rig) return pass_on(rig);
    input.rig = std::move(*rig);
    input.files = input.rig.files;
    input.files.push_back(*rig_file);
    return input;
}

Result<std::vector<Light>> resolve_input(LightsInput input, Diagnostics& diagnostics, unsigned threads) {
    if (!input.rig_file.empty()) return resolve_lights(std::move(input.rig), diagnostics, threads);
    Result<Light> light = resolve_light(std::move(input.rig.lights.front()), diagnostics);
    if (!light) return pass_on(light);
    std::vector<Light> lights;
    lights.push_back(std::move(*light));
    return lights;
}

} // namespace gonio::cli
