#include <gonio/plot/palette.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace gonio {

namespace {

struct Rgb {
    int r, g, b;
};

constexpr std::array series{Rgb{0x00, 0x72, 0xb2}, Rgb{0xd5, 0x5e, 0x00}, Rgb{0x00, 0x9e, 0x73}, Rgb{0xcc, 0x79, 0xa7},
                            Rgb{0xe6, 0x9f, 0x00}, Rgb{0x56, 0xb4, 0xe9}, Rgb{0x00, 0x00, 0x00}};

constexpr std::array ramp{Rgb{0x44, 0x01, 0x54}, Rgb{0x47, 0x2d, 0x7b}, Rgb{0x3b, 0x52, 0x8b},
                          Rgb{0x2c, 0x72, 0x8e}, Rgb{0x21, 0x91, 0x8c}, Rgb{0x28, 0xae, 0x80},
                          Rgb{0x5e, 0xc9, 0x62}, Rgb{0xad, 0xdc, 0x30}, Rgb{0xfd, 0xe7, 0x25}};

std::string hex(int r, int g, int b) {
    return fmt::format("#{:02x}{:02x}{:02x}", r, g, b);
}

int mix(int from, int to, double weight) {
    return static_cast<int>(std::lround(from + weight * (to - from)));
}

} // namespace

std::string series_color(std::size_t index) {
    const Rgb& color = series[index % series.size()];
    return hex(color.r, color.g, color.b);
}

std::string ramp_color(double value) {
    const double clamped = value > 0.0 ? std::fmin(value, 1.0) : 0.0;
    const double at = clamped * static_cast<double>(ramp.size() - 1);
    const std::size_t lower = std::min(static_cast<std::size_t>(at), ramp.size() - 2);
    const double weight = at - static_cast<double>(lower);
    const Rgb& from = ramp[lower];
    const Rgb& to = ramp[lower + 1];
    return hex(mix(from.r, to.r, weight), mix(from.g, to.g, weight), mix(from.b, to.b, weight));
}

} // namespace gonio
