#include "request.hpp"

#include <gonio/asset/light_scene.hpp>
#include <gonio/base/file.hpp>
#include <gonio/base/folder.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/base/version.hpp>
#include <gonio/light/light_color.hpp>

#include "../options/light_input.hpp"
#include "../options/rig_input.hpp"
#include "../options/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace gonio::cli {

namespace {

Result<std::vector<const Target*>> parse_targets(const Arguments& arguments) {
    const auto text = arguments.value("--to");
    if (!text) return fail("USE0104", "no target is given", "for example --to gltf; 'gonio list targets' shows all");
    std::vector<const Target*> chosen;
    std::string_view rest = *text;
    while (true) {
        const std::size_t comma = rest.find(',');
        Result<const Target*> target = find_target(rest.substr(0, comma));
        if (!target) return pass_on(target);
        if (std::find(chosen.begin(), chosen.end(), *target) == chosen.end()) chosen.push_back(*target);
        if (comma == std::string_view::npos) return chosen;
        rest.remove_prefix(comma + 1);
    }
}

Result<void> parse_light(const Arguments& arguments, MeasuredLightOptions& light) {
    if (const auto text = arguments.value("--flux")) {
        Result<double> flux = parse_amount(*text, Dimension::luminous_flux, "--flux");
        if (!flux) return pass_on(flux);
        if (!(*flux > 0.0)) return fail("USE0106", fmt::format("--flux must be greater than 0 lm, not '{}'", *text));
        light.flux = Lumens(*flux);
    }
    if (const auto text = arguments.value("--rotate")) {
        Result<double> angle = parse_amount(*text, Dimension::angle, "--rotate");
        if (!angle) return pass_on(angle);
        light.rotation = Radians(*angle);
    }
    const auto color = arguments.value("--color");
    if (color && !is_about_messages(*color)) {
        const Result<glm::dvec3> rgb = parse_light_color(*color); // before anything is written
        if (!rgb) return Unexpected(rgb.error());
        light.color = *color;
    }
    return {};
}

// Everything that describes a light without a file, or the amount of a profile.
Result<void> parse_described(const Arguments& arguments, ImportRequest& request) {
    for (const char* option : {"--preset", "--shape", "--intensity"})
        if (const auto text = arguments.value(option))
            request.description += fmt::format(" {}={}", std::string_view(option).substr(2), *text);
    if (is_described(arguments)) {
        if (request.light.flux)
            return fail("USE0107", "--flux scales a profile", "use --intensity for the amount of a shape");
        Result<LightDescription> light = light_itself(arguments, request.remarks);
        if (!light) return pass_on(light);
        if (const auto name = arguments.value("--preset")) light->name = *name;
        request.described = std::move(*light);
    } else if (const auto text = arguments.value("--intensity")) {
        if (request.light.flux)
            return fail("USE0107", "--flux and --intensity are both given", "leave one of them out");
        Result<PhotometricValue> value = parse_photometric_value(*text);
        if (!value) return pass_on(value);
        request.intensity = *value;
    }
    return {};
}

} // namespace

Result<ImportRequest> parse_import(const Arguments& arguments) {
    ImportRequest request;
    Result<std::vector<const Target*>> chosen = parse_targets(arguments);
    if (!chosen) return pass_on(chosen);
    request.targets = std::move(*chosen);
    const auto folder = arguments.value("--output-dir");
    if (!folder) return fail("USE0104", "no output folder is given", "add -O DIR");
    if (!is_folder(*folder))
        return fail(Failure::io, file_exists(*folder) ? "this is a file, not a folder" : "the folder does not exist",
                    file_exists(*folder) ? "" : "create it first: mkdir " + *folder, *folder);
    request.folder = *folder;
    if (Result<void> light = parse_light(arguments, request.light); !light) return pass_on(light);
    if (Result<void> light = parse_described(arguments, request); !light) return pass_on(light);
    if (const auto text = arguments.value("--unit-scale")) {
        Result<Meters> unit = parse_length_unit(*text, "--unit-scale");
        if (!unit) return pass_on(unit);
        request.unit = *unit;
        for (const Target* target : request.targets)
            if (Result<void> takes = check_unit(*target, request.unit); !takes) return pass_on(takes);
    }
    request.photometric = arguments.has("--photometric");
    const auto is_usd = [](const Target* target) { return target->name == "usd"; };
    if (request.photometric && std::none_of(request.targets.begin(), request.targets.end(), is_usd))
        return fail("USE0107", "--photometric is for usd: no other target has schemas for lumens", "add --to usd");
    Result<Catalogue> catalogue = catalogue_of(arguments);
    if (!catalogue) return pass_on(catalogue);
    request.catalogue = std::move(*catalogue);
    if (arguments.value("--output"))
        return fail("USE0107", "-o is only for --merge", "use -O DIR for the folders of the targets");
    Result<ProfileInputOptions> input = profile_input(arguments);
    if (!input) return pass_on(input);
    input->photometric = true;
    request.input = *input;
    request.rig = rig_read_options(arguments);
    Result<SkyRequest> sky = plain_sky_request(arguments);
    if (!sky) return pass_on(sky);
    request.sky = std::move(*sky);
    request.sky.threads = 1; // inputs run side by side
    request.overwrite = arguments.has("--overwrite");
    request.update = arguments.has("--update");
    return request;
}

bool is_described(const Arguments& arguments) {
    return arguments.has("--shape") || arguments.has("--preset");
}

std::string folder_of(const ImportRequest& request, const Target& target) {
    return fmt::format("{}/{}", request.folder, target.name);
}

std::string recipe_of(const ImportRequest& request) {
    std::string text = fmt::format("gonio {} import", version) + request.description;
    if (request.light.flux) text += fmt::format(" flux={}lm", request.light.flux->value);
    if (!request.light.color.empty()) text += " color=" + request.light.color;
    if (request.light.rotation.value != 0.0) text += fmt::format(" rotate={}deg", to_degrees(request.light.rotation));
    if (request.unit.value != 1.0) text += fmt::format(" unit={}m", request.unit.value);
    if (request.photometric) text += " photometric";
    return text + recipe_of(request.input);
}

} // namespace gonio::cli
