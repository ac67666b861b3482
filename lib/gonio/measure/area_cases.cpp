#include <gonio/measure/area_cases.hpp>
#include <gonio/measure/random.hpp>
#include <gonio/shading/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio::measure {

namespace {

using Kind = shading::LightConstants::Kind;
using Vec = shading::vec3<double>;

Vec random_direction(Random& random) {
    const double z = random.uniform(-1.0, 1.0);
    const double phi = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double radius = std::sqrt((1.0 - z) * (1.0 + z));
    return {radius * std::cos(phi), radius * std::sin(phi), z};
}

double log_uniform(Random& random, double low, double high) {
    return std::exp(random.uniform(std::log(low), std::log(high)));
}

Vec vec(const float (&v)[3]) {
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

void put(Vec from, float (&to)[3]) {
    to[0] = static_cast<float>(from.x);
    to[1] = static_cast<float>(from.y);
    to[2] = static_cast<float>(from.z);
}

shading::LightConstants random_light(Kind kind, Random& random) {
    shading::LightConstants light;
    light.kind = kind;
    const Vec axis = random_direction(random);
    put(axis, light.axis);
    put(shading::normalized(shading::cross(axis, random_direction(random))), light.width_direction);
    const double size = log_uniform(random, 0.01, 100.0);
    light.radius = static_cast<float>(size);
    light.width = static_cast<float>(size);
    light.height = static_cast<float>(size * log_uniform(random, 0.01, 1.0));
    light.length = static_cast<float>(size * log_uniform(random, 0.01, 100.0));
    if (random.uniform() < 0.5) std::swap(light.width, light.height);
    if (kind == Kind::sphere) light.length = 0.0F; // sampled as a tube
    return light;
}

// A random point on the light's surface, and the outward normal there.
struct SurfaceSample {
    Vec point, outward;
};

SurfaceSample sample(const shading::LightConstants& light, Random& random) {
    const Vec axis = vec(light.axis);
    const Vec across = vec(light.width_direction);
    const Vec other = shading::cross(axis, across);
    const auto in_plane = [&](double x, double y) { return across * x + other * y; };
    const auto half = [](float size) { return 0.5 * static_cast<double>(size); };
    const auto r = static_cast<double>(light.radius);
    if (light.kind == Kind::rectangle)
        return {in_plane(random.uniform(-1.0, 1.0) * half(light.width), random.uniform(-1.0, 1.0) * half(light.height)),
                axis};
    const double phi = random.uniform(0.0, 2.0 * std::numbers::pi);
    const Vec round = in_plane(std::cos(phi), std::sin(phi));
    if (light.kind == Kind::ellipse) {
        const double out = std::sqrt(random.uniform());
        return {in_plane(out * std::cos(phi) * half(light.width), out * std::sin(phi) * half(light.height)), axis};
    }
    if (light.kind == Kind::disk) return {round * (r * std::sqrt(random.uniform())), axis};
    if (light.kind == Kind::cylinder || random.uniform() < 0.5)
        return {axis * (random.uniform(-1.0, 1.0) * half(light.length)) + round * r, round};
    const Vec out = random_direction(random);
    const double side = shading::dot(out, axis) < 0.0 ? -1.0 : 1.0;
    return {axis * (side * half(light.length)) + out * r, out};
}

Vec tilted(Vec toward, double cosine, Random& random) {
    const Vec tangent = shading::normalized(shading::cross(toward, random_direction(random)));
    return toward * cosine + tangent * std::sqrt(std::max(0.0, (1.0 - cosine) * (1.0 + cosine)));
}

struct Receiver {
    Vec position, normal;
};

Receiver random_receiver(const shading::LightConstants& light, Stratum stratum, Random& random) {
    const double size = bounding_radius(light);
    if (stratum == Stratum::near) {
        const SurfaceSample from = sample(light, random);
        return {from.point + from.outward * (size * log_uniform(random, 1e-3, 0.3)), random_direction(random)};
    }
    Vec away = random_direction(random);
    const bool is_flat = light.kind != Kind::tube && light.kind != Kind::cylinder;
    if (is_flat && shading::dot(away, vec(light.axis)) < 0.0) away = away * -1.0;
    const bool far = stratum == Stratum::far;
    const double d = far ? log_uniform(random, 30.0, 1e6) : log_uniform(random, 1.05, 30.0);
    const double s = 1.0 / d;
    double cosine = random.uniform(-s, s);
    if (stratum == Stratum::above || (far && random.uniform() < 0.5)) cosine = random.uniform(s, 1.0);
    if (stratum == Stratum::below) cosine = random.uniform(-1.0, -s);
    return {away * (d * size), tilted(away * -1.0, cosine, random)};
}

} // namespace

double bounding_radius(const shading::LightConstants& light) {
    const auto r = static_cast<double>(light.radius);
    switch (light.kind) {
    case Kind::punctual:
    case Kind::sun:
        return 0.0;
    case Kind::sphere:
    case Kind::disk:
        return r;
    case Kind::ellipse:
        return 0.5 * static_cast<double>(std::max(light.width, light.height));
    case Kind::rectangle:
        return 0.5 * std::hypot(static_cast<double>(light.width), static_cast<double>(light.height));
    case Kind::cylinder:
        return std::hypot(r, 0.5 * static_cast<double>(light.length));
    case Kind::tube:
        return r + 0.5 * static_cast<double>(light.length);
    }
    return 0.0;
}

shading::Surfaces AreaCases::surfaces(std::size_t group) const {
    shading::Surfaces result;
    const std::size_t first = group * group_size;
    for (std::size_t k = 0; k < 3; ++k) {
        result.position[k] = position[k].data() + first;
        result.normal[k] = normal[k].data() + first;
    }
    result.count = std::min(group_size, size() - first);
    return result;
}

AreaCases area_cases(Kind kind, std::size_t count, std::uint64_t seed) {
    Random random(seed);
    AreaCases cases;
    for (std::size_t i = 0; i < count; ++i) {
        if (i % AreaCases::group_size == 0) cases.lights.push_back(random_light(kind, random));
        const auto stratum = static_cast<Stratum>(i % stratum_count);
        const Receiver receiver = random_receiver(cases.lights.back(), stratum, random);
        float p[3];
        float n[3];
        put(receiver.position, p);
        put(receiver.normal, n);
        for (std::size_t k = 0; k < 3; ++k) {
            cases.position[k].push_back(p[k]);
            cases.normal[k].push_back(n[k]);
        }
        cases.stratum.push_back(stratum);
    }
    return cases;
}

AreaCases area_cases_of(Kind kind, Stratum stratum, std::size_t count, std::uint64_t seed) {
    const std::size_t groups = (count + AreaCases::group_size - 1) / AreaCases::group_size;
    const AreaCases all = area_cases(kind, groups * AreaCases::group_size, seed);
    AreaCases some;
    for (std::size_t g = 0; g < groups; ++g) {
        std::vector<std::size_t> of_group;
        for (std::size_t i = g * AreaCases::group_size; i < (g + 1) * AreaCases::group_size; ++i)
            if (all.stratum[i] == stratum) of_group.push_back(i);
        some.lights.push_back(all.lights[g]);
        for (std::size_t k = 0; k < AreaCases::group_size; ++k) {
            const std::size_t i = of_group[k % of_group.size()];
            for (std::size_t c = 0; c < 3; ++c) {
                some.position[c].push_back(all.position[c][i]);
                some.normal[c].push_back(all.normal[c][i]);
            }
            some.stratum.push_back(stratum);
        }
    }
    return some;
}

} // namespace gonio::measure
