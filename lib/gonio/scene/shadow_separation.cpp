#include <gonio/scene/core_vector.hpp>
#include <gonio/scene/shadow_separation.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <variant>

namespace gonio::detail {

namespace {

// On the way from `center` to `point`, at most `radius` away.
glm::dvec3 within(const glm::dvec3& center, double radius, const glm::dvec3& point) {
    const glm::dvec3 off = point - center;
    const double distance = glm::length(off);
    return distance > radius ? center + radius / distance * off : point;
}

// The point of a solid or surface that is nearest to another; that point itself inside.
struct NearestOfBody {
    const glm::dvec3& point;

    glm::dvec3 operator()(const Plane& plane) const {
        return point - glm::dot(point - plane.point, plane.normal) * plane.normal;
    }
    glm::dvec3 operator()(const Panel& panel) const {
        return in_box(panel.frame, {0.5 * panel.width, 0.5 * panel.height, 0.0});
    }
    glm::dvec3 operator()(const Ball& ball) const { return within(ball.center, ball.radius, point); }
    glm::dvec3 operator()(const Box& box) const { return in_box(box.frame, box.half_size); }
    glm::dvec3 operator()(const Capsule& capsule) const {
        const double along =
            std::clamp(glm::dot(point - capsule.center, capsule.axis), -capsule.half_length, capsule.half_length);
        return within(capsule.center + along * capsule.axis, capsule.radius, point);
    }

private:
    glm::dvec3 in_box(const Frame& frame, const glm::dvec3& half_size) const {
        return frame.origin + frame.to_world(glm::clamp(frame.to_local(point - frame.origin), -half_size, half_size));
    }
};

// A light as a convex set.
class LightSet {
public:
    explicit LightSet(const LinedLight& light)
        : kind_(light.kind),
          center_(vector(kind_ == LinedLight::Kind::none ? light.around : light.center)),
          x_(vector(light.x)),
          y_(vector(light.y)),
          z_(vector(light.z)),
          half_x_(light.half_size[0]),
          half_y_(light.half_size[1]),
          radius_(kind_ == LinedLight::Kind::none ? light.around_radius : light.radius) {}

    const glm::dvec3& center() const { return center_; }

    glm::dvec3 nearest(const glm::dvec3& point) const {
        const glm::dvec3 off = point - center_;
        switch (kind_) {
        case LinedLight::Kind::none:
        case LinedLight::Kind::ball:
            return within(center_, radius_, point);
        case LinedLight::Kind::tube:
            return within(center_ + along(off) * x_, radius_, point);
        case LinedLight::Kind::disk:
            return within(center_, radius_, point - glm::dot(off, z_) * z_);
        case LinedLight::Kind::ellipse: // within its rectangle
        case LinedLight::Kind::rectangle:
            return center_ + along(off) * x_ + std::clamp(glm::dot(off, y_), -half_y_, half_y_) * y_;
        case LinedLight::Kind::cylinder:
            break;
        }
        const double beyond = along(off) - glm::dot(off, x_);
        return within(center_ + along(off) * x_, radius_, point + beyond * x_);
    }

    // The least of the products of a vector with the light's points from its centre.
    double least(const glm::dvec3& n) const {
        const double along_x = std::abs(glm::dot(n, x_));
        switch (kind_) {
        case LinedLight::Kind::none:
        case LinedLight::Kind::ball:
            return -radius_ * glm::length(n);
        case LinedLight::Kind::tube:
            return -half_x_ * along_x - radius_ * glm::length(n);
        case LinedLight::Kind::disk:
            return -radius_ * glm::length(n - glm::dot(n, z_) * z_);
        case LinedLight::Kind::ellipse:
        case LinedLight::Kind::rectangle:
            return -half_x_ * along_x - half_y_ * std::abs(glm::dot(n, y_));
        case LinedLight::Kind::cylinder:
            break;
        }
        return -half_x_ * along_x - radius_ * glm::length(n - glm::dot(n, x_) * x_);
    }

private:
    static glm::dvec3 vector(const double (&v)[3]) { return {v[0], v[1], v[2]}; }
    double along(const glm::dvec3& off) const { return std::clamp(glm::dot(off, x_), -half_x_, half_x_); }

    LinedLight::Kind kind_;
    glm::dvec3 center_, x_, y_, z_;
    double half_x_, half_y_;
    double radius_;
};

} // namespace

// The nearest point of each to that of the other, in turn (W. Cheney and A. Goldstein, "Proximity maps for convex
// sets", Proc. AMS 10, 1959). The body is on one side of the plane across the way from its nearest point in each step;
// the first plane that has the light on the other side is enough.
std::optional<Separation> separation(const Primitive& body, const LinedLight& light) {
    constexpr int steps = 24;
    const LightSet set(light);
    glm::dvec3 of_light = set.center();
    for (int i = 0; i < steps; ++i) {
        const glm::dvec3 of_body = std::visit(NearestOfBody{of_light}, body);
        const glm::dvec3 way = of_light - of_body;
        const double gap = glm::dot(set.center() - of_body, way) + set.least(way); // times the length of the way
        const double touching = touching_share * (1.0 + glm::length(of_body));
        if (gap > touching * glm::length(way)) return Separation{of_body, way};
        of_light = set.nearest(of_body);
    }
    return std::nullopt;
}

} // namespace gonio::detail
