#include <gonio/light/light_color.hpp>
#include <gonio/light/shape_traits.hpp>
#include <gonio/preview/detail/unit_hash.hpp>
#include <gonio/preview/path_tracer.hpp>
#include <gonio/scene/core_vector.hpp>
#include <gonio/scene/light_sampler.hpp>
#include <gonio/scene/occlusion.hpp>
#include <gonio/scene/primitives.hpp>
#include <gonio/scene/probe_light.hpp>
#include <gonio/transport/light_reach.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

namespace gonio::detail {

namespace {

using Vec = shading::vec3<double>;

constexpr std::uint32_t most_vertices = 4096; // roulette ends paths long before
constexpr std::size_t few_lights = 4;         // more are drawn by chance, at vertices after the first
constexpr std::uint32_t luminance_stream = 0;
constexpr std::uint32_t illuminance_stream = 0x10000U;

double fraction(double x) {
    return x - std::floor(x);
}

// A surface point under the lights. `Numbers` gives the number of a dimension for a light.
template<class Core>
class LitPoint {
public:
    LitPoint(const Stage& stage, const Core& material, const Hit& hit, const glm::dvec3& view, bool shadows)
        : stage_(stage), material_(material), hit_(hit), view_(view), shadows_(shadows) {}

    template<class Numbers>
    Shown of(const Light& light, const Numbers& numbers) const {
        if (light.is_emitted_by(hit_.surface)) return {};
        return has_extent(light.shape) ? of_surface(light, numbers) : of_point(light);
    }

    // A direction sampled from the material for the luminance, and a cosine-distributed one for the lux.
    template<class Numbers>
    Shown of(const Sky& sky, const Numbers& numbers) const {
        constexpr double far = std::numeric_limits<double>::infinity();
        Shown shown;
        const Vec n = vec(hit_.normal);
        const auto own = shading::sample_brdf(material_, n, vec(view_), {numbers(2), numbers(3), numbers(4)});
        const double cosine = dot(n, own.l);
        if (own.pdf > 0.0 && cosine > 0.0 && !hidden(vec(own.l), far))
            shown.rgb = brdf(vec(own.l)) * (cosine / own.pdf) * sky.radiance(vec(own.l));
        const shading::TangentFrame<double> frame(n);
        const Vec l = frame.to_world(shading::cosine_direction(numbers(5), numbers(6)));
        if (!hidden(vec(l), far)) shown.lx = std::numbers::pi * glm::dot(sky.radiance(vec(l)), rec709_luminance);
        return shown;
    }

    // A direction of the material and what a luminance of 1 from there shows; nothing where it is not above the
    // surface.
    struct Bounce {
        glm::dvec3 direction{0.0};
        glm::dvec3 weight{0.0};
    };
    Bounce bounce(const Vec& u) const {
        const Vec n = vec(hit_.normal);
        const auto own = shading::sample_brdf(material_, n, vec(view_), u);
        const double cosine = dot(n, own.l);
        if (!(own.pdf > 0.0) || !(cosine > 0.0)) return {};
        return {vec(own.l), brdf(vec(own.l)) * (cosine / own.pdf)};
    }

private:
    // Of the light that the surface `emitter` emits, if one does.
    bool hidden(const glm::dvec3& direction, double distance, std::size_t emitter = no_surface) const {
        return shadows_ && is_hidden(stage_, hit_.surface, hit_.position, direction, distance, emitter);
    }
    glm::dvec3 brdf(const glm::dvec3& l) const {
        return vec(shading::brdf(material_, vec(hit_.normal), vec(l), vec(view_)));
    }

    Shown of_point(const Light& light) const {
        const glm::dvec3 way = light.frame.origin - hit_.position;
        const double distance = glm::length(way);
        if (!(distance > 0.0)) return {};
        const double lx =
            illuminance_of(light, hit_.position, hit_.normal, {IrradianceMethod::exact, {}}).illuminance_lx;
        if (!(lx > 0.0) || hidden(way / distance, distance)) return {};
        return {light.color * (lx * brdf(way / distance)), lx};
    }

