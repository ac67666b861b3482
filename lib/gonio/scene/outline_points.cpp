#include <gonio/base/frame.hpp>
#include <gonio/scene/outline_points.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <variant>

namespace gonio {

namespace {

constexpr int corners_of_circle = 32;
constexpr double corner_rad = 2.0 * std::numbers::pi / corners_of_circle;

// Of a regular polygon with the area of a circle, over that circle's.
double radius_of_same_area() {
    return std::sqrt(corner_rad / std::sin(corner_rad));
}

using Points = std::vector<glm::dvec3>;

const std::array<glm::dvec2, corners_of_circle>& circle() {
    static const std::array<glm::dvec2, corners_of_circle> corners = [] {
        std::array<glm::dvec2, corners_of_circle> made{};
        double angle = 0.0;
        for (glm::dvec2& corner : made) {
            corner = {std::cos(angle), std::sin(angle)};
            angle += corner_rad;
        }
        return made;
    }();
    return corners;
}

// Begins at the end of the half axis `x`.
void add_ellipse(const glm::dvec3& center, const glm::dvec3& x, const glm::dvec3& y, Points& points) {
    points.reserve(points.size() + corners_of_circle);
    for (const glm::dvec2& corner : circle())
        points.push_back(center + corner.x * x + corner.y * y);
}

// The circle on which lines from the eye touch a sphere, which begins at right angles to `axis`; false from inside.
bool add_ball(const Ball& ball, const glm::dvec3& axis, double scale, const glm::dvec3& eye, Points& points) {
    const glm::dvec3 toward = eye - ball.center;
    const double distance2 = glm::dot(toward, toward);
    const double radius2 = ball.radius * ball.radius;
    if (!(distance2 > radius2)) return false;
    const double radius = scale * ball.radius * std::sqrt(1.0 - radius2 / distance2);
    const Frame frame = aimed_frame(ball.center + radius2 / distance2 * toward, toward, axis);
    add_ellipse(frame.origin, radius * frame.x, radius * frame.y, points);
    return true;
}

struct OutlineOf {
    const glm::dvec3& eye;

    Points operator()(const Plane& /*infinite*/) const { return {}; }
    Points operator()(const Panel& panel) const {
        const std::array<glm::dvec3, 4> all = corners(panel);
        return {all.begin(), all.end()};
    }
    Points operator()(const Ball& ball) const {
        Points points;
        add_ball(ball, {0.0, 0.0, 1.0}, radius_of_same_area(), eye, points);
        return points;
    }
    Points operator()(const Box& box) const {
        Points points;
        for (const int index : {4, 5})
            for (const glm::dvec3& corner : corners(face(box, index)))
                points.push_back(corner);
        return points;
    }
    // The hull of the balls at its ends.
    Points operator()(const Capsule& capsule) const {
        Points points;
        for (const double end : {-1.0, 1.0}) {
            const Ball ball{capsule.center + end * capsule.half_length * capsule.axis, capsule.radius};
            if (!add_ball(ball, capsule.axis, 1.0, eye, points)) return {};
        }
        return points;
    }
};

} // namespace

std::vector<glm::dvec3> outline_points(const Primitive& primitive, const glm::dvec3& eye) {
    return std::visit(OutlineOf{eye}, primitive);
}

std::vector<glm::dvec3> ellipse_outline(const glm::dvec3& center, const glm::dvec3& x, const glm::dvec3& y) {
    Points points;
    add_ellipse(center, radius_of_same_area() * x, radius_of_same_area() * y, points);
    return points;
}

std::vector<glm::dvec3> cylinder_outline(const glm::dvec3& center, const glm::dvec3& half_axis, double radius,
                                         const glm::dvec3& eye) {
    const Frame frame = aimed_frame(center, half_axis, eye - center);
    Points points;
    for (const double end : {-1.0, 1.0})
        add_ellipse(center + end * half_axis, radius * frame.x, radius * frame.y, points);
    return points;
}

} // namespace gonio
