#include <gonio/base/parallel.hpp>
#include <gonio/preview/ticks.hpp>
#include <gonio/scene/emitter.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace gonio {

namespace {

constexpr double left_of_luminance = 0.25;

// Total length of the lines between 0 and `at`, with lines that begin at whole metres.
double line_length(double at) {
    const double whole = std::floor(at);
    return tick_width * whole + std::min(at - whole, tick_width);
}

class Ticks {
public:
    Ticks(const Stage& stage, std::span<const Light> lights, const CameraRays& rays)
        : stage_(stage), lights_(lights), rays_(rays) {}

    // The share of the luminance that the lines leave to the pixel in column x, row y.
    double left(int x, int y) const {
        const Ray ray = rays_.ray(x + 0.5, y + 0.5);
        const std::optional<Hit> hit = first_hit(stage_, ray);
        if (!hit || !is_sheet(stage_.surfaces[hit->surface].geometry)) return 1.0;
        for (const Light& light : lights_) {
            if (light.is_emitted_by(hit->surface)) return 1.0;
            if (light.emitted_by) continue; // not nearer than its surface
            const std::optional<double> distance = distance_to(light, ray);
            if (distance && *distance < hit->distance) return 1.0;
        }
        // The pixel on the surface: a parallelogram; the lines of each axis are averaged over its extent along that
        // axis.
        const glm::dvec3 across = glm::abs(on_plane(*hit, x + 1.0, y + 0.5) - on_plane(*hit, x, y + 0.5));
        const glm::dvec3 down = glm::abs(on_plane(*hit, x + 0.5, y + 1.0) - on_plane(*hit, x + 0.5, y));
        double share = 1.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double slope = std::sqrt(std::max(1.0 - hit->normal[axis] * hit->normal[axis], 0.0));
            if (slope < 0.1) continue; // the surface is perpendicular to this axis
            const double covered = tick_coverage(hit->position[axis], across[axis] + down[axis]);
            share *= 1.0 - (1.0 - left_of_luminance) * covered;
        }
        return share;
    }

private:
    // The point where the ray through a point of the picture meets the plane of a hit; the hit itself if they do not
    // meet.
    glm::dvec3 on_plane(const Hit& hit, double x, double y) const {
        const Ray ray = rays_.ray(x, y);
        const std::optional<double> t = distance_to(Plane{hit.position, hit.normal}, ray);
        return t ? ray.origin + *t * ray.direction : hit.position;
    }

    const Stage& stage_;
    std::span<const Light> lights_;
    const CameraRays& rays_;
};

} // namespace

double tick_coverage(double at, double width) {
    constexpr double least = 1e-9;
    const double half = 0.5 * std::max(width, least);
    const double begin = at + 0.5 * tick_width; // lines are centred on the whole metres
    if (!(half < 1e6)) return tick_width;       // towards the horizon, the mean coverage
    return std::clamp((line_length(begin + half) - line_length(begin - half)) / (2.0 * half), 0.0, 1.0);
}

void draw_ticks(Image& luminance_nt, const Stage& stage, std::span<const Light> lights, const Camera& camera,
                unsigned threads) {
    const CameraRays rays(camera, luminance_nt.width, luminance_nt.height);
    const Ticks ticks(stage, lights, rays);
    parallel_for(static_cast<std::size_t>(luminance_nt.height), threads, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < luminance_nt.width; ++x) {
            const auto left = static_cast<float>(ticks.left(x, y));
            float* const pixel = luminance_nt.at(x, y);
            for (int channel = 0; channel < 3; ++channel)
                pixel[channel] *= left;
        }
    });
}

} // namespace gonio
