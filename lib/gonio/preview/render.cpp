#include <gonio/base/parallel.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/preview/shading_constants.hpp>
#include <gonio/scene/emitter.hpp>
#include <gonio/scene/occlusion.hpp>
#include <gonio/scene/reference.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace gonio {

namespace {

constexpr int tile_size = 32;
constexpr int edge_samples = 4; // along each side of a pixel on an outline

// What a camera ray ended on.
struct Seen {
    enum class What : std::uint8_t { nothing, emitter, surface };

    What what = What::nothing;
    Hit hit;
    glm::dvec3 view{0.0}; // unit, towards the eye
    double visible = 1.0; // share of the light that is not occluded
};

// Points on one surface, in the arrays that the kernels read.
struct Batch {
    std::array<std::vector<float>, 3> position;
    std::array<std::vector<float>, 3> normal;
    std::array<std::vector<float>, 3> view;
    std::vector<float> intensity_cd;
    std::vector<float> weight; // share of the pixel × visible share of the light
    std::vector<std::uint32_t> pixel;
    std::array<std::vector<float>, 3> rgb; // results
};

class Renderer {
public:
    Renderer(const Stage& stage, const Light& light, const Camera& camera, const RenderOptions& options)
        : stage_(stage),
          light_(light),
          options_(options),
          rays_(camera, options.width, options.height),
          kernels_(shading::kernels(options.instruction_set)),
          light_constants_(light_constants(light)),
          shadow_radius_(shadow_radius(light)),
          is_punctual_(light_constants_.kind == shading::LightConstants::Kind::punctual) {
        for (const Surface& surface : stage.surfaces)
            materials_.push_back(material_constants(surface.material));
    }

    void render_tile(Rendering& image, int left, int top) const {
        const int right = std::min(left + tile_size, options_.width);
        const int bottom = std::min(top + tile_size, options_.height);
        // One pixel more on each side shows which pixels of the tile lie on an outline.
        const int stride = right - left + 2;
        std::vector<Seen> centers;
        centers.reserve(static_cast<std::size_t>(stride) * static_cast<std::size_t>(bottom - top + 2));
        for (int y = top - 1; y <= bottom; ++y)
            for (int x = left - 1; x <= right; ++x)
                centers.push_back(look(x + 0.5, y + 0.5));

        std::vector<Batch> batches(stage_.surfaces.size());
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) {
                const Seen* const center =
                    &centers[static_cast<std::size_t>(y - top + 1) * static_cast<std::size_t>(stride) +
                             static_cast<std::size_t>(x - left + 1)];
                const bool on_outline = differ(center[0], center[-1]) || differ(center[0], center[1]) ||
                                        differ(center[0], center[-stride]) || differ(center[0], center[stride]);
                if (!on_outline)
                    add(image, batches, x, y, *center, 1.0);
                else
                    add_subsamples(image, batches, x, y);
            }
        for (std::size_t surface = 0; surface < batches.size(); ++surface)
            shade(image, batches[surface], materials_[surface]);
    }

private:
    Seen look(double x, double y) const {
        const Ray ray = rays_.ray(x, y);
        Seen seen;
        seen.view = -ray.direction;
        const std::optional<Hit> hit = first_hit(stage_, ray);
        if (!is_punctual_) {
            const std::optional<double> distance = distance_to(light_, ray);
            if (distance && (!hit || *distance < hit->distance)) {
                seen.what = Seen::What::emitter;
                return seen;
            }
        }
        if (!hit) return seen;
        seen.what = Seen::What::surface;
        seen.hit = *hit;
        if (options_.shadows)
            seen.visible = visible_share(stage_, hit->surface, hit->position, light_.frame.origin, shadow_radius_);
        return seen;
    }

    // Soft shadows are smooth; only a jump from lit to dark between neighbours needs more samples.
    static bool differ(const Seen& a, const Seen& b) {
        if (a.what != b.what) return true;
        return a.what == Seen::What::surface &&
               (a.hit.surface != b.hit.surface || a.hit.face != b.hit.face || std::abs(a.visible - b.visible) > 0.5);
    }

    void add_subsamples(Rendering& image, std::vector<Batch>& batches, int x, int y) const {
        for (int j = 0; j < edge_samples; ++j)
            for (int i = 0; i < edge_samples; ++i)
                add(image, batches, x, y, look(x + (i + 0.5) / edge_samples, y + (j + 0.5) / edge_samples),
                    1.0 / (edge_samples * edge_samples));
    }

