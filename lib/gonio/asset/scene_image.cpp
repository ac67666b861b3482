#include <gonio/asset/detail/scene_image.hpp>
#include <gonio/light/light_image.hpp>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <variant>

namespace gonio::asset_detail {

namespace {

constexpr int most_texels = 2048; // a side

// Lights of one colour each: the light itself, or the colours of its image.
std::span<const Light> colors_of(const Light& light) {
    return light.parts != nullptr ? std::span<const Light>(*light.parts) : std::span(&light, 1);
}

template<class Value>
Image picture(int width, int height, double peak, const Value& value) {
    Image made(width, height, 3);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const glm::dvec3 rgb = value(column, row) / peak;
            for (int channel = 0; channel < 3; ++channel)
                made.at(column, row)[channel] = static_cast<float>(rgb[channel]);
        }
    return made;
}

// On the plane one metre before the light, along the finer side.
double texels_per_meter_of(const Projection& projection) {
    return std::max(0.5 * projection.width / projection.slopes.x, 0.5 * projection.height / projection.slopes.y);
}

} // namespace

SceneImage scene_image(const Light& light, std::string name) {
    SceneImage image{std::move(name), std::make_shared<const Light>(light)};
    const bool is_panel = std::holds_alternative<RectShape>(light.shape);
    for (const Light& color : colors_of(light)) {
        const double amount = is_panel ? color.luminance.value : color.intensity.value;
        image.peak = std::max({image.peak, amount * color.color.x, amount * color.color.y, amount * color.color.z});
    }
    image.width = light.image->width();
    image.height = light.image->height();
    const glm::dvec2 covered = covered_by_image(light.shape);
    image.slope_x = covered.x;
    image.slope_y = covered.y;
    return image;
}

Projection projection_of(const SceneImage& image) {
    constexpr int least = 512;
    const int longer = std::max(image.width, image.height);
    // Whole numbers of texels for a pixel keep the pixels' centres where they are looked up.
    const int times = std::max((least + longer - 1) / longer, 1);
    const double shrunk = std::min(static_cast<double>(most_texels) / (static_cast<double>(times) * longer), 1.0);
    const auto side = [&](int pixels) {
        return std::max(static_cast<int>(std::lround(shrunk * times * static_cast<double>(pixels))), 1);
    };
    return {{image.slope_x, image.slope_y}, side(image.width), side(image.height)};
}

Projection square_texels(const SceneImage& image, int least) {
    const double shorter = std::min(image.slope_x, image.slope_y);
    const double longer = std::max(image.slope_x, image.slope_y);
    const double texels_per_meter =
        std::clamp(texels_per_meter_of(projection_of(image)), 0.5 * least / longer, 0.5 * most_texels / longer);
    const int across = std::max(static_cast<int>(std::lround(2.0 * shorter * texels_per_meter)), 1);
    const int along = static_cast<int>(std::ceil(across * longer / shorter - 1e-9));
    const double covered = shorter * along / across;
    if (image.slope_x < image.slope_y) return {{shorter, covered}, across, along};
    return {{covered, shorter}, along, across};
}

double cone_of(const SceneImage& image) {
    // A little wider, so that the edge of a cone does not darken the corners.
    constexpr double beyond = 1.02;
    return std::atan(beyond * std::hypot(image.slope_x, image.slope_y));
}

Projection square_around_cone(const SceneImage& image, double cone_rad) {
    const double slope = std::tan(cone_rad);
    const double texels = 2.0 * slope * texels_per_meter_of(projection_of(image));
    const int side = static_cast<int>(std::ceil(std::min(texels, static_cast<double>(most_texels))));
    return {{slope, slope}, side, side};
}

Image projected_picture(const SceneImage& image, const Projection& projection) {
    const Light& light = *image.light;
    const std::span<const Light> colors = colors_of(light);
    // Means over texels that are larger than the image's pixels.
    const glm::dvec2 texel = 2.0 * projection.slopes / glm::dvec2(projection.width, projection.height);
    const glm::dvec2 pixel = 2.0 * glm::dvec2(image.slope_x, image.slope_y) / glm::dvec2(image.width, image.height);
    constexpr double most_samples = 8.0;
    const glm::ivec2 samples(glm::clamp(glm::ceil(texel / pixel - 1e-6), 1.0, most_samples));
    return picture(projection.width, projection.height, image.peak, [&](int column, int row) {
        glm::dvec3 sum(0.0);
        for (int j = 0; j < samples.y; ++j)
            for (int i = 0; i < samples.x; ++i) {
                const double x = (column + (i + 0.5) / samples.x) * texel.x - projection.slopes.x;
                const double y = projection.slopes.y - (row + (j + 0.5) / samples.y) * texel.y;
                const glm::dvec3 direction = light.frame.to_world({x, y, -1.0});
                for (const Light& color : colors)
                    sum += color.intensity_towards(direction).value * color.color;
            }
        return sum / static_cast<double>(samples.x * samples.y);
    });
}

Image panel_picture(const SceneImage& image) {
    const std::span<const Light> colors = colors_of(*image.light);
    const glm::dvec2 size(image.width, image.height);
    return picture(image.width, image.height, image.peak, [&](int column, int row) {
        glm::dvec3 sum(0.0);
        for (const Light& color : colors)
            sum += color.luminance.value * color.image->pixel(glm::dvec2(column + 0.5, row + 0.5) / size) * color.color;
        return sum;
    });
}

} // namespace gonio::asset_detail
