#include <gonio/base/named.hpp>
#include <gonio/table/stored_table.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gonio {

namespace {

constexpr std::array pixels{
    TablePixelInfo{"float", TablePixel::float32, 32, 0.0}, TablePixelInfo{"half", TablePixel::half, 16, 0.0},
    TablePixelInfo{"rgb9e5", TablePixel::rgb9e5, 32, 0.0}, TablePixelInfo{"uint16", TablePixel::uint16, 16, 65535.0},
    TablePixelInfo{"uint8", TablePixel::uint8, 8, 255.0},
};
static_assert(in_enum_order(pixels, &TablePixelInfo::pixel, TablePixel::uint8));

constexpr std::size_t channels_of_layer = 4;

std::vector<std::size_t> layers_of(std::size_t channels) {
    std::vector<std::size_t> layers;
    for (std::size_t left = channels; left > 0; left -= layers.back())
        layers.push_back(std::min(left, channels_of_layer));
    return layers;
}

// Calls f(index of the value, channel) for each component in the order in which they are stored.
template<class F>
void in_stored_order(const ShadingTable& table, const F& f) {
    const std::size_t channels = table.channels();
    const std::size_t texels = table.values.size() / channels;
    std::size_t first = 0;
    for (const std::size_t width : layers_of(channels)) {
        for (std::size_t texel = 0; texel < texels; ++texel)
            for (std::size_t c = first; c < first + width; ++c)
                f(texel * channels + c, c);
        first += width;
    }
}

// RGB9E5: 2^(e − 15 − 9) · m for each channel (OpenGL 3.0, EXT_texture_shared_exponent).
constexpr int shared_bias = 15 + 9;
constexpr double most_shared = 511.0 / 512.0 * 65536.0;

std::uint32_t shared_bits(std::span<const float> rgb) {
    double most = 0.0;
    for (const float value : rgb)
        most = std::max(most, static_cast<double>(value));
    int exponent = 0;
    static_cast<void>(std::frexp(most, &exponent)); // most < 2^exponent
    const auto mantissa = [](double value, int of) { return std::nearbyint(std::ldexp(value, shared_bias - of)); };
    int shared = most > 0.0 ? std::max(exponent + 15, 0) : 0;
    if (mantissa(most, shared) > 511.0) ++shared;
    std::uint32_t bits = static_cast<std::uint32_t>(shared) << 27U;
    for (std::size_t c = 0; c < rgb.size(); ++c)
        bits |= static_cast<std::uint32_t>(mantissa(static_cast<double>(rgb[c]), shared)) << (9U * c);
    return bits;
}

double shared_value(std::uint32_t bits, std::size_t channel) {
    const auto mantissa = static_cast<double>((bits >> (9U * channel)) & 511U);
    return std::ldexp(mantissa, static_cast<int>(bits >> 27U) - shared_bias);
}

bool has_roots(TableKind kind, TablePixel pixel) {
    const std::span<const TableChannel> channels = info_of(kind).channels;
    return info_of(pixel).steps > 0.0 && std::any_of(channels.begin(), channels.end(), [](const TableChannel& channel) {
               return channel.root_in_integers;
           });
}

void take_roots(ShadingTable& table) {
    table.has_roots = true;
    for (std::size_t i = 0; i < table.values.size(); ++i)
        // Interpolated fits can lie a little below 0.
        if (table.holds_root(i % table.channels())) table.values[i] = std::sqrt(std::max(table.values[i], 0.0F));
}

Result<void> check_fit(const ShadingTable& table, TablePixel pixel) {
    const TableInfo& info = info_of(table.kind);
    const auto [low, high] = std::minmax_element(table.values.begin(), table.values.end());
    constexpr const char* hint = "float and half hold every table; uint16 and uint8 every one that is no polynomial";
    if (table.form == TableForm::chebyshev && pixel != TablePixel::float32 && pixel != TablePixel::half)
        return fail(
            "USE0107",
            fmt::format("{} holds no coefficients of a polynomial: their rounding adds up", info_of(pixel).name), hint);
    if (table.kind == TableKind::ltc_heitz && pixel != TablePixel::float32 && pixel != TablePixel::half)
        return fail("USE0107",
                    fmt::format("lookups of {} take texels as they are, but {} needs an offset and a scale", info.name,
                                info_of(pixel).name),
                    "use --pixel half or float");
    if (pixel == TablePixel::half)
        for (const float end : {*low, *high})
            if (!(std::fabs(half_value(half_bits(static_cast<double>(end)))) <= 65504.0))
                return fail("USE0107", fmt::format("half ends at 65504, but {} has {}", info.name, end), hint);
    if (pixel != TablePixel::rgb9e5) return {};
    if (table.channels() > 3)
        return fail("USE0107", fmt::format("rgb9e5 has 3 channels, but {} has {}", info.name, table.channels()), hint);
    if (*low < 0.0F || static_cast<double>(*high) > most_shared)
        return fail("USE0107",
                    fmt::format("rgb9e5 goes from 0 to {}, but {} from {} to {}", most_shared, info.name, *low, *high),
                    hint);
    return {};
}

} // namespace

std::span<const TablePixelInfo> table_pixels() {
    return pixels;
}

const TablePixelInfo& info_of(TablePixel pixel) {
    return pixels.at(static_cast<std::size_t>(pixel));
}

