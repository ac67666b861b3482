// Indirect light between Lambertian surfaces under one disk, by paths from both ends.
//
// Paths from the points rarely meet what is small and bright: a pole beside the lamp of a street. Paths from the lamp
// always do, but are noisy where they end close to a point. So each takes what it is good at: light whose last vertex
// is farther than `near_m` from the point comes along paths from the lamp, all other light along paths from the point.
// Together they have no bias.
#pragma once

#include <gonio/base/parallel.hpp>
#include <gonio/preview/path_tracer.hpp>
#include <gonio/scene/occlusion.hpp>
#include <gonio/scene/primitives.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/shading/brdf_sample.hpp>
#include <gonio/transport/lighting_options.hpp>
#include <gonio/transport/ray_bundle.hpp>
#include <gonio/transport/ray_caster.hpp>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <variant>
#include <vector>

namespace gonio::bench {

class TwoWayPaths {
public:
    // Surfaces are grey Lambertian ones, and the lamp is a disk that emits to one side. They must outlive this.
    TwoWayPaths(const Stage& stage, const Light& lamp, std::span<const Hit> points, double near_m)
        : stage_(stage), lamp_(lamp), points_(points), near_m_(near_m), caster_(stage) {}

    // The indirect illuminance of each point [lx], in green.
    std::vector<double> lx(std::size_t from_lamp, std::size_t from_point, std::uint32_t seed) const {
        std::vector<double> sum(points_.size(), 0.0);
        constexpr std::size_t blocks = 64;
        std::vector<std::vector<double>> of_blocks(blocks, sum);
        parallel_for(blocks, 0, [&](std::size_t block) {
            for (std::size_t i = block; i < from_lamp; i += blocks)
                add_from_lamp(i, seed, of_blocks[block]);
        });
        for (const std::vector<double>& of_block : of_blocks)
            for (std::size_t i = 0; i < sum.size(); ++i)
                sum[i] += of_block[i] / static_cast<double>(from_lamp);
        detail::PathTracer::Options options;
        options.bounces = all_bounces;
        const detail::PathTracer tracer(stage_, {&lamp_, 1}, options);
        parallel_for(points_.size(), 0, [&](std::size_t i) {
            double near = 0.0;
            for (std::size_t path = 0; path < from_point; ++path)
                near += along(tracer, points_[i], {path, seed * 0x10001U + static_cast<std::uint32_t>(i)});
            sum[i] += near / static_cast<double>(from_point);
        });
        return sum;
    }

private:
    static constexpr double pi = std::numbers::pi;

    static glm::dvec3 cosine_about(const glm::dvec3& normal, double a, double b) {
        const auto local = shading::cosine_direction(a, b);
        return detail::frame_about(glm::dvec3(0.0), normal).to_world({local.x, local.y, local.z});
    }

    detail::RayEnd cast(const glm::dvec3& from, const glm::dvec3& normal, const glm::dvec3& direction,
                        std::size_t surface) const {
        const bool leaves_solid = surface != no_surface && !is_sheet(stage_.surfaces[surface].geometry);
        const double lift_m = 1e-9 * (1.0 + glm::length(from));
        return caster_.cast({from + lift_m * normal, direction}, leaves_solid ? surface : detail::RayEnd::nothing);
    }

    Hit hit_of(const detail::RayEnd& end) const {
        return {end.distance, end.surface, end.face, end.position,
                normal_at(stage_.surfaces[end.surface].geometry, end.position)};
    }

    void add_from_lamp(std::size_t path, std::uint32_t seed, std::vector<double>& lx) const {
        const detail::PixelSequence numbers(path, 0x5eedU + seed);
        const double radius_m = std::get<DiskShape>(lamp_.shape).radius.value;
        const double r = radius_m * std::sqrt(numbers(2, 0));
        const double azimuth = 2.0 * pi * numbers(3, 0);
        glm::dvec3 from =
            lamp_.frame.origin + r * (std::cos(azimuth) * lamp_.frame.x + std::sin(azimuth) * lamp_.frame.y);
        glm::dvec3 normal = -lamp_.frame.z;
        glm::dvec3 direction = cosine_about(normal, numbers(4, 0), numbers(5, 0));
        std::size_t surface = no_surface;
        const double flux_lm = pi * lamp_.luminance.value * pi * radius_m * radius_m;
        for (std::uint32_t vertex = 1; vertex < 1000; ++vertex) {
            const detail::RayEnd end = cast(from, normal, direction, surface);
            if (end.surface == detail::RayEnd::nothing) return;
            const Hit hit = hit_of(end);
            const double albedo = std::get<LambertMaterial>(stage_.surfaces[hit.surface].material).albedo.y;
            for (std::size_t i = 0; i < points_.size(); ++i)
                lx[i] += flux_lm * albedo / pi * arriving(hit, points_[i]);
            if (numbers.independent(vertex, 0) >= albedo) return;
            from = hit.position;
            normal = hit.normal;
            surface = hit.surface;
            direction = cosine_about(normal, numbers.independent(vertex, 1), numbers.independent(vertex, 2));
        }
    }

    // cosθ cosθ'/d², 0 for what is near or hidden.
    double arriving(const Hit& from, const Hit& at) const {
        const glm::dvec3 way = from.position - at.position;
        const double square = glm::dot(way, way);
        if (!(square >= near_m_ * near_m_)) return 0.0;
        const double here = glm::dot(at.normal, way);
        const double there = -glm::dot(from.normal, way);
        if (!(here > 0.0) || !(there > 0.0)) return 0.0;
        const double distance = std::sqrt(square);
        if (is_hidden(stage_, at.surface, at.position, way / distance, distance, from.surface)) return 0.0;
        return here * there / (square * square);
    }

    double along(const detail::PathTracer& tracer, const Hit& point, const detail::PixelSequence& numbers) const {
        // The tracer uses the other dimensions for what it adds to this direction.
        const glm::dvec3 direction = cosine_about(point.normal, numbers(0, 0), numbers(1, 0));
        const detail::RayEnd end = cast(point.position, point.normal, direction, point.surface);
        if (end.surface == detail::RayEnd::nothing || !(end.distance < near_m_)) return 0.0;
        return pi * tracer.at(hit_of(end), -direction, numbers).rgb.y;
    }

    const Stage& stage_;
    const Light& lamp_;
    std::span<const Hit> points_;
    double near_m_;
    detail::RayCaster caster_;
};

} // namespace gonio::bench
