#include <gonio/media/dither.hpp>

#include <cmath>
#include <cstddef>

namespace gonio::media {

std::vector<float> dithered(const Image& image, int greatest) {
    // 1/p and 1/p², where p³ = p + 1.
    constexpr double across = 0.75487766624669276005;
    constexpr double down = 0.56984029099805326591;
    constexpr double least = 1e-3; // keeps whole steps from the edge where rounding would go the other way
    std::vector<float> values(image.pixels.begin(), image.pixels.end());
    const auto channels = static_cast<std::size_t>(image.channels);
    std::size_t i = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double place = across * x + down * y;
            const double within = place - std::floor(place) - 0.5;
            const auto shift = static_cast<float>((1.0 - least) * within / greatest);
            for (std::size_t channel = 0; channel < channels; ++channel, ++i)
                values[i] += shift;
        }
    return values;
}

} // namespace gonio::media
