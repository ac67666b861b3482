// Receivers before lights of every shape in the strata that formulas break in, the same for the same seed everywhere.
//
// A light lies at the origin; `receiver` places one of its receivers. Lights are round numbers of metres or not, axes
// aligned or not, a quarter of them needles and plates.
#pragma once

#include "area_truth.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace area {

enum class Stratum : unsigned { above, straddling, below, grazing, near, on, inside, far, axial };
inline constexpr std::size_t stratum_count = 9;
inline constexpr std::array<const char*, stratum_count> stratum_names{"above", "straddling", "below", "grazing", "near",
                                                                      "on",    "inside",     "far",   "axial"};

inline double log_uniform(Random& random, double low, double high) {
    return std::exp(random.uniform(std::log(low), std::log(high)));
}

// center and normal are left for `receiver`.
inline Pose random_light(Shape shape, Random& random) {
    Pose light;
    light.shape = shape;
    light.axis = random.uniform() < 0.15 ? Vec{0, 0, -1} : poses::random_direction(random);
    light.across = poses::unit(
        gonio::shading::cross(light.axis, random.uniform() < 0.5 ? Vec{0, 1, 0} : poses::random_direction(random)));
    light.p =
        random.uniform() < 0.3 ? std::exp2(std::floor(random.uniform(-6.0, 6.0))) : log_uniform(random, 1e-2, 1e2);
    const bool extreme = random.uniform() < 0.25;
    switch (shape) {
    case Shape::rectangle:
        light.q = light.p * (extreme ? log_uniform(random, 1e-4, 1e-2) : log_uniform(random, 0.02, 50.0));
        if (extreme && random.uniform() < 0.5) std::swap(light.p, light.q);
        break;
    case Shape::tube:
        light.q = light.p * (extreme ? log_uniform(random, 1e2, 1e4) : log_uniform(random, 0.01, 100.0));
        break;
    default:
        break;
    }
    return light;
}

namespace detail {

// A point of the light's surface from its centre, and the direction away from it.
struct SurfacePoint {
    Vec at, outward;
};

inline SurfacePoint on_surface(const Pose& light, Random& random) {
    const Vec other = gonio::shading::cross(light.axis, light.across);
    const double phi = random.uniform(0.0, 2.0 * std::numbers::pi);
    const Vec round = light.across * std::cos(phi) + other * std::sin(phi);
    const bool border = random.uniform() < 0.3;
    const Vec out = poses::random_direction(random);
    switch (light.shape) {
    case Shape::sphere:
        return {out * light.p, out};
    case Shape::disk:
        return {round * (light.p * (border ? 1.0 : std::sqrt(random.uniform()))), light.axis};
    case Shape::rectangle: {
        double x = random.uniform(-0.5, 0.5);
        const double y = random.uniform(-0.5, 0.5);
        if (border) x = x < 0.0 ? -0.5 : 0.5;
        return {light.across * (x * light.p) + other * (y * light.q), light.axis};
    }
    case Shape::tube:
        break;
    }
    const double along = random.uniform(-0.5, 0.5);
    if (random.uniform() < 0.5) return {light.axis * (along * light.q) + round * light.p, round};
    const double side = gonio::shading::dot(out, light.axis) < 0.0 ? -0.5 : 0.5;
    return {light.axis * (side * light.q) + out * light.p, out};
}

inline bool one_sided(const Pose& light) {
    return light.shape == Shape::disk || light.shape == Shape::rectangle;
}

} // namespace detail

// Distances from 1e-4 to 1e6 of the light's bounding radius.
inline Pose receiver(Pose pose, Stratum stratum, Random& random) {
    const double size = bounding_radius(pose);
    pose.normal =
        random.uniform() < 0.1 ? pose.axis * (random.uniform() < 0.5 ? -1.0 : 1.0) : poses::random_direction(random);
    const double small =
        random.uniform() < 0.2 ? 0.0 : log_uniform(random, 1e-9, 1e-5) * (random.uniform() < 0.5 ? -1 : 1);
    switch (stratum) {
    case Stratum::near:
    case Stratum::on: {
        const detail::SurfacePoint from = detail::on_surface(pose, random);
        const double off = stratum == Stratum::near ? log_uniform(random, 1e-4, 0.3) : small;
        pose.center = (from.at + from.outward * (size * off)) * -1.0;
        return pose;
    }
    case Stratum::inside: {
        const detail::SurfacePoint from = detail::on_surface(pose, random);
        pose.center = detail::one_sided(pose) ? from.at * (-random.uniform()) - from.outward * (size * small)
                                              : from.at * (-random.uniform());
        return pose;
    }
    case Stratum::axial: {
        const double d = size * log_uniform(random, 1e-4, 1e6);
        const double off = random.uniform() < 0.5 ? 0.0 : log_uniform(random, 1e-12, 1e-3);
        pose.center = pose.axis * -d + pose.across * (off * d);
        if (pose.shape == Shape::rectangle && random.uniform() < 0.5)
            pose.center = pose.center + pose.across * (0.5 * pose.p);
        return pose;
    }
    default:
        break;
    }
    Vec away = poses::random_direction(random);
    if (stratum == Stratum::grazing && random.uniform() < 0.4) // its own plane, or axis, seen at a small angle
        away = poses::tilted(pose.axis, log_uniform(random, 1e-8, 1e-2), random);
    if (detail::one_sided(pose) && gonio::shading::dot(away, pose.axis) > 0.0) away = away * -1.0;
    const double d = stratum == Stratum::far       ? log_uniform(random, 30.0, 1e6)
                     : stratum == Stratum::grazing ? log_uniform(random, 1.05, 1e3)
                                                   : log_uniform(random, 1.01, 30.0);
    const double s = 1.0 / d;
    double cosine = random.uniform(-s, s);
    if (stratum == Stratum::above || (stratum == Stratum::far && random.uniform() < 0.5))
        cosine = random.uniform(s, 1.0);
    if (stratum == Stratum::below) cosine = random.uniform(-1.0, -s);
    if (stratum == Stratum::grazing) {
        const double by = log_uniform(random, 1e-8, 1e-2) * (random.uniform() < 0.5 ? -1.0 : 1.0);
        cosine = random.uniform() < 0.3 ? s * by : s * (1.0 + by) * (random.uniform() < 0.5 ? -1.0 : 1.0);
    }
    pose.center = away * (d * size);
    pose.normal = poses::tilted(away, std::fmax(-1.0, std::fmin(cosine, 1.0)), random);
    return pose;
}

} // namespace area
