#include <gonio/base/parallel.hpp>
#include <gonio/preview/detail/render_check.hpp>
#include <gonio/preview/detail/unit_hash.hpp>
#include <gonio/preview/reference_picture.hpp>
#include <gonio/scene/core_vector.hpp>
#include <gonio/scene/emitter.hpp>
#include <gonio/scene/light_sampler.hpp>
#include <gonio/scene/occlusion.hpp>
#include <gonio/scene/probe_light.hpp>
#include <gonio/transport/light_reach.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace gonio {

namespace {

using detail::LightDirection;
using detail::LightSampler;
using detail::vec;
using Vec = shading::vec3<double>;

// The numbers in [0, 1) for one pass and pixel: the fractional parts of multiples of 1/g, 1/g², …, where g⁸ = g + 1.
class Sequence {
public:
    static constexpr std::size_t dimensions = 7;

    Sequence(std::size_t index, std::uint32_t pixel) : index_(static_cast<double>(index)), pixel_(pixel) {}

    // `turn` shifts all numbers: 0 for the pixel itself, other values for the lights.
    double operator()(std::size_t dimension, std::uint32_t turn) const {
        const std::uint32_t seed = (pixel_ * 0x9e3779b1U + turn) * 7U + static_cast<std::uint32_t>(dimension);
        const double at = detail::unit_hash(seed) + index_ * steps[dimension];
        return at - std::floor(at);
    }

private:
    static constexpr double g = 1.0969815577985598;
    static constexpr std::array<double, dimensions> steps{1 / g,
                                                          1 / (g * g),
                                                          1 / (g * g * g),
                                                          1 / (g * g * g * g),
                                                          1 / (g * g * g * g * g),
                                                          1 / (g * g * g * g * g * g),
                                                          1 / (g * g * g * g * g * g * g)};

    double index_;
    std::uint32_t pixel_;
};

// What a point receives from one light, and what the surface shows of it.
struct Shown {
    glm::dvec3 rgb{0.0};
    double lx = 0.0;
};

// A surface point under the lights.
template<class Core>
class LitPoint {
public:
    LitPoint(const Stage& stage, const Core& material, const Hit& hit, const glm::dvec3& view, bool shadows)
        : stage_(stage), material_(material), hit_(hit), view_(view), shadows_(shadows) {}

    Shown of(const Light& light, const Sequence& numbers, std::uint32_t turn) const {
        return has_extent(light.shape) ? of_surface(light, numbers, turn) : of_point(light);
    }

    // For a uniform sky of luminance 1: a direction sampled from the material for the luminance, and a
    // cosine-distributed one for the lux.
    Shown of_sky(const Sequence& numbers) const {
        constexpr double far = std::numeric_limits<double>::infinity();
        Shown shown;
        const Vec n = vec(hit_.normal);
        const auto own = shading::sample_brdf(material_, n, vec(view_), {numbers(2, 0), numbers(3, 0), numbers(4, 0)});
        const double cosine = dot(n, own.l);
        if (own.pdf > 0.0 && cosine > 0.0 && !hidden(vec(own.l), far))
            shown.rgb = brdf(vec(own.l)) * (cosine / own.pdf);
        const shading::TangentFrame<double> frame(n);
        const Vec l = frame.to_world(shading::cosine_direction(numbers(5, 0), numbers(6, 0)));
        if (!hidden(vec(l), far)) shown.lx = std::numbers::pi;
        return shown;
    }

private:
    bool hidden(const glm::dvec3& direction, double distance) const {
        return shadows_ && is_hidden(stage_, hit_.surface, hit_.position, direction, distance);
    }
    glm::dvec3 brdf(const glm::dvec3& l) const {
        return vec(shading::brdf(material_, vec(hit_.normal), vec(l), vec(view_)));
    }

    Shown of_point(const Light& light) const {
        const glm::dvec3 way = light.frame.origin - hit_.position;
        const double distance = glm::length(way);
        if (!(distance > 0.0)) return {};
        const double lx =
            detail::illuminance_of(light, hit_.position, hit_.normal, {IrradianceMethod::exact, {}}).illuminance_lx;
        if (!(lx > 0.0) || hidden(way / distance, distance)) return {};
        return {light.color * (lx * brdf(way / distance)), lx};
    }

