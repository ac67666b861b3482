#include <gonio/base/codes/result.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/media/detail/linear_image.hpp>
#include <gonio/media/layers.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace gonio::media::detail {

Result<PictureDimensions> dimensions_within(std::string_view bytes, const Limit& most, const char* hint) {
    Result<PictureDimensions> size = picture_dimensions(bytes);
    if (!size || size->values() <= static_cast<double>(most.value)) return size;
    return fail(Failure::unsupported,
                fmt::format("the image has {}x{} pixels with {} channels: more than {}", size->width, size->height,
                            size->channels, to_text(most)),
                hint);
}

Result<Image> three_channels(const DecodedImage& file) {
    const Image& image = file.image;
    std::optional<Image> layer = find_layer(file, "");
    if (layer && layer->channels == 3) return std::move(*layer);
    if (!layer && image.channels > 2)
        return fail(Failure::unsupported, "the image has no channels R, G and B", "write its channels as R, G and B");
    const Image& gray = layer ? *layer : image;
    Image rgb(image.width, image.height, 3);
    for (std::size_t i = 0; i < rgb.pixels.size(); ++i)
        rgb.pixels[i] = gray.pixels[i / 3 * static_cast<std::size_t>(gray.channels)];
    return rgb;
}

void to_rec709(Image& image, const RgbSpace& from, Diagnostics& diagnostics) {
    const glm::dmat3 matrix = find_rgb_space("rec709")->from_xyz * from.to_xyz;
    std::size_t outside = 0;
    for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3) {
        float* const pixel = image.pixels.data() + i;
        const glm::dvec3 rgb = matrix * glm::dvec3(pixel[0], pixel[1], pixel[2]);
        glm::dvec3 kept(std::fmax(rgb.x, 0.0), std::fmax(rgb.y, 0.0), std::fmax(rgb.z, 0.0));
        const double luminance = std::fmax(glm::dot(rgb, rec709_luminance), 0.0);
        const double now = glm::dot(kept, rec709_luminance);
        const double most = std::max({kept.x, kept.y, kept.z});
        // Rounding of white and greys is no colour outside.
        if (std::min({rgb.x, rgb.y, rgb.z}) < -1e-6 * most) ++outside;
        kept *= now > 0.0 ? luminance / now : 0.0;
        for (int c = 0; c < 3; ++c)
            pixel[c] = static_cast<float>(kept[c]);
    }
    if (outside > 0)
        diagnostics.push_back(result_diagnostic(
            "RES0104", fmt::format("{} of {} pixels lie outside Rec.709: moved into it at the same luminance", outside,
                                   image.pixels.size() / 3)));
}

Result<std::optional<RgbSpace>> stated_space(const DecodedImage& file) {
    for (const ImageAttribute& attribute : file.attributes) {
        const auto* const xy = std::get_if<std::vector<float>>(&attribute.value);
        if (attribute.name != "chromaticities" || xy == nullptr || xy->size() != 8) continue;
        constexpr std::array rec709{0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290};
        constexpr double same = 1e-4;
        std::array<Xy, 4> points;
        bool is_rec709 = true;
        for (std::size_t i = 0; i < rec709.size(); ++i) {
            const auto value = static_cast<double>((*xy)[i]);
            (i % 2 == 0 ? points.at(i / 2).x : points.at(i / 2).y) = value;
            is_rec709 = is_rec709 && std::abs(value - rec709.at(i)) < same;
        }
        if (is_rec709) break;
        Result<RgbSpace> space = rgb_space_of("chromaticities", points[0], points[1], points[2], points[3]);
        if (!space)
            return fail(Failure::malformed, "the chromaticities that the image states do not span a colour space",
                        "name the space of its pixels: space=rec709");
        return std::optional(std::move(*space));
    }
    return std::optional<RgbSpace>();
}

Result<std::optional<double>> exposure_of(std::string_view bytes) {
    constexpr std::string_view key = "EXPOSURE=";
    std::optional<double> product;
    if (!bytes.starts_with("#?")) return product;
    while (!bytes.empty()) {
        const std::size_t end = std::min(bytes.find('\n'), bytes.size());
        std::string_view line = bytes.substr(0, end);
        if (line.empty()) break;
        bytes.remove_prefix(std::min(end + 1, bytes.size()));
        if (!line.starts_with(key)) continue;
        line.remove_prefix(key.size());
        const std::optional<double> value = parse_number(trimmed(line));
        if (!value || !(*value > 0.0))
            return fail(Failure::malformed, "a line EXPOSURE= of the image is not a number above 0",
                        "correct the line, or take it out");
        product = product.value_or(1.0) * *value;
    }
    constexpr double greatest = 1e30;
    if (product && !(*product >= 1.0 / greatest && *product <= greatest))
        return fail(Failure::malformed,
                    fmt::format("the exposure of the image is not within {} and {}", 1.0 / greatest, greatest),
                    "take the lines EXPOSURE= out of its header");
    return product;
}

} // namespace gonio::media::detail
