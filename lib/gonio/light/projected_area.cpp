#include <gonio/light/projected_area.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio {

double projected_area_m2(const Opening& opening, const glm::dvec3& direction) {
    constexpr double quarter_pi = std::numbers::pi / 4.0;
    const glm::dvec3& size = opening.size_m;
    const glm::dvec3& to = direction;
    const double down = std::max(-to.z, 0.0);
    switch (opening.shape) {
    case OpeningShape::point:
        return 0.0;
    case OpeningShape::rectangle:
        return size.x * size.y * down;
    case OpeningShape::box: {
        const double side_x_m2 = size.y * opening.side_heights_m[to.x > 0.0 ? 0 : 2];
        const double side_y_m2 = size.x * opening.side_heights_m[to.y > 0.0 ? 1 : 3];
        return size.x * size.y * down + side_x_m2 * std::abs(to.x) + side_y_m2 * std::abs(to.y);
    }
    case OpeningShape::disk:
    case OpeningShape::ellipse:
        return quarter_pi * size.x * size.y * down;
    case OpeningShape::vertical_cylinder:
        return quarter_pi * size.x * size.y * std::abs(to.z) + size.z * std::hypot(size.x * to.y, size.y * to.x);
    case OpeningShape::horizontal_cylinder: // its axis is X
        return quarter_pi * size.y * size.z * std::abs(to.x) + size.x * std::hypot(size.y * to.z, size.z * to.y);
    case OpeningShape::horizontal_cylinder_across: // its axis is Y
        return quarter_pi * size.x * size.z * std::abs(to.y) + size.y * std::hypot(size.x * to.z, size.z * to.x);
    case OpeningShape::upright_disk: {
        const bool faces_x = size.x < size.y;
        const double diameter_m = faces_x ? size.y : size.x;
        return quarter_pi * diameter_m * size.z * std::abs(faces_x ? to.x : to.y);
    }
    case OpeningShape::sphere:
    case OpeningShape::ellipsoid:
        return quarter_pi * std::hypot(size.y * size.z * to.x, size.x * size.z * to.y, size.x * size.y * to.z);
    }
    return 0.0;
}

} // namespace gonio
