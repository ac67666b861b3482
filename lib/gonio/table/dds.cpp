// The layout of the file: Microsoft, "Programming Guide for DDS".
#include <gonio/table/dds.hpp>

#include <algorithm>
#include <array>

namespace gonio {

namespace {

// By pixel type, for 1, 2 and 4 channels.
constexpr std::array<std::array<DdsFormat, 3>, 5> formats{{
    {{{"R32_FLOAT", 41, 1}, {"R32G32_FLOAT", 16, 2}, {"R32G32B32A32_FLOAT", 2, 4}}},
    {{{"R16_FLOAT", 54, 1}, {"R16G16_FLOAT", 34, 2}, {"R16G16B16A16_FLOAT", 10, 4}}},
    {{{"R9G9B9E5_SHAREDEXP", 67, 1}, {"R9G9B9E5_SHAREDEXP", 67, 1}, {"R9G9B9E5_SHAREDEXP", 67, 1}}},
    {{{"R16_UNORM", 56, 1}, {"R16G16_UNORM", 35, 2}, {"R16G16B16A16_UNORM", 11, 4}}},
    {{{"R8_UNORM", 61, 1}, {"R8G8_UNORM", 49, 2}, {"R8G8B8A8_UNORM", 28, 4}}},
}};

} // namespace

DdsFormat dds_format(const StoredTable& stored) {
    const std::size_t widest = *std::max_element(stored.layers.begin(), stored.layers.end());
    return formats.at(static_cast<std::size_t>(stored.pixel)).at(widest <= 2 ? widest - 1 : 2);
}

std::string dds_file(const StoredTable& stored) {
    const DdsFormat format = dds_format(stored);
    const int bytes_each = info_of(stored.pixel).bits / 8; // of a component; rgb9e5: of a texel
    const auto texels = static_cast<std::size_t>(stored.table.width) * static_cast<std::size_t>(stored.table.height);
    const auto pitch = static_cast<std::uint32_t>(stored.table.width) * static_cast<std::uint32_t>(format.channels) *
                       static_cast<std::uint32_t>(bytes_each);
    constexpr std::uint32_t has_caps = 0x1, has_height = 0x2, has_width = 0x4, has_pitch = 0x8, has_format = 0x1000;
    constexpr std::uint32_t by_four_characters = 0x4;
    constexpr std::uint32_t is_texture = 0x1000;
    std::string bytes = "DDS ";
    const auto number = [&](std::uint32_t value) { append_bytes(bytes, value, 4); };
    number(124);
    number(has_caps | has_height | has_width | has_pitch | has_format);
    number(static_cast<std::uint32_t>(stored.table.height));
    number(static_cast<std::uint32_t>(stored.table.width));
    number(pitch);
    number(0); // depth
    number(1); // level
    bytes.append(44, '\0');
    number(32); // the size of the pixel format
    number(by_four_characters);
    bytes += "DX10";
    bytes.append(20, '\0');
    number(is_texture);
    bytes.append(16, '\0');
    number(format.number);
    number(3); // two-dimensional
    number(0);
    number(static_cast<std::uint32_t>(stored.layers.size()));
    number(format.channels == 4 ? 4 : 0); // the fourth channel is a number of its own, not opacity
    std::size_t at = 0;
    for (const std::size_t layer : stored.layers) {
        // A texel of rgb9e5 is one number.
        const std::size_t numbers = stored.pixel == TablePixel::rgb9e5 ? 1 : layer;
        for (std::size_t texel = 0; texel < texels; ++texel)
            for (std::size_t c = 0; c < format.channels; ++c)
                append_bytes(bytes, c < numbers ? stored.stored[at++] : 0U, bytes_each);
    }
    return bytes;
}

} // namespace gonio
