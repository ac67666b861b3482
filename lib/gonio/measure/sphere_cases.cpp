#include <gonio/measure/random.hpp>
#include <gonio/measure/sphere_cases.hpp>
#include <gonio/shading/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio::measure {

namespace {

using Vec = shading::vec3<double>;

Vec random_direction(Random& random) {
    const double z = random.uniform(-1.0, 1.0);
    const double phi = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double radius = std::sqrt((1.0 - z) * (1.0 + z));
    return {radius * std::cos(phi), radius * std::sin(phi), z};
}

struct Pose {
    double distance; // d/r
    double cosine;   // between the normal and the direction to the centre
};

Pose random_pose(Stratum stratum, Random& random) {
    const auto log_uniform = [&](double low, double high) {
        return std::exp(random.uniform(std::log(low), std::log(high)));
    };
    switch (stratum) {
    case Stratum::near:
        return {1.0 + log_uniform(1e-6, 0.1), random.uniform(-1.0, 1.0)};
    case Stratum::far: {
        const double d = log_uniform(30.0, 1e6);
        const bool grazing = random.uniform() < 0.5;
        return {d, grazing ? random.uniform(-1.2, 1.2) / d : random.uniform(0.0, 1.0)};
    }
    default:
        break;
    }
    const double d = log_uniform(1.01, 30.0);
    const double s = 1.0 / d;
    if (stratum == Stratum::above) return {d, random.uniform(s, 1.0)};
    if (stratum == Stratum::below) return {d, random.uniform(-1.0, -s)};
    return {d, random.uniform(-s, s)};
}

} // namespace

const char* to_text(Stratum stratum) {
    switch (stratum) {
    case Stratum::above:
        return "above";
    case Stratum::straddling:
        return "straddling";
    case Stratum::below:
        return "below";
    case Stratum::near:
        return "near";
    case Stratum::far:
        return "far";
    }
    return "";
}

shading::Surfaces SphereCases::surfaces() const {
    shading::Surfaces result;
    for (std::size_t k = 0; k < 3; ++k) {
        result.position[k] = position[k].data();
        result.normal[k] = normal[k].data();
    }
    result.count = size();
    return result;
}

shading::LightConstants SphereCases::light() {
    shading::LightConstants light;
    light.kind = shading::LightConstants::Kind::sphere;
    light.radius = 1.0F;
    return light;
}

SphereCases sphere_cases(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    SphereCases cases;
    for (std::size_t i = 0; i < count; ++i) {
        const auto stratum = static_cast<Stratum>(i % stratum_count);
        const Pose pose = random_pose(stratum, random);
        const Vec to_center = random_direction(random);
        const Vec tangent = shading::normalized(shading::cross(to_center, random_direction(random)));
        const double sine = std::sqrt(std::max(0.0, (1.0 - pose.cosine) * (1.0 + pose.cosine)));
        const Vec normal = to_center * pose.cosine + tangent * sine;
        const Vec position = to_center * -pose.distance;
        const double p[3] = {position.x, position.y, position.z};
        const double n[3] = {normal.x, normal.y, normal.z};
        for (std::size_t k = 0; k < 3; ++k) {
            cases.position[k].push_back(static_cast<float>(p[k]));
            cases.normal[k].push_back(static_cast<float>(n[k]));
        }
        cases.stratum.push_back(stratum);
    }
    return cases;
}

SphereCases sphere_cases_of(Stratum stratum, std::size_t count, std::uint64_t seed) {
    const SphereCases all = sphere_cases(count * stratum_count, seed);
    SphereCases some;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all.stratum[i] != stratum) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            some.position[k].push_back(all.position[k][i]);
            some.normal[k].push_back(all.normal[k][i]);
        }
        some.stratum.push_back(stratum);
    }
    return some;
}

} // namespace gonio::measure
