#include <gonio/base/file.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/media/detail/linear_image.hpp>
#include <gonio/media/image_file.hpp>
#include <gonio/media/light_image_file.hpp>

#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <utility>

namespace gonio::media {

namespace {

// The last channel of a picture with an even number of them; nothing without one.
std::optional<std::size_t> alpha_of(const DecodedImage& picture) {
    const auto channels = static_cast<std::size_t>(picture.image.channels);
    if (channels != 2 && channels != 4) return std::nullopt;
    return channels - 1;
}

// Linear Rec.709 from the values of a display.
Image decoded(const DecodedImage& picture) {
    const Image& image = picture.image;
    const std::optional<std::size_t> alpha = alpha_of(picture);
    const auto stored = static_cast<std::size_t>(image.channels);
    const std::size_t colors = stored - (alpha ? 1 : 0);
    Image linear(image.width, image.height, colors < 3 ? 1 : 3);
    const auto channels = static_cast<std::size_t>(linear.channels);
    for (std::size_t i = 0; i < linear.pixels.size(); ++i) {
        const std::size_t pixel = i / channels * stored;
        const double value = decode_srgb(static_cast<double>(image.pixels[pixel + i % channels]));
        const double opaque = alpha ? static_cast<double>(image.pixels[pixel + *alpha]) : 1.0;
        linear.pixels[i] = static_cast<float>(value * opaque);
    }
    return linear;
}

// Lines EXPOSURE= of Radiance pictures are not read: a factor on all pixels changes no mask.
Result<Image> as_stored(const DecodedImage& picture, Diagnostics& diagnostics) {
    Result<std::optional<RgbSpace>> space = detail::stated_space(picture);
    if (!space) return pass_on(space);
    Result<Image> rgb = detail::three_channels(picture);
    if (!rgb) return rgb;
    if (*space) detail::to_rec709(*rgb, **space, diagnostics);
    return rgb;
}

Result<LightImage> read(std::string_view bytes, Diagnostics& diagnostics) {
    constexpr const Limit& most = limit("light-image-values");
    Result<PictureDimensions> size = detail::dimensions_within(bytes, most, "make it smaller first");
    if (!size) return pass_on(size);
    Result<DecodedImage> picture = decode_image(bytes, most.value);
    if (!picture) return pass_on(picture);
    const bool is_display = picture->pixel == Pixel::uint8 || picture->pixel == Pixel::uint16;
    Result<Image> linear = is_display ? Result<Image>(decoded(*picture)) : as_stored(*picture, diagnostics);
    if (!linear) return pass_on(linear);
    return LightImage::create(*linear);
}

} // namespace

Result<LightImage> read_light_image_file(const std::string& file, Diagnostics& diagnostics) {
    Result<std::string> bytes = read_file(file);
    if (!bytes) return pass_on(bytes);
    Result<LightImage> image = read(*bytes, diagnostics);
    if (image) return image;
    Error error = std::move(image.error());
    for (Diagnostic& diagnostic : error.diagnostics)
        if (diagnostic.location.file.empty()) diagnostic.location.file = file;
    return Unexpected(std::move(error));
}

void enable_light_images() {
    set_light_image_reader(read_light_image_file);
}

} // namespace gonio::media
