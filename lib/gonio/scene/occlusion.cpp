#include <gonio/base/frame.hpp>
#include <gonio/scene/detail/cap.hpp>
#include <gonio/scene/detail/touching.hpp>
#include <gonio/scene/occlusion.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace gonio {

namespace {

using detail::angle_between;
using detail::cap_area;

constexpr double pi = std::numbers::pi;

double safe_acos(double x) {
    return std::acos(std::clamp(x, -1.0, 1.0));
}

double cross(const glm::dvec2& p, const glm::dvec2& q) {
    return p.x * q.y - p.y * q.x;
}

// Corners of a convex outline, relative to the receiver.
class Outline {
public:
    void add(const glm::dvec3& corner) { corners_[count_++] = corner; }
    void clear() { count_ = 0; }
    std::span<const glm::dvec3> corners() const { return {corners_.data(), count_}; }

    // Each of the two planes that cut a convex outline adds one corner; the largest outline before that is a capsule's.
    static constexpr std::size_t most = 28;

private:
    std::array<glm::dvec3, most> corners_{};
    std::size_t count_ = 0;
};

// The outline of a capsule as corners relative to the receiver, which is the origin and outside it; empty where one end
// hides the other. Follows the outline of a tube light (irradiance of area lights, exact forms).
class CapsuleOutline {
public:
    static constexpr int chords = 12; // of each round end

    explicit CapsuleOutline(const Capsule& capsule, const glm::dvec3& point) : radius_(capsule.radius) {
        const glm::dvec3 to_center = capsule.center - point;
        const glm::dvec3& a = capsule.axis;
        const double z = glm::dot(to_center, a);
        const glm::dvec3 perpendicular = to_center - z * a;
        const double distance = glm::length(perpendicular);
        const double s = capsule.radius / distance;
        if (!(s < 1.0)) return;
        const double kappa = std::sqrt((1.0 - s) * (1.0 + s));
        const glm::dvec3 f = perpendicular / distance;
        const glm::dvec3 g = glm::cross(a, f);
        const double z1 = z + capsule.half_length;
        const double z0 = z - capsule.half_length;
        const double d1 = std::hypot(distance, z1);
        const double d0 = std::hypot(distance, z0);
        round_end(distance * f + z1 * a, (distance * a - z1 * f) / d1, -g, std::atan2(d1 * kappa, s * z1));
        round_end(distance * f + z0 * a, (z0 * f - distance * a) / d0, g, std::atan2(d0 * kappa, -s * z0));
    }

    std::span<const glm::dvec3> corners() const { return outline_.corners(); }

private:
    static_assert(2 * (chords + 1) + 2 <= Outline::most);

    // Where the receiver's tangents touch the sphere at an end, over the half angle `half` around u. The corners
    // between the first and the last are moved outwards so far that the chords enclose the area of the arc.
    void round_end(const glm::dvec3& center, const glm::dvec3& u, const glm::dvec3& v, double half) {
        const double d2 = glm::dot(center, center);
        const double towards = radius_ * radius_ / d2;
        const double across = radius_ * std::sqrt(std::max(1.0 - towards, 0.0));
        const double step = 2.0 * half / chords;
        const double sharp = std::sqrt(step / std::sin(step));
        for (int i = 0; i <= chords; ++i) {
            const double phi = -half + i * step;
            const double out = i == 0 || i == chords ? across : across * sharp;
            outline_.add((1.0 - towards) * center + out * (std::cos(phi) * u + std::sin(phi) * v));
        }
    }

    double radius_;
    Outline outline_;
};

// A light as a receiver sees it.
class SeenLight {
public:
    SeenLight(const glm::dvec3& point, const glm::dvec3& direction, double distance, double angle)
        : point_(point),
          direction_(direction),
          distance_(distance),
          angle_(angle),
          sine_(std::sin(angle)),
          area_(cap_area(angle)),
          tangent_(std::tan(angle)) {
        if (has_extent()) frame_ = aimed_frame(point, -direction, {0.0, 0.0, 1.0});
    }

