#include "pictures.hpp"

#include <gonio/base/base64.hpp>
#include <gonio/base/path.hpp>

#include "../options/bounces.hpp"
#include "../preview/picture.hpp"
#include "html.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <utility>

namespace gonio::cli {

namespace {

std::string image_element(const std::string& png, PixelSize size, const std::string& alternative) {
    return fmt::format(R"(<img src="data:image/png;base64,{}" width="{}" height="{}" alt="{}">)", base64(png),
                       size.width, size.height, html(alternative));
}

} // namespace

Result<PreviewRequest> picture_request(const Arguments& arguments, unsigned threads) {
    PreviewRequest request;
    Result<int> bounces = read_bounces(arguments);
    if (!bounces) return pass_on(bounces);
    request.render.bounces = *bounces;
    request.render.threads = threads;
    request.format = media::find_image_format("png");
    const char* const config = std::getenv("OCIO");
    request.display.config = config == nullptr ? "" : config;
    request.display.threads = threads;
    return request;
}

Result<void> try_pictures(const PreviewRequest& request, const Console& console) {
    Rendering pixel;
    pixel.luminance_nt = Image(1, 1, 3);
    Result<EncodedPicture> made = encode_picture(std::move(pixel), request, {}, console);
    if (!made) return pass_on(made);
    return {};
}

Result<std::string> profile_picture(const std::string& file, ProfileShape profile, const PreviewRequest& request,
                                    ProfileStages& stages, const Console& console, Diagnostics& diagnostics) {
    PreviewRequest picture = request;
    picture.render.width = profile_picture_size.width;
    picture.render.height = profile_picture_size.height;
    Result<ProfileStages::Shown> shown = stages.show(file, std::move(profile), picture.render, diagnostics);
    if (!shown) return pass_on(shown);
    picture.stage = *shown->stage;
    Result<EncodedPicture> made = encode_picture(std::move(shown->rendering), picture, {&shown->light, 1}, console);
    if (!made) return pass_on(made);
    return image_element(made->bytes, profile_picture_size,
                         fmt::format("The light of {} on the stage {}", file_name(file), picture.stage.name));
}

Result<std::string> rig_picture(const std::string& rig, std::span<const Light> lights, const PreviewRequest& request,
                                const Console& console) {
    PreviewRequest picture = request;
    picture.render.width = rig_picture_size.width;
    picture.render.height = rig_picture_size.height;
    Result<Rendering> rendering = render(picture.stage, lights, picture.stage.camera, picture.render);
    if (!rendering) return pass_on(rendering);
    Result<EncodedPicture> made = encode_picture(std::move(*rendering), picture, lights, console);
    if (!made) return pass_on(made);
    return image_element(made->bytes, rig_picture_size,
                         fmt::format("The lights of {} on the stage {}", file_name(rig), picture.stage.name));
}

} // namespace gonio::cli
