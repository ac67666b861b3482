#include <gonio/base/codes/result.hpp>
#include <gonio/media/layers.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_set>
#include <utility>

namespace gonio::media {

namespace {

constexpr std::size_t longest_name = 64;

constexpr std::array<std::string_view, 3> rgb{"R", "G", "B"};
constexpr std::array<std::string_view, 1> gray{"Y"};

std::span<const std::string_view> channels_of(int channels) {
    return channels == 3 ? std::span<const std::string_view>(rgb) : gray;
}

std::string channel_name(std::string_view layer, std::string_view channel) {
    return layer.empty() ? std::string(channel) : fmt::format("{}.{}", layer, channel);
}

bool is_plain(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

std::string plain_name(const std::string& name) {
    std::string plain;
    bool replaced = false; // a run of several becomes one
    for (const char c : name) {
        if (plain.size() == longest_name) break;
        if (is_plain(c)) {
            plain += c;
        } else if (!replaced) {
            plain += '_';
        }
        replaced = !is_plain(c);
    }
    return plain.empty() ? "_" : plain;
}

} // namespace

Result<LayeredImage> LayeredImage::create(int width, int height, std::size_t channels) {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (pixels == 0 || channels > max_layered_values / pixels)
        return fail(Failure::unsupported,
                    fmt::format("{} channels of {}x{} pixels are too many: a layered picture may have {}, by {}",
                                channels, width, height, pixels == 0 ? 0 : max_layered_values / pixels,
                                to_text(limit("layered-values"))),
                    "use a smaller size");
    LayeredImage layered;
    layered.image_ = Image(width, height, static_cast<int>(channels));
    return layered;
}

void LayeredImage::add(std::string_view name, const Image& picture) {
    const std::size_t first = channel_names_.size();
    const auto count = static_cast<std::size_t>(picture.channels);
    const auto all = static_cast<std::size_t>(image_.channels);
    for (const std::string_view channel : channels_of(picture.channels))
        channel_names_.push_back(channel_name(name, channel));
    for (std::size_t from = 0, to = first; from < picture.pixels.size(); from += count, to += all)
        std::copy_n(picture.pixels.begin() + static_cast<std::ptrdiff_t>(from), count,
                    image_.pixels.begin() + static_cast<std::ptrdiff_t>(to));
}

Result<std::string> LayeredImage::encode(std::vector<ImageAttribute> attributes, unsigned threads) const {
    ImageWriteOptions options;
    options.pixel = Pixel::float32;
    options.color_space = "Linear";
    options.channel_names = channel_names_;
    options.attributes = std::move(attributes);
    options.threads = threads;
    return encode_image(image_, *find_image_format("exr"), options);
}

std::vector<std::string> layer_names(std::span<const std::string> names, std::span<const std::string_view> reserved,
                                     Diagnostics& diagnostics) {
    std::unordered_set<std::string> taken;
    for (const std::string_view name : reserved)
        taken.emplace(name);
    std::vector<std::string> given;
    given.reserve(names.size());
    for (const std::string& name : names) {
        const std::string plain = plain_name(name);
        std::string unique = plain;
        for (std::size_t count = 2; !taken.insert(unique).second; ++count)
            unique = fmt::format("{}_{}", plain, count);
        if (unique != name)
            diagnostics.push_back(
                result_diagnostic("RES0204", fmt::format("the layer of '{}' is called {}", name, unique)));
        given.push_back(std::move(unique));
    }
    return given;
}

std::optional<Image> find_layer(const DecodedImage& file, std::string_view name) {
    for (const int channels : {3, 1}) {
        std::vector<std::size_t> at;
        for (const std::string_view channel : channels_of(channels)) {
            const auto found =
                std::find(file.channel_names.begin(), file.channel_names.end(), channel_name(name, channel));
            if (found != file.channel_names.end())
                at.push_back(static_cast<std::size_t>(found - file.channel_names.begin()));
        }
        if (at.size() != static_cast<std::size_t>(channels)) continue;
        Image layer(file.image.width, file.image.height, channels);
        const auto all = static_cast<std::size_t>(file.image.channels);
        for (std::size_t i = 0; i < layer.pixels.size(); ++i)
            layer.pixels[i] = file.image.pixels[i / at.size() * all + at[i % at.size()]];
        return layer;
    }
    return std::nullopt;
}

} // namespace gonio::media