    const glm::dvec3& point() const { return point_; }
    const glm::dvec3& direction() const { return direction_; }
    double distance() const { return distance_; }
    bool has_extent() const { return area_ > 0.0; }
    // The light's own radius, for distances to planes and faces.
    double radius() const { return std::isfinite(distance_) ? distance_ * sine_ : 0.0; }
    double sine() const { return sine_; }

    // Whether a sphere reaches into the cone from the receiver to the light; may return true when in doubt.
    bool may_be_met_by(const Ball& ball) const {
        const glm::dvec3 to_ball = ball.center - point();
        const double along = glm::dot(to_ball, direction());
        if (along < -ball.radius || along > distance_ + ball.radius) return false;
        const double reach = std::max(along, 0.0) * tangent_ + ball.radius * std::sqrt(1.0 + tangent_ * tangent_);
        return glm::dot(to_ball, to_ball) - along * along <= reach * reach;
    }

    // The share that a sphere covers. Only the part of the sphere nearer than the light counts; that part ends where
    // the sphere about the receiver with the light's distance as radius cuts it.
    double covered_by(const Ball& ball) const {
        const glm::dvec3 to_ball = ball.center - point();
        const double ball_distance = glm::length(to_ball);
        if (!(ball_distance > ball.radius) || ball_distance - ball.radius >= distance_) return 0.0; // touching is not
        double angle = std::asin(ball.radius / ball_distance);
        if (std::isfinite(distance_) && distance_ < ball_distance * std::cos(angle))
            angle = safe_acos((ball_distance * ball_distance + distance_ * distance_ - ball.radius * ball.radius) /
                              (2.0 * ball_distance * distance_));
        return cap_overlap(angle_, angle, angle_between(direction(), to_ball)) / area_;
    }

    // The share that a flat or convex outline covers, with its corners relative to the receiver.
    double covered_by(std::span<const glm::dvec3> outline) const {
        constexpr double nearest = 1e-6; // of the light's distance or of 1 m: objects close to the receiver
        Outline local;
        for (const glm::dvec3& corner : outline)
            local.add(frame_.to_local(corner));
        local = clipped(local, 1.0, nearest * (std::isfinite(distance_) ? distance_ : 1.0));
        if (std::isfinite(distance_)) local = clipped(local, -1.0, -distance_);
        std::array<glm::dvec2, Outline::most> projected{};
        std::size_t count = 0;
        for (const glm::dvec3& corner : local.corners())
            projected[count++] = {corner.x / corner.z, corner.y / corner.z};
        return polygon_overlap(angle_, {projected.data(), count}) / area_;
    }

private:
    // The part of an outline with sign·z ≥ least.
    static Outline clipped(const Outline& outline, double sign, double least) {
        const std::span<const glm::dvec3> corners = outline.corners();
        Outline kept;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::dvec3& from = corners[i];
            const glm::dvec3& to = corners[i + 1 < corners.size() ? i + 1 : 0];
            const double above_from = sign * from.z - least;
            const double above_to = sign * to.z - least;
            if (above_from >= 0.0) kept.add(from);
            if ((above_from >= 0.0) != (above_to >= 0.0))
                kept.add(glm::mix(from, to, above_from / (above_from - above_to)));
        }
        return kept;
    }

    glm::dvec3 point_;
    glm::dvec3 direction_;
    Frame frame_; // Z towards the light, if it has an extent
    double distance_;
    double angle_;
    double sine_;
    double area_;
    double tangent_;
};

// The share of a light that a primitive covers.
struct Covered {
    const SeenLight& light;

    double operator()(const Plane& plane) const {
        const double receiver = glm::dot(light.point() - plane.point, plane.normal);
        if (std::abs(receiver) <= detail::touching(light.point())) return 0.0;
        const double side = receiver < 0.0 ? -1.0 : 1.0;
        const double slope = side * glm::dot(light.direction(), plane.normal);
        if (!std::isfinite(light.distance())) return slope < 0.0 ? 1.0 : 0.0;
        // In light radii, > 0 on the receiver's side.
        const double height = std::abs(receiver) + slope * light.distance();
        const double radius = light.radius();
        if (height >= radius) return 0.0;
        if (height <= -radius) return 1.0;
        const double x = height / radius;
        return (std::acos(x) - x * std::sqrt((1.0 - x) * (1.0 + x))) / pi;
    }

