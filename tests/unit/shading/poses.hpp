// A sphere in front of a receiver, in doubles, for the tests of closed forms; measure/ makes the float ones.
#pragma once

#include <gonio/measure/hostile_poses.hpp>
#include <gonio/measure/random.hpp>
#include <gonio/shading/vec3.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace poses {

using Vec = gonio::shading::vec3<double>;
using gonio::measure::Random;

inline Vec unit(Vec a) {
    const double inverse = 1.0 / std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
    return {a.x * inverse, a.y * inverse, a.z * inverse};
}

inline Vec random_direction(Random& random) {
    const double z = random.uniform(-1.0, 1.0);
    const double phi = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double r = std::sqrt(1.0 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
}

// A unit normal with the given `cosine` to `to`.
inline Vec tilted(Vec to, double cosine, Random& random) {
    const Vec axis = unit(to);
    const Vec tangent = unit(gonio::shading::cross(axis, random_direction(random)));
    return unit(axis * cosine + tangent * std::sqrt(std::fmax(0.0, 1.0 - cosine * cosine)));
}

struct Pose {
    Vec center;
    double radius = 1.0;
    Vec normal{0.0, 0.0, 1.0};
};

// Index modulo 5: above, straddling, below, near the surface, far away; sizes from 1e-3 to 1e3 m.
inline Pose random_pose(unsigned index, Random& random) {
    const auto log_uniform = [&](double a, double b) { return std::exp(random.uniform(std::log(a), std::log(b))); };
    Pose pose;
    pose.radius = log_uniform(1e-3, 1e3);
    double ratio = log_uniform(1.001, 100.0);
    double cosine = 0.0;
    switch (index % 5) {
    case 0:
        cosine = random.uniform(1.0 / ratio, 1.0);
        break;
    case 1:
        cosine = random.uniform(-1.0, 1.0) / ratio;
        break;
    case 2:
        cosine = random.uniform(-1.0, -1.0 / ratio);
        break;
    case 3:
        ratio = 1.0 + log_uniform(1e-7, 0.1);
        cosine = random.uniform(-1.0, 1.0);
        break;
    default:
        ratio = log_uniform(100.0, 1e6);
        cosine = random.uniform() < 0.5 ? random.uniform(-1.1, 1.1) / ratio : random.uniform(-1.0, 1.0);
        break;
    }
    pose.center = random_direction(random) * (ratio * pose.radius);
    pose.normal = tilted(pose.center, cosine, random);
    return pose;
}

// Numbers that break formulas in float, mixed with ordinary ones.
inline double hostile(gonio::measure::Random& random) {
    return gonio::measure::hostile::number(random);
}

} // namespace poses
