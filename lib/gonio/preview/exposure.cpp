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
constexpr double most_white = 40.0;
constexpr double least_white = 200.0;

// Of the weight of all lit pixels.
constexpr double least_share_of_subject = 0.5;

} // namespace

Nits white_luminance(Ev100 ev) {
    return Nits(1.2 * std::exp2(ev.value));
}

Ev100 auto_exposure(const Image& rgb_nits, std::span<const std::uint8_t> left_out,
                    std::span<const std::uint8_t> subject) {
    struct Metered {
        double luminance;
        bool is_subject;
    };
    std::vector<Metered> pixels;
    pixels.reserve(rgb_nits.pixels.size() / 3);
    for (std::size_t i = 0; i + 2 < rgb_nits.pixels.size(); i += 3) {
        if (!left_out.empty() && left_out[i / 3] != 0) continue;
        const glm::dvec3 rgb(rgb_nits.pixels[i], rgb_nits.pixels[i + 1], rgb_nits.pixels[i + 2]);
        const double y = glm::dot(rgb, rec709_luminance);
        if (y > 0.0) pixels.push_back({y, !subject.empty() && subject[i / 3] != 0});
    }
    if (pixels.empty()) return left_out.empty() ? Ev100(0.0) : auto_exposure(rgb_nits);
    const auto all = static_cast<double>(pixels.size());
    const auto of_subject = static_cast<double>(
        std::count_if(pixels.begin(), pixels.end(), [](const Metered& pixel) { return pixel.is_subject; }));
    // The weights of all pixels add up to their number.
    const bool is_small = of_subject > 0.0 && of_subject < least_share_of_subject * all;
    const double subject_weight = is_small ? least_share_of_subject * all / of_subject : 1.0;
    const double other_weight = is_small ? (1.0 - least_share_of_subject) * all / (all - of_subject) : 1.0;
    const auto weight = [&](const Metered& pixel) { return pixel.is_subject ? subject_weight : other_weight; };
    double logarithms = 0.0;
    for (const Metered& pixel : pixels)
        logarithms += weight(pixel) * std::log(pixel.luminance);
    const double mean = std::exp(logarithms / all);
    std::sort(pixels.begin(), pixels.end(),
              [](const Metered& a, const Metered& b) { return a.luminance < b.luminance; });
    const auto above = [&](double share) { // which one in `share` of the weight is above
        const double below = (all - 1.0) * (share - 1.0) / share;
        double sum = 0.0;
        for (const Metered& pixel : pixels) {
            sum += weight(pixel);
            if (sum > below) return pixel.luminance;
        }
        return pixels.back().luminance;
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
