#include <gonio/preview/detail/thin_lights.hpp>
#include <gonio/scene/emitter.hpp>
#include <gonio/scene/outline_points.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace gonio::detail {

namespace {

using Polygon = std::vector<glm::dvec2>;

// Of wider outlines four points across a pixel see enough.
constexpr double most_width = 1.5; // pixels
// Coordinates beyond it lose digits of a pixel.
constexpr double farthest = 1e7; // pixels

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

double area_of(std::span<const glm::dvec2> polygon) {
    double twice = 0.0;
    for (std::size_t i = 2; i < polygon.size(); ++i)
        twice += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return 0.5 * std::abs(twice);
}

// A. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
Polygon hull_of(Polygon points) {
    std::sort(points.begin(), points.end(),
              [](const glm::dvec2& a, const glm::dvec2& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); });
    Polygon hull;
    const auto add = [&](const glm::dvec2& point, std::size_t least) {
        while (hull.size() >= least + 2 &&
               cross(hull.back() - hull[hull.size() - 2], point - hull[hull.size() - 2]) <= 0.0)
            hull.pop_back();
        hull.push_back(point);
    };
    for (const glm::dvec2& point : points)
        add(point, 0);
    const std::size_t lower = hull.size() - 1;
    for (auto point = points.rbegin() + 1; point != points.rend(); ++point)
        add(*point, lower);
    hull.pop_back();
    return hull;
}

// The outline in the picture's plane; nothing where some of it is not in front of the eye, or far beside the picture.
Polygon outline_in(const CameraRays& rays, const std::vector<glm::dvec3>& points) {
    Polygon places;
    places.reserve(points.size());
    for (const glm::dvec3& point : points) {
        const std::optional<glm::dvec2> place = rays.place_of(point);
        if (!place || !(std::abs(place->x) < farthest) || !(std::abs(place->y) < farthest)) return {};
        places.push_back(*place);
    }
    return places.size() < 3 ? Polygon() : hull_of(std::move(places));
}

struct Extent {
    glm::dvec2 low;
    glm::dvec2 high;
};

Extent extent_of(const Polygon& polygon) {
    Extent extent{polygon.front(), polygon.front()};
    for (const glm::dvec2& corner : polygon) {
        extent.low = {std::min(extent.low.x, corner.x), std::min(extent.low.y, corner.y)};
        extent.high = {std::max(extent.high.x, corner.x), std::max(extent.high.y, corner.y)};
    }
    return extent;
}

// [pixels]
struct Size {
    double length = 0.0;
    double width = 0.0; // in the mean
};

Size size_of(const Polygon& outline) {
    const Extent extent = extent_of(outline);
    const double length = glm::length(extent.high - extent.low);
    return {length, area_of(outline) / length};
}

// What lies between two lines across an axis (I. Sutherland, G. Hodgman, "Reentrant polygon clipping", 1974).
Polygon cut(const Polygon& polygon, int axis, double low, double high) {
    const auto cut_at = [axis](const Polygon& all, double bound, double side) {
        Polygon kept;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const glm::dvec2& from = all[i];
            const glm::dvec2& to = all[i + 1 < all.size() ? i + 1 : 0];
            const double before = side * (from[axis] - bound);
            const double after = side * (to[axis] - bound);
            if (before >= 0.0) kept.push_back(from);
            if ((before < 0.0) != (after < 0.0)) {
                glm::dvec2 at = from + before / (before - after) * (to - from);
                at[axis] = bound;
                kept.push_back(at);
            }
        }
        return kept;
    };
    return cut_at(cut_at(polygon, low, 1.0), high, -1.0);
}

