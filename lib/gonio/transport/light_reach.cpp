#include <gonio/light/shape_traits.hpp>
#include <gonio/scene/reference.hpp>
#include <gonio/transport/light_reach.hpp>
#include <gonio/web/web.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace gonio::detail {

namespace {

// Kernels compute in float: directions and distances get this tolerance relative to the exact ones.
constexpr double angle_room = 1e-5;
constexpr double length_room = 1e-5;

// cos(a + b) of angles in [0, π]; −1 if their sum is π or more.
double cosine_of_sum(double sin_a, double cos_a, double sin_b, double cos_b) {
    return cos_a > -cos_b ? cos_a * cos_b - sin_a * sin_b : -1.0;
}

struct Seen {
    glm::dvec3 toward; // unit, to the middle of the bounds
    double sine;       // of the angle that they subtend about it
    double cosine;
};

// The bounds, widened by `more`, as seen from a point; false if the point is not outside the sphere about them.
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

// The same test with the plane that touches the cone on the side of the box, which is tighter for long boxes. For cones
// with a half angle of at most 90°.
bool misses_box(const DirectionCone& cone, const glm::dvec3& apex, const SampleBounds& bounds) {
    if (cone.cosine < 0.0) return false;
    const glm::dvec3 way = bounds.center - apex;
    const glm::dvec3 across = way - glm::dot(way, cone.axis) * cone.axis;
    const double distance = glm::length(across);
    if (!(distance > 0.0)) return false;
    const glm::dvec3 normal = across * (cone.cosine / distance) - cone.axis * cone.sine;
    const glm::dvec3 half = 0.5 * (bounds.high - bounds.low);
    const double reach = glm::dot(glm::abs(normal), half);
    return glm::dot(normal, way) > reach + length_room * (glm::length(way) + bounds.radius);
}

// Whether all directions within `sine` of `toward`, as seen from the points, are below their horizons.
bool is_below(const SampleBounds& bounds, const glm::dvec3& toward, double sine, double cosine) {
    // The sum of the angle and of the spread of the normals is below a right angle.
    const double cosine_both = cosine * bounds.spread_cos - sine * bounds.spread_sin;
    const double sine_both = sine * bounds.spread_cos + cosine * bounds.spread_sin;
    return cosine_both > 0.0 && glm::dot(bounds.normal, toward) < -sine_both;
}

DirectionCone cone_of(const glm::dvec3& axis, double half_angle) {
    const double angle = std::min(half_angle, std::numbers::pi);
    return {axis, std::sin(angle), std::cos(angle)};
}

// Over an interval of angles in [−180°, 180°].
using Cosines = LitCosines;
Cosines cosines(double low_deg, double high_deg) {
    const double a = std::cos(degrees(low_deg).value);
    const double b = std::cos(degrees(high_deg).value);
    return {std::min(a, b), low_deg <= 0.0 && high_deg >= 0.0 ? 1.0 : std::max(a, b)};
}

Cosines lit_cosines(const Web& web) {
    const std::span<const double> horizontal = web.horizontal_deg();
    const std::span<const double> vertical = web.vertical_deg();
    Cosines lit{1.0, -1.0};
    for (std::size_t column = 0; column < horizontal.size(); ++column)
        for (std::size_t row = 0; row < vertical.size(); ++row) {
            if (web.column(column)[row] == 0.0) continue;
            // The interpolant extends to the adjacent angles.
            const Cosines v =
                cosines(vertical[row > 0 ? row - 1 : row], vertical[std::min(row + 1, vertical.size() - 1)]);
            Cosines h{1.0, 1.0}; // for type C, cosγ is that of the row; for A and B it is cos H cos V
            if (web.photometry() != Photometry::c)
                h = cosines(horizontal[column > 0 ? column - 1 : column],
                            horizontal[std::min(column + 1, horizontal.size() - 1)]);
            for (const double product :
                 {v.least * h.least, v.least * h.greatest, v.greatest * h.least, v.greatest * h.greatest}) {
                lit.least = std::min(lit.least, product);
                lit.greatest = std::max(lit.greatest, product);
            }
        }
    return lit;
}

// Cones that contain the light of a web, about its aim and about the opposite direction.
void add_web_cones(const Cosines& lit, const Frame& frame, LightReach& reach) {
    const auto add = [&](const glm::dvec3& axis, double cosine) {
        // The room also covers the tolerance of the renderer's table at its ends.
        if (cosine > -1.0) reach.cones[reach.cone_count++] = cone_of(axis, std::acos(cosine) + angle_room);
    };
    add(-frame.z, lit.least);
    add(frame.z, -lit.greatest);
}

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
    const bool outside = cone_count > 0 && seen_from(center, bounds, 0.0, seen);
    for (std::size_t i = 0; i < cone_count; ++i)
        if ((outside && misses(cones[i], seen)) || misses_box(cones[i], center, bounds)) return Unlit::outside_cone;
    return Unlit::no;
}

LightReach reach_of(const Light& light, bool mask_from_center, WebsLitCosines& known) {
    LightReach reach;
    reach.center = light.frame.origin;
    reach.range = light.range ? light.range->value : std::numeric_limits<double>::infinity();
    if (const auto* sun = std::get_if<SunShape>(&light.shape)) { // the only light at infinity
        reach.at_infinity = true;
        reach.range = std::numeric_limits<double>::infinity();
        reach.toward = light.frame.z;
        reach.angular_radius_sin = std::sin(0.5 * sun->diameter.value);
        return reach;
    }
    reach.body_radius = with_traits(light.shape, [](const auto& kind, auto traits) { return traits.radius(kind); });
    const double own =
        with_traits(light.shape, [](const auto& kind, auto traits) { return traits.half_cone(kind).value; });
    if (own < std::numbers::pi) reach.cones[reach.cone_count++] = cone_of(-light.frame.z, own + angle_room);
    const auto* profile = std::get_if<ProfileShape>(&light.shape);
    const Web* const web = profile != nullptr ? profile->web.get() : mask_of(light.shape).web;
    if (web == nullptr || (has_extent(light.shape) && !mask_from_center)) return reach;
    const auto [of_web, is_new] = known.try_emplace(web);
    if (is_new) of_web->second = lit_cosines(*web);
    add_web_cones(of_web->second, light.frame, reach);
    return reach;
}

LightReach reach_of(const Light& light, bool mask_from_center) {
    WebsLitCosines known;
    return reach_of(light, mask_from_center, known);
}

bool is_dark(const Light& light) {
    const bool has_color = light.color != glm::dvec3(0.0);
    return !has_color || (light.intensity.value == 0.0 && light.luminance.value == 0.0);
}

} // namespace gonio::detail
