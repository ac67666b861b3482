#include <gonio/transport/ray_bundle.hpp>

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace gonio::detail {

std::vector<glm::dvec3> cosine_directions(std::size_t count) {
    constexpr double golden_angle = std::numbers::pi * (3.0 - 2.2360679774997896964);
    std::vector<glm::dvec3> directions;
    directions.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double sine2 = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        const double sine = std::sqrt(sine2);
        const double azimuth = golden_angle * static_cast<double>(i);
        directions.emplace_back(sine * std::cos(azimuth), sine * std::sin(azimuth), std::sqrt(1.0 - sine2));
    }
    return directions;
}

Frame frame_about(const glm::dvec3& origin, const glm::dvec3& normal) {
    // Without a seam but at −Z (T. Duff et al., "Building an Orthonormal Basis, Revisited", 2017).
    const double sign = std::copysign(1.0, normal.z);
    const double a = -1.0 / (sign + normal.z);
    const double b = normal.x * normal.y * a;
    return {origin,
            {1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x},
            {b, sign + normal.y * normal.y * a, -normal.y},
            normal};
}

void cast_bundle(const RayCaster& caster, const Patches& patches, const Frame& from, std::size_t own,
                 std::span<const glm::dvec3> directions, std::span<std::uint32_t> ends) {
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const RayEnd end = caster.cast({from.origin, from.to_world(directions[i])}, own);
        ends[i] = end.surface == RayEnd::nothing
                      ? no_patch
                      : patches.at(patches.charts().index_of(end.surface, end.face), end.position);
    }
}

} // namespace gonio::detail
