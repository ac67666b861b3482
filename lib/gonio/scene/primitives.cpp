#include <gonio/scene/primitives.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gonio {

namespace {

// The closest point of a ray's line to another point, computed from the miss distance and not from b²−4ac: far spheres
// keep their outline.
struct Approach {
    double along;
    double miss2;
};

Approach approach(const glm::dvec3& to_point, const glm::dvec3& direction) {
    const double along = glm::dot(to_point, direction);
    const glm::dvec3 miss = to_point - along * direction;
    return {along, glm::dot(miss, miss)};
}

// Distances along a ray to where it enters a shape; 0 where it does not. In packs: preview/kernels_camera_impl.hpp.

inline double ahead(double t) {
    return t > 0.0 ? t : 0.0;
}

inline double entry(const Plane& plane, const Ray& ray) {
    const double facing = glm::dot(ray.direction, plane.normal);
    if (!(facing < 0.0)) return 0.0;
    return ahead(glm::dot(plane.point - ray.origin, plane.normal) / facing);
}

inline double entry(const Panel& panel, const Ray& ray) {
    const double t = entry(Plane{panel.frame.origin, panel.frame.z}, ray);
    if (t == 0.0) return 0.0;
    const glm::dvec3 at = ray.origin + t * ray.direction - panel.frame.origin;
    const bool within = std::abs(glm::dot(at, panel.frame.x)) <= 0.5 * panel.width &&
                        std::abs(glm::dot(at, panel.frame.y)) <= 0.5 * panel.height;
    return within ? t : 0.0;
}

inline double entry(const Ball& ball, const Ray& ray) {
    const Approach closest = approach(ball.center - ray.origin, ray.direction);
    const double half_chord2 = ball.radius * ball.radius - closest.miss2;
    if (!(half_chord2 >= 0.0)) return 0.0;
    return ahead(closest.along - std::sqrt(half_chord2));
}

inline double entry(const Box& box, const Ray& ray) {
    const glm::dvec3 origin = box.frame.to_local(ray.origin - box.frame.origin);
    const glm::dvec3 direction = box.frame.to_local(ray.direction);
    double entry = -std::numeric_limits<double>::infinity();
    double exit = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0.0) {
            if (!(std::abs(origin[axis]) < box.half_size[axis])) return 0.0;
            continue;
        }
        const double towards = std::copysign(box.half_size[axis], direction[axis]);
        entry = std::max(entry, (-towards - origin[axis]) / direction[axis]);
        exit = std::min(exit, (towards - origin[axis]) / direction[axis]);
    }
    return entry <= exit ? ahead(entry) : 0.0;
}

inline double entry(const Capsule& capsule, const Ray& ray) {
    const glm::dvec3 to_center = capsule.center - ray.origin;
    // Most rays miss most capsules.
    const double reach = capsule.half_length + capsule.radius;
    if (approach(to_center, ray.direction).miss2 > reach * reach) return 0.0;
    const double along_axis = glm::dot(ray.direction, capsule.axis);
    const glm::dvec3 across = ray.direction - along_axis * capsule.axis;
    const double speed2 = glm::dot(across, across);
    // The ray's line enters through the side; otherwise through the end on the side where it enters the infinite
    // cylinder; if it runs along the axis, through the end that it reaches first.
    double end = along_axis < 0.0 ? 1.0 : -1.0;
    if (speed2 > 1e-20) {
        const double closest = glm::dot(to_center, across) / speed2;
        const glm::dvec3 miss = to_center - glm::dot(to_center, capsule.axis) * capsule.axis - closest * across;
        const double half_chord2 = (capsule.radius * capsule.radius - glm::dot(miss, miss)) / speed2;
        if (!(half_chord2 >= 0.0)) return 0.0;
        const double t = closest - std::sqrt(half_chord2);
        const double height = t * along_axis - glm::dot(to_center, capsule.axis);
        if (std::abs(height) <= capsule.half_length) return ahead(t);
        end = height < 0.0 ? -1.0 : 1.0;
    }
    return entry(Ball{capsule.center + end * capsule.half_length * capsule.axis, capsule.radius}, ray);
}

template<class Shape>
std::optional<double> found(const Shape& shape, const Ray& ray) {
    const double t = entry(shape, ray);
    return t > 0.0 ? std::optional(t) : std::nullopt;
}

double outside(const Box& box, const glm::dvec3& local) {
    const glm::dvec3 beyond = glm::abs(local) - box.half_size;
    return std::max({beyond.x, beyond.y, beyond.z});
}

int face_of(const Box& box, const glm::dvec3& point) {
    const glm::dvec3 local = box.frame.to_local(point - box.frame.origin);
    const glm::dvec3 beyond = glm::abs(local) - box.half_size;
    const int side = beyond.x >= beyond.y ? 0 : 1;
    const int axis = beyond[side] >= beyond.z ? side : 2;
    return 2 * axis + (local[axis] < 0.0 ? 1 : 0);
}

