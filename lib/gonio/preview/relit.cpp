#include <gonio/preview/relit.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gonio {

namespace {

// Amounts are computed from what was asked for, which leaves a few roundings between factors that are the same.
constexpr double same = 1e-12;

bool are_same(double a, double b) {
    return std::abs(a - b) <= same * std::max(std::abs(a), std::abs(b));
}

// The amount of a light that its shape has: one of them.
double amount(const Light& light) {
    if (light.luminance.value != 0.0) return light.luminance.value;
    return light.intensity.value;
}

struct Factors {
    double amount = 1.0;
    glm::dvec3 rgb{1.0};
};

std::optional<Factors> of_light(const Light& before, const Light& now) {
    Factors factors;
    if (!(amount(before) > 0.0)) return std::nullopt;
    factors.amount = amount(now) / amount(before);
    for (int channel = 0; channel < 3; ++channel) {
        if (before.color[channel] == 0.0 && now.color[channel] == 0.0)
            factors.rgb[channel] = factors.amount;
        else if (before.color[channel] == 0.0)
            return std::nullopt;
        else
            factors.rgb[channel] = factors.amount * (now.color[channel] / before.color[channel]);
        if (!std::isfinite(factors.rgb[channel])) return std::nullopt;
    }
    return factors;
}

void multiply(double factor, float& value) {
    value = static_cast<float>(factor * static_cast<double>(value));
}

} // namespace

std::optional<Rendering> relit(const Rendering& picture, std::span<const Light> before, std::span<const Light> now) {
    if (before.size() != now.size() || before.empty()) return std::nullopt;
    std::optional<Factors> all;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const std::optional<Factors> one = of_light(before[i], now[i]);
        if (!one) return std::nullopt;
        if (!all) all = one;
        if (!are_same(one->amount, all->amount)) return std::nullopt;
        for (int channel = 0; channel < 3; ++channel)
            if (!are_same(one->rgb[channel], all->rgb[channel])) return std::nullopt;
    }
    const bool same_color =
        are_same(all->rgb.x, all->amount) && are_same(all->rgb.y, all->amount) && are_same(all->rgb.z, all->amount);
    if (!same_color && picture.indirect != nullptr && !picture.illuminance_lx.pixels.empty()) return std::nullopt;
    Rendering result = picture;
    result.indirect = nullptr;
    for (std::size_t i = 0; i < result.luminance_nt.pixels.size(); ++i)
        multiply(all->rgb[static_cast<int>(i % 3)], result.luminance_nt.pixels[i]);
    for (float& lux : result.illuminance_lx.pixels)
        multiply(all->amount, lux);
    for (PartialLight& light : result.partial_lights)
        for (std::size_t channel = 0; channel < 3; ++channel)
            multiply(all->rgb[static_cast<int>(channel)], light.rgb[channel]);
    return result;
}

} // namespace gonio
