#include "light_input.hpp"

#include <gonio/base/unit_text.hpp>
#include <gonio/color/spectrum.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/light/presets.hpp>
#include <gonio/web/smooth.hpp>

#include "smooth_step.hpp"
#include "values.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <utility>
#include <variant>

namespace gonio::cli {

bool is_about_messages(std::string_view color) {
    return color == "auto" || color == "always" || color == "never";
}

namespace {

// --smooth, if it is given.
Result<void> smooth_profile(const Arguments& arguments, Shape& shape, Diagnostics& diagnostics) {
    const Result<std::optional<double>> step = smooth_step(arguments);
    if (!step) return Unexpected(step.error());
    if (!*step) return {};
    auto* const profile = std::get_if<ProfileShape>(&shape);
    if (profile == nullptr)
        return fail("USE0107", fmt::format("--smooth is for the table of a profile, not for a {}", kind_of(shape)));
    if (Result<void> loaded = load_profile(shape, diagnostics); !loaded) return loaded;
    Result<Web> smooth = smoothed(*profile->web, **step, profile->file, diagnostics);
    if (!smooth) return pass_on(smooth);
    profile->web = std::make_shared<const Web>(std::move(*smooth));
    return {};
}

Result<std::vector<LightDescription>> at_positions(const std::vector<std::string>& positions, LightDescription light) {
    if (positions.empty()) return std::vector{std::move(light)};
    std::vector<LightDescription> lights;
    for (const std::string& text : positions) {
        Result<glm::dvec3> position = parse_vector(text, "--position");
        if (!position) return pass_on(position);
        lights.push_back(light);
        lights.back().position = *position;
        if (positions.size() > 1) lights.back().name += fmt::format("-{}", lights.size());
    }
    return lights;
}

} // namespace

Result<LightDescription> light_itself(const Arguments& arguments, Diagnostics& diagnostics) {
    const std::vector<std::string>& files = arguments.positional();
    const auto preset_name = arguments.value("--preset");
    auto shape_text = arguments.value("--shape");
    auto amount = arguments.value("--intensity");
    if (files.size() > 1) return fail("USE0107", fmt::format("expected one profile, but {} are given", files.size()));
    if (files.empty() && !shape_text && !preset_name)
        return fail("USE0104", "no light is given", "name a profile, or use --shape sphere:r=10cm --intensity 800lm");
    if (!files.empty() && (shape_text || preset_name))
        return fail("USE0107", fmt::format("a profile and {} are both given", shape_text ? "--shape" : "--preset"),
                    "leave one of them out");
    if (preset_name) {
        Result<const LightPreset*> preset = find_preset(*preset_name);
        if (!preset) return pass_on(preset);
        if (!shape_text) shape_text = (*preset)->shape;
        if (!amount) amount = (*preset)->value;
    }
    LightDescription light;
    Result<Shape> shape = shape_text ? parse_shape(*shape_text) : Result<Shape>(ProfileShape{files[0], nullptr});
    if (!shape) return pass_on(shape);
    light.shape = *shape;
    if (Result<void> smooth = smooth_profile(arguments, light.shape, diagnostics); !smooth) return pass_on(smooth);
    light.name = kind_of(light.shape);
    if (amount) {
        Result<PhotometricValue> value = parse_photometric_value(*amount);
        if (!value) return pass_on(value);
        light.intensity = *value;
    }
    const auto color = arguments.value("--color");
    if (color && !is_about_messages(*color)) {
        Result<glm::dvec3> rgb = parse_light_color(*color, &diagnostics);
        if (!rgb) return pass_on(rgb);
        light.color = *rgb;
    }
    if (const auto text = arguments.value("--rotate")) {
        Result<double> angle = parse_amount(*text, Dimension::angle, "--rotate");
        if (!angle) return pass_on(angle);
        light.rotation = Radians(*angle);
    }
    return light;
}

Result<std::vector<LightDescription>> light_input(const Arguments& arguments, const LightPlacement& placement,
                                                  Diagnostics& diagnostics) {
    Result<LightDescription> light = light_itself(arguments, diagnostics);
    if (!light) return pass_on(light);
    hang(*light, placement);
    struct Vector {
        const char* option;
        glm::dvec3* target;
    };
    for (const Vector& vector : {Vector{"--direction", &light->direction}, Vector{"--up", &light->up}}) {
        const auto text = arguments.value(vector.option);
        if (!text) continue;
        Result<glm::dvec3> parsed = parse_vector(*text, vector.option);
        if (!parsed) return pass_on(parsed);
        *vector.target = *parsed;
    }
    if (const auto text = arguments.value("--range")) {
        Result<double> meters = parse_amount(*text, Dimension::length, "--range");
        if (!meters) return pass_on(meters);
        light->range = Meters(*meters);
    }
    return at_positions(arguments.values("--position"), std::move(*light));
}

std::vector<std::string> files_of(const Shape& shape) {
    const std::string* const file = file_of(shape);
    return file != nullptr ? std::vector{*file} : std::vector<std::string>();
}

std::vector<std::string> files_of_color(const std::string& color) {
    if (!color.starts_with(spectrum_prefix)) return {};
    return {color.substr(spectrum_prefix.size())};
}

std::string_view given_light_option(const Arguments& arguments) {
    for (const Option& option : light_options) {
        const auto value = arguments.value(option.names);
        if (value && !(option.names == "--color" && is_about_messages(*value))) return option.names;
    }
    return {};
}

} // namespace gonio::cli
