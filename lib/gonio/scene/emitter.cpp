#include <gonio/light/shape_traits.hpp>
#include <gonio/scene/emitter.hpp>
#include <gonio/scene/outline_points.hpp>
#include <gonio/scene/primitives.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gonio {

namespace {

// Where a ray crosses the plane of a flat light, in the light's X and Y; nothing from the dark side.
struct Crossing {
    double distance;
    double x;
    double y;
};

std::optional<Crossing> cross_plane(const Frame& frame, const Ray& ray, bool two_sided) {
    // The light emits along −Z, so rays that go along +Z see its face.
    const double facing = glm::dot(ray.direction, frame.z);
    if (facing == 0.0 || (facing < 0.0 && !two_sided)) return std::nullopt;
    const double t = glm::dot(frame.origin - ray.origin, frame.z) / facing;
    if (!(t > 0.0)) return std::nullopt;
    const glm::dvec3 at = ray.origin + t * ray.direction - frame.origin;
    return Crossing{t, glm::dot(at, frame.x), glm::dot(at, frame.y)};
}

struct Distance {
    const Light& light;
    const Ray& ray;

    std::optional<double> operator()(const SphereShape& sphere) const {
        return distance_to(Ball{light.frame.origin, sphere.radius.value}, ray);
    }
    std::optional<double> operator()(const DiskShape& disk) const {
        const auto at = cross_plane(light.frame, ray, disk.two_sided);
        const bool inside = at && std::hypot(at->x, at->y) <= disk.radius.value;
        return inside ? std::optional(at->distance) : std::nullopt;
    }
    std::optional<double> operator()(const EllipseShape& ellipse) const {
        const auto at = cross_plane(light.frame, ray, ellipse.two_sided);
        const bool inside =
            at && std::hypot(at->x / (0.5 * ellipse.width.value), at->y / (0.5 * ellipse.height.value)) <= 1.0;
        return inside ? std::optional(at->distance) : std::nullopt;
    }
    std::optional<double> operator()(const RectShape& rect) const {
        const auto at = cross_plane(light.frame, ray, rect.two_sided);
        const bool inside =
            at && std::abs(at->x) <= 0.5 * rect.width.value && std::abs(at->y) <= 0.5 * rect.height.value;
        return inside ? std::optional(at->distance) : std::nullopt;
    }
    std::optional<double> operator()(const TubeShape& tube) const {
        return distance_to(Capsule{light.frame.origin, light.frame.x, 0.5 * tube.length.value, tube.radius.value}, ray);
    }
    // Rays that come from outside; from its ends and its inside it is not there.
    std::optional<double> operator()(const CylinderShape& cylinder) const {
        const glm::dvec3& a = light.frame.x;
        const glm::dvec3 from = ray.origin - light.frame.origin;
        const double along = glm::dot(from, a);
        const double speed = glm::dot(ray.direction, a);
        const glm::dvec3 across = from - along * a;
        const glm::dvec3 heading = ray.direction - speed * a;
        const double speed2 = glm::dot(heading, heading);
        const double distance = glm::length(across);
        const double toward = -glm::dot(across, heading);
        if (!(distance > cylinder.radius.value) || !(toward > 0.0)) return std::nullopt;
        // Of the axis line, squared, times speed2.
        const glm::dvec3 turned = glm::cross(across, heading);
        const double under_root = cylinder.radius.value * cylinder.radius.value * speed2 - glm::dot(turned, turned);
        if (!(under_root >= 0.0)) return std::nullopt;
        const double gap2 = (distance - cylinder.radius.value) * (distance + cylinder.radius.value);
        const double t = gap2 / (toward + std::sqrt(under_root));
        const bool hits = t > 0.0 && std::abs(along + t * speed) <= 0.5 * cylinder.length.value;
        return hits ? std::optional(t) : std::nullopt;
    }
    std::optional<double> operator()(const SunShape& /*no surface at a finite distance*/) const { return std::nullopt; }
    template<PunctualShape Kind>
    std::optional<double> operator()(const Kind& /*no surface*/) const {
        return std::nullopt;
    }
};

struct Reach {
    const Frame& frame;
    const glm::dvec3& direction;

