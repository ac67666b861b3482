#include <gonio/base/parallel.hpp>
#include <gonio/measure/opening_cases.hpp>
#include <gonio/measure/random.hpp>
#include <gonio/scene/reference.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace gonio::measure {

namespace {

glm::dvec3 direction(Random& random, double least_z) {
    const double z = random.uniform(least_z, 1.0);
    const double turn = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double r = std::sqrt((1.0 - z) * (1.0 + z));
    return {r * std::cos(turn), r * std::sin(turn), z};
}

} // namespace

transport::Receivers OpeningCases::receivers() const {
    return {{position[0].data(), position[1].data(), position[2].data()},
            {normal[0].data(), normal[1].data(), normal[2].data()},
            size()};
}

shading::Surfaces OpeningCases::surfaces() const {
    shading::Surfaces surfaces;
    const transport::Receivers from = receivers();
    std::copy(std::begin(from.position), std::end(from.position), std::begin(surfaces.position));
    std::copy(std::begin(from.normal), std::end(from.normal), std::begin(surfaces.normal));
    surfaces.count = from.count;
    return surfaces;
}

OpeningCases opening_cases(const Light& luminaire, double distance_in_sides, std::size_t count, std::uint64_t seed) {
    OpeningCases cases{std::make_shared<const Light>(luminaire), {}, {}};
    const Light& face = cases.face();
    const auto* const rect = std::get_if<RectShape>(&face.shape);
    // Of another outline, the square of the same area.
    const double half = 0.5 * std::sqrt(face.intensity.value / face.luminance.value);
    const double half_x = rect != nullptr ? 0.5 * rect->width.value : half;
    const double half_y = rect != nullptr ? 0.5 * rect->height.value : half;
    const double distance = distance_in_sides * 2.0 * std::max(half_x, half_y);
    Random random(seed);
    while (cases.size() < count) {
        glm::dvec3 from(0.0);
        if (distance_in_sides < 1.0) from = {random.uniform(-half_x, half_x), random.uniform(-half_y, half_y), 0.0};
        const glm::dvec3 local = from + distance * direction(random, 0.05); // z: along the emission
        const glm::dvec3 position =
            face.frame.origin + local.x * face.frame.x + local.y * face.frame.y - local.z * face.frame.z;
        const glm::dvec3 to_light = glm::normalize(face.frame.origin - position);
        glm::dvec3 normal = to_light;
        if (cases.size() % 2 == 1) normal = direction(random, -1.0);
        if (glm::dot(normal, to_light) < 0.1) continue;
        for (int axis = 0; axis < 3; ++axis) {
            cases.position.at(static_cast<std::size_t>(axis)).push_back(static_cast<float>(position[axis]));
            cases.normal.at(static_cast<std::size_t>(axis)).push_back(static_cast<float>(normal[axis]));
        }
    }
    return cases;
}

std::vector<double> opening_truth(const OpeningCases& cases, unsigned threads, double relative_error) {
    std::vector<double> lx(cases.size());
    parallel_for(cases.size(), threads, [&](std::size_t i) {
        const glm::dvec3 position(cases.position[0][i], cases.position[1][i], cases.position[2][i]);
        const glm::dvec3 normal(cases.normal[0][i], cases.normal[1][i], cases.normal[2][i]);
        lx[i] = reference_illuminance(cases.face(), position, glm::normalize(normal), {relative_error}).value;
    });
    return lx;
}

} // namespace gonio::measure
