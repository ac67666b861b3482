#include "picture.hpp"

#include <gonio/preview/exposure.hpp>

#include "../options/output.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace gonio::cli {

Result<EncodedPicture> encode_picture(Rendering rendering, const PreviewRequest& request, const Console& console) {
    Image& image = rendering.luminance_nt;
    const Ev100 exposure = request.exposure ? *request.exposure : auto_exposure(image);
    console.remark(fmt::format("exposure EV100 {:.2f}", exposure.value));
    media::ImageWriteOptions write;
    if (!has_pixel(*request.format, media::Pixel::float32)) {
        expose(image, exposure);
        Result<media::DisplayUsed> used = media::apply_display(image, request.display);
        if (!used) return pass_on(used);
        console.say(used->diagnostics);
        write.color_space = "sRGB";
    } else {
        write.pixel = media::Pixel::float32;
        write.color_space = "Linear";
        write.attributes = {{"gonio:unit", std::string("cd/m2")},
                            {"gonio:exposure_ev100", std::vector<float>{static_cast<float>(exposure.value)}}};
    }
    Result<std::string> bytes = media::encode_image(image, *request.format, write);
    if (!bytes) return pass_on(bytes);
    return EncodedPicture{std::move(*bytes), exposure};
}

} // namespace gonio::cli
