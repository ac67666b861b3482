#include "export.hpp"

#include <gonio/asset/stage_scene.hpp>
#include <gonio/base/codes/result.hpp>
#include <gonio/media/asset_bytes.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace gonio::cli {

namespace {

// With its trailing '/', or empty.
std::string folder_of(const std::string& file) {
    return file.substr(0, file.rfind('/') + 1);
}

std::string description_of(const PreviewRequest& request, std::size_t lights, std::optional<Nits> white) {
    const std::string_view sky = request.render.sky.is_dark() ? "" : lights > 0 ? " and a sky" : "a sky";
    std::string text = fmt::format("{}{} on the stage {}, seen as gonio preview does",
                                   lights > 0 ? fmt::format("{} light{}", lights, lights == 1 ? "" : "s") : "", sky,
                                   request.stage.name);
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
    if (lights.empty() && request.render.sky.is_dark())
        return fail("USE0107", "--export writes lights, and there are none", "add a light or a sky that is not dark");
    StageSceneOptions options;
    std::optional<SkyPicture> sky;
    if (!request.render.sky.is_dark()) {
        Result<SkyPicture> made = sky_picture(request.render.sky, request.render.threads);
        if (!made) return pass_on(made);
        sky = std::move(*made);
        sky->source = request.sky_source.text;
        sky->source_sha256 = request.sky_source.sha256;
        options.sky = &*sky;
        options.shows_sky = request.render.shows_sky;
    }
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
        Result<std::vector<media::NamedBytes>> contents = media::bytes_of(file, request.render.threads);
        if (!contents) return pass_on(contents);
        for (media::NamedBytes& content : *contents) {
            const bool is_scene = exported.files.empty();
            exported.files.push_back({is_scene ? request.export_file : folder_of(request.export_file) + content.name,
                                      std::move(content.bytes)});
        }
    }
    if (request.render.shadows != Shadows::soft)
        scene->instead.emplace_back("other renderers cast soft shadows regardless of --shadows");
    for (const std::string& line : scene->instead)
        exported.diagnostics.push_back(result_diagnostic("RES0201", line, {}, request.export_file));
    return exported;
}

} // namespace gonio::cli
