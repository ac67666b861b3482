#include <gonio/transport/chart.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>

namespace gonio::detail {

namespace {

using std::numbers::pi;

// A plane ends where less than this share of the downward light of a point source lies beyond: h/√(h² + R²).
constexpr double far_in_interests = 30.0;
// A side longer than this many interests is divided more coarsely towards its ends.
constexpr double long_in_interests = 8.0;

// Any two directions perpendicular to a normal.
Frame frame_on(const glm::dvec3& origin, const glm::dvec3& normal) {
    Frame frame;
    frame.origin = origin;
    frame.z = normal;
    const glm::dvec3 aside = std::abs(normal.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
    frame.x =
        glm::normalize(std::abs(normal.z) < 0.9 ? glm::cross(aside, normal) : aside - glm::dot(aside, normal) * normal);
    frame.y = glm::cross(normal, frame.x);
    return frame;
}

// A direction along which the edge of another surface may cross a plane.
struct EdgeAlong {
    const glm::dvec3& normal;

    std::optional<glm::dvec3> across(const glm::dvec3& of) const {
        const glm::dvec3 within = of - glm::dot(of, normal) * normal;
        const double length = glm::length(within);
        return length > 1e-3 ? std::optional(within / length) : std::nullopt;
    }
    std::optional<glm::dvec3> operator()(const Plane& plane) const { return across(plane.normal); }
    std::optional<glm::dvec3> operator()(const Panel& panel) const { return across(panel.frame.z); }
    std::optional<glm::dvec3> operator()(const Box& box) const {
        const std::optional<glm::dvec3> along_x = across(box.frame.x);
        return along_x ? along_x : across(box.frame.y);
    }
    template<class Round>
    std::optional<glm::dvec3> operator()(const Round& /*has no straight edge*/) const {
        return std::nullopt;
    }
};

// Its axes are those of the first surface with a straight edge on the plane.
Frame frame_of_plane(const Stage& stage, const glm::dvec3& origin, const glm::dvec3& normal) {
    Frame frame = frame_on(origin, normal);
    for (const Surface& surface : stage.surfaces) {
        const std::optional<glm::dvec3> across = std::visit(EdgeAlong{normal}, surface.geometry);
        if (!across) continue;
        frame.x = *across;
        frame.y = glm::cross(normal, *across);
        break;
    }
    return frame;
}

struct Maker {
    const Stage& stage;
    std::size_t surface;
    const Interest& interest;
    std::vector<Chart>& charts;

    void add_flat(const Frame& frame, double width, double height, int face) const {
        Chart chart;
        chart.surface = surface;
        chart.face = face;
        chart.frame = frame;
        const glm::dvec3 to_center = interest.center - frame.origin;
        const auto side = [&](double length, double middle) {
            return length > long_in_interests * interest.radius
                       ? Range{-0.5 * length, 0.5 * length, std::clamp(middle, -0.5 * length, 0.5 * length),
                               interest.radius}
                       : Range{-0.5 * length, 0.5 * length, 0.0, 0.0};
        };
        chart.u = side(width, glm::dot(to_center, frame.x));
        chart.v = side(height, glm::dot(to_center, frame.y));
        charts.push_back(chart);
    }

    void operator()(const Plane& plane) const {
        Chart chart;
        chart.surface = surface;
        const double height = glm::dot(interest.center - plane.point, plane.normal);
        chart.frame = frame_of_plane(stage, interest.center - height * plane.normal, plane.normal);
        const double core = std::max(interest.radius, std::abs(height));
        const double far = far_in_interests * core;
        chart.u = chart.v = {-far, far, 0.0, core};
        chart.endless = true;
        charts.push_back(chart);
    }
    void operator()(const Panel& panel) const { add_flat(panel.frame, panel.width, panel.height, 0); }
    void operator()(const Box& box) const {
        for (int i = 0; i < 6; ++i) {
            const Panel side = face(box, i);
            add_flat(side.frame, side.width, side.height, i);
        }
    }
    void add_round(const glm::dvec3& center, const glm::dvec3& axis, double half_length, double radius) const {
        Chart chart;
        chart.surface = surface;
        chart.kind = Chart::Kind::round;
        chart.frame = frame_on(center, axis);
        chart.half_length = half_length;
        chart.radius = radius;
        chart.u = {0.0, 2.0 * pi, 0.0, 0.0};
        chart.v = {0.0, pi * radius + 2.0 * half_length, 0.0, 0.0};
        charts.push_back(chart);
    }
    void operator()(const Ball& ball) const { add_round(ball.center, {0.0, 0.0, 1.0}, 0.0, ball.radius); }
    void operator()(const Capsule& capsule) const {
        add_round(capsule.center, capsule.axis, capsule.half_length, capsule.radius);
    }
};

// From [−π, π] to [0, 2π).
double unwrapped(double azimuth) {
    return azimuth < 0.0 ? azimuth + 2.0 * pi : azimuth;
}

// A point of the outline of a capsule: its distance from the axis, its height along it, and the sine of the slope of
// its normal.
struct Outline {
    double out;
    double along;
    double rise; // of the normal along the axis
};

Outline outline_at(const Chart& chart, double arc) {
    const double quarter = 0.5 * pi * chart.radius;
    const double straight = 2.0 * chart.half_length;
    const double beyond = arc - quarter - std::clamp(arc - quarter, 0.0, straight);
    const double angle = chart.radius > 0.0 ? beyond / chart.radius : 0.0; // from the equator of its end
    return {chart.radius * std::cos(angle),
            std::clamp(arc - quarter, 0.0, straight) - chart.half_length + chart.radius * std::sin(angle),
            std::sin(angle)};
}

} // namespace

Interest interest_of(const Stage& stage, const std::vector<glm::dvec3>& lights) {
    glm::dvec3 low = glm::min(stage.camera.position, stage.camera.target);
    glm::dvec3 high = glm::max(stage.camera.position, stage.camera.target);
    const auto add = [&](const glm::dvec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    };
    add(stage.light.position);
    for (const glm::dvec3& light : lights)
        add(light);
    for (const Surface& surface : stage.surfaces)
        if (const auto* ball = std::get_if<Ball>(&surface.geometry)) add(ball->center);
    const double radius = 0.5 * glm::length(high - low);
    return {0.5 * (low + high), radius > 0.0 ? radius : 1.0};
}

glm::dvec2 Chart::coordinates(const glm::dvec3& position) const {
    const glm::dvec3 local = frame.to_local(position - frame.origin);
    if (kind == Kind::flat) return {local.x, local.y};
    const double quarter = 0.5 * pi * radius;
    const double straight = std::clamp(local.z, -half_length, half_length);
    const double out = std::hypot(local.x, local.y);
    const double angle = std::atan2(local.z - straight, out);
    return {unwrapped(std::atan2(local.y, local.x)), quarter + straight + half_length + radius * angle};
}

glm::dvec2 Chart::on_sphere(double azimuth, double elevation) const {
    return {unwrapped(azimuth), radius * (0.5 * pi + elevation)};
}

glm::dvec3 Chart::position(const glm::dvec2& at) const {
    if (kind == Kind::flat) return frame.origin + at.x * frame.x + at.y * frame.y;
    const Outline outline = outline_at(*this, at.y);
    return frame.origin + outline.out * (std::cos(at.x) * frame.x + std::sin(at.x) * frame.y) + outline.along * frame.z;
}

glm::dvec3 Chart::normal(const glm::dvec2& at) const {
    if (kind == Kind::flat) return frame.z;
    const double rise = outline_at(*this, at.y).rise;
    return std::sqrt((1.0 - rise) * (1.0 + rise)) * (std::cos(at.x) * frame.x + std::sin(at.x) * frame.y) +
           rise * frame.z;
}

Chart::Spot Chart::nearest(const glm::dvec3& position) const {
    const double along = glm::dot(position - frame.origin, frame.z);
    if (kind == Kind::flat) return {position - along * frame.z, frame.z};
    const glm::dvec3 center = frame.origin + std::clamp(along, -half_length, half_length) * frame.z;
    const glm::dvec3 normal = glm::normalize(position - center);
    return {center + radius * normal, normal};
}

double Chart::area(const glm::dvec2& low, const glm::dvec2& high) const {
    if (kind == Kind::flat) return (high.x - low.x) * (high.y - low.y);
    // Archimedes: the area of a sphere's zone is that of the cylinder around it.
    return radius * (high.x - low.x) * (outline_at(*this, high.y).along - outline_at(*this, low.y).along);
}

Charts::Charts(const Stage& stage, const Interest& interest) {
    for (std::size_t i = 0; i < stage.surfaces.size(); ++i) {
        first_.push_back(charts_.size());
        std::visit(Maker{stage, i, interest, charts_}, stage.surfaces[i].geometry);
    }
    const double most = 6.0 * interest.radius; // of the length that counts of a plane
    for (const Chart& chart : charts_) {
        const auto length = [&](const Range& range) {
            return range.core > 0.0 ? std::min(range.high - range.low, most) : range.high - range.low;
        };
        area_ += length(chart.u) * length(chart.v) * (chart.kind == Chart::Kind::round ? chart.radius : 1.0);
    }
}

bool Charts::endless() const {
    return std::any_of(charts_.begin(), charts_.end(), [](const Chart& chart) { return chart.endless; });
}

bool Charts::uses_interest() const {
    return std::any_of(charts_.begin(), charts_.end(),
                       [](const Chart& chart) { return chart.u.core > 0.0 || chart.v.core > 0.0; });
}

double Charts::square_of(double count) const {
    return std::sqrt(area_ / count);
}

} // namespace gonio::detail