    double operator()(const Panel& panel) const {
        const double receiver = glm::dot(light.point() - panel.frame.origin, panel.frame.z);
        if (std::abs(receiver) <= detail::touching(light.point())) return 0.0;
        const double side = receiver < 0.0 ? -1.0 : 1.0;
        const double slope = side * glm::dot(light.direction(), panel.frame.z);
        if (std::isfinite(light.distance()) && std::abs(receiver) + slope * light.distance() >= light.radius())
            return 0.0;
        if (!light.has_extent()) return meets_either_side(panel) ? 1.0 : 0.0;
        return polygon(panel);
    }

    double operator()(const Ball& ball) const { return light.has_extent() ? light.covered_by(ball) : solid(ball); }

    double operator()(const Box& box) const {
        // The box cannot be in between if one of its faces has both the receiver and the light in front of it.
        const glm::dvec3 receiver = box.frame.to_local(light.point() - box.frame.origin);
        const glm::dvec3 direction = box.frame.to_local(light.direction());
        for (int axis = 0; axis < 3; ++axis) {
            const double side = receiver[axis] < 0.0 ? -1.0 : 1.0;
            if (side * receiver[axis] < box.half_size[axis]) continue;
            if (std::isfinite(light.distance())) {
                const double center = side * (receiver[axis] + direction[axis] * light.distance());
                if (center - light.radius() >= box.half_size[axis]) return 0.0;
            } else if (side * direction[axis] >= light.sine()) {
                return 0.0;
            }
        }
        if (!light.has_extent()) return solid(box);
        double covered = 0.0;
        for (int axis = 0; axis < 3; ++axis)
            if (std::abs(receiver[axis]) > box.half_size[axis])
                covered += polygon(face(box, 2 * axis + (receiver[axis] < 0.0 ? 1 : 0)));
        return covered;
    }

    double operator()(const Capsule& capsule) const {
        if (!light.has_extent()) return solid(capsule);
        const CapsuleOutline outline(capsule, light.point());
        if (!outline.corners().empty()) return light.covered_by(outline.corners());
        // The receiver looks along the axis: only the nearer end is visible.
        const double along = glm::dot(light.point() - capsule.center, capsule.axis);
        const double end = std::copysign(capsule.half_length, along);
        return light.covered_by(Ball{capsule.center + end * capsule.axis, capsule.radius});
    }

private:
    template<class Solid>
    double solid(const Solid& body) const {
        const auto t = distance_to(body, Ray{light.point(), light.direction()});
        return t && *t < light.distance() ? 1.0 : 0.0;
    }

    bool meets_either_side(Panel panel) const {
        const Ray ray{light.point(), light.direction()};
        if (glm::dot(ray.direction, panel.frame.z) > 0.0) panel.frame.z = -panel.frame.z;
        const auto t = distance_to(panel, ray);
        return t && *t < light.distance();
    }

    double polygon(const Panel& panel) const {
        std::array<glm::dvec3, 4> outline = corners(panel);
        for (glm::dvec3& corner : outline)
            corner -= light.point();
        return light.covered_by(outline);
    }
};

// Whether two spheres are on the same side of one of an object's planes, so that no part of the object is between them.
struct Parted {
    const Ball& points;
    const Ball& light;

    bool operator()(const Plane& plane) const { return both_beyond(plane.normal, plane.point, 0.0); }
    bool operator()(const Panel& panel) const { return both_beyond(panel.frame.z, panel.frame.origin, 0.0); }
    bool operator()(const Box& box) const {
        return both_beyond(box.frame.x, box.frame.origin, box.half_size.x) ||
               both_beyond(box.frame.y, box.frame.origin, box.half_size.y) ||
               both_beyond(box.frame.z, box.frame.origin, box.half_size.z);
    }
    template<class Round>
    bool operator()(const Round& /*has no planes*/) const {
        return false;
    }

private:
    bool both_beyond(const glm::dvec3& normal, const glm::dvec3& middle, double half) const {
        const double of_points = glm::dot(points.center - middle, normal);
        const double of_light = glm::dot(light.center - middle, normal);
        const double side = of_points < 0.0 ? -1.0 : 1.0;
        return side * of_points - points.radius >= half - detail::touching(points.center) &&
               side * of_light - light.radius >= half;
    }
};

