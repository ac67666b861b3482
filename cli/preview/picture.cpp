#include "picture.hpp"

#include <gonio/base/codes/result.hpp>
#include <gonio/plot/legend.hpp>
#include <gonio/plot/picture_contours.hpp>
#include <gonio/plot/raster.hpp>
#include <gonio/preview/exposure.hpp>
#include <gonio/preview/glare.hpp>
#include <gonio/preview/white_balance.hpp>
#include <gonio/shading/lights.hpp>

#include "../options/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

constexpr int ramp_colors = 256;

// From cd/m² to display-encoded values.
Result<void> develop(Image& image, std::vector<PartialLight> lights, Ev100 exposure, const PreviewRequest& request,
                     const Console& console) {
    expose(image, exposure);
    expose(lights, exposure);
    ExposedPicture picture{&image, std::move(lights), request.stage.camera};
    return show_exposed({&picture, 1}, request, console);
}

Image gray_picture(const Image& values) {
    Image gray(values.width, values.height, 3);
    for (std::size_t i = 0; i < values.pixels.size(); ++i)
        std::fill_n(gray.pixels.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, values.pixels[i]);
    return gray;
}

LegendUnit legend_unit(const LookRequest& look) {
    const std::string symbol(look.unit->symbol == "nt"      ? "cd/m²"
                             : look.unit->symbol == "cd/m2" ? "cd/m²"
                                                            : look.unit->symbol);
    return {symbol, look.unit->base_per_unit};
}

std::vector<std::array<float, 3>> colors_of(const Image& row) {
    std::vector<std::array<float, 3>> colors;
    for (int x = 0; x < row.width; ++x)
        colors.push_back({row.at(x, 0)[0], row.at(x, 0)[1], row.at(x, 0)[2]});
    return colors;
}

// A row of pixels with the values of a scale, from its low end to its high end.
Image scale_row(const ValueScale& scale) {
    Image row(ramp_colors, 1, 1);
    for (int x = 0; x < ramp_colors; ++x)
        *row.at(x, 0) = static_cast<float>(scale.value(static_cast<double>(x) / (ramp_colors - 1)));
    return row;
}

class PictureMaker {
public:
    PictureMaker(Rendering rendering, const PreviewRequest& request, std::span<const Light> lights,
                 const Console& console)
        : rendering_(std::move(rendering)), request_(request), lights_(lights), console_(console) {
        picture_.exposure = request.exposure.of(rendering_, request.render.threads);
        if (request.look.look == Look::beauty) return;
        values_ = quantity_image(rendering_, request.look.quantity);
        if (request.look.look == Look::false_color)
            picture_.scale = request.look.scale
                                 ? *request.look.scale
                                 : round_scale(values_, request.look.logarithmic, request.look.unit->base_per_unit);
        if (request.look.look == Look::luminance)
            picture_.scale = ValueScale{false, 0.0, white_luminance(picture_.exposure).value};
        picture_.use = use_of(values_, picture_.scale.value_or(ValueScale{false, 0.0, 1.0}));
        if (request.look.look != Look::isolux) return;
        picture_.levels = request.look.levels.empty() ? contour_levels(picture_.use.least, picture_.use.greatest,
                                                                       request.look.unit->base_per_unit)
                                                      : request.look.levels;
    }

    Result<EncodedPicture> make() {
        const bool floats = has_pixel(*request_.format, media::Pixel::float32);
        Result<std::string> bytes = floats ? numbers() : display();
        if (!bytes) return pass_on(bytes);
        picture_.bytes = std::move(*bytes);
        return std::move(picture_);
    }

