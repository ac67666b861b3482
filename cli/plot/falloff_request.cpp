#include "falloff_request.hpp"

#include <gonio/base/path.hpp>
#include <gonio/base/unit_text.hpp>

#include "../options/files_in_use.hpp"
#include "../options/light_input.hpp"
#include "../options/profile_input.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace gonio::cli {

namespace {

Result<std::vector<LightDescription>> described(const Arguments& arguments) {
    std::vector<LightDescription> lights;
    const std::vector<std::string> shapes = arguments.values("--shape");
    const std::vector<std::string> amounts = arguments.values("--intensity");
    if (!arguments.positional().empty()) {
        Result<std::vector<std::string>> files = input_files(arguments);
        if (!files) return pass_on(files);
        for (const std::string& file : *files) {
            LightDescription light;
            light.name = file_name(file);
            light.shape = ProfileShape{file, nullptr};
            lights.push_back(std::move(light));
        }
    }
    if (lights.empty() && shapes.empty())
        return fail("USE0104", "no light is given", "name profiles, or use --shape sphere:r=10cm --intensity 800lm");
    if (shapes.empty() ? !amounts.empty() : amounts.size() > 1 && amounts.size() != shapes.size())
        return fail("USE0107", fmt::format("{} values of --intensity for {} of --shape", amounts.size(), shapes.size()),
                    "give one for all shapes, or one for each; profiles keep their own intensity");
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        Result<Shape> shape = parse_shape(shapes[i]);
        if (!shape) return pass_on(shape);
        LightDescription light;
        light.name = shapes[i];
        light.shape = std::move(*shape);
        if (!amounts.empty()) {
            const std::string& text = amounts.size() == 1 ? amounts[0] : amounts[i];
            Result<PhotometricValue> amount = parse_photometric_value(text);
            if (!amount) return pass_on(amount);
            light.intensity = *amount;
            light.name += " " + text;
        }
        lights.push_back(std::move(light));
    }
    return lights;
}

// The diagram must not replace a file that it is drawn from.
Result<void> check_free(const Arguments& arguments, std::span<const LightDescription> lights) {
    std::vector<std::string> inputs;
    for (const LightDescription& light : lights)
        for (std::string& file : files_of(light.shape))
            inputs.push_back(std::move(file));
    const std::vector<std::string> outputs = arguments.values("--output");
    return check_outputs(inputs, outputs);
}

} // namespace

Result<void> no_falloff_options(const Arguments& arguments) {
    for (const Option& option : falloff_options)
        if (arguments.has(option.names))
            return fail("USE0107", fmt::format("{} is only for the diagram falloff", option.names),
                        "add --diagram falloff");
    return {};
}

Result<FalloffOptions> read_falloff(const Arguments& arguments) {
    FalloffOptions options;
    const auto text = arguments.value("--distance");
    if (!text) return options;
    const std::size_t colon = text->find(':');
    if (colon == std::string::npos)
        return fail("USE0105", fmt::format("'{}' is not a range of distances", *text),
                    "write FROM:TO, for example 0.1m:20m");
    Result<double> from = parse_amount(std::string_view(*text).substr(0, colon), Dimension::length, "--distance");
    if (!from) return pass_on(from);
    Result<double> to = parse_amount(std::string_view(*text).substr(colon + 1), Dimension::length, "--distance");
    if (!to) return pass_on(to);
    options.nearest_m = *from;
    options.farthest_m = *to;
    return options;
}

Result<std::vector<PlottedLight>> falloff_lights(const Arguments& arguments, Diagnostics& diagnostics) {
    Result<std::vector<LightDescription>> descriptions = described(arguments);
    if (!descriptions) return pass_on(descriptions);
    if (Result<void> free = check_free(arguments, *descriptions); !free) return pass_on(free);
    std::optional<Meters> range;
    if (const auto text = arguments.value("--range")) {
        Result<double> length = parse_amount(*text, Dimension::length, "--range");
        if (!length) return pass_on(length);
        range = Meters(*length);
    }
    std::vector<PlottedLight> lights;
    for (LightDescription& description : *descriptions) {
        description.range = range;
        std::string label = description.name;
        Result<Light> light = resolve_light(std::move(description), diagnostics);
        if (!light) return pass_on(light);
        lights.push_back({std::move(label), std::move(*light)});
    }
    return lights;
}

} // namespace gonio::cli