    double operator()(const SphereShape& sphere) const { return sphere.radius.value; }
    double operator()(const DiskShape& disk) const {
        return disk.radius.value * glm::length(glm::cross(frame.z, direction));
    }
    double operator()(const EllipseShape& ellipse) const {
        return std::hypot(0.5 * ellipse.width.value * glm::dot(frame.x, direction),
                          0.5 * ellipse.height.value * glm::dot(frame.y, direction));
    }
    double operator()(const RectShape& rect) const {
        return 0.5 * rect.width.value * std::abs(glm::dot(frame.x, direction)) +
               0.5 * rect.height.value * std::abs(glm::dot(frame.y, direction));
    }
    double operator()(const TubeShape& tube) const {
        return 0.5 * tube.length.value * std::abs(glm::dot(frame.x, direction)) + tube.radius.value;
    }
    double operator()(const CylinderShape& cylinder) const {
        return 0.5 * cylinder.length.value * std::abs(glm::dot(frame.x, direction)) +
               cylinder.radius.value * glm::length(glm::cross(frame.x, direction));
    }
    double operator()(const SunShape& /*no surface at a finite distance*/) const { return 0.0; }
    template<PunctualShape Kind>
    double operator()(const Kind& /*no surface*/) const {
        return 0.0;
    }
};

using Points = std::vector<glm::dvec3>;

struct Outline {
    const Frame& frame;
    const glm::dvec3& eye;

    Points operator()(const SphereShape& sphere) const {
        return outline_points(Ball{frame.origin, sphere.radius.value}, eye);
    }
    Points operator()(const DiskShape& disk) const {
        return ellipse_outline(frame.origin, disk.radius.value * frame.x, disk.radius.value * frame.y);
    }
    Points operator()(const EllipseShape& ellipse) const {
        return ellipse_outline(frame.origin, 0.5 * ellipse.width.value * frame.x, 0.5 * ellipse.height.value * frame.y);
    }
    Points operator()(const RectShape& rect) const {
        return outline_points(Panel{frame, rect.width.value, rect.height.value}, eye);
    }
    Points operator()(const TubeShape& tube) const {
        return outline_points(Capsule{frame.origin, frame.x, 0.5 * tube.length.value, tube.radius.value}, eye);
    }
    Points operator()(const CylinderShape& cylinder) const {
        return cylinder_outline(frame.origin, 0.5 * cylinder.length.value * frame.x, cylinder.radius.value, eye);
    }
    Points operator()(const SunShape& /*no surface at a finite distance*/) const { return {}; }
    template<PunctualShape Kind>
    Points operator()(const Kind& /*no surface*/) const {
        return {};
    }
};

} // namespace

std::vector<glm::dvec3> outline_points(const Light& light, const glm::dvec3& eye) {
    if (light.parts == nullptr) return std::visit(Outline{light.frame, eye}, light.shape);
    Points all;
    for (const Light& face : *light.parts) {
        const Points points = outline_points(face, eye);
        all.insert(all.end(), points.begin(), points.end());
    }
    return all;
}

double reach_along(const Light& light, const glm::dvec3& direction) {
    if (light.parts != nullptr) {
        double most = 0.0;
        for (const Light& face : *light.parts) {
            const double from = glm::dot(face.frame.origin - light.frame.origin, direction) / glm::length(direction);
            most = std::max(most, from + reach_along(face, direction));
        }
        return most;
    }
    return std::visit(Reach{light.frame, direction}, light.shape);
}

std::optional<double> distance_to(const Light& light, const Ray& ray) {
    if (light.parts != nullptr) {
        std::optional<double> nearest;
        for (const Light& face : *light.parts) {
            const std::optional<double> distance = distance_to(face, ray);
            if (distance && !(nearest && *nearest <= *distance)) nearest = distance;
        }
        return nearest;
    }
    return std::visit(Distance{light, ray}, light.shape);
}

} // namespace gonio