    template<class Numbers>
    Shown of_surface(const Light& light, const Numbers& numbers) const {
        const LightSampler sampler(light, hit_.position);
        const std::size_t emitter = light.emitted_by ? light.emitted_by->surface : no_surface;
        Shown shown;
        const auto add = [&](const glm::dvec3& l, double light_pdf, double own_pdf) {
            const double cosine = glm::dot(hit_.normal, l);
            const double both = light_pdf + own_pdf;
            if (!(cosine > 0.0) || !(both > 0.0)) return;
            const LightDirection seen = sampler.at(l);
            if (!(seen.luminance_nt > 0.0) || hidden(l, seen.distance, emitter)) return;
            const double lx = seen.luminance_nt * cosine / both;
            shown.rgb += light.color * (lx * brdf(l));
            shown.lx += lx;
        };
        const Vec n = vec(hit_.normal);
        const Vec v = vec(view_);
        if (const auto drawn = sampler.sample(numbers(2), numbers(3)); drawn.pdf > 0.0)
            add(vec(drawn.direction), drawn.pdf, shading::pdf_brdf(material_, n, v, drawn.direction));
        const auto own = shading::sample_brdf(material_, n, v, {numbers(4), numbers(5), numbers(6)});
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

// By which a light is drawn among many: any number > 0 is right, one near its share of the light has less noise.
double weight_of(const Light& light) {
    return std::isfinite(light.intensity.value) && light.intensity.value > 0.0 ? light.intensity.value
                                                                               : light.illuminance.value;
}

} // namespace

double PixelSequence::operator()(std::size_t dimension, std::uint32_t turn) const {
    constexpr double g = 1.0969815577985598;
    constexpr std::array<double, dimensions> steps{1 / g,
                                                   1 / (g * g),
                                                   1 / (g * g * g),
                                                   1 / (g * g * g * g),
                                                   1 / (g * g * g * g * g),
                                                   1 / (g * g * g * g * g * g),
                                                   1 / (g * g * g * g * g * g * g)};
    const std::uint32_t seed = (pixel_ * 0x9e3779b1U + turn) * 7U + static_cast<std::uint32_t>(dimension);
    return fraction(unit_hash(seed) + static_cast<double>(pass_) * steps[dimension]);
}

double PixelSequence::independent(std::uint32_t vertex, std::uint32_t dimension) const {
    // Two rounds, so that no two of the four numbers can cancel.
    const auto mixed = [](std::uint32_t a, std::uint32_t b) {
        std::uint32_t x = a * 0x9e3779b1U ^ (b + 0x85ebca6bU + (a << 6U) + (a >> 2U));
        x ^= x >> 15U;
        x *= 0x2c1b3c6dU;
        x ^= x >> 12U;
        x *= 0x297a2d39U;
        return x ^ (x >> 15U);
    };
    const auto pass = static_cast<std::uint32_t>(pass_);
    return unit_hash(mixed(mixed(mixed(pixel_, pass), vertex), dimension));
}

PathTracer::PathTracer(const Stage& stage, std::span<const Light> lights, const Options& options)
    : stage_(stage), lights_(lights), options_(options), caster_(stage) {
    for (const Surface& surface : stage.surfaces) {
        const CoreMaterial whole = core_material(surface.material);
        materials_.push_back(
            options.specular ? whole
                             : std::visit([](const auto& core) { return CoreMaterial(diffuse_alone(core)); }, whole));
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        is_dark_.push_back(detail::is_dark(lights[i]) ? 1 : 0);
        if (is_dark_.back() != 0) continue;
        shining_.push_back(i);
        sum += weight_of(lights[i]);
    }
    // Half of the chance is the same for all, so that no light is drawn too rarely for what it gives somewhere.
    double up_to = 0.0;
    for (const std::size_t i : shining_) {
        up_to += 0.5 / static_cast<double>(shining_.size()) + 0.5 * (sum > 0.0 ? weight_of(lights[i]) / sum : 0.0);
        chance_.push_back(up_to);
    }
}

Shown PathTracer::at(const Hit& hit, const glm::dvec3& view, const PixelSequence& numbers) const {
    Shown shown;
    std::visit(
        [&](const auto& core) {
            const LitPoint point(stage_, core, hit, view, options_.shadows);
            const auto of = [&](std::uint32_t turn) {
                return [&numbers, turn](std::size_t dimension) { return numbers(dimension, turn); };
            };
            if (options_.sky != nullptr) {
                const Shown by_sky = point.of(*options_.sky, of(0));
                shown.rgb += by_sky.rgb;
                shown.lx += by_sky.lx;
            }
            for (const std::size_t i : shining_) {
                const Shown by_light = point.of(lights_[i], of(static_cast<std::uint32_t>(i) + 1));
                shown.rgb += by_light.rgb;
                shown.lx += by_light.lx;
            }
            if (options_.bounces <= 0) return;
            const auto u = of(static_cast<std::uint32_t>(lights_.size()) + 1);
            const auto bounce = point.bounce({u(2), u(3), u(4)});
            if (bounce.weight != glm::dvec3(0.0))
                shown.rgb += bounce.weight * arriving(hit.surface, hit.position, hit.normal, bounce.direction, numbers,
                                                      luminance_stream);
        },
        materials_[hit.surface]);
    if (options_.bounces > 0 && options_.illuminance) shown.lx += glm::dot(indirect_lx(hit, numbers), rec709_luminance);
    return shown;
}

glm::dvec3 PathTracer::indirect_lx(const Hit& hit, const PixelSequence& numbers) const {
    const shading::TangentFrame<double> frame(vec(hit.normal));
    const std::uint32_t turn = static_cast<std::uint32_t>(lights_.size()) + 2;
    const Vec l = frame.to_world(shading::cosine_direction(numbers(2, turn), numbers(3, turn)));
    return std::numbers::pi * arriving(hit.surface, hit.position, hit.normal, vec(l), numbers, illuminance_stream);
}

glm::dvec3 PathTracer::direct(const Hit& hit, const glm::dvec3& view, const PixelSequence& numbers,
                              std::uint32_t vertex) const {
    glm::dvec3 rgb(0.0);
    std::visit(
        [&](const auto& core) {
            const LitPoint point(stage_, core, hit, view, options_.shadows);
            const auto of = [&](std::uint32_t turn) {
                return [&numbers, vertex, turn](std::size_t dimension) {
                    return numbers.independent(vertex, turn * 8 + static_cast<std::uint32_t>(dimension));
                };
            };
            if (options_.sky != nullptr) rgb += point.of(*options_.sky, of(1)).rgb;
            if (shining_.size() <= few_lights) {
                for (std::size_t i = 0; i < shining_.size(); ++i)
                    rgb += point.of(lights_[shining_[i]], of(static_cast<std::uint32_t>(i) + 2)).rgb;
                return;
            }
            const double drawn = numbers.independent(vertex, 7) * chance_.back();
            const auto found = std::upper_bound(chance_.begin(), chance_.end() - 1, drawn);
            const auto i = static_cast<std::size_t>(found - chance_.begin());
            const double chance = chance_[i] - (i > 0 ? chance_[i - 1] : 0.0);
            rgb += point.of(lights_[shining_[i]], of(2)).rgb * (chance_.back() / chance);
        },
        materials_[hit.surface]);
    return rgb;
}

glm::dvec3 PathTracer::arriving(std::size_t surface, const glm::dvec3& position, const glm::dvec3& normal,
                                const glm::dvec3& direction, const PixelSequence& numbers, std::uint32_t stream) const {
    glm::dvec3 sum(0.0);
    glm::dvec3 throughput(1.0);
    Ray ray{position, direction};
    glm::dvec3 from_normal = normal;
    for (int bounce = 1; bounce <= options_.bounces && bounce < static_cast<int>(most_vertices); ++bounce) {
        // Surfaces that touch this one begin beside it, not at it.
        const double lift_m = 1e-9 * (1.0 + glm::length(ray.origin));
        ray.origin += lift_m * from_normal;
        const std::size_t own = is_sheet(stage_.surfaces[surface].geometry) ? RayEnd::nothing : surface;
        const RayEnd end = caster_.cast(ray, own);
        if (end.surface == RayEnd::nothing) break;
        const Primitive& geometry = stage_.surfaces[end.surface].geometry;
        const Hit hit{end.distance, end.surface, end.face, end.position, normal_at(geometry, end.position)};
        const glm::dvec3 view = -ray.direction;
        const std::uint32_t vertex = stream + static_cast<std::uint32_t>(bounce);
        sum += throughput * direct(hit, view, numbers, vertex);
        if (bounce == options_.bounces) break;
        glm::dvec3 next(0.0);
        glm::dvec3 weight(0.0);
        std::visit(
            [&](const auto& core) {
                const LitPoint point(stage_, core, hit, view, options_.shadows);
                const auto bounced = point.bounce(
                    {numbers.independent(vertex, 0), numbers.independent(vertex, 1), numbers.independent(vertex, 2)});
                next = bounced.direction;
                weight = bounced.weight;
            },
            materials_[hit.surface]);
        throughput *= weight;
        const double most = std::max({throughput.x, throughput.y, throughput.z});
        if (!(most > 0.0)) break;
        if (bounce > 2) {
            const double chance = std::min(most, 0.95);
            if (numbers.independent(vertex, 3) >= chance) break;
            throughput /= chance;
        }
        ray = {hit.position, next};
        surface = hit.surface;
        from_normal = hit.normal;
    }
    return sum;
}

IndirectEstimate indirect_by_paths(const PathTracer& tracer, const Hit& hit, std::size_t paths, std::uint32_t seed) {
    constexpr std::size_t groups = 16; // each with a shift of its own: their spread is the error
    std::array<glm::dvec3, groups> means{};
    IndirectEstimate estimate;
    for (std::size_t group = 0; group < groups; ++group) {
        const std::size_t count = std::max<std::size_t>(paths / groups, 1);
        glm::dvec3 sum(0.0);
        for (std::size_t i = 0; i < count; ++i)
            sum += tracer.indirect_lx(
                hit, PixelSequence(i, seed * static_cast<std::uint32_t>(groups) + static_cast<std::uint32_t>(group)));
        means[group] = sum / static_cast<double>(count);
        estimate.lx += means[group] / static_cast<double>(groups);
    }
    glm::dvec3 variance(0.0);
    for (const glm::dvec3& mean : means)
        variance += (mean - estimate.lx) * (mean - estimate.lx);
    estimate.standard_error_lx = glm::sqrt(variance / static_cast<double>(groups * (groups - 1)));
    return estimate;
}

} // namespace gonio::detail
