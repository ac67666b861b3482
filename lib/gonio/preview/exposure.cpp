#include <gonio/light/light_color.hpp>
#include <gonio/preview/exposure.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace gonio {

namespace {

// One in so many pixels of an automatic exposure is white, at most and at least.
constexpr std::size_t most_white = 40;
constexpr std::size_t least_white = 200;

} // namespace

Nits white_luminance(Ev100 ev) {
    return Nits(1.2 * std::exp2(ev.value));
}

Ev100 auto_exposure(const Image& rgb_nits, std::span<const std::uint8_t> left_out) {
    std::vector<double> luminances;
    luminances.reserve(rgb_nits.pixels.size() / 3);
    for (std::size_t i = 0; i + 2 < rgb_nits.pixels.size(); i += 3) {
        if (!left_out.empty() && left_out[i / 3] != 0) continue;
        const glm::dvec3 rgb(rgb_nits.pixels[i], rgb_nits.pixels[i + 1], rgb_nits.pixels[i + 2]);
        const double y = glm::dot(rgb, rec709_luminance);
        if (y > 0.0) luminances.push_back(y);
    }
    if (luminances.empty()) return left_out.empty() ? Ev100(0.0) : auto_exposure(rgb_nits);
    double logarithms = 0.0;
    for (const double y : luminances)
        logarithms += std::log(y);
    const double mean = std::exp(logarithms / static_cast<double>(luminances.size()));
    const auto above = [&](std::size_t share) { // which one in `share` pixels is above
        const std::size_t rank = (luminances.size() - 1) * (share - 1) / share;
        std::nth_element(luminances.begin(), luminances.begin() + static_cast<std::ptrdiff_t>(rank), luminances.end());
        return luminances[rank];
    };
    constexpr double middle_grey = 0.18;
    return Ev100(std::log2(std::clamp(mean / middle_grey, above(most_white), above(least_white)) / 1.2));
}

Ev100 exposure_of_card(Lux on_card) {
    return Ev100(std::log2(on_card.value / (1.2 * std::numbers::pi)));
}

Lux card_illuminance(Ev100 ev) {
    return Lux(std::numbers::pi * white_luminance(ev).value);
}

void expose(Image& image, Ev100 ev) {
    const double factor = 1.0 / white_luminance(ev).value;
    const auto scale = static_cast<float>(factor);
    if (std::isfinite(scale)) {
        for (float& value : image.pixels)
            value *= scale;
        return;
    }
    for (float& value : image.pixels) // almost no light: black stays black
        value = static_cast<float>(static_cast<double>(value) * factor);
}

} // namespace gonio
