#include <gonio/light/luminous_body.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/quick_web.hpp>
#include <gonio/web/zones.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace gonio {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int prism_sides = 12;
constexpr glm::dvec3 up{0.0, 0.0, 1.0};

// A frame with Z against the normal and X along `along`, which is perpendicular to it.
Frame frame_of(const glm::dvec3& center, const glm::dvec3& normal, const glm::dvec3& along) {
    return {center, along, glm::cross(-normal, along), -normal};
}

// The flux into the half-space in front of a plane, by a midpoint rule: it decides whether a side emits, and is shown.
Lumens flux_towards(const Web& web, const glm::dvec3& normal) {
    if (normal == up) return zone_flux(web, 90.0, 180.0);
    if (normal == -up) return zone_flux(web, 0.0, 90.0);
    constexpr int rows = 180;
    constexpr int columns = 360;
    const QuickWeb quick(web);
    std::vector<glm::dvec3> azimuths; // the sine of 90° is 1
    for (int column = 0; column < columns; ++column)
        azimuths.push_back(direction_of({Radians((column + 0.5) * 2.0 * pi / columns), Radians(0.5 * pi)}));
    std::vector<glm::dvec3> directions;
    std::vector<double> candela(columns);
    double sum = 0.0;
    for (int row = 0; row < rows; ++row) {
        const Radians gamma((row + 0.5) * pi / rows);
        const double sine = std::sin(gamma.value);
        directions.clear();
        for (const glm::dvec3& azimuth : azimuths) {
            const glm::dvec3 direction(sine * azimuth.x, sine * azimuth.y, -std::cos(gamma.value));
            if (glm::dot(direction, normal) > 0.0) directions.push_back(direction);
        }
        const std::span<double> found(candela.data(), directions.size());
        quick.candela(directions, found);
        for (const double cd : found)
            sum += std::max(cd, 0.0) * sine;
    }
    return Lumens(sum * (pi / rows) * (2.0 * pi / columns));
}

bool is_round(OpeningShape shape) {
    return shape == OpeningShape::disk || shape == OpeningShape::ellipse || shape == OpeningShape::upright_disk;
}

// The axis along which an opening does not extend; −1 for a solid.
int flat_axis(const Opening& opening) {
    switch (opening.shape) {
    case OpeningShape::rectangle:
    case OpeningShape::disk:
    case OpeningShape::ellipse:
        return 2;
    case OpeningShape::upright_disk:
        return opening.size_m.x < opening.size_m.y ? 0 : 1;
    case OpeningShape::box: // LM-63 has no code for upright rectangles: boxes without a width or a length
        for (int axis = 0; axis < 2; ++axis)
            if (opening.size_m[axis] == 0.0 && opening.size_m[1 - axis] > 0.0 && opening.size_m.z > 0.0) return axis;
        return -1;
    default:
        return -1;
    }
}

} // namespace

void LuminousBody::add(Shape shape, const Frame& frame, double area_m2) {
    const bool is_flat = !std::holds_alternative<SphereShape>(shape);
    faces_.push_back({std::move(shape), frame, area_m2, is_flat, is_flat ? -frame.z : glm::dvec3(0.0)});
}

void LuminousBody::add_rectangle(const glm::dvec3& center, const glm::dvec3& normal, const glm::dvec3& along,
                                 double width_m, double height_m) {
    if (!(width_m * height_m > 0.0)) return;
    add(RectShape{Meters(width_m), Meters(height_m)}, frame_of(center, normal, along), width_m * height_m);
}

void LuminousBody::add_disk(const glm::dvec3& center, const glm::dvec3& normal, const glm::dvec3& along, double width_m,
                            double height_m) {
    if (!(width_m * height_m > 0.0)) return;
    const Shape shape = width_m == height_m ? Shape(DiskShape{Meters(0.5 * width_m)})
                                            : Shape(EllipseShape{Meters(width_m), Meters(height_m)});
    add(shape, frame_of(center, normal, along), 0.25 * pi * width_m * height_m);
}

// The sides of a EULUMDAT box shine from its lower edge up to their own heights.
void LuminousBody::add_box(const glm::dvec3& size_m, const std::array<double, 4>& side_heights_m, bool emits_up) {
    const glm::dvec3 half = 0.5 * size_m;
    add_rectangle({0.0, 0.0, -half.z}, -up, {1.0, 0.0, 0.0}, size_m.x, size_m.y);
    if (emits_up) add_rectangle({0.0, 0.0, half.z}, up, {1.0, 0.0, 0.0}, size_m.x, size_m.y);
    const std::array normals{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, -1, 0)};
    for (std::size_t side = 0; side < normals.size(); ++side) {
        const glm::dvec3& normal = normals.at(side);
        const double height_m = side_heights_m.at(side);
        const glm::dvec3 center = normal * half + glm::dvec3(0.0, 0.0, 0.5 * height_m - half.z);
        add_rectangle(center, normal, glm::cross(up, normal), side % 2 == 0 ? size_m.y : size_m.x, height_m);
    }
}

