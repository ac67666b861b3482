#include <gonio/light/light_color.hpp>
#include <gonio/light/light_parts.hpp>
#include <gonio/light/luminaire.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

namespace gonio {

namespace {

Result<std::vector<Light>> colors_of(const Light& light, const LightImage& image) {
    std::vector<Light> parts;
    for (std::size_t c = 0; c < image.colors().size(); ++c) {
        const ImageColor& of = image.colors().at(c);
        const auto channel = static_cast<int>(c);
        const double share = of.share * light.color[channel];
        if (!(share > 0.0)) continue;
        Light part = light;
        part.parts.reset();
        part.image = of.plane;
        part.color = glm::dvec3(0.0);
        part.color[channel] = 1.0 / rec709_luminance[channel];
        part.intensity = light.intensity * share;
        part.luminance = light.luminance * share;
        parts.push_back(std::move(part));
    }
    if (light.color == glm::dvec3(1.0)) return parts; // their flux is that of the light already
    if (parts.empty())
        return fail(Failure::usage, "the colour of the light and its image have nothing in common: no light passes",
                    "leave the colour of the light out");
    const ImageSolidAngles::Values& solid_angles = light.image_solid_angles->of(light.shape, image);
    double flux_over_intensity = 0.0; // of the parts, over the intensity of the whole light
    for (std::size_t c = 0; c < image.colors().size(); ++c)
        flux_over_intensity +=
            image.colors().at(c).share * light.color[static_cast<int>(c)] * solid_angles.color_sr.at(c);
    const double factor = solid_angles.luminance_sr / flux_over_intensity;
    for (Light& part : parts) {
        part.intensity = part.intensity * factor;
        part.luminance = part.luminance * factor;
    }
    return parts;
}

} // namespace

const ImageSolidAngles::Values& ImageSolidAngles::of(const Shape& shape, const LightImage& image) const {
    std::call_once(once_, [&] {
        values_.luminance_sr = image_solid_angle(shape, *image.luminance()).value;
        for (std::size_t c = 0; c < image.colors().size(); ++c)
            if (const ImagePlane* const plane = image.colors().at(c).plane.get())
                values_.color_sr.at(c) = image_solid_angle(shape, *plane).value;
    });
    return values_;
}

Result<void> place_parts(Light& light) {
    light.parts.reset();
    if (light.body != nullptr) {
        light.parts = std::make_shared<const std::vector<Light>>(faces_of(light));
        return {};
    }
    const LightImage* const image = mask_of(light.shape).image;
    if (image == nullptr || !image->is_colored()) return {};
    if (light.image_solid_angles == nullptr) light.image_solid_angles = std::make_shared<const ImageSolidAngles>();
    Result<std::vector<Light>> colors = colors_of(light, *image);
    if (!colors) return pass_on(colors);
    light.parts = std::make_shared<const std::vector<Light>>(std::move(*colors));
    return {};
}

glm::dvec3 shown_luminance(std::span<const Light> lights, std::size_t index, const glm::dvec3& viewer,
                           const glm::dvec3& toward) {
    const auto shown = [&](const Light& light) {
        return light.luminance_share_at(viewer, toward) * light.luminance.value * light.color;
    };
    const Light& first = lights[index];
    glm::dvec3 sum = shown(first);
    const LightImage* const image = mask_of(first.shape).image;
    if (image == nullptr || !image->is_colored()) return sum;
    for (std::size_t i = index + 1; i < lights.size(); ++i) {
        const Light& light = lights[i];
        if (mask_of(light.shape).image != image || light.frame.origin != first.frame.origin ||
            light.image == first.image)
            break;
        sum += shown(light);
    }
    return sum;
}

ShiningLights::ShiningLights(std::span<const Light> lights, bool faces) : lights_(lights) {
    const auto is_replaced = [&](const Light& light) {
        return light.parts != nullptr && (faces || light.body == nullptr);
    };
    has_parts_ = std::any_of(lights.begin(), lights.end(), is_replaced);
    if (!has_parts_) return;
    for (const Light& light : lights) {
        if (is_replaced(light))
            parts_.insert(parts_.end(), light.parts->begin(), light.parts->end());
        else
            parts_.push_back(light);
    }
}

} // namespace gonio