    // What an integer format stores, before it is encoded.
    Result<ShownPicture> shown() {
        Result<Image> image = shown_image();
        if (!image) return pass_on(image);
        return ShownPicture{std::move(*image), picture_.exposure, picture_.use, picture_.scale,
                            std::move(picture_.levels)};
    }

private:
    Result<std::string> numbers() {
        media::ImageWriteOptions write;
        write.pixel = media::Pixel::float32;
        write.color_space = "Linear";
        write.threads = request_.render.threads;
        if (request_.look.look != Look::beauty) {
            const char* const unit = request_.look.quantity == PictureQuantity::illuminance ? "lx" : "cd/m2";
            write.channel_names = {"Y"};
            write.attributes = {{"ImageDescription", fmt::format("{} in {}", to_text(request_.look.quantity), unit)},
                                {"gonio:quantity", std::string(to_text(request_.look.quantity))},
                                {"gonio:unit", std::string(unit)}};
            picture_.width = values_.width;
            return media::encode_image(values_, *request_.format, write);
        }
        Image& image = rendering_.luminance_nt;
        picture_.width = image.width;
        write.attributes = {{"gonio:unit", std::string("cd/m2")},
                            {"gonio:exposure_ev100", std::vector<float>{static_cast<float>(picture_.exposure.value)}}};
        if (request_.exposure.tone_map == ToneMap::ue3_inverse) {
            expose(image, picture_.exposure);
            apply_ue3_inverse(image);
            write.attributes[0] = {"gonio:tone_map", std::string(to_text(ToneMap::ue3_inverse))};
        }
        return media::encode_image(image, *request_.format, write);
    }

    Result<Image> shown_image() {
        switch (request_.look.look) {
        case Look::false_color:
            return colored();
        case Look::isolux:
            return contoured();
        case Look::luminance:
            return gray();
        case Look::beauty:
            break;
        }
        return beauty();
    }

    Result<std::string> display() {
        Result<Image> image = shown_image();
        if (!image) return pass_on(image);
        picture_.width = image->width;
        media::ImageWriteOptions write;
        write.color_space = "sRGB";
        write.dither = is_dithered(request_.look.look);
        return media::encode_image(*image, *request_.format, write);
    }

    Result<Image> beauty() {
        Image image = std::move(rendering_.luminance_nt);
        if (request_.exposure.glare) show_points(image, request_.stage, lights_, request_.stage.camera);
        const Result<void> developed =
            develop(image, std::move(rendering_.partial_lights), picture_.exposure, request_, console_);
        if (!developed) return Unexpected(developed.error());
        return image;
    }

    Result<Image> colored() const {
        const LookRequest& look = request_.look;
        Image image = false_color(values_, *picture_.scale, *look.palette);
        if (!look.legend) return image;
        return with_legend(image, {*picture_.scale, legend_unit(look),
                                   colors_of(false_color(scale_row(*picture_.scale), *picture_.scale, *look.palette)),
                                   picture_.use});
    }

    Result<Image> contoured() {
        const LookRequest& look = request_.look;
        Result<Image> image = beauty();
        if (!image) return image;
        dim(*image);
        const std::vector<Ink> inks = contour_inks(picture_.levels.size(), *look.palette);
        const std::vector<std::int32_t> surfaces = seen_surfaces(
            request_.stage, lights_, request_.stage.camera, values_.width, values_.height, request_.render.threads);
        draw(contour_drawing(values_, surfaces, picture_.levels, inks, look.unit->base_per_unit), *image);
        if (!look.legend) return image;
        return with_legend(*image, {picture_.levels, inks, legend_unit(look), picture_.use.greatest});
    }

    Result<Image> gray() const {
        Image image = gray_picture(values_);
        Image ramp = gray_picture(scale_row(*picture_.scale));
        Result<void> developed = develop(image, {}, picture_.exposure, request_, console_);
        if (developed) developed = develop(ramp, {}, picture_.exposure, request_, console_);
        if (!developed) return pass_on(developed);
        if (!request_.look.legend) return image;
        return with_legend(image, {*picture_.scale, legend_unit(request_.look), colors_of(ramp), picture_.use});
    }

    Rendering rendering_;
    const PreviewRequest& request_;
    std::span<const Light> lights_;
    const Console& console_;
    Image values_; // for display modes other than beauty
    EncodedPicture picture_;
};

} // namespace

