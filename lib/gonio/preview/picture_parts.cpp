#include <gonio/preview/picture_parts.hpp>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace gonio {

namespace {

Light darkened(Light light) {
    light.color = glm::dvec3(0.0);
    light.intensity = Candelas();
    light.luminance = Nits();
    light.illuminance = Lux();
    light.web_scale = 0.0;
    return light;
}

std::vector<Light> all_dark(std::span<const Light> lights) {
    std::vector<Light> dark;
    dark.reserve(lights.size());
    for (const Light& light : lights)
        dark.push_back(darkened(light));
    return dark;
}

Image minus(Image from, const Image& what) {
    std::transform(from.pixels.begin(), from.pixels.end(), what.pixels.begin(), from.pixels.begin(), std::minus<>());
    return from;
}

} // namespace

Result<Rendering> render_unlit(const Stage& stage, std::span<const Light> lights, const Camera& camera,
                               const RenderOptions& options) {
    return render(stage, all_dark(lights), camera, options);
}

Result<void> render_each_light(const Stage& stage, std::span<const Light> lights, const Camera& camera,
                               const RenderOptions& options, const Rendering& unlit,
                               const std::function<Result<void>(std::size_t light, Rendering share)>& use) {
    std::vector<Light> one_lit = all_dark(lights);
    RenderOptions again = options;
    again.known = unlit.indirect;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        Light dark = std::exchange(one_lit[i], lights[i]);
        Result<Rendering> share = render(stage, one_lit, camera, again);
        if (!share) return pass_on(share);
        one_lit[i] = std::move(dark);
        share->luminance_nt = minus(std::move(share->luminance_nt), unlit.luminance_nt);
        share->illuminance_lx = minus(std::move(share->illuminance_lx), unlit.illuminance_lx);
        if (Result<void> used = use(i, std::move(*share)); !used) return used;
    }
    return {};
}

Result<PictureParts> picture_parts(const Image& picture, Stage stage, std::span<const Light> lights,
                                   const Camera& camera, const RenderOptions& options) {
    RenderOptions luminance_only = options;
    luminance_only.illuminance = false;
    luminance_only.specular = false;
    Result<Rendering> diffuse = render(stage, lights, camera, luminance_only);
    if (!diffuse) return pass_on(diffuse);
    luminance_only.bounces = 0; // a black stage reflects nothing
    for (Surface& surface : stage.surfaces)
        surface.material = LambertMaterial{glm::dvec3(0.0)};
    Result<Rendering> emission = render(stage, lights, camera, luminance_only);
    if (!emission) return pass_on(emission);
    PictureParts parts;
    parts.specular_nt = minus(picture, diffuse->luminance_nt);
    parts.diffuse_nt = minus(std::move(diffuse->luminance_nt), emission->luminance_nt);
    parts.emission_nt = std::move(emission->luminance_nt);
    return parts;
}

} // namespace gonio
