#include <gonio/color/rgb_space.hpp>
#include <gonio/preview/exposure.hpp>
#include <gonio/preview/partial_light.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace gonio {

namespace {

using Run = std::span<const PartialLight>;

// Calls use(run) for the lights of each pixel.
template<class Use>
void for_each_pixel(std::span<const PartialLight> lights, const Use& use) {
    while (!lights.empty()) {
        const auto end = std::find_if(lights.begin(), lights.end(),
                                      [&](const PartialLight& light) { return light.pixel != lights.front().pixel; });
        const auto count = static_cast<std::size_t>(end - lights.begin());
        use(lights.first(count));
        lights = lights.subspan(count);
    }
}

// Of the pixel, without its lights.
float share_left(Run run) {
    float left = 1.0F;
    for (const PartialLight& light : run)
        left -= light.share;
    return std::max(left, 0.0F);
}

} // namespace

void expose(std::span<PartialLight> lights, Ev100 ev) {
    const double factor = 1.0 / white_luminance(ev).value;
    for (PartialLight& light : lights)
        for (float& channel : light.rgb)
            channel = static_cast<float>(static_cast<double>(channel) * factor);
}

Image parts_of(const Image& picture, std::span<const PartialLight> lights) {
    std::vector<float> parts;
    for_each_pixel(lights, [&](Run run) {
        const float* const whole = picture.pixels.data() + std::size_t{run.front().pixel} * 3;
        const float left = share_left(run);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            float rest = whole[channel];
            for (const PartialLight& light : run)
                rest -= light.share * light.rgb[channel];
            // Where hardly anything is left, the difference is rounding.
            parts.push_back(left > 1e-3F ? std::max(rest, 0.0F) / left : 0.0F);
        }
        for (const PartialLight& light : run)
            parts.insert(parts.end(), light.rgb.begin(), light.rgb.end());
    });
    Image image;
    image.width = static_cast<int>(parts.size() / 3);
    image.height = image.width > 0 ? 1 : 0;
    image.channels = 3;
    image.pixels = std::move(parts);
    return image;
}

void merge_parts(const Image& parts, std::span<const PartialLight> lights, Image& picture) {
    const float* part = parts.pixels.data();
    for_each_pixel(lights, [&](Run run) {
        float* const whole = picture.pixels.data() + std::size_t{run.front().pixel} * 3;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const auto shown = [&](std::size_t index) {
                return decode_srgb(static_cast<double>(std::clamp(part[3 * index + channel], 0.0F, 1.0F)));
            };
            double left = 1.0;
            double sum = 0.0;
            for (std::size_t i = 0; i < run.size(); ++i) {
                const PartialLight& light = run[i];
                const float times = std::clamp(light.rgb[channel], 1.0F, light.widening);
                const double share = std::min(static_cast<double>(light.share) * static_cast<double>(times), left);
                left -= share;
                sum += share * shown(i + 1);
            }
            whole[channel] = static_cast<float>(encode_srgb(sum + left * shown(0)));
        }
        part += 3 * (run.size() + 1);
    });
}

} // namespace gonio
