#include <gonio/bake/texture.hpp>
#include <gonio/base/named.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace gonio {

namespace {

constexpr std::array<std::string_view, 4> names{"none", "peak", "mean", "flux"};
static_assert(names.size() == static_cast<std::size_t>(Normalization::flux) + 1);

} // namespace

std::span<const std::string_view> normalization_names() {
    return names;
}

const char* to_text(Normalization normalization) {
    return names[static_cast<std::size_t>(normalization)].data();
}

Result<Normalization> parse_normalization(std::string_view text) {
    return find_named("normalization", text, names).map([](const std::string_view* name) {
        return static_cast<Normalization>(name - names.data());
    });
}

double as_stored(TexelType type, double value) {
    const auto on_steps = [&](double steps) { return std::nearbyint(std::clamp(value, 0.0, 1.0) * steps) / steps; };
    switch (type) {
    case TexelType::float32:
        return static_cast<double>(static_cast<float>(value));
    case TexelType::half: {
        // As from an image of floats; 11 bits, the last is at least 2⁻²⁴.
        const auto single = static_cast<double>(static_cast<float>(value));
        int exponent = 0;
        static_cast<void>(std::frexp(single, &exponent));
        const int last_bit = std::max(exponent - 11, -24);
        const double rounded = std::ldexp(std::nearbyint(std::ldexp(single, -last_bit)), last_bit);
        return rounded > 65504.0 ? std::numeric_limits<double>::infinity() : rounded;
    }
    case TexelType::uint16:
        return on_steps(65535.0);
    case TexelType::uint8:
        return on_steps(255.0);
    }
    return value;
}

const char* to_text(Sampling sampling) {
    switch (sampling) {
    case Sampling::mean:
        return "mean";
    case Sampling::left_edge:
        return "left-edge";
    case Sampling::edge_columns:
        return "edge-columns";
    case Sampling::corners:
        return "corners";
    }
    return "mean";
}

const char* to_text(Transfer transfer) {
    return transfer == Transfer::srgb ? "srgb" : "linear";
}

double encoded(Transfer transfer, double value) {
    if (transfer == Transfer::linear) return value;
    return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
}

double decoded(Transfer transfer, double value) {
    if (transfer == Transfer::linear) return value;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

Image picture_of(const Texture& texture, int x, int width, int channels) {
    Image image(width, texture.image.height, channels);
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < width; ++column) {
            const float value = *texture.image.at(x + column, row);
            const float stored = texture.transfer == Transfer::linear
                                     ? value
                                     : static_cast<float>(encoded(texture.transfer, static_cast<double>(value)));
            std::fill_n(image.at(column, row), channels, stored);
        }
    return image;
}

} // namespace gonio
