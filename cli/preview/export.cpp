#include "export.hpp"

#include <gonio/asset/stage_scene.hpp>
#include <gonio/base/codes/result.hpp>

#include "../asset_bytes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace gonio::cli {

namespace {

// With its trailing '/', or empty.
std::string folder_of(const std::string& file) {
    return file.substr(0, file.rfind('/') + 1);
}

std::string description_of(const PreviewRequest& request, std::size_t lights, std::optional<Nits> white) {
    std::string text = fmt::format("{} light{} on the stage {}, seen as gonio preview does", lights,
                                   lights == 1 ? "" : "s", request.stage.name);
    if (white) text += fmt::format("; pictures are scene-linear, and {:.6g} cd/m2 is white there", white->value);
    return text;
}

} // namespace

Result<void> check_export(const std::string& file) {
    if (file == "-")
        return fail("USE0107", "a scene has several files, and stdout holds only one",
                    "give --export a file name, for example --export scene.gltf");
    Result<const StageFormat*> format = stage_format_of(file);
    if (!format) return pass_on(format);
    return {};
}

Result<ExportedScene> export_scene(const PreviewRequest& request, std::span<const Light> lights,
                                   std::optional<Nits> white) {
    Result<const StageFormat*> format = stage_format_of(request.export_file);
    if (!format) return pass_on(format);
    if (lights.empty())
        return fail("USE0107", "--export writes lights, and there is only a sky", "add a light, or leave --export out");
    StageSceneOptions options;
    options.name = asset_name(request.export_file);
    options.description = description_of(request, lights.size(), white);
    options.width = request.render.width;
    options.height = request.render.height;
    options.white = white;
    options.bounces = std::min(request.render.bounces, max_bounces);
    options.bounces_matter = request.bounces_given;
    Result<LightScene> scene = stage_scene(**format, request.stage, request.stage.camera, lights, options);
    if (!scene) return pass_on(scene);
    ExportedScene exported;
    for (const AssetFile& file : scene->files) {
        Result<std::string> bytes = bytes_of(file);
        if (!bytes) return pass_on(bytes);
        const bool is_scene = exported.files.empty();
        exported.files.push_back(
            {is_scene ? request.export_file : folder_of(request.export_file) + file.name, std::move(*bytes)});
    }
    if (request.render.shadows != Shadows::soft)
        scene->instead.emplace_back("other renderers cast soft shadows regardless of --shadows");
    if (!request.render.sky.is_dark()) scene->instead.emplace_back("the sky is left out");
    for (const std::string& line : scene->instead)
        exported.diagnostics.push_back(result_diagnostic("RES0201", line, {}, request.export_file));
    return exported;
}

} // namespace gonio::cli
