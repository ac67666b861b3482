#include <gonio/light/light_change.hpp>
#include <gonio/preview/relit.hpp>

#include <cstddef>

namespace gonio {

namespace {

void multiply(double factor, float& value) {
    value = static_cast<float>(factor * static_cast<double>(value));
}

} // namespace

std::optional<Rendering> relit(const Rendering& picture, std::span<const Light> before, std::span<const Light> now) {
    const std::optional<LightChange> all = common_change(before, now);
    if (!all) return std::nullopt;
    if (all->is_of_color() && picture.indirect != nullptr && !picture.illuminance_lx.pixels.empty())
        return std::nullopt;
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
