#include <gonio/transport/ray_caster.hpp>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <optional>
#include <variant>

namespace gonio::detail {

namespace {

struct Met {
    double distance;
    bool from_behind = false;
};

std::optional<Met> met(const Plane& plane, const Ray& ray) {
    const double facing = glm::dot(ray.direction, plane.normal);
    if (facing == 0.0) return std::nullopt;
    const double t = glm::dot(plane.point - ray.origin, plane.normal) / facing;
    if (!(t > 0.0)) return std::nullopt;
    return Met{t, facing > 0.0};
}

std::optional<Met> met(const Panel& panel, const Ray& ray) {
    const std::optional<Met> at_plane = met(Plane{panel.frame.origin, panel.frame.z}, ray);
    if (!at_plane) return std::nullopt;
    const glm::dvec3 at = ray.origin + at_plane->distance * ray.direction - panel.frame.origin;
    const bool within = std::abs(glm::dot(at, panel.frame.x)) <= 0.5 * panel.width &&
                        std::abs(glm::dot(at, panel.frame.y)) <= 0.5 * panel.height;
    return within ? at_plane : std::nullopt;
}

template<class Solid>
std::optional<Met> met(const Solid& solid, const Ray& ray) {
    const std::optional<double> t = distance_to(solid, ray);
    if (!t) return std::nullopt;
    return Met{*t};
}

} // namespace

RayEnd RayCaster::cast(const Ray& ray, std::size_t own) const {
    RayEnd end;
    end.distance = std::numeric_limits<double>::infinity();
    bool from_behind = false;
    for (std::size_t i = 0; i < stage_.surfaces.size(); ++i) {
        if (i == own) continue;
        const auto found = std::visit([&](const auto& shape) { return met(shape, ray); }, stage_.surfaces[i].geometry);
        if (!found || found->distance >= end.distance) continue;
        end.distance = found->distance;
        end.surface = i;
        from_behind = found->from_behind;
    }
    if (end.surface == RayEnd::nothing) return end;
    if (from_behind) {
        end.surface = RayEnd::nothing;
        return end;
    }
    end.position = ray.origin + end.distance * ray.direction;
    end.face = face_at(stage_.surfaces[end.surface].geometry, end.position);
    return end;
}

} // namespace gonio::detail
