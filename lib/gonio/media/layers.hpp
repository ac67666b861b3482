// Layers: several pictures of one size as the channels of one OpenEXR file, as compositing programs read them.
//
// The channels of a layer are its name, a dot and R, G and B, or Y where it has one channel; those of the layer without
// a name are R, G, B alone, which is what programs show that know no layers.
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
    LayeredImage() = default; // without room

    // Room for layers of `channels` channels together. Fails (unsupported) on more than max_layered_values, before
    // anything is allocated.
    static Result<LayeredImage> create(int width, int height, std::size_t channels);

    // A picture of the size, of one or three channels, for which there must be room. The name is as layer_names() gives
    // it, or empty.
    void add(std::string_view name, const Image& picture);

    // As encode_image() does with 32-bit floats, of the layers that were added.
    Result<std::string> encode(std::vector<ImageAttribute> attributes) const;

private:
    Image image_;
    std::vector<std::string> channel_names_;
};

// What layers can be called, in the order of the names: letters, digits, '-' and '_', anything else becoming one '_';
// at most 64 of them. A name that is taken, or one of `reserved`, gets _2, _3, … A note tells of each that changed.
std::vector<std::string> layer_names(std::span<const std::string> names, std::span<const std::string_view> reserved,
                                     Diagnostics& diagnostics);

// A layer of a file that was read; nothing where there is none of that name.
std::optional<Image> find_layer(const DecodedImage& file, std::string_view name);

} // namespace gonio::media