    void add(Rendering& image, std::vector<Batch>& batches, int x, int y, const Seen& seen, double share) const {
        if (seen.what == Seen::What::emitter) {
            for (int channel = 0; channel < 3; ++channel)
                image.luminance_nt.at(x, y)[channel] +=
                    static_cast<float>(share * light_.luminance.value * light_.color[channel]);
        }
        if (seen.what != Seen::What::surface || seen.visible <= 0.0) return;
        Batch& batch = batches[seen.hit.surface];
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            batch.position[a].push_back(static_cast<float>(seen.hit.position[axis]));
            batch.normal[a].push_back(static_cast<float>(seen.hit.normal[axis]));
            batch.view[a].push_back(static_cast<float>(seen.view[axis]));
        }
        if (is_punctual_) {
            const double cd = light_.intensity_towards(seen.hit.position - light_.frame.origin).value;
            batch.intensity_cd.push_back(static_cast<float>(std::max(cd, 0.0)));
        }
        batch.weight.push_back(static_cast<float>(share * seen.visible));
        batch.pixel.push_back(static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(options_.width) +
                              static_cast<std::uint32_t>(x));
    }

    void shade(Rendering& image, Batch& batch, const shading::MaterialConstants& material) const {
        const std::size_t count = batch.pixel.size();
        if (count == 0) return;
        shading::Surfaces surfaces;
        std::array<float*, 3> rgb{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            surfaces.position[axis] = batch.position[axis].data();
            surfaces.normal[axis] = batch.normal[axis].data();
            surfaces.view[axis] = batch.view[axis].data();
            batch.rgb[axis].resize(count);
            rgb[axis] = batch.rgb[axis].data();
        }
        surfaces.count = count;
        shading::LightConstants light = light_constants_;
        light.intensity_cd = batch.intensity_cd.data();
        kernels_.shade(surfaces, light, material, rgb.data());
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t channel = 0; channel < 3; ++channel)
                image.luminance_nt.pixels[std::size_t{batch.pixel[i]} * 3 + channel] +=
                    batch.weight[i] * rgb[channel][i];
        if (!options_.illuminance) return;
        kernels_.irradiance(surfaces, light, batch.rgb[0].data());
        const float luminance_nt = is_punctual_ ? 1.0F : static_cast<float>(light_.luminance.value);
        for (std::size_t i = 0; i < count; ++i)
            image.illuminance_lx.pixels[batch.pixel[i]] += batch.weight[i] * luminance_nt * batch.rgb[0][i];
    }

    const Stage& stage_;
    const Light& light_;
    const RenderOptions& options_;
    CameraRays rays_;
    const shading::Kernels& kernels_;
    shading::LightConstants light_constants_;
    std::vector<shading::MaterialConstants> materials_;
    double shadow_radius_;
    bool is_punctual_;
};

} // namespace

Result<Rendering> render(const Stage& stage, std::span<const Light> lights, const Camera& camera,
                         const RenderOptions& options) {
    const auto fits = [](int side) { return side >= 1 && side <= max_picture_size; };
    if (!fits(options.width) || !fits(options.height))
        return fail(Failure::usage,
                    fmt::format("a picture of {}x{} pixels is out of range", options.width, options.height),
                    fmt::format("each side may have 1 to {} pixels", max_picture_size));
    for (const Light& light : lights) {
        if (has_extent(light.shape) && mask_of(light.shape).web != nullptr)
            return fail(Failure::unsupported,
                        fmt::format("a {} behind a mask is not rendered yet", kind_of(light.shape)),
                        "probe computes what it gives to points");
        if (!has_kernel(light.shape))
            return fail(Failure::unsupported,
                        fmt::format("pictures of {} lights are not computed yet", kind_of(light.shape)),
                        "those of every other shape are");
    }
    Rendering image{Image(options.width, options.height, 3), {}};
    if (options.illuminance) image.illuminance_lx = Image(options.width, options.height, 1);
    const int across = (options.width + tile_size - 1) / tile_size;
    const int down = (options.height + tile_size - 1) / tile_size;
    for (const Light& light : lights) {
        const Renderer renderer(stage, light, camera, options);
        parallel_for(static_cast<std::size_t>(across) * static_cast<std::size_t>(down), options.threads,
                     [&](std::size_t tile) {
                         const int index = static_cast<int>(tile);
                         renderer.render_tile(image, index % across * tile_size, index / across * tile_size);
                     });
    }
    return image;
}

} // namespace gonio
