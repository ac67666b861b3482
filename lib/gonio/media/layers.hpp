// Layers: several pictures of one size as the channels of one OpenEXR file, as compositing programs read them.
//
// The channels of a layer are its name, a dot and R, G and B, or Y if it has one channel. Those of the layer without a
// name are just R, G, B, which is what programs without layers show.
#pragma once

#include <gonio/base/diagnostics.hpp>
#include <gonio/base/image.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/result.hpp>
#include <gonio/media/image_file.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::media {

// The most values (width × height × channels) of a layered picture: half a gigabyte.
inline constexpr std::size_t max_layered_values = limit("layered-values").value;

class LayeredImage {
public:
    LayeredImage() = default; // has no space for layers

    // Allocates space for layers with `channels` channels in total. Fails (unsupported) on more than
    // max_layered_values, before anything is allocated.
    static Result<LayeredImage> create(int width, int height, std::size_t channels);

    // Adds a picture of the same size, with one or three channels, for which there must be space. The name is one from
    // layer_names(), or empty.
    void add(std::string_view name, const Image& picture);

    // Encodes the layers that were added, as encode_image() does with 32-bit floats and that many threads.
    Result<std::string> encode(std::vector<ImageAttribute> attributes, unsigned threads = 1) const;

private:
    Image image_;
    std::vector<std::string> channel_names_;
};

// Valid layer names, in the order of `names`: letters, digits, '-' and '_', any run of other characters becomes one
// '_'; at most 64 characters before a number. A name that is in use, or one of `reserved`, gets _2, _3, … A note
// reports each changed name.
std::vector<std::string> layer_names(std::span<const std::string> names, std::span<const std::string_view> reserved,
                                     Diagnostics& diagnostics);

// A layer of a file that was read; nothing if there is no layer of that name.
std::optional<Image> find_layer(const DecodedImage& file, std::string_view name);

} // namespace gonio::media