Result<void> show_exposed(std::span<ExposedPicture> pictures, const PreviewRequest& request, const Console& console) {
    std::vector<Image*> all;
    for (const ExposedPicture& shown : pictures)
        if (!shown.picture->pixels.empty()) all.push_back(shown.picture);
    if (all.empty()) return {};
    std::optional<glm::dmat3> white;
    if (request.exposure.auto_white)
        white = white_balance(gray_world_white(std::vector<const Image*>(all.begin(), all.end())));
    if (request.exposure.white) white = white_balance(*request.exposure.white);
    std::vector<Image> parts; // of pixels that show a light in part
    for (ExposedPicture& shown : pictures) {
        if (request.exposure.glare && !shown.picture->pixels.empty())
            add_glare(*shown.picture, shown.lights, shown.camera, {*request.exposure.glare, request.render.threads});
        parts.push_back(parts_of(*shown.picture, shown.lights));
    }
    for (Image& image : parts)
        if (!image.pixels.empty()) all.push_back(&image);
    for (Image* const image : all) {
        if (white) balance(*image, *white);
        if (request.exposure.tone_map == ToneMap::ue3) apply_ue3(*image);
    }
    if (request.exposure.tone_map != ToneMap::ue3) {
        Result<media::DisplayUsed> used = media::apply_display(all, request.display);
        if (!used) return pass_on(used);
        console.say(used->diagnostics);
    }
    for (std::size_t i = 0; i < pictures.size(); ++i)
        merge_parts(parts[i], pictures[i].lights, *pictures[i].picture);
    return {};
}

void warn_of_ceiling(const Image& luminance_nt, Diagnostics& diagnostics) {
    // A surface with an albedo of 1e-9 or more reaches this at the ceiling; the sun's disk has 1.6e9 cd/m².
    constexpr Nits suspicious(1e20);
    if (!reaches(luminance_nt, suspicious)) return;
    const std::vector<float>& pixels = luminance_nt.pixels;
    const float greatest =
        *std::max_element(pixels.begin(), pixels.end(), [](float a, float b) { return a < b || std::isnan(a); });
    diagnostics.push_back(result_diagnostic("RES0203",
                                            fmt::format("pixels reach {:.3g} cd/m2: illuminance is limited to {} lx",
                                                        static_cast<double>(greatest), shading::illuminance_ceiling),
                                            "use less light, or move it farther away"));
}

void warn_of_black(const Image& luminance_nt, const PreviewRequest& request, std::span<const Light> lights,
                   Diagnostics& diagnostics) {
    const bool lit =
        std::any_of(luminance_nt.pixels.begin(), luminance_nt.pixels.end(), [](float nt) { return nt > 0; });
    const bool shines = std::any_of(lights.begin(), lights.end(), [](const Light& light) {
        return light.intensity.value > 0.0 || light.illuminance.value > 0.0;
    });
    if (lit || !shines) return;
    diagnostics.push_back(result_diagnostic(
        "RES0207",
        fmt::format("the picture is black: no light reaches what the camera sees of the stage '{}'",
                    request.stage.name),
        "compare the positions of the lights with the stage; --stage chooses another one, for example room"));
}

bool is_dithered(Look look) {
    return look != Look::false_color;
}

Result<ShownPicture> show_picture(Rendering rendering, const PreviewRequest& request, std::span<const Light> lights,
                                  const Console& console) {
    return PictureMaker(std::move(rendering), request, lights, console).shown();
}

Result<EncodedPicture> encode_picture(Rendering rendering, const PreviewRequest& request, std::span<const Light> lights,
                                      const Console& console) {
    PictureMaker maker(std::move(rendering), request, lights, console);
    Result<EncodedPicture> picture = maker.make();
    if (!picture) return picture;
    console.remark(fmt::format("exposure EV100 {:.2f}", picture->exposure.value));
    return picture;
}

} // namespace gonio::cli
