#include <gonio/figures/box_room.hpp>

#include <fmt/format.h>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <numbers>

namespace gonio {

std::string to_text(const RoomReflectances& reflectances) {
    return fmt::format("{:.0f}/{:.0f}/{:.0f}", 100.0 * reflectances.ceiling, 100.0 * reflectances.walls,
                       100.0 * reflectances.floor);
}

double facing_rectangles_form_factor(double x, double y) {
    if (std::isinf(x) && std::isinf(y)) return 1.0;
    const double root_x = std::hypot(1.0, x);
    const double root_y = std::hypot(1.0, y);
    const double logarithm = std::log(root_x * root_y / std::sqrt(1.0 + x * x + y * y));
    return 2.0 / (std::numbers::pi * x * y) *
           (logarithm + x * root_y * std::atan(x / root_y) + y * root_x * std::atan(y / root_x) - x * std::atan(x) -
            y * std::atan(y));
}

FluxTransfer flux_transfer(double x, double y, const RoomReflectances& reflectances) {
    const bool is_infinite = std::isinf(x) && std::isinf(y);
    const double across = facing_rectangles_form_factor(x, y); // from floor to ceiling and back
    const double from_walls = is_infinite ? 0.0 : (1.0 - across) * x * y / (2.0 * (x + y)); // to floor, to ceiling
    enum { floor, walls, ceiling };
    // Columns are what is reflected, rows what receives it: FᵀP.
    glm::dmat3 once(0.0);
    once[floor] = reflectances.floor * glm::dvec3(0.0, 1.0 - across, across);
    once[walls] = reflectances.walls * glm::dvec3(from_walls, 1.0 - 2.0 * from_walls, from_walls);
    once[ceiling] = reflectances.ceiling * glm::dvec3(across, 1.0 - across, 0.0);
    const glm::dmat3 all = glm::inverse(glm::dmat3(1.0) - once);
    return {{all[floor][floor], all[walls][floor], all[ceiling][floor]},
            {all[floor][walls], all[walls][walls], all[ceiling][walls]},
            {all[floor][ceiling], all[walls][ceiling], all[ceiling][ceiling]}};
}

} // namespace gonio