// The point of a capsule's axis segment that is nearest to a point.
glm::dvec3 nearest_on_axis(const Capsule& capsule, const glm::dvec3& point) {
    const double along = glm::dot(point - capsule.center, capsule.axis);
    return capsule.center + std::clamp(along, -capsule.half_length, capsule.half_length) * capsule.axis;
}

struct NormalAt {
    const glm::dvec3& point;

    glm::dvec3 operator()(const Plane& plane) const { return plane.normal; }
    glm::dvec3 operator()(const Panel& panel) const { return panel.frame.z; }
    glm::dvec3 operator()(const Ball& ball) const { return glm::normalize(point - ball.center); }
    glm::dvec3 operator()(const Box& box) const { return face(box, face_of(box, point)).frame.z; }
    glm::dvec3 operator()(const Capsule& capsule) const {
        return glm::normalize(point - nearest_on_axis(capsule, point));
    }
};

struct Hides {
    const glm::dvec3& point;

    bool operator()(const Plane& plane) const { return glm::dot(point - plane.point, plane.normal) <= 0.0; }
    bool operator()(const Panel& /*seen through from behind*/) const { return false; }
    bool operator()(const Ball& ball) const { return glm::distance(point, ball.center) < ball.radius; }
    bool operator()(const Box& box) const { return outside(box, box.frame.to_local(point - box.frame.origin)) < 0.0; }
    bool operator()(const Capsule& capsule) const {
        return glm::distance(point, nearest_on_axis(capsule, point)) < capsule.radius;
    }
};

struct Bounds {
    std::optional<Ball> operator()(const Plane& /*endless*/) const { return std::nullopt; }
    std::optional<Ball> operator()(const Panel& panel) const {
        return Ball{panel.frame.origin, 0.5 * std::hypot(panel.width, panel.height)};
    }
    std::optional<Ball> operator()(const Ball& ball) const { return ball; }
    std::optional<Ball> operator()(const Box& box) const { return Ball{box.frame.origin, glm::length(box.half_size)}; }
    std::optional<Ball> operator()(const Capsule& capsule) const {
        return Ball{capsule.center, capsule.half_length + capsule.radius};
    }
};

} // namespace

Capsule capsule_between(const glm::dvec3& from, const glm::dvec3& to, double radius) {
    const double length = glm::distance(from, to);
    return {0.5 * (from + to), (to - from) / length, 0.5 * length, radius};
}

Panel panel_facing(const glm::dvec3& center, const glm::dvec3& normal, const glm::dvec3& up, double width,
                   double height) {
    return {aimed_frame(center, -normal, up), width, height};
}

std::optional<double> distance_to(const Plane& plane, const Ray& ray) {
    return found(plane, ray);
}

std::optional<double> distance_to(const Panel& panel, const Ray& ray) {
    return found(panel, ray);
}

std::optional<double> distance_to(const Ball& ball, const Ray& ray) {
    return found(ball, ray);
}

std::optional<double> distance_to(const Box& box, const Ray& ray) {
    return found(box, ray);
}

std::optional<double> distance_to(const Capsule& capsule, const Ray& ray) {
    return found(capsule, ray);
}

bool is_sheet(const Primitive& primitive) {
    return std::holds_alternative<Plane>(primitive) || std::holds_alternative<Panel>(primitive);
}

int face_at(const Primitive& primitive, const glm::dvec3& on_surface) {
    const auto* const box = std::get_if<Box>(&primitive);
    return box == nullptr ? 0 : face_of(*box, on_surface);
}

glm::dvec3 normal_at(const Primitive& primitive, const glm::dvec3& on_surface) {
    return std::visit(NormalAt{on_surface}, primitive);
}

bool hides(const Primitive& primitive, const glm::dvec3& point) {
    return std::visit(Hides{point}, primitive);
}

std::optional<Ball> bounds(const Primitive& primitive) {
    return std::visit(Bounds{}, primitive);
}

std::array<glm::dvec3, 4> corners(const Panel& panel) {
    const glm::dvec3 x = 0.5 * panel.width * panel.frame.x;
    const glm::dvec3 y = 0.5 * panel.height * panel.frame.y;
    const glm::dvec3& c = panel.frame.origin;
    return {c - x - y, c + x - y, c + x + y, c - x + y};
}

Panel face(const Box& box, int index) {
    const int axis = index / 2;
    const double side = index % 2 == 0 ? 1.0 : -1.0;
    const std::array<glm::dvec3, 3> axes{box.frame.x, box.frame.y, box.frame.z};
    const auto at = [&](int i) { return axes[static_cast<std::size_t>(i % 3)]; };
    // X×Y = Z for each face: the other two axes in their cyclic order, one of them reversed for the negative side.
    return {
        {box.frame.origin + side * box.half_size[axis] * at(axis), side * at(axis + 1), at(axis + 2), side * at(axis)},
        2.0 * box.half_size[(axis + 1) % 3],
        2.0 * box.half_size[(axis + 2) % 3]};
}

} // namespace gonio