// The greatest of n·p over the points p of an object.
struct GreatestAlong {
    const glm::dvec3& n;

    double operator()(const Plane& plane) const {
        return plane.normal == n ? glm::dot(n, plane.point) : std::numeric_limits<double>::infinity();
    }
    double operator()(const Panel& panel) const {
        return glm::dot(n, panel.frame.origin) + 0.5 * panel.width * std::abs(glm::dot(n, panel.frame.x)) +
               0.5 * panel.height * std::abs(glm::dot(n, panel.frame.y));
    }
    double operator()(const Ball& ball) const { return glm::dot(n, ball.center) + ball.radius; }
    double operator()(const Box& box) const {
        const glm::dvec3 along = glm::abs(box.frame.to_local(n));
        return glm::dot(n, box.frame.origin) + glm::dot(along, box.half_size);
    }
    double operator()(const Capsule& capsule) const {
        return glm::dot(n, capsule.center) + capsule.half_length * std::abs(glm::dot(n, capsule.axis)) + capsule.radius;
    }
};

// Whether a primitive is on the path of a ray; one-sided surfaces stop it from both sides.
struct Stops {
    const Ray& ray;
    double distance;

    bool operator()(const Plane& plane) const {
        const double height = glm::dot(ray.origin - plane.point, plane.normal);
        if (std::abs(height) <= detail::touching(ray.origin)) return false;
        return reaches(distance_to(height > 0.0 ? plane : Plane{plane.point, -plane.normal}, ray));
    }
    bool operator()(const Panel& panel) const {
        const double height = glm::dot(ray.origin - panel.frame.origin, panel.frame.z);
        if (std::abs(height) <= detail::touching(ray.origin)) return false;
        if (height > 0.0) return reaches(distance_to(panel, ray));
        Panel back = panel;
        back.frame.z = -back.frame.z;
        return reaches(distance_to(back, ray));
    }
    template<class Solid>
    bool operator()(const Solid& solid) const {
        return reaches(distance_to(solid, ray));
    }

private:
    bool reaches(const std::optional<double>& hit) const { return hit && *hit < distance; }
};

double free_share(const Stage& stage, std::size_t own, const SeenLight& light, std::size_t emitter = no_surface) {
    double share = 1.0;
    for (std::size_t i = 0; i < stage.surfaces.size() && share > 0.0; ++i) {
        if (i == own || i == emitter) continue;
        const Primitive& primitive = stage.surfaces[i].geometry;
        const std::optional<Ball> around = bounds(primitive);
        if (around && !light.may_be_met_by(*around)) continue;
        share *= 1.0 - std::clamp(std::visit(Covered{light}, primitive), 0.0, 1.0);
    }
    // Otherwise the rounding error of a covered light would count as lit.
    return share > 1e-12 ? share : 0.0;
}

} // namespace

bool is_hidden(const Stage& stage, std::size_t own, const glm::dvec3& point, const glm::dvec3& direction,
               double distance, std::size_t emitter) {
    const Ray ray{point, direction};
    for (std::size_t i = 0; i < stage.surfaces.size(); ++i)
        if (i != own && i != emitter && stops(stage.surfaces[i].geometry, ray, distance)) return true;
    return false;
}

bool stops(const Primitive& body, const Ray& ray, double distance) {
    return std::visit(Stops{ray, distance}, body);
}

