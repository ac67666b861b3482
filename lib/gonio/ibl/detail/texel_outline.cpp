#include <gonio/ibl/detail/texel_outline.hpp>

#include <glm/vec2.hpp>

#include <numbers>
#include <utility>

namespace gonio::detail {

namespace {

OutlineSide great_circle(const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 normal = glm::cross(from, to);
    const double sine = glm::length(normal);
    if (!(sine > 0.0)) return {glm::dvec3(0.0), from, glm::dvec3(0.0), 0.0};
    return {glm::dvec3(0.0), from, glm::cross(normal / sine, from), std::atan2(sine, glm::dot(from, to))};
}

// Eastwards by the angle, which is negative to the west.
OutlineSide parallel(const glm::dvec3& from, double angle) {
    const glm::dvec3 middle(0.0, 0.0, from.z);
    // Azimuths count from north over east: clockwise as seen from above.
    const glm::dvec3 e = from - middle;
    return {middle, e, {e.y, -e.x, 0.0}, angle};
}

} // namespace

TexelOutline outline_of(const EnvironmentGrid& grid, TexelIndex texel) {
    // A corner may belong to another face: from just inside.
    constexpr double inwards = 1e-11;
    const auto corner = [&](double right, double below) {
        return grid.direction({texel.column + (right > 0.0 ? 1.0 - inwards : inwards),
                               texel.row + (below > 0.0 ? 1.0 - inwards : inwards)});
    };
    if (grid.layout() == EnvironmentLayout::latlong) {
        const double width = 2.0 * std::numbers::pi / grid.width();
        const auto at = [&](int right, int below) {
            return grid.direction({static_cast<double>(texel.column + right), static_cast<double>(texel.row + below)});
        };
        // East lies to the right and the zenith above: seen from outside, the order is to the left below.
        return {parallel(at(0, 0), width), great_circle(at(1, 0), at(1, 1)), parallel(at(1, 1), -width),
                great_circle(at(0, 1), at(0, 0))};
    }
    std::array corners{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
    // Some layouts are as seen from inside, others as seen from outside.
    const glm::dvec3 turn = glm::cross(corners[1] - corners[0], corners[2] - corners[0]) +
                            glm::cross(corners[2] - corners[0], corners[3] - corners[0]);
    if (glm::dot(turn, corners[0] + corners[2]) < 0.0) std::swap(corners[1], corners[3]);
    return {great_circle(corners[0], corners[1]), great_circle(corners[1], corners[2]),
            great_circle(corners[2], corners[3]), great_circle(corners[3], corners[0])};
}

} // namespace gonio::detail
