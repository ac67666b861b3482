#include <gonio/preview/detail/light_reach.hpp>
#include <gonio/scene/reference.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace gonio::detail {

namespace {

// Kernels compute in float: directions and distances have this much room beside the exact ones.
constexpr double angle_room = 1e-5;
constexpr double length_room = 1e-5;

// cos(a + b) of angles in [0, π], −1 where their sum reaches π.
double cosine_of_sum(double sin_a, double cos_a, double sin_b, double cos_b) {
    return cos_a > -cos_b ? cos_a * cos_b - sin_a * sin_b : -1.0;
}

struct Seen {
    glm::dvec3 toward; // unit, to the middle of the bounds
    double sine;       // of the angle that they fill about it
    double cosine;
};

// From a point outside the sphere about the bounds widened by `more`.
bool seen_from(const glm::dvec3& from, const SampleBounds& bounds, double more, Seen& seen) {
    const glm::dvec3 way = bounds.center - from;
    const double distance = glm::length(way);
    const double radius = (bounds.radius + more) * (1.0 + length_room);
    if (!(radius + angle_room * distance < distance)) return false;
    seen.toward = way / distance;
    seen.sine = radius / distance + angle_room;
    seen.cosine = std::sqrt((1.0 - seen.sine) * (1.0 + seen.sine));
    return seen.sine < 1.0;
}

bool misses(const DirectionCone& cone, const Seen& seen) {
    return glm::dot(cone.axis, seen.toward) < cosine_of_sum(cone.sine, cone.cosine, seen.sine, seen.cosine);
}

// Whether all directions within `sine` of `toward`, as seen from the points, lie below their horizons.
bool is_below(const SampleBounds& bounds, const glm::dvec3& toward, double sine, double cosine) {
    // The sum of the angle and of the normals' spread stays short of a right angle.
    const double cosine_both = cosine * bounds.spread_cos - sine * bounds.spread_sin;
    const double sine_both = sine * bounds.spread_cos + cosine * bounds.spread_sin;
    return cosine_both > 0.0 && glm::dot(bounds.normal, toward) < -sine_both;
}

DirectionCone cone_of(const glm::dvec3& axis, double half_angle) {
    const double angle = std::min(half_angle, std::numbers::pi);
    return {axis, std::sin(angle), std::cos(angle)};
}

// γ beyond which a web of type C is dark, from its aim and from the other end.
void add_web_cones(const Web& web, const Frame& frame, LightReach& reach) {
    if (web.photometry() != Photometry::c) return;
    const std::span<const double> gammas = web.gammas_deg();
    double first = 180.0;
    double last = 0.0;
    for (std::size_t row = 0; row < gammas.size(); ++row) {
        bool lit = false;
        for (std::size_t plane = 0; plane < web.planes_deg().size(); ++plane)
            lit = lit || web.column(plane)[row] != 0.0;
        if (!lit) continue;
        // The interpolant reaches to the next rows.
        first = std::min(first, row > 0 ? gammas[row - 1] : gammas[row]);
        last = std::max(last, row + 1 < gammas.size() ? gammas[row + 1] : gammas[row]);
    }
    const auto add = [&](const glm::dvec3& axis, double half_angle_deg) {
        // What the renderer's table takes for its end.
        const double half_angle = degrees(half_angle_deg).value + angle_room;
        if (half_angle_deg < 180.0) reach.cones[reach.cone_count++] = cone_of(axis, half_angle);
    };
    add(-frame.z, last);
    add(frame.z, 180.0 - first);
}

struct OwnCone {
    const Light& light;

    double operator()(const SpotShape& spot) const { return spot.outer.value; }
    double operator()(const FrustumShape& frustum) const {
        const double x = std::tan(0.5 * frustum.horizontal.value);
        const double y = std::tan(0.5 * frustum.vertical.value);
        return std::atan(std::hypot(x, y));
    }
    double operator()(const DiskShape& disk) const { return flat(disk.two_sided); }
    double operator()(const RectShape& rect) const { return flat(rect.two_sided); }
    template<class Other>
    double operator()(const Other& /*emits all round*/) const {
        return std::numbers::pi;
    }

private:
    static double flat(bool two_sided) { return two_sided ? std::numbers::pi : 0.5 * std::numbers::pi; }
};

struct BodyRadius {
    double operator()(const SphereShape& s) const { return s.radius.value; }
    double operator()(const DiskShape& s) const { return s.radius.value; }
    double operator()(const RectShape& s) const { return 0.5 * std::hypot(s.width.value, s.height.value); }
    double operator()(const TubeShape& s) const { return 0.5 * s.length.value + s.radius.value; }
    template<class Punctual>
    double operator()(const Punctual& /*shape*/) const {
        return 0.0;
    }
};

} // namespace

Unlit LightReach::unlit(const SampleBounds& bounds) const {
    if (at_infinity) {
        const double sine = std::min(angular_radius_sin + angle_room, 1.0);
        const bool below = is_below(bounds, toward, sine, std::sqrt((1.0 - sine) * (1.0 + sine)));
        return below ? Unlit::below_horizon : Unlit::no;
    }
    const glm::dvec3 nearest = glm::clamp(center, bounds.low, bounds.high);
    const double away = glm::length(center - nearest);
    if (away > range * (1.0 + length_room)) return Unlit::out_of_range;
    const double room = length_room * (away + bounds.radius + body_radius);
    if (bounds.flat && glm::dot(bounds.normal, center) + body_radius + room < bounds.least_height)
        return Unlit::below_horizon;
    Seen seen;
    if (!bounds.flat && seen_from(center, bounds, body_radius, seen) &&
        is_below(bounds, -seen.toward, seen.sine, seen.cosine))
        return Unlit::below_horizon;
    if (cone_count == 0 || !seen_from(center, bounds, 0.0, seen)) return Unlit::no;
    for (std::size_t i = 0; i < cone_count; ++i)
        if (misses(cones[i], seen)) return Unlit::outside_cone;
    return Unlit::no;
}

LightReach reach_of(const Light& light, bool mask_from_center) {
    LightReach reach;
    reach.center = light.frame.origin;
    reach.range = light.range ? light.range->value : std::numeric_limits<double>::infinity();
    if (const auto* sun = std::get_if<SunShape>(&light.shape)) {
        reach.at_infinity = true;
        reach.range = std::numeric_limits<double>::infinity();
        reach.toward = light.frame.z;
        reach.angular_radius_sin = std::sin(0.5 * sun->diameter.value);
        return reach;
    }
    reach.body_radius = std::visit(BodyRadius{}, light.shape);
    const double own = std::visit(OwnCone{light}, light.shape);
    if (own < std::numbers::pi) reach.cones[reach.cone_count++] = cone_of(-light.frame.z, own + angle_room);
    const auto* profile = std::get_if<ProfileShape>(&light.shape);
    const Web* const web = profile != nullptr ? profile->web.get() : mask_of(light.shape).web;
    if (web != nullptr && (!has_extent(light.shape) || mask_from_center)) add_web_cones(*web, light.frame, reach);
    return reach;
}

bool is_dark(const Light& light) {
    const bool has_color = light.color != glm::dvec3(0.0);
    return !has_color || (light.intensity.value == 0.0 && light.luminance.value == 0.0);
}

} // namespace gonio::detail