bool may_stand_between(const Primitive& body, const Ball& points, const Ball& light) {
    if (std::visit(Parted{points, light}, body)) return false;
    const std::optional<Ball> around = bounds(body);
    if (!around) return true;
    // All paths lie within the hull of the two spheres.
    const glm::dvec3 way = light.center - points.center;
    const double length2 = glm::dot(way, way);
    const glm::dvec3 to_body = around->center - points.center;
    const double along = length2 > 0.0 ? std::clamp(glm::dot(to_body, way) / length2, 0.0, 1.0) : 0.0;
    // The hull is a cone if the spheres differ: at most as wide as its wider end and, where it is slender, as its
    // middle.
    const double widening = std::abs(light.radius - points.radius);
    double width = std::max(light.radius, points.radius);
    if (widening * widening < 0.01 * length2)
        width = 1.01 * glm::mix(points.radius, light.radius, along) + 0.01 * around->radius;
    const double near = (around->radius + width) * (1.0 + 1e-6);
    const glm::dvec3 apart = to_body - along * way;
    return glm::dot(apart, apart) <= near * near;
}

bool is_behind(const Primitive& body, const Light& light, const Ball& points) {
    if (!is_flat(light.shape)) return false;
    const double height = glm::dot(points.center - light.frame.origin, light.frame.z);
    if (!(std::abs(height) >= points.radius)) return false;
    const glm::dvec3 towards_points = height < 0.0 ? -light.frame.z : light.frame.z;
    return std::visit(GreatestAlong{towards_points}, body) <= glm::dot(towards_points, light.frame.origin);
}

double polygon_overlap(double a, std::span<const glm::dvec2> corners) {
    const double area = cap_area(a);
    const double tangent = std::tan(a);
    const auto sector = [&](const glm::dvec2& p, const glm::dvec2& q) {
        return area / (2.0 * pi) * std::atan2(cross(p, q), glm::dot(p, q));
    };
    const auto triangle = [](const glm::dvec2& p, const glm::dvec2& q) {
        const double length_p = std::sqrt(1.0 + glm::dot(p, p));
        const double length_q = std::sqrt(1.0 + glm::dot(q, q));
        return 2.0 * std::atan2(cross(p, q), length_p * length_q + length_p + length_q + 1.0 + glm::dot(p, q));
    };
    double sum = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2& p = corners[i];
        const glm::dvec2& q = corners[(i + 1) % corners.size()];
        // The part of p + s (q − p) in the cap: between the roots of |p + s (q − p)|² = tan² a.
        const glm::dvec2 along = q - p;
        const double length2 = glm::dot(along, along);
        if (!(length2 > 0.0)) continue;
        const double middle = -glm::dot(p, along) / length2;
        const glm::dvec2 nearest = p + middle * along;
        const double half2 = (tangent * tangent - glm::dot(nearest, nearest)) / length2;
        const double half = half2 > 0.0 ? std::sqrt(half2) : 0.0;
        const double entry = std::clamp(middle - half, 0.0, 1.0);
        const double exit = std::clamp(middle + half, 0.0, 1.0);
        if (!(entry < exit)) {
            sum += sector(p, q);
            continue;
        }
        const glm::dvec2 from = entry > 0.0 ? p + entry * along : p;
        const glm::dvec2 to = exit < 1.0 ? p + exit * along : q;
        if (entry > 0.0) sum += sector(p, from);
        sum += triangle(from, to);
        if (exit < 1.0) sum += sector(to, q);
    }
    return std::min(std::abs(sum), area);
}

double visible_share(const Stage& stage, std::size_t own, const glm::dvec3& point, const glm::dvec3& light_center,
                     double light_radius, std::size_t emitter) {
    const glm::dvec3 to_light = light_center - point;
    const double distance = glm::length(to_light);
    if (!(distance > light_radius)) return 1.0;
    // Lights below 1e-7 rad have no visible penumbra.
    const double sine = light_radius / distance;
    const SeenLight light(point, to_light / distance, distance, sine > 1e-7 ? std::asin(sine) : 0.0);
    return free_share(stage, own, light, emitter);
}

double visible_share_of_sun(const Stage& stage, std::size_t own, const glm::dvec3& point, const glm::dvec3& towards,
                            double half_angle) {
    const SeenLight light(point, towards, std::numeric_limits<double>::infinity(),
                          half_angle > 1e-7 ? half_angle : 0.0);
    return free_share(stage, own, light);
}

} // namespace gonio
