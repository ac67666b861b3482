#include <gonio/measure/random.hpp>
#include <gonio/measure/specular_cases.hpp>
#include <gonio/shading/vec3.hpp>

#include <cmath>
#include <numbers>
#include <utility>

namespace gonio::measure {

namespace {

using Vec = shading::vec3<double>;

Vec random_direction(Random& random) {
    const double z = random.uniform(-1.0, 1.0);
    const double phi = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double r = std::sqrt((1.0 - z) * (1.0 + z));
    return {r * std::cos(phi), r * std::sin(phi), z};
}

SpecularCases with_eyes(AreaCases area, std::uint64_t seed) {
    Random random(seed ^ 0x5EC0'1A12'0000'0001U);
    SpecularCases cases;
    for (std::size_t i = 0; i < area.lights.size(); ++i)
        cases.alpha.push_back(static_cast<float>(std::exp(random.uniform(std::log(0.01), 0.0))));
    for (std::size_t i = 0; i < area.size(); ++i) {
        const auto at = [i](const std::array<std::vector<float>, 3>& v) {
            return Vec{static_cast<double>(v[0][i]), static_cast<double>(v[1][i]), static_cast<double>(v[2][i])};
        };
        const Vec n = at(area.normal);
        const double size = bounding_radius(area.lights[i / AreaCases::group_size]);
        Vec v{};
        for (int trial = 0; trial < 64; ++trial) {
            const double reach = 2.0 * size * random.uniform();
            const Vec aimed = shading::normalized(random_direction(random) * reach - at(area.position));
            v = i % 2 == 0 && trial < 32 ? n * (2.0 * dot(n, aimed)) - aimed : random_direction(random);
            if (dot(n, v) > 0.01) break;
            v = n;
        }
        const double components[3] = {v.x, v.y, v.z};
        for (std::size_t k = 0; k < 3; ++k)
            cases.view[k].push_back(static_cast<float>(components[k]));
    }
    cases.stratum = area.stratum;
    cases.area = std::move(area);
    return cases;
}

} // namespace

shading::Surfaces SpecularCases::surfaces(std::size_t group) const {
    shading::Surfaces result = area.surfaces(group);
    for (std::size_t k = 0; k < 3; ++k)
        result.view[k] = view[k].data() + group * group_size;
    return result;
}

SpecularCases specular_cases(shading::LightConstants::Kind kind, std::size_t count, std::uint64_t seed) {
    return with_eyes(area_cases(kind, count, seed), seed);
}

SpecularCases specular_cases_of(shading::LightConstants::Kind kind, Stratum stratum, std::size_t count,
                                std::uint64_t seed) {
    return with_eyes(area_cases_of(kind, stratum, count, seed), seed);
}

} // namespace gonio::measure
