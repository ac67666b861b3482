#include <gonio/measure/hostile_poses.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace gonio::measure::hostile {

namespace {

double log_uniform(Random& random, double low, double high) {
    return std::exp(random.uniform(std::log(low), std::log(high)));
}

// A point on the light's surface relative to its centre, and the outward normal there.
struct SurfacePoint {
    Vec at, outward;
};

SurfacePoint on_surface(const Pose& light, Random& random) {
    const Vec other = shading::cross(light.axis, light.across);
    const double phi = random.uniform(0.0, 2.0 * std::numbers::pi);
    const Vec round = light.across * std::cos(phi) + other * std::sin(phi);
    const bool border = random.uniform() < 0.3;
    const Vec out = random_direction(random);
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
    const double side = shading::dot(out, light.axis) < 0.0 ? -0.5 : 0.5;
    return {light.axis * (side * light.q) + out * light.p, out};
}

bool one_sided(const Pose& light) {
    return light.shape == Shape::disk || light.shape == Shape::rectangle;
}

Vec narrowed(Vec v) {
    const auto narrow = [](double x) { return static_cast<double>(static_cast<float>(x)); };
    return {narrow(v.x), narrow(v.y), narrow(v.z)};
}

} // namespace

Vec random_direction(Random& random) {
    const double z = random.uniform(-1.0, 1.0);
    const double phi = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double r = std::sqrt((1.0 - z) * (1.0 + z));
    return {r * std::cos(phi), r * std::sin(phi), z};
}

Vec tilted(Vec to, double cosine, Random& random) {
    const Vec axis = shading::normalized(to);
    const Vec tangent = shading::normalized(shading::cross(axis, random_direction(random)));
    return shading::normalized(axis * cosine + tangent * std::sqrt(std::fmax(0.0, 1.0 - cosine * cosine)));
}

double number(Random& random) {
    static constexpr double special[] = {0.0,   -0.0, 1.0,  -1.0,      1e-45,     -1e-45, 1.2e-38, 1e-30,
                                         1e-20, 1e-7, 0.3,  1.0000001, 0.9999999, 1e3,    1e10,    1e19,
                                         -1e19, 2e19, 1e30, -1e30,     3.4e38,    -3.4e38};
    const std::uint64_t choice = random.bits() % 32;
    if (choice < std::size(special)) return special[choice];
    return random.uniform(-2.0, 2.0);
}

double bounding_radius(const Pose& pose) {
    switch (pose.shape) {
    case Shape::disk:
    case Shape::sphere:
        return pose.p;
    case Shape::rectangle:
        return 0.5 * std::hypot(pose.p, pose.q);
    case Shape::tube:
        return pose.p + 0.5 * pose.q;
    }
    return 0.0;
}

double subtended(const Pose& pose) {
    const double d = std::sqrt(shading::dot(pose.center, pose.center));
    return 2.0 * std::asin(std::min(1.0, bounding_radius(pose) / d));
}

Pose random_light(Shape shape, Random& random) {
    Pose light;
    light.shape = shape;
    light.axis = random.uniform() < 0.15 ? Vec{0, 0, -1} : random_direction(random);
    light.across = shading::normalized(
        shading::cross(light.axis, random.uniform() < 0.5 ? Vec{0, 1, 0} : random_direction(random)));
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

Pose receiver(Pose pose, Stratum stratum, Random& random) {
    const double size = bounding_radius(pose);
    pose.normal = random.uniform() < 0.1 ? pose.axis * (random.uniform() < 0.5 ? -1.0 : 1.0) : random_direction(random);
    const double small =
        random.uniform() < 0.2 ? 0.0 : log_uniform(random, 1e-9, 1e-5) * (random.uniform() < 0.5 ? -1 : 1);
    switch (stratum) {
    case Stratum::near:
    case Stratum::on: {
        const SurfacePoint from = on_surface(pose, random);
        const double off = stratum == Stratum::near ? log_uniform(random, 1e-4, 0.3) : small;
        pose.center = (from.at + from.outward * (size * off)) * -1.0;
        return pose;
    }
    case Stratum::inside: {
        const SurfacePoint from = on_surface(pose, random);
        pose.center = one_sided(pose) ? from.at * (-random.uniform()) - from.outward * (size * small)
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
    Vec away = random_direction(random);
    if (stratum == Stratum::grazing && random.uniform() < 0.4) // its plane or axis, seen at a small angle
        away = tilted(pose.axis, log_uniform(random, 1e-8, 1e-2), random);
    if (one_sided(pose) && shading::dot(away, pose.axis) > 0.0) away = away * -1.0;
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
    pose.normal = tilted(away, std::fmax(-1.0, std::fmin(cosine, 1.0)), random);
    return pose;
}

Pose as_float(Pose pose) {
    pose.center = narrowed(pose.center);
    pose.axis = narrowed(pose.axis);
    pose.across = narrowed(pose.across);
    pose.normal = narrowed(pose.normal);
    pose.p = static_cast<double>(static_cast<float>(pose.p));
    pose.q = static_cast<double>(static_cast<float>(pose.q));
    return pose;
}

shading::LightConstants light_constants(const Pose& pose) {
    using Kind = shading::LightConstants::Kind;
    constexpr Kind kinds[] = {Kind::disk, Kind::rectangle, Kind::tube, Kind::sphere};
    shading::LightConstants made;
    made.kind = kinds[static_cast<std::size_t>(pose.shape)];
    made.radius = static_cast<float>(pose.p);
    made.width = static_cast<float>(pose.p);
    made.height = static_cast<float>(pose.q);
    made.length = static_cast<float>(pose.q);
    const double axis[3] = {pose.axis.x, pose.axis.y, pose.axis.z};
    const double across[3] = {pose.across.x, pose.across.y, pose.across.z};
    for (std::size_t k = 0; k < 3; ++k) {
        made.axis[k] = static_cast<float>(axis[k]);
        made.width_direction[k] = static_cast<float>(across[k]);
    }
    return made;
}

std::string to_text(const Pose& p) {
    return fmt::format("center {:a} {:a} {:a} normal {:a} {:a} {:a} axis {:a} {:a} {:a} across {:a} {:a} {:a} sizes "
                       "{:a} {:a}",
                       p.center.x, p.center.y, p.center.z, p.normal.x, p.normal.y, p.normal.z, p.axis.x, p.axis.y,
                       p.axis.z, p.across.x, p.across.y, p.across.z, p.p, p.q);
}

} // namespace gonio::measure::hostile
