#include <gonio/base/named.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/plot/look.hpp>
#include <gonio/scene/emitter.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace gonio {

namespace {

constexpr std::array known{
    LookName{Look::beauty, "beauty", "as a camera shows it: exposed, through the display transform"},
    LookName{Look::false_color, "falsecolour", "lux or nits in false colour, with a legend"},
    LookName{Look::isolux, "isolux", "lines of equal lux or nits over the dimmed picture"},
    LookName{Look::luminance, "luminance", "the luminance as a grey picture, with a legend in nits"},
};
static_assert(in_enum_order(known, &LookName::look, Look::luminance));

constexpr std::int32_t nothing_seen = -1;
constexpr std::int32_t outline_seen = -2;

} // namespace

std::span<const LookName> looks() {
    return known;
}

Result<Look> parse_look(std::string_view name) {
    for (const std::string_view other : {"falsecolor", "false-colour", "false-color"})
        if (name == other) name = "falsecolour";
    return find_named("look", name, known).map([](const LookName* look) { return look->look; });
}

std::string_view to_text(Look look) {
    return known[static_cast<std::size_t>(look)].name;
}

std::string_view to_text(PictureQuantity quantity) {
    return quantity == PictureQuantity::illuminance ? "illuminance" : "luminance";
}

Image quantity_image(const Rendering& rendering, PictureQuantity quantity) {
    if (quantity == PictureQuantity::illuminance) return rendering.illuminance_lx;
    const Image& rgb = rendering.luminance_nt;
    Image values(rgb.width, rgb.height, 1);
    for (std::size_t i = 0; i < values.pixels.size(); ++i) {
        const float* const pixel = rgb.pixels.data() + 3 * i;
        values.pixels[i] = static_cast<float>(glm::dot(glm::dvec3(pixel[0], pixel[1], pixel[2]), rec709_luminance));
    }
    return values;
}

Image false_color(const Image& values, const ValueScale& scale, const Palette& palette) {
    Image image(values.width, values.height, 3);
    for (std::size_t i = 0; i < values.pixels.size(); ++i) {
        const std::array<float, 3> color = palette.at(scale.share(static_cast<double>(values.pixels[i])));
        std::copy(color.begin(), color.end(), image.pixels.begin() + static_cast<std::ptrdiff_t>(3 * i));
    }
    return image;
}

std::vector<std::int32_t> seen_surfaces(const Stage& stage, std::span<const Light> lights, const Camera& camera,
                                        int width, int height, unsigned threads) {
    const CameraRays rays(camera, width, height);
    const auto columns = static_cast<std::size_t>(width);
    std::vector<std::int32_t> seen(columns * static_cast<std::size_t>(height), nothing_seen);
    parallel_for(static_cast<std::size_t>(height), threads, [&](std::size_t row) {
        for (std::size_t column = 0; column < columns; ++column) {
            const Ray ray = rays.ray(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
            std::int32_t& what = seen[row * columns + column];
            double nearest = 0.0;
            if (const auto hit = first_hit(stage, ray)) {
                what = static_cast<std::int32_t>(hit->surface);
                nearest = hit->distance;
            }
            for (std::size_t i = 0; i < lights.size(); ++i) {
                if (lights[i].emitted_by) continue; // its surface
                const auto distance = distance_to(lights[i], ray);
                if (!distance || (what != nothing_seen && *distance >= nearest)) continue;
                what = static_cast<std::int32_t>(stage.surfaces.size() + i);
                nearest = *distance;
            }
        }
    });
    std::vector<std::int32_t> marked = seen;
    for (std::size_t row = 0; row < static_cast<std::size_t>(height); ++row)
        for (std::size_t column = 0; column < columns; ++column) {
            const std::size_t i = row * columns + column;
            const bool alone = (column > 0 && seen[i - 1] != seen[i]) ||
                               (column + 1 < columns && seen[i + 1] != seen[i]) ||
                               (row > 0 && seen[i - columns] != seen[i]) ||
                               (row + 1 < static_cast<std::size_t>(height) && seen[i + columns] != seen[i]);
            if (alone) marked[i] = outline_seen;
        }
    return marked;
}

} // namespace gonio
