#include "request.hpp"

#include <gonio/base/file.hpp>
#include <gonio/base/file_scope.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/efficacy.hpp>

#include "../options/values.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

namespace gonio::cli {

Result<SceneRequest> parse_scene(const Arguments& arguments) {
    SceneRequest request;
    if (arguments.positional().empty())
        return fail("USE0104", "no scene is given", "for example: gonio lights scene.gltf");
    if (arguments.positional().size() > 1)
        return fail("USE0107", "'lights' takes one scene", "run it once for each scene");
    request.file = arguments.positional().front();
    if (const auto name = arguments.value("--from")) {
        Result<const SceneFormat*> format = find_scene_format(*name);
        if (!format) return pass_on(format);
        request.format = *format;
    }
    if (const auto text = arguments.value("--unit-scale")) {
        Result<Meters> unit = parse_length_unit(*text, "--unit-scale");
        if (!unit) return pass_on(unit);
        request.options.unit = *unit;
    }
    if (const auto text = arguments.value("--up")) {
        if (*text != "y" && *text != "z")
            return fail("USE0105", fmt::format("--up takes y or z, not '{}'", *text), "for example --up y");
        request.options.up = text->front();
    }
    if (const auto text = arguments.value("--time")) {
        request.options.time = parse_number(*text);
        if (!request.options.time)
            return fail("USE0105", fmt::format("--time takes a number, not '{}'", *text), "for example --time 12");
    }
    request.options.variant = arguments.value("--variant").value_or("");
    if (const auto text = arguments.value("--zoom")) {
        Result<double> zoom = parse_amount(*text, Dimension::angle, "--zoom");
        if (!zoom) return pass_on(zoom);
        request.options.zoom = Radians(*zoom);
    }
    if (const auto text = arguments.value("--lm-per-watt")) {
        Result<Efficacy> efficacy = parse_efficacy(*text);
        if (!efficacy) return pass_on(efficacy);
        request.options.lumens_per_watt = efficacy->lm_per_w;
    }
    Result<std::string> bytes =
        request.file == "-" ? read_standard_input(limit("scene-bytes")) : read_file(request.file, limit("scene-bytes"));
    if (!bytes) return pass_on(bytes);
    request.bytes = std::move(*bytes);
    const std::string folder = folder_of_file(request.file);
    auto scope = std::make_shared<FileScope>(
        arguments.has("--allow-outside") ? FileScope::anywhere(folder)
                                         : FileScope::under(folder, "add --allow-outside if you trust the scene"));
    request.options.read_beside = [scope](const std::string& name) -> Result<std::string> {
        Result<std::string> path = scope->path_of(name);
        if (!path) return path;
        return read_file(*path);
    };
    return request;
}

} // namespace gonio::cli