    Shown of_surface(const Light& light, const Sequence& numbers, std::uint32_t turn) const {
        const LightSampler sampler(light, hit_.position);
        Shown shown;
        const auto add = [&](const glm::dvec3& l, double light_pdf, double own_pdf) {
            const double cosine = glm::dot(hit_.normal, l);
            const double both = light_pdf + own_pdf;
            if (!(cosine > 0.0) || !(both > 0.0)) return;
            const LightDirection seen = sampler.at(l);
            if (!(seen.luminance_nt > 0.0) || hidden(l, seen.distance)) return;
            const double lx = seen.luminance_nt * cosine / both;
            shown.rgb += light.color * (lx * brdf(l));
            shown.lx += lx;
        };
        const Vec n = vec(hit_.normal);
        const Vec v = vec(view_);
        if (const auto drawn = sampler.sample(numbers(2, turn), numbers(3, turn)); drawn.pdf > 0.0)
            add(vec(drawn.direction), drawn.pdf, shading::pdf_brdf(material_, n, v, drawn.direction));
        const auto own = shading::sample_brdf(material_, n, v, {numbers(4, turn), numbers(5, turn), numbers(6, turn)});
        const double of_light = own.pdf > 0.0 ? sampler.pdf(own.l) : 0.0;
        if (of_light > 0.0) add(vec(own.l), of_light, own.pdf);
        return shown;
    }

    const Stage& stage_;
    const Core& material_;
    const Hit& hit_;
    const glm::dvec3& view_;
    bool shadows_;
};

} // namespace

ReferencePicture::ReferencePicture(const Stage& stage, std::span<const Light> lights, const Camera& camera,
                                   const RenderOptions& options)
    : stage_(&stage),
      lights_(lights),
      options_(options),
      rays_(camera, options.width, options.height),
      pixels_(static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height)),
      row_passes_(static_cast<std::size_t>(options.height)) {
    for (const Surface& surface : stage.surfaces)
        materials_.push_back(core_material(surface.material));
    for (const Light& light : lights)
        is_dark_.push_back(detail::is_dark(light) ? 1 : 0);
}

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
    const Sequence numbers(pass, index);
    const Ray ray = rays_.ray(x + numbers(0, 0), y + numbers(1, 0));
    const std::optional<Hit> hit = first_hit(*stage_, ray);
    const Light* emitter = nullptr;
    double nearest = hit ? hit->distance : 0.0;
    for (const Light& light : lights_) {
        const std::optional<double> distance = distance_to(light, ray);
        if (!distance || ((hit || emitter != nullptr) && *distance >= nearest)) continue;
        emitter = &light;
        nearest = *distance;
    }
    if (emitter != nullptr) {
        const double mask = detail::mask_share(*emitter, emitter->frame.origin - ray.direction);
        pixel.emitter += glm::vec3(mask * emitter->luminance.value * emitter->color);
        pixel.shows_light = true;
        return;
    }
    if (!hit) return;
    const glm::dvec3 view = -ray.direction;
    glm::dvec3 rgb(0.0);
    double lx = 0.0;
    std::visit(
        [&](const auto& core) {
            const LitPoint point(*stage_, core, *hit, view, options_.shadows != Shadows::off);
            if (options_.sky.value > 0.0) {
                const Shown shown = point.of_sky(numbers);
                rgb += options_.sky.value * shown.rgb;
                lx += options_.sky.value * shown.lx;
            }
            for (std::size_t i = 0; i < lights_.size(); ++i) {
                if (is_dark_[i] != 0) continue;
                const Shown shown = point.of(lights_[i], numbers, static_cast<std::uint32_t>(i) + 1);
                rgb += shown.rgb;
                lx += shown.lx;
            }
        },
        materials_[hit->surface]);
    pixel.surface[pass % 2] += glm::vec3(rgb);
    pixel.illuminance_lx += static_cast<float>(lx);
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

Rendering ReferencePicture::picture() const {
    Rendering rendering;
    rendering.luminance_nt = Image(options_.width, options_.height, 3);
    if (options_.illuminance) rendering.illuminance_lx = Image(options_.width, options_.height, 1);
    rendering.shows_light.resize(pixels_.size());
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
    stats.dark_lights = static_cast<std::size_t>(std::count(is_dark_.begin(), is_dark_.end(), 1));
    stats.evaluations = lights_.size() * stats.samples;
    stats.dark = stats.dark_lights * stats.samples;
    stats.evaluated = stats.evaluations - stats.dark;
    return rendering;
}

} // namespace gonio
