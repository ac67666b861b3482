#include <gonio/base/codes/result.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/media/color_space.hpp>
#include <gonio/media/detail/linear_image.hpp>
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

double nits_per_unit_of(const DecodedImage& file) {
    for (const ImageAttribute& attribute : file.attributes) {
        const auto* const numbers = std::get_if<std::vector<float>>(&attribute.value);
        if (attribute.name != scale_attribute || numbers == nullptr || numbers->size() != 1) continue;
        const auto scale = static_cast<double>(numbers->front());
        if (scale > 0.0 && std::isfinite(scale)) return scale;
    }
    return 1.0;
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
    constexpr const Limit& most = limit("environment-values");
    Result<PictureDimensions> size =
        detail::dimensions_within(bytes, most, "make it smaller first; 8192x4096 pixels with three channels are read");
    if (!size) return pass_on(size);
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

    Result<std::optional<double>> exposure = detail::exposure_of(bytes);
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
        Result<std::optional<RgbSpace>> stated = detail::stated_space(*file);
        if (!stated) return pass_on(stated);
        space = std::move(*stated);
    }
    const double nits_per_unit = nits_per_unit_of(*file) / exposure->value_or(1.0);
    const Pixel pixel = file->pixel;
    Result<Image> rgb = detail::three_channels(*file);
    if (!rgb) return pass_on(rgb);
    file->image = Image();
    // Bad pixels are judged as they are stored: conversion makes negative ones of any saturated colour.
    Result<EnvironmentMap> map =
        EnvironmentMap::create(layout, std::move(*rgb), nits_per_unit, options.bad_pixels, diagnostics);
    if (!map) return pass_on(map);
    if (space) {
        Image converted = map->image();
        detail::to_rec709(converted, *space, diagnostics);
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
                                       std::vector<ImageAttribute> attributes, unsigned threads) {
    ImageWriteOptions options;
    options.threads = threads;
    options.pixel = pixel;
    options.color_space = "Linear";
    options.attributes = std::move(attributes);
    options.attributes.push_back({std::string(layout_attribute), std::string(info_of(map.grid().layout()).name)});
    options.attributes.push_back(
        {std::string(scale_attribute), std::vector<float>{static_cast<float>(map.nits_per_unit())}});
    return encode_image(map.image(), format, options);
}

} // namespace gonio::media
