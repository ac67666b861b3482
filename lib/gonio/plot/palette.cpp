#include <gonio/base/named.hpp>
#include <gonio/plot/palette.hpp>

#include <algorithm>
#include <cmath>

namespace gonio {

namespace {

constexpr std::array series{ink(0x0072b2), ink(0xd55e00), ink(0x009e73), ink(0xcc79a7),
                            ink(0xe69f00), ink(0x56b4e9), ink(0x000000)};

// viridis, magma, inferno, plasma: van der Walt and Smith, 2015, public domain; cividis: Nuñez, Anderton and Renslow,
// PLOS ONE 13(7), 2018. Colours at steps of 1/9.
constexpr std::array viridis{ink(0x440154), ink(0x482878), ink(0x3e4a89), ink(0x31688e), ink(0x26828e),
                             ink(0x1f9e89), ink(0x35b779), ink(0x6dcd59), ink(0xb4de2c), ink(0xfde725)};
constexpr std::array inferno{ink(0x000004), ink(0x1b0c42), ink(0x4b0c6b), ink(0x781c6d), ink(0xa52c60),
                             ink(0xcf4446), ink(0xed6925), ink(0xfb9a06), ink(0xf7d03c), ink(0xfcffa4)};
constexpr std::array magma{ink(0x000004), ink(0x180f3e), ink(0x451077), ink(0x721f81), ink(0x9f2f7f),
                           ink(0xcd4071), ink(0xf1605d), ink(0xfd9567), ink(0xfec98d), ink(0xfcfdbf)};
constexpr std::array plasma{ink(0x0d0887), ink(0x47039f), ink(0x7301a8), ink(0x9c179e), ink(0xbd3786),
                            ink(0xd8576b), ink(0xed7953), ink(0xfa9e3b), ink(0xfdc926), ink(0xf0f921)};
constexpr std::array cividis{ink(0x00204d), ink(0x00336f), ink(0x39486b), ink(0x575c6d), ink(0x707173),
                             ink(0x8a8779), ink(0xa69d75), ink(0xc4b56c), ink(0xe4cf5b), ink(0xffea46)};
// A. Mikhailov, "Turbo, an improved rainbow colormap for visualization", Google AI Blog, 2019. At steps of 1/17.
constexpr std::array turbo{ink(0x30123b), ink(0x3f3e9c), ink(0x4666dd), ink(0x458cfd), ink(0x2fb2f4), ink(0x1ad4d0),
                           ink(0x22ebaa), ink(0x52fa7a), ink(0x8bff4b), ink(0xb7f735), ink(0xdbe236), ink(0xf5c53a),
                           ink(0xfea130), ink(0xf9751d), ink(0xe84b0c), ink(0xce2d04), ink(0xa91601), ink(0x7a0403)};
constexpr std::array gray{ink(0x000000), ink(0xffffff)};

// The formula of the paper, from (59, 76, 192) to (180, 4, 38), at steps of 1/10.
constexpr std::array blue_to_red{ink(0x3b4cc0), ink(0x5a77e3), ink(0x7b9ff9), ink(0x9fbeff),
                                 ink(0xc0d4f5), ink(0xdddddd), ink(0xf2cbb7), ink(0xf7ad8f),
                                 ink(0xee8568), ink(0xd75344), ink(0xb40426)};
constexpr Palette diverging{"blue-red", "blue below 0, grey, red above", blue_to_red};

constexpr std::array known{
    Palette{"viridis", "violet, green, yellow", viridis},
    Palette{"inferno", "black, red, yellow", inferno},
    Palette{"magma", "black, violet, cream", magma},
    Palette{"plasma", "blue, red, yellow", plasma},
    Palette{"cividis", "blue, grey, yellow: safe for colour-blind viewers", cividis},
    Palette{"turbo", "blue, green, red, as lighting programs draw it; dark at both ends", turbo, false},
    Palette{"gray", "black to white", gray},
};

} // namespace

Ink series_color(std::size_t index) {
    return series[index % series.size()];
}

std::array<float, 3> Palette::at(double value) const {
    const double clamped = value > 0.0 ? std::fmin(value, 1.0) : 0.0;
    const double place = clamped * static_cast<double>(knots.size() - 1);
    const std::size_t lower = std::min(static_cast<std::size_t>(place), knots.size() - 2);
    const double weight = place - static_cast<double>(lower);
    const Ink from = knots[lower];
    const Ink to = knots[lower + 1];
    const auto mixed = [&](double a, double b) { return static_cast<float>((a + weight * (b - a)) / 255.0); };
    return {mixed(from.r, to.r), mixed(from.g, to.g), mixed(from.b, to.b)};
}

Ink Palette::ink_at(double value) const {
    const std::array<float, 3> rgb = at(value);
    const auto byte = [](float channel) { return static_cast<std::uint8_t>(std::lround(255.0F * channel)); };
    return {byte(rgb[0]), byte(rgb[1]), byte(rgb[2])};
}

std::span<const Palette> palettes() {
    return known;
}

const Palette& diverging_palette() {
    return diverging;
}

Result<const Palette*> find_palette(std::string_view name) {
    if (name == "grey") name = "gray";
    return find_named("palette", name, known);
}

} // namespace gonio
