#include <gonio/base/parallel.hpp>
#include <gonio/preview/detail/render_check.hpp>
#include <gonio/preview/path_tracer.hpp>
#include <gonio/preview/reference_picture.hpp>
#include <gonio/scene/emitter.hpp>
#include <gonio/scene/probe_light.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace gonio {

ReferencePicture::ReferencePicture(const Stage& stage, std::span<const Light> lights, const Camera& camera,
                                   const RenderOptions& options)
    : stage_(&stage),
      shining_(std::make_shared<const ShiningLights>(lights)),
      lights_(shining_->all()),
      options_(options),
      rays_(camera, options.width, options.height),
      emitted_(stage, lights_),
      pixels_(static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height)),
      row_passes_(static_cast<std::size_t>(options.height)),
      tracer_(std::make_shared<detail::PathTracer>(
          stage, lights_,
          detail::PathTracer::Options{options.shadows != Shadows::off, options.specular,
                                      options.sky.is_dark() ? nullptr : std::make_shared<const Sky>(options.sky),
                                      options.bounces, options.illuminance})) {}

Result<ReferencePicture> ReferencePicture::begin(const Stage& stage, std::span<const Light> lights,
                                                 const Camera& camera, const RenderOptions& options) {
    if (Result<void> checked = detail::check_rendering(lights, options); !checked) return pass_on(checked);
    return ReferencePicture(stage, lights, camera, options);
}

void ReferencePicture::add_pass(const std::function<bool()>& stop) {
    const std::size_t pass = passes();
    const auto width = static_cast<std::size_t>(options_.width);
    parallel_for(row_passes_.size(), options_.threads, [&](std::size_t row) {
        if (row_passes_[row] > pass || (stop && stop())) return;
        for (std::size_t x = 0; x < width; ++x)
            sample(pixels_[row * width + x], static_cast<int>(x), static_cast<int>(row), pass);
        ++row_passes_[row];
    });
}

std::size_t ReferencePicture::passes() const {
    return *std::min_element(row_passes_.begin(), row_passes_.end());
}

void ReferencePicture::sample(Pixel& pixel, int x, int y, std::size_t pass) const {
    const auto index =
        static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(options_.width) + static_cast<std::uint32_t>(x);
    const detail::PixelSequence numbers(pass, index);
    const Ray ray = rays_.ray(x + numbers(0, 0), y + numbers(1, 0));
    const std::optional<Hit> hit = first_hit(*stage_, ray);
    const Light* emitter = nullptr;
    double nearest = hit ? hit->distance : 0.0;
    for (const Light& light : lights_) {
        if (light.emitted_by) continue; // shown by its surface
        const std::optional<double> distance = distance_to(light, ray);
        if (!distance || ((hit || emitter != nullptr) && *distance >= nearest)) continue;
        emitter = &light;
        nearest = *distance;
    }
    if (emitter != nullptr) {
        const auto first = static_cast<std::size_t>(emitter - lights_.data());
        pixel.emitter += glm::vec3(shown_luminance(lights_, first, ray.origin, ray.direction));
        pixel.shows_light = true;
        return;
    }
    if (!hit) {
        if (options_.shows_sky) pixel.emitter += glm::vec3(options_.sky.radiance(ray.direction));
        return;
    }
    if (const std::optional<std::uint32_t> own = emitted_.at(*hit)) {
        const Light& light = lights_[*own];
        pixel.emitter += glm::vec3(light.luminance.value * light.color);
        pixel.shows_light = true;
    }
    const detail::Shown shown = tracer_->at(*hit, -ray.direction, numbers);
    pixel.surface[pass % 2] += glm::vec3(shown.rgb);
    pixel.illuminance_lx += static_cast<float>(shown.lx);
}

double ReferencePicture::error_estimate() const {
    if (passes() < 2) return 1.0;
    double apart = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        const std::size_t passes = row_passes_[i / static_cast<std::size_t>(options_.width)];
        const std::size_t odd_passes = passes / 2;
        const auto odd = static_cast<double>(odd_passes);
        const auto even = static_cast<double>(passes - odd_passes);
        for (int channel = 0; channel < 3; ++channel) {
            const double a = pixels_[i].surface[0][channel] / even;
            const double b = pixels_[i].surface[1][channel] / odd;
            apart += 0.5 * std::abs(a - b);
            all += 0.5 * (a + b);
        }
    }
    return all > 0.0 ? apart / all : 0.0;
}

std::vector<std::uint8_t> ReferencePicture::subjects() const {
    std::vector<std::uint8_t> subjects(pixels_.size());
    const auto width = static_cast<std::size_t>(options_.width);
    parallel_for(row_passes_.size(), options_.threads, [&](std::size_t row) {
        for (std::size_t x = 0; x < width; ++x) {
            const std::optional<Hit> hit =
                first_hit(*stage_, rays_.ray(static_cast<double>(x) + 0.5, static_cast<double>(row) + 0.5));
            if (hit && stage_->surfaces[hit->surface].subject) subjects[row * width + x] = 1;
        }
    });
    return subjects;
}

Rendering ReferencePicture::picture() const {
    Rendering rendering;
    rendering.luminance_nt = Image(options_.width, options_.height, 3);
    if (options_.illuminance) rendering.illuminance_lx = Image(options_.width, options_.height, 1);
    rendering.shows_light.resize(pixels_.size());
    rendering.shows_subject = subjects();
    RenderStats& stats = rendering.stats;
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        const Pixel& pixel = pixels_[i];
        const std::size_t passes = row_passes_[i / static_cast<std::size_t>(options_.width)];
        const float scale = passes > 0 ? 1.0F / static_cast<float>(passes) : 0.0F;
        const glm::vec3 rgb = (pixel.surface[0] + pixel.surface[1] + pixel.emitter) * scale;
        for (int channel = 0; channel < 3; ++channel)
            rendering.luminance_nt.pixels[3 * i + static_cast<std::size_t>(channel)] = rgb[channel];
        if (options_.illuminance) rendering.illuminance_lx.pixels[i] = pixel.illuminance_lx * scale;
        rendering.shows_light[i] = pixel.shows_light ? 1 : 0;
        stats.samples += passes;
    }
    stats.lights = lights_.size();
    for (std::size_t i = 0; i < lights_.size(); ++i)
        if (tracer_->is_dark(i)) ++stats.dark_lights;
    stats.evaluations = lights_.size() * stats.samples;
    stats.dark = stats.dark_lights * stats.samples;
    stats.evaluated = stats.evaluations - stats.dark;
    return rendering;
}

} // namespace gonio
