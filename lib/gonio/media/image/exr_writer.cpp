#include <gonio/media/image/exr_names.hpp>
#include <gonio/media/image/exr_writer.hpp>
#include <gonio/media/image/exr_zip.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gonio::media::detail {

namespace {

using Bytes = std::vector<unsigned char>;

// Little-endian, as WebAssembly is.
template<class T>
void put(Bytes& to, T value) {
    const std::size_t at = to.size();
    to.resize(at + sizeof value);
    std::memcpy(to.data() + at, &value, sizeof value);
}

void put_text(Bytes& to, std::string_view text) {
    to.insert(to.end(), text.begin(), text.end());
    to.push_back(0);
}

void put_attribute(Bytes& to, std::string_view name, std::string_view type, const Bytes& value) {
    put_text(to, name);
    put_text(to, type);
    put(to, static_cast<std::int32_t>(value.size()));
    to.insert(to.end(), value.begin(), value.end());
}

template<class... T>
void put_attribute(Bytes& to, std::string_view name, std::string_view type, T... values) {
    Bytes bytes;
    (put(bytes, values), ...);
    put_attribute(to, name, type, bytes);
}

void put_custom(Bytes& to, const abi::Attribute& attribute) {
    const std::string_view name = exr_name(attribute.name);
    Bytes value;
    switch (attribute.kind) {
    case abi::attribute_text: {
        const std::string_view text = attribute.text;
        value.assign(text.begin(), text.end());
        put_attribute(to, name, "string", value);
        break;
    }
    case abi::attribute_floats:
        for (std::size_t i = 0; i < attribute.count; ++i)
            put(value, attribute.floats[i]);
        put_attribute(to, name, attribute.count == 1 ? "float" : "floatvector", value);
        break;
    default:
        for (std::size_t i = 0; i < attribute.count; ++i)
            put(value, attribute.ints[i]);
        if (attribute.count >= 1 && attribute.count <= 3)
            put_attribute(to, name, attribute.count == 1 ? "int" : attribute.count == 2 ? "v2i" : "v3i", value);
        break;
    }
}

// To the nearest, ties to even; the caller has checked the range.
std::uint16_t half_of(float value) {
    const auto bits = __builtin_bit_cast(std::uint32_t, value);
    const std::uint32_t sign = bits >> 16U & 0x8000U;
    const std::uint32_t magnitude = bits & 0x7fffffffU;
    if (magnitude > 0x7f800000U) return static_cast<std::uint16_t>(sign | 0x7e00U); // no number
    if (magnitude >= 0x477ff000U) return static_cast<std::uint16_t>(sign | 0x7c00U);
    if (magnitude < 0x33000001U) return static_cast<std::uint16_t>(sign);
    std::uint32_t mantissa = magnitude & 0x7fffffU;
    const auto exponent = static_cast<std::int32_t>(magnitude >> 23U) - 127;
    std::uint32_t result = 0;
    std::uint32_t dropped = 13;
    if (exponent < -14) { // a number below the least normal one
        mantissa |= 0x800000U;
        dropped += static_cast<std::uint32_t>(-14 - exponent);
    } else {
        result = static_cast<std::uint32_t>(exponent + 15) << 10U;
    }
    result += mantissa >> dropped;
    const std::uint32_t rest = mantissa & ((1U << dropped) - 1U);
    const std::uint32_t tie = 1U << (dropped - 1U);
    if (rest > tie || (rest == tie && (result & 1U) != 0U)) ++result;
    return static_cast<std::uint16_t>(sign | result);
}

} // namespace

std::vector<unsigned char> exr_bytes(const abi::EncodeRequest& request) {
    std::string_view compression = "zip";
    for (std::size_t i = 0; i < request.attribute_count; ++i)
        if (std::string_view(request.attributes[i].name) == "compression") compression = request.attributes[i].text;
    if (compression != "zip" && compression != "none")
        throw std::runtime_error("of OpenEXR's compressions, WebAssembly has none and zip");
    const bool zips = compression == "zip";
    const bool is_half = request.pixel == abi::pixel_half;

    // Channels are stored in the order of their names.
    std::vector<std::int32_t> order(static_cast<std::size_t>(request.channels));
    std::iota(order.begin(), order.end(), 0);
    const auto name_of = [&](std::int32_t channel) { return std::string_view(request.channel_names[channel]); };
    std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) { return name_of(a) < name_of(b); });

    Bytes channels;
    bool has_long_name = false;
    for (const std::int32_t channel : order) {
        has_long_name |= name_of(channel).size() > 31;
        put_text(channels, name_of(channel));
        put(channels, std::int32_t{is_half ? 1 : 2});
        put(channels, std::int32_t{0}); // not perceptually linear
        put(channels, std::int32_t{1});
        put(channels, std::int32_t{1});
    }
    channels.push_back(0);
    Bytes custom;
    for (std::size_t i = 0; i < request.attribute_count; ++i) {
        const std::string_view name = request.attributes[i].name;
        if (name == "compression") continue;
        has_long_name |= exr_name(name).size() > 31;
        put_custom(custom, request.attributes[i]);
    }

    Bytes file;
    put(file, std::int32_t{20000630});
    put(file, std::int32_t{has_long_name ? 0x402 : 2});
    put_attribute(file, "channels", "chlist", channels);
    put_attribute(file, "compression", "compression", static_cast<unsigned char>(zips ? 3 : 0));
    for (const char* const window : {"dataWindow", "displayWindow"})
        put_attribute(file, window, "box2i", std::int32_t{0}, std::int32_t{0}, request.width - 1, request.height - 1);
    put_attribute(file, "lineOrder", "lineOrder", static_cast<unsigned char>(0));
    put_attribute(file, "pixelAspectRatio", "float", 1.0F);
    put_attribute(file, "screenWindowCenter", "v2f", 0.0F, 0.0F);
    put_attribute(file, "screenWindowWidth", "float", 1.0F);
    file.insert(file.end(), custom.begin(), custom.end());
    file.push_back(0);

    const std::int32_t lines = zips ? 16 : 1; // of a block
    const std::int32_t blocks = (request.height + lines - 1) / lines;
    const std::size_t table = file.size();
    file.resize(table + 8 * static_cast<std::size_t>(blocks));
    for (std::int32_t block = 0; block < blocks; ++block) {
        const std::int32_t first = block * lines;
        Bytes raw;
        for (std::int32_t y = first; y < std::min(first + lines, request.height); ++y)
            for (const std::int32_t channel : order)
                for (std::int32_t x = 0; x < request.width; ++x) {
                    const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(request.width) +
                                              static_cast<std::size_t>(x);
                    const float value = request.pixels[pixel * static_cast<std::size_t>(request.channels) +
                                                       static_cast<std::size_t>(channel)];
                    if (is_half)
                        put(raw, half_of(value));
                    else
                        put(raw, value);
                }
        const std::uint64_t at = file.size();
        std::memcpy(file.data() + table + 8 * static_cast<std::size_t>(block), &at, sizeof at);
        const Bytes data = zips ? exr_zip(raw) : raw;
        put(file, first);
        put(file, static_cast<std::int32_t>(data.size()));
        file.insert(file.end(), data.begin(), data.end());
    }
    return file;
}

} // namespace gonio::media::detail