double half_value(std::uint32_t bits) {
    const double sign = (bits & 0x8000U) != 0 ? -1.0 : 1.0;
    const auto exponent = static_cast<int>((bits >> 10U) & 31U);
    const auto mantissa = static_cast<double>(bits & 1023U);
    if (exponent == 31)
        return mantissa > 0.0 ? std::numeric_limits<double>::quiet_NaN()
                              : sign * std::numeric_limits<double>::infinity();
    return sign * (exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024.0 + mantissa, exponent - 25));
}

std::uint32_t half_bits(double value) {
    const std::uint32_t sign = std::signbit(value) ? 0x8000U : 0U;
    const double size = std::fabs(value);
    if (std::isnan(size)) return 0x7e00U;
    if (std::isinf(size)) return sign | 0x7c00U;
    if (size == 0.0) return sign; // which has no exponent
    int exponent = 0;
    static_cast<void>(std::frexp(size, &exponent)); // size < 2^exponent
    const int last_bit = std::max(exponent - 11, -24);
    const double steps = std::nearbyint(std::ldexp(size, -last_bit)); // at most 2048
    if (std::ldexp(steps, last_bit) > 65504.0) return sign | 0x7c00U;
    // Counting in steps of the last bit goes on in the next exponent where the mantissa overflows.
    return sign | (static_cast<std::uint32_t>(last_bit + 24) * 1024U + static_cast<std::uint32_t>(steps));
}

ShadingTable read_back(const ShadingTable& shape, TablePixel pixel, std::span<const ChannelRange> ranges,
                       std::span<const std::uint32_t> stored) {
    ShadingTable table = shape;
    table.has_roots = has_roots(shape.kind, pixel);
    const double steps = info_of(pixel).steps;
    std::size_t at = 0;
    in_stored_order(shape, [&](std::size_t index, std::size_t channel) {
        double value = 0.0;
        if (pixel == TablePixel::rgb9e5) {
            value = shared_value(stored[index / shape.channels()], channel);
        } else if (pixel == TablePixel::float32) {
            value = static_cast<double>(__builtin_bit_cast(float, stored[at]));
        } else if (pixel == TablePixel::half) {
            value = half_value(stored[at]);
        } else {
            value = ranges[channel].offset + ranges[channel].scale * static_cast<double>(stored[at]) / steps;
        }
        table.values[index] = static_cast<float>(value);
        ++at;
    });
    return table;
}

Result<StoredTable> store_table(ShadingTable table, TablePixel pixel) {
    if (Result<void> fine = check_fit(table, pixel); !fine) return pass_on(fine);
    const std::size_t channels = table.channels();
    StoredTable made;
    made.pixel = pixel;
    made.layers = layers_of(channels);
    made.ranges.resize(channels);
    std::vector<double> greatest(channels);
    const double steps = info_of(pixel).steps;
    if (has_roots(table.kind, pixel) && !table.has_roots) take_roots(table);
    for (std::size_t c = 0; c < channels; ++c) {
        auto low = static_cast<double>(table.values[c]);
        double high = low;
        for (std::size_t i = c; i < table.values.size(); i += channels) {
            low = std::min(low, static_cast<double>(table.values[i]));
            high = std::max(high, static_cast<double>(table.values[i]));
        }
        greatest[c] = std::max(std::fabs(low), std::fabs(high));
        // As floats: a shader computes with them.
        if (steps > 0.0) made.ranges[c] = {low, static_cast<double>(static_cast<float>(high - low))};
    }
    if (pixel == TablePixel::rgb9e5)
        for (std::size_t i = 0; i < table.values.size(); i += channels)
            made.stored.push_back(shared_bits(std::span(table.values).subspan(i, channels)));
    else
        in_stored_order(table, [&](std::size_t index, std::size_t channel) {
            const auto value = static_cast<double>(table.values[index]);
            if (pixel == TablePixel::float32) {
                made.stored.push_back(__builtin_bit_cast(std::uint32_t, table.values[index]));
            } else if (pixel == TablePixel::half) {
                made.stored.push_back(half_bits(value));
            } else {
                const auto [offset, scale] = made.ranges[channel];
                const double share = scale > 0.0 ? (value - offset) / scale : 0.0;
                made.stored.push_back(static_cast<std::uint32_t>(std::nearbyint(std::clamp(share, 0.0, 1.0) * steps)));
            }
        });
    made.table = read_back(table, pixel, made.ranges, made.stored);
    for (std::size_t i = 0; i < table.values.size(); ++i)
        if (greatest[i % channels] > 0.0)
            made.rounding = std::max(made.rounding, std::fabs(static_cast<double>(made.table.values[i]) -
                                                              static_cast<double>(table.values[i])) /
                                                        greatest[i % channels]);
    return made;
}

void append_bytes(std::string& bytes, std::uint32_t number, int count) {
    for (int k = 0; k < count; ++k)
        bytes += static_cast<char>((number >> (8U * static_cast<unsigned>(k))) & 255U);
}

std::string raw_bytes(const StoredTable& stored) {
    std::string bytes;
    const int count = info_of(stored.pixel).bits / 8;
    bytes.reserve(stored.stored.size() * static_cast<std::size_t>(count));
    for (const std::uint32_t component : stored.stored)
        append_bytes(bytes, component, count);
    return bytes;
}

} // namespace gonio
