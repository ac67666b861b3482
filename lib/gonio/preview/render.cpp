#include <gonio/base/amount_range.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/base/picture_size.hpp>
#include <gonio/preview/detail/lit_tile.hpp>
#include <gonio/preview/detail/render_check.hpp>
#include <gonio/preview/kernels_camera.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/transport/interreflection.hpp>
#include <gonio/transport/named_surroundings.hpp>
#include <gonio/transport/sky_light.hpp>

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace gonio {

Result<void> detail::check_rendering(std::span<const Light> lights, const RenderOptions& options) {
    if (Result<void> fits = check_picture_size(options.width, options.height); !fits) return fits;
    for (const Light& light : lights) {
        const glm::dvec3& at = light.frame.origin;
        if (!in_amount_range(at.x) || !in_amount_range(at.y) || !in_amount_range(at.z))
            return fail("USE0106", fmt::format("the position of '{}' is out of range", light.name),
                        fmt::format("coordinates of a picture reach to {} m", greatest_amount));
        if (!std::isfinite(light.luminance.value) || !std::isfinite(light.intensity.value))
            return fail("USE0106", fmt::format("the luminance of '{}' is infinite", light.name),
                        "its amount is too large for its size");
    }
    return {};
}

void RenderStats::add(const RenderStats& other) {
    samples += other.samples;
    samples_without_specular += other.samples_without_specular;
    pairs += other.pairs;
    pairs_lit += other.pairs_lit;
    evaluations += other.evaluations;
    evaluated += other.evaluated;
    from_center += other.from_center;
    as_point += other.as_point;
    outside_cone += other.outside_cone;
    below_horizon += other.below_horizon;
    in_shadow += other.in_shadow;
    at_shadow_edges += other.at_shadow_edges;
    not_converged += other.not_converged;
    shadow_tests += other.shadow_tests;
    shadow_tested += other.shadow_tested;
    in_penumbra += other.in_penumbra;
}

Result<Rendering> render(const Stage& stage, std::span<const Light> lights, const Camera& camera,
                         const RenderOptions& options) {
    if (Result<void> checked = detail::check_rendering(lights, options); !checked) return pass_on(checked);
    Rendering picture;
    picture.luminance_nt = Image(options.width, options.height, 3);
    picture.shows_light.resize(picture.luminance_nt.pixels.size() / 3);
    picture.shows_subject.resize(picture.shows_light.size());
    if (options.illuminance) picture.illuminance_lx = Image(options.width, options.height, 1);
    // A single surface is convex: nothing that it reflects meets it again.
    std::shared_ptr<Interreflection> bounced;
    if (options.bounces > 0 && (stage.surfaces.size() > 1 || !options.sky.is_dark())) {
        Result<Interreflection> indirect = Interreflection::of(stage, lights, options, {}, options.known.get());
        if (!indirect) return pass_on(indirect);
        bounced = std::make_shared<Interreflection>(std::move(*indirect));
        picture.indirect = bounced;
    }
    detail::LitScene scene(stage, lights, options,
                           options.known != nullptr ? options.known->reflectances()
                                                    : detail::SurroundingsReflectances());
    if (bounced) bounced->keep(scene.surroundings);
    const std::shared_ptr<const detail::SkyLight> sky =
        detail::SkyLight::on(stage, lights, options, picture.indirect.get());
    scene.sky = sky.get();
    const std::shared_ptr<const detail::NamedSurroundings> named =
        detail::NamedSurroundings::of(options, scene.core_materials);
    scene.named = named.get();
    const CameraRays rays(camera, options.width, options.height);
    const detail::LightTree no_bodies({});
    const EmittedLights no_emitted;
    const detail::RayScene ray_scene{stage,
                                     scene.all_lights,
                                     rays,
                                     options.shows_lights ? scene.bodies : no_bodies,
                                     options.shows_lights ? scene.emitted : no_emitted,
                                     options.width,
                                     options.height,
                                     preview::camera_kernels(options.instruction_set)};
    const int across = (options.width + detail::tile_size - 1) / detail::tile_size;
    const int down = (options.height + detail::tile_size - 1) / detail::tile_size;
    const std::size_t tiles = static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
    std::vector<RenderStats> of_tiles(tiles);
    std::vector<std::vector<PartialLight>> partial(tiles);
    parallel_for(tiles, options.threads, [&](std::size_t tile) {
        const int index = static_cast<int>(tile);
        detail::LitTile(scene, options, ray_scene, index % across * detail::tile_size,
                        index / across * detail::tile_size, picture, of_tiles[tile], partial[tile])
            .light_up();
    });
    for (const std::vector<PartialLight>& of_tile : partial)
        picture.partial_lights.insert(picture.partial_lights.end(), of_tile.begin(), of_tile.end());
    std::stable_sort(picture.partial_lights.begin(), picture.partial_lights.end(),
                     [](const PartialLight& a, const PartialLight& b) { return a.pixel < b.pixel; });
    RenderStats& stats = picture.stats;
    for (const RenderStats& of_tile : of_tiles)
        stats.add(of_tile);
    stats.lights = lights.size();
    stats.tiles = tiles;
    for (const detail::LitLight& light : scene.lights) {
        if (light.is_dark) ++stats.dark_lights;
        if (light.pattern && light.pattern->has_axial_web()) ++stats.axial_webs;
    }
    if (options.skip) stats.dark = stats.dark_lights * stats.samples;
    stats.out_of_range =
        stats.evaluations - stats.evaluated - stats.outside_cone - stats.below_horizon - stats.in_shadow - stats.dark;
    return picture;
}

} // namespace gonio
