// Pixels of a stage, and how far a computed value is from a noisy truth, without the truth's noise.
#pragma once

#include <gonio/light/light_color.hpp>
#include <gonio/scene/camera.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/transport/interreflection.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace gonio::bench {

// A value and two estimates of it whose errors are independent.
struct Point {
    double found, first, second;
};

struct Errors {
    double mean = 0.0;
    double rms = 0.0, bias = 0.0, noise = 0.0; // relative to the mean
};

// The mean of (x − a)(x − b) has no noise of a and b.
inline Errors errors_of(const std::vector<Point>& points) {
    Errors errors;
    double square = 0.0;
    for (const Point& point : points) {
        const double truth = 0.5 * (point.first + point.second);
        errors.mean += truth;
        errors.bias += point.found - truth;
        square += (point.found - point.first) * (point.found - point.second);
        errors.noise += 0.25 * (point.first - point.second) * (point.first - point.second);
    }
    const auto count = static_cast<double>(points.size());
    errors.mean /= count;
    errors.rms = std::sqrt(std::max(square / count, 0.0)) / errors.mean;
    errors.bias /= count * errors.mean;
    errors.noise = std::sqrt(errors.noise / count) / errors.mean;
    return errors;
}

inline constexpr int pixels = 256; // along a side
inline constexpr int step = 7;     // of those that are compared: odd, so that few are corners of squares

struct Pixel {
    Hit hit;
    glm::dvec3 view;   // towards the eye
    std::size_t index; // in a picture
};

// Those whose neighbours show the same surface, which counts: a picture shows their middles. Others are means over
// several points.
inline std::vector<Pixel> pixels_of_one_surface(const Stage& stage, const std::vector<std::uint8_t>& counts) {
    std::vector<Pixel> found;
    const CameraRays rays(stage.camera, pixels, pixels);
    const auto shows = [&](int i, int j, const Hit& middle) {
        const std::optional<Hit> hit = first_hit(stage, rays.ray(i + 0.5, j + 0.5));
        return hit && hit->surface == middle.surface && hit->face == middle.face;
    };
    for (int j = step / 2; j < pixels; j += step)
        for (int i = step / 2; i < pixels; i += step) {
            const Ray ray = rays.ray(i + 0.5, j + 0.5);
            const std::optional<Hit> hit = first_hit(stage, ray);
            if (!hit || counts[hit->surface] == 0) continue;
            if (!shows(i - 1, j, *hit) || !shows(i + 1, j, *hit) || !shows(i, j - 1, *hit) || !shows(i, j + 1, *hit))
                continue;
            found.push_back({*hit, -ray.direction, static_cast<std::size_t>(j) * pixels + static_cast<std::size_t>(i)});
        }
    return found;
}

inline double luminance_of(const Image& picture, std::size_t pixel) {
    return glm::dot(rec709_luminance, glm::dvec3(picture.pixels[3 * pixel], picture.pixels[3 * pixel + 1],
                                                 picture.pixels[3 * pixel + 2]));
}

// The solids that a stage is there to show get this material, and all else is Lambertian; null leaves the stage as it
// is. Returns which surfaces count: these solids, or all.
inline std::vector<std::uint8_t> put_on_subjects(Stage& stage, const char* material) {
    std::vector<std::uint8_t> counts(stage.surfaces.size(), 1);
    for (std::size_t i = 0; material != nullptr && i < counts.size(); ++i) {
        Surface& surface = stage.surfaces[i];
        counts[i] = surface.subject && !is_sheet(surface.geometry) ? 1 : 0;
        surface.material =
            counts[i] != 0 ? parse_material(material).value() : LambertMaterial{hemispherical_albedo(surface.material)};
    }
    return counts;
}

} // namespace gonio::bench