// A prism about `axis`, and its ends. The corners lie outside the cylinder by the factor that gives the sides together
// its lateral area.
void LuminousBody::add_cylinder(const glm::dvec3& axis, const glm::dvec3& across, const glm::dvec3& size_m) {
    const glm::dvec3 other = glm::cross(axis, across);
    const double length_m = std::abs(glm::dot(size_m, axis));
    const double step = 2.0 * pi / prism_sides;
    const double outside = 0.5 * step / std::sin(0.5 * step);
    const double a = 0.5 * outside * std::abs(glm::dot(size_m, across));
    const double b = 0.5 * outside * std::abs(glm::dot(size_m, other));
    const auto corner = [&](int i) { return a * std::cos(i * step) * across + b * std::sin(i * step) * other; };
    for (int i = 0; i < prism_sides; ++i) {
        const glm::dvec3 edge = corner(i + 1) - corner(i);
        const double width_m = glm::length(edge);
        const glm::dvec3 along = edge / width_m;
        add_rectangle(0.5 * (corner(i) + corner(i + 1)), glm::cross(along, axis), along, width_m, length_m);
    }
    for (const glm::dvec3& end : {axis, -axis})
        add_disk(0.5 * length_m * end, end, across, std::abs(glm::dot(size_m, across)),
                 std::abs(glm::dot(size_m, other)));
}

std::optional<LuminousBody> LuminousBody::of(const Opening& opening, const Web& web) {
    const double flux_lm = flux(web).value;
    if (opening.shape == OpeningShape::point || !(opening.largest_m() > 0.0) || !(flux_lm > 0.0)) return std::nullopt;
    glm::dvec3 size_m = opening.size_m;
    const int flat = flat_axis(opening);
    for (int axis = 0; axis < 3; ++axis)
        if (axis != flat && !(size_m[axis] > 0.0) && !(opening.shape == OpeningShape::box && axis == 2))
            size_m[axis] = 1e-3 * opening.largest_m();
    LuminousBody body;
    if (flat >= 0) {
        glm::dvec3 back(0.0);
        back[flat] = flat == 2 ? 1.0 : -1.0;
        // Width along X where the opening has one.
        const glm::dvec3 along = flat == 0 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
        const double width_m = flat == 0 ? size_m.y : size_m.x;
        const double height_m = flat == 2 ? size_m.y : size_m.z;
        body.flux_behind_ = flux_towards(web, back);
        for (const bool front : {true, false}) {
            const glm::dvec3 normal = front ? -back : back;
            const Lumens flux_there = front ? flux_towards(web, normal) : body.flux_behind_;
            if (!(flux_there.value > 0.0)) continue;
            if (is_round(opening.shape))
                body.add_disk({}, normal, along, width_m, height_m);
            else
                body.add_rectangle({}, normal, along, width_m, height_m);
        }
    } else {
        switch (opening.shape) {
        case OpeningShape::vertical_cylinder:
            body.add_cylinder(up, {1, 0, 0}, size_m);
            break;
        case OpeningShape::ellipsoid:
            body.add_cylinder(up, {1, 0, 0}, {size_m.x, size_m.y, size_m.z * 2.0 / 3.0});
            break;
        case OpeningShape::horizontal_cylinder: // along the length, which LM-63 measures along C0
            body.add_cylinder({1, 0, 0}, up, size_m);
            break;
        case OpeningShape::horizontal_cylinder_across:
            body.add_cylinder({0, 1, 0}, up, size_m);
            break;
        case OpeningShape::sphere: {
            const double radius_m = 0.5 * size_m.x;
            body.add(SphereShape{Meters(radius_m)}, Frame{}, 4.0 * pi * radius_m * radius_m);
            break;
        }
        default:
            body.add_box(size_m, opening.side_heights_m, flux_towards(web, up).value > 0.0);
            break;
        }
    }
    for (const LuminousFace& face : body.faces_)
        body.area_m2_ += face.area_m2;
    if (!(body.area_m2_ > 0.0)) return std::nullopt;
    if (flat >= 0) body.flat_area_m2_ = body.faces_.front().area_m2;
    body.mean_luminance_ = Nits(flux_lm / (pi * body.area_m2_));
    return body;
}

double LuminousBody::projected_area_m2(const glm::dvec3& direction) const {
    double sum = 0.0;
    for (const LuminousFace& face : faces_)
        sum += face.is_flat ? face.area_m2 * std::max(glm::dot(face.normal, direction), 0.0)
                            : 0.25 * face.area_m2 * glm::length(direction);
    return sum / glm::length(direction);
}

} // namespace gonio
