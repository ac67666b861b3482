#include <gonio/base/codes/result.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/media/color_space.hpp>
#include <gonio/media/environment_file.hpp>
#include <gonio/media/layers.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gonio::media {

namespace {

constexpr std::string_view scale_attribute = "gonio:nits_per_unit";
constexpr std::string_view layout_attribute = "gonio:layout";

// Three channels of the picture: R, G and B by their names, else Y or a single channel three times, else the first
// ones.
Result<Image> three_channels(const DecodedImage& file) {
    const Image& image = file.image;
    std::optional<Image> layer = find_layer(file, "");
    if (layer && layer->channels == 3) return std::move(*layer);
    if (!layer && image.channels > 2)
        return fail(Failure::unsupported, "the image has no channels R, G and B", "write the environment as RGB");
    const Image& gray = layer ? *layer : image;
    Image rgb(image.width, image.height, 3);
    for (std::size_t i = 0; i < rgb.pixels.size(); ++i)
        rgb.pixels[i] = gray.pixels[i / 3 * static_cast<std::size_t>(gray.channels)];
    return rgb;
}

// Into Rec.709; colours outside it are moved to its border at their luminance.
void convert(Image& image, const RgbSpace& from, Diagnostics& diagnostics) {
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

// The space that an OpenEXR file states by its chromaticities, if it is not Rec.709.
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

double nits_per_unit_of(const DecodedImage& file) {
    for (const ImageAttribute& attribute : file.attributes) {
        const auto* const numbers = std::get_if<std::vector<float>>(&attribute.value);
        if (attribute.name != scale_attribute || numbers == nullptr || numbers->size() != 1) continue;
        const auto scale = static_cast<double>(numbers->front());
        if (scale > 0.0 && std::isfinite(scale)) return scale;
    }
    return 1.0;
}

// What the pixels of a Radiance picture were multiplied by: the product of the lines EXPOSURE= of its header, which
// ends at an empty line. Nothing without such a line. Fails (malformed) on values that are not numbers above 0.
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

// To 11 bits, or to multiples of 2⁻²⁴ for small values, halves to even. Larger than 65504 stays for encode_image() to
// refuse.
float rounded_to_half(float value) {
    int exponent = 0;
    std::frexp(value, &exponent);
    constexpr int digits = 11;
    constexpr int least_exponent = -24;
    const int unit = std::max(exponent - digits, least_exponent);
    return std::ldexp(std::nearbyint(std::ldexp(value, -unit)), unit);
}

// To eight bits of the greatest channel's power of two. The writer cuts off what is left, which would darken the image
// by 0.3 %.
void round_to_shared_exponent(float* rgb) {
    const float most = std::max({rgb[0], rgb[1], rgb[2]});
    if (!(most > 0.0F)) return;
    int exponent = 0;
    // The next power of two, if rounding reaches it.
    if (std::frexp(most, &exponent) * 256.0F >= 255.5F) ++exponent;
    for (int c = 0; c < 3; ++c)
        rgb[c] = std::ldexp(std::nearbyint(std::ldexp(rgb[c], 8 - exponent)), exponent - 8);
}

} // namespace

Result<EnvironmentImage> decode_environment(std::string_view bytes, const EnvironmentReadOptions& options,
                                            Diagnostics& diagnostics) {
    // What can be said without the pixels comes first: they may need gigabytes.
    Result<PictureDimensions> size = picture_dimensions(bytes);
    if (!size) return pass_on(size);
    constexpr const Limit& most = limit("environment-values");
    if (size->values() > static_cast<double>(most.value))
        return fail(Failure::unsupported,
                    fmt::format("the image has {}x{} pixels with {} channels: more than {}", size->width, size->height,
                                size->channels, to_text(most)),
                    "make it smaller first; 8192x4096 pixels with three channels are read");
    EnvironmentLayout layout{};
    if (options.layout) {
        layout = *options.layout;
    } else {
        Result<EnvironmentLayout> found = environment_layout_of(size->width, size->height);
        if (!found) return pass_on(found);
        layout = *found;
    }
    if (Result<EnvironmentGrid> grid = EnvironmentGrid::create(layout, size->width, size->height); !grid)
        return pass_on(grid);
    std::optional<RgbSpace> space;
    if (!options.space.empty()) {
        const RgbSpace* const known = options.config.empty() ? find_rgb_space(options.space) : nullptr;
        Result<RgbSpace> named =
            known != nullptr ? Result<RgbSpace>(*known) : rgb_space_of_config(options.space, options.config);
        if (!named) return pass_on(named);
        space = std::move(*named);
    }

    Result<std::optional<double>> exposure = exposure_of(bytes);
    if (!exposure) return pass_on(exposure);
    if (*exposure && **exposure != 1.0)
        diagnostics.push_back(result_diagnostic(
            "RES0505", fmt::format("the image has an exposure of {:.6g}: its pixels are divided by it", **exposure)));
    Result<DecodedImage> file = decode_image(bytes, most.value);
    if (!file) return pass_on(file);
    if (file->pixel == Pixel::uint8 || file->pixel == Pixel::uint16)
        return fail(Failure::unsupported,
                    fmt::format("the image has {} pixels: values for a display, not light", to_text(file->pixel)),
                    "an environment is an EXR or a Radiance HDR with linear values");
    if (!space) {
        Result<std::optional<RgbSpace>> stated = stated_space(*file);
        if (!stated) return pass_on(stated);
        space = std::move(*stated);
    }
    const double nits_per_unit = nits_per_unit_of(*file) / exposure->value_or(1.0);
    const Pixel pixel = file->pixel;
    Result<Image> rgb = three_channels(*file);
    if (!rgb) return pass_on(rgb);
    file->image = Image();
    // Bad pixels are judged as they are stored: conversion makes negative ones of any saturated colour.
    Result<EnvironmentMap> map =
        EnvironmentMap::create(layout, std::move(*rgb), nits_per_unit, options.bad_pixels, diagnostics);
    if (!map) return pass_on(map);
    if (space) {
        Image converted = map->image();
        convert(converted, *space, diagnostics);
        *map = EnvironmentMap::of_valid(map->grid(), std::move(converted), nits_per_unit);
    }
    return EnvironmentImage{std::move(*map), *size, pixel};
}

EnvironmentMap as_stored(const EnvironmentMap& map, double nits_per_unit, const ImageFormat& format, Pixel pixel) {
    Image image = map.image();
    const double factor = map.nits_per_unit() / nits_per_unit;
    for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3) {
        float* const rgb = image.pixels.data() + i;
        for (int c = 0; c < 3; ++c)
            rgb[c] = static_cast<float>(static_cast<double>(rgb[c]) * factor);
        if (format.name == "hdr")
            round_to_shared_exponent(rgb);
        else if (pixel == Pixel::half)
            std::transform(rgb, rgb + 3, rgb, rounded_to_half);
    }
    return EnvironmentMap::of_valid(map.grid(), std::move(image), nits_per_unit);
}

Result<std::string> encode_environment(const EnvironmentMap& map, const ImageFormat& format, Pixel pixel,
                                       std::vector<ImageAttribute> attributes) {
    ImageWriteOptions options;
    options.pixel = pixel;
    options.color_space = "Linear";
    options.attributes = std::move(attributes);
    options.attributes.push_back({std::string(layout_attribute), std::string(info_of(map.grid().layout()).name)});
    options.attributes.push_back(
        {std::string(scale_attribute), std::vector<float>{static_cast<float>(map.nits_per_unit())}});
    return encode_image(map.image(), format, options);
}

} // namespace gonio::media