// Spread over a convex polygon: parts of the same area of its triangles, and the golden ratio within them.
void spread_over(const Polygon& polygon, double area, std::span<glm::dvec2> points) {
    glm::dvec2 middle(0.0);
    for (const glm::dvec2& corner : polygon)
        middle += corner / static_cast<double>(polygon.size());
    // Sides of polygons are chords or tangents of a round outline: its edge itself is not asked.
    constexpr double within = 0.99;
    std::size_t triangle = 2;
    const auto area_to = [&](std::size_t corner) {
        return 0.5 * std::abs(cross(polygon[corner - 1] - polygon[0], polygon[corner] - polygon[0]));
    };
    double before = 0.0;
    double here = area_to(triangle);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double wanted = (static_cast<double>(i) + 0.5) / static_cast<double>(points.size()) * area;
        while (triangle + 1 < polygon.size() && wanted > before + here) {
            before += here;
            here = area_to(++triangle);
        }
        const double along = here > 0.0 ? std::clamp((wanted - before) / here, 0.0, 1.0) : 0.5;
        const double away = std::sqrt(std::fmod(0.5 + static_cast<double>(i) / std::numbers::phi, 1.0));
        const glm::dvec2 side = polygon[triangle - 1] + along * (polygon[triangle] - polygon[triangle - 1]);
        points[i] = middle + within * (polygon[0] + away * (side - polygon[0]) - middle);
    }
}

// A flat light whose dark side is towards the eye.
bool turns_away(const Light& light, const glm::dvec3& eye) {
    const glm::dvec3 to_light = light.frame.origin - eye;
    return is_flat(light.shape) && light.parts == nullptr && glm::dot(to_light, to_light) > 0.0 &&
           !distance_to(light, {eye, glm::normalize(to_light)});
}

} // namespace

ThinLights::ThinLights(const RayScene& scene, const PixelArea& area, std::vector<std::uint32_t>& lights,
                       std::vector<std::uint32_t>& surfaces) {
    const glm::dvec3& eye = scene.rays.eye();
    const auto take = [&](const auto& of, bool is_surface, std::uint32_t number) {
        Polygon outline = outline_in(scene.rays, outline_points(of, eye));
        if (outline.size() < 3) return false;
        const Size size = size_of(outline);
        if (!(size.width < most_width)) return false;
        add({is_surface, number, std::move(outline), 1.0 / (std::min(size.width, 1.0) * std::min(size.length, 1.0))},
            area);
        return true;
    };
    std::erase_if(lights, [&](std::uint32_t number) {
        const Light& light = scene.lights[number];
        return turns_away(light, eye) || take(light, false, number);
    });
    if (!scene.emitted.empty())
        std::erase_if(surfaces, [&](std::uint32_t number) {
            return scene.emitted.emits(number) && take(scene.stage.surfaces[number].geometry, true, number);
        });
    std::sort(parts_.begin(), parts_.end(),
              [](const Part& a, const Part& b) { return std::tie(a.y, a.x, a.thing) < std::tie(b.y, b.x, b.thing); });
}

void ThinLights::add(Thing thing, const PixelArea& area) {
    const auto index = static_cast<std::uint32_t>(things_.size());
    things_.push_back(std::move(thing));
    const auto for_each_pixel = [](const Polygon& polygon, int axis, int first, int end, const auto& use) {
        if (polygon.size() < 3) return;
        const Extent extent = extent_of(polygon);
        const auto from = static_cast<int>(std::max<double>(first, std::floor(extent.low[axis])));
        const auto to = static_cast<int>(std::min<double>(end, std::ceil(extent.high[axis])));
        for (int at = from; at < to; ++at)
            use(at, cut(polygon, axis, at, at + 1.0));
    };
    for_each_pixel(things_.back().outline, 1, area.top, area.bottom, [&](int y, const Polygon& row) {
        for_each_pixel(row, 0, area.left, area.right, [&](int x, const Polygon& within) {
            const double share = within.size() < 3 ? 0.0 : area_of(within);
            if (!(share > 0.0)) return;
            Part& part = parts_.emplace_back();
            part.x = x;
            part.y = y;
            part.thing = index;
            part.share = share;
            spread_over(within, share, part.points);
        });
    });
}

} // namespace gonio::detail
