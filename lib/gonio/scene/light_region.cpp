#include <gonio/scene/detail/light_region.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio::detail {

namespace {

using std::numbers::pi;

double height(Vec a) {
    return shading::length(a);
}

Vec unit(Vec a) {
    return a * (1.0 / height(a));
}

// Any two unit vectors with u × v = a.
std::array<Vec, 2> across(Vec a) {
    const Vec seed = std::abs(a.x) < 0.6 ? Vec{1.0, 0.0, 0.0} : Vec{0.0, 1.0, 0.0};
    const Vec u = unit(seed - a * dot(a, seed));
    return {u, cross(a, u)};
}

// How high the receiver lies above a flat light; 0 where that is the rounding of its place, because outlines seen from
// there would have no digits. Lengths are scaled to at most 1.
double above_plane(Vec axis, Vec center) {
    constexpr double rounding = 1e-15;
    const double z = -dot(axis, center);
    return std::abs(z) < rounding ? 0.0 : z;
}

// The part within [0, π] of the angles up to `half_width` ≤ π/2 from `middle` in (−π, π].
PolarInterval around(double middle, double half_width) {
    const double turned = middle < -0.5 * pi ? middle + 2.0 * pi : middle;
    return {std::max(turned - half_width, 0.0), std::min(turned + half_width, pi)};
}

// The part of a ray with a·ω ≥ 0.
PolarInterval half_space(Vec a, Vec pole, Vec tangent) {
    return around(std::atan2(dot(a, tangent), dot(a, pole)), 0.5 * pi);
}

PolarInterval both(PolarInterval a, PolarInterval b) {
    return {std::max(a.from, b.from), std::min(a.to, b.to)};
}

// The hull of two intervals of a convex set.
PolarInterval hull(PolarInterval a, PolarInterval b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {std::min(a.from, b.from), std::max(a.to, b.to)};
}

// Both t with x cos t + y sin t = k; nothing if there are none.
struct Angles {
    std::array<double, 2> t{};
    bool exist = false;
};

Angles solve_circle(double x, double y, double k) {
    const double amplitude = std::hypot(x, y);
    if (!(std::abs(k) <= amplitude) || amplitude == 0.0) return {};
    const double middle = std::atan2(y, x);
    const double half = std::atan2(std::sqrt((amplitude - k) * (amplitude + k)), k);
    return {{middle - half, middle + half}, true};
}

} // namespace

LightRegion LightRegion::sphere(Vec center, double radius, Vec normal) {
    LightRegion region(normal);
    if (height(center) < radius)
        region.whole_ = true;
    else
        region.add_sphere(center, radius);
    region.finish();
    return region;
}

LightRegion LightRegion::cap(Vec axis, double sin_sigma, double cos_sigma, Vec normal) {
    LightRegion region(normal);
    region.add_cone(axis, sin_sigma, cos_sigma);
    region.finish();
    return region;
}

LightRegion LightRegion::disk(Vec center, Vec axis, double radius, bool two_sided, Vec normal) {
    LightRegion region(normal);
    double z = above_plane(axis, center);
    Vec w = axis * -1.0;
    if (two_sided && z < 0.0) {
        z = -z;
        w = axis;
    }
    const bool touching = z == 0.0 && height(center) < radius;
    if (touching && two_sided) {
        region.whole_ = true;
    } else if (touching) {
        region.add_cone(w, 1.0, 0.0);
    } else if (z > 0.0) {
        const auto [u, v] = across(w);
        region.circles_[0] = {center, u, v, radius};
        region.circle_count_ = 1;
        region.is_disk_ = true;
    } else {
        region.dark_ = true;
    }
    region.finish();
    return region;
}

LightRegion LightRegion::rectangle(Vec center, Vec axis, Vec width_direction, double width, double height_m,
                                   bool two_sided, Vec normal) {
    LightRegion region(normal);
    const Vec up = cross(axis, width_direction);
    double z = above_plane(axis, center);
    Vec w = axis * -1.0;
    if (two_sided && z < 0.0) {
        z = -z;
        w = axis;
    }
    const bool touching =
        z == 0.0 && std::abs(dot(center, width_direction)) < 0.5 * width && std::abs(dot(center, up)) < 0.5 * height_m;
    if (touching && two_sided) {
        region.whole_ = true;
    } else if (touching) {
        region.add_cone(w, 1.0, 0.0);
    } else if (z > 0.0) {
        const Vec x = width_direction * (0.5 * width);
        const Vec y = up * (0.5 * height_m);
        region.set_polygon({center - x - y, center - x + y, center + x + y, center + x - y}, center);
    } else {
        region.dark_ = true;
    }
    region.finish();
    return region;
}

LightRegion LightRegion::tube(Vec center, Vec axis, double radius, double length, Vec normal) {
    LightRegion region(normal);
    const std::array<Vec, 2> ends{center - axis * (0.5 * length), center + axis * (0.5 * length)};
    const Vec to_line = center - axis * dot(axis, center);
    const double d = height(to_line);
    const bool beyond = dot(axis, ends[0]) > 0.0 || dot(axis, ends[1]) < 0.0;
    const Vec& nearer = height(ends[0]) < height(ends[1]) ? ends[0] : ends[1];
    if (beyond ? height(nearer) < radius : d < radius) {
        region.whole_ = true;
    } else if (d <= radius) {
        // Within the prolonged tube the nearer end hides the rest.
        if (beyond)
            region.add_sphere(nearer, radius);
        else
            region.add_cone(unit(to_line), 1.0, 0.0);
    } else {
        const Vec f = to_line * (1.0 / d);
        const Vec g = cross(axis, f);
        const double s = radius / d;
        const double kappa = std::sqrt((d - radius) * (d + radius)) / d;
        const Vec left = (g * kappa - f * s) * radius;
        const Vec right = (g * -kappa - f * s) * radius;
        region.set_polygon({ends[0] + left, ends[1] + left, ends[1] + right, ends[0] + right},
                           center - f * (s * radius));
        region.add_sphere(ends[0], radius);
        region.add_sphere(ends[1], radius);
    }
    region.finish();
    return region;
}

LightRegion LightRegion::cylinder(Vec center, Vec axis, double radius, double length, Vec normal) {
    LightRegion region(normal);
    const Vec to_line = center - axis * dot(axis, center);
    const double d = height(to_line);
    if (!(d > radius)) {
        // A point of the side sees half of all around; one within it, or within its prolongation, sees nothing.
        if (d == radius && d > 0.0 && std::abs(dot(axis, center)) <= 0.5 * length)
            region.add_cone(unit(to_line), 1.0, 0.0);
        else
            region.dark_ = true;
        region.finish();
        return region;
    }
    const std::array<Vec, 2> ends{center - axis * (0.5 * length), center + axis * (0.5 * length)};
    const Vec f = to_line * (1.0 / d);
    const Vec g = cross(axis, f);
    const double s = radius / d;
    const double kappa = std::sqrt((d - radius) * (d + radius)) / d;
    const Vec left = (g * kappa - f * s) * radius;
    const Vec right = (g * -kappa - f * s) * radius;
    region.set_polygon({ends[0] + left, ends[1] + left, ends[1] + right, ends[0] + right}, center - f * (s * radius));
    for (const Vec& end : ends)
        region.circles_[region.circle_count_++] = {end, f, g, radius};
    region.is_disk_ = true;
    region.finish();
    return region;
}

void LightRegion::add_cone(Vec axis, double sin_sigma, double cos_sigma) {
    const auto [u, v] = across(axis);
    circles_[circle_count_] = {axis * cos_sigma, u, v, sin_sigma};
    cones_[circle_count_] = {axis, sin_sigma, cos_sigma};
    ++circle_count_;
}

void LightRegion::add_sphere(Vec center, double radius) {
    const double d = height(center);
    add_cone(center * (1.0 / d), std::min(radius / d, 1.0), std::sqrt(std::max((d - radius) * (d + radius), 0.0)) / d);
}

void LightRegion::set_polygon(const std::array<Vec, 4>& corners, Vec within) {
    has_polygon_ = true;
    corners_ = corners;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec side = cross(corners[i], corners[(i + 1) % 4] - corners[i]);
        inward_[i] = dot(side, within) < 0.0 ? side * -1.0 : side;
    }
}

// Points where the outlines cross the horizon, and corners above it.
void LightRegion::add_horizon_points(std::vector<Vec>& points) const {
    for (std::size_t i = 0; i < circle_count_; ++i) {
        const Circle& c = circles_[i];
        const Angles cut =
            solve_circle(dot(normal_, c.u) * c.radius, dot(normal_, c.v) * c.radius, -dot(normal_, c.center));
        if (!cut.exist) continue;
        for (const double t : cut.t)
            points.push_back(c.at(std::cos(t), std::sin(t)));
    }
    if (!has_polygon_) return;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec a = corners_[i];
        const Vec b = corners_[(i + 1) % 4];
        const double up_a = dot(normal_, a);
        const double up_b = dot(normal_, b);
        if (up_a >= 0.0) points.push_back(a);
        if ((up_a > 0.0 && up_b < 0.0) || (up_a < 0.0 && up_b > 0.0))
            points.push_back(a + (b - a) * (up_a / (up_a - up_b)));
    }
}

void LightRegion::finish() {
    middle_ = normal_;
    reach_ = 0.5 * pi;
    if (whole_ || dark_) return;
    std::vector<Vec> points;
    add_horizon_points(points);
    for (std::size_t i = 0; i < circle_count_; ++i)
        for (int k = 0; k < 8; ++k) {
            const Vec p = circles_[i].at(std::cos(0.25 * pi * k), std::sin(0.25 * pi * k));
            if (dot(normal_, p) > 0.0) points.push_back(p);
        }
    Vec sum{0.0, 0.0, 0.0};
    double highest = 0.0;
    for (Vec& p : points) {
        const double length = height(p);
        if (!(length > 0.0)) continue;
        p = p * (1.0 / length);
        highest = std::max(highest, dot(normal_, p));
        sum = sum + p;
    }
    if (circle_count_ > 0 && !is_disk_) // for a hemisphere the outline's sum is zero
        for (std::size_t i = 0; i < circle_count_; ++i)
            if (dot(normal_, cones_[i].axis) > 0.0) {
                sum = sum + cones_[i].axis;
                highest = std::max(highest, dot(normal_, cones_[i].axis));
            }
    if (!(highest > 0.0) || !(height(sum) > 0.0)) {
        dark_ = true;
        return;
    }
    middle_ = unit(sum);
    double farthest = 0.0;
    for (const Vec& p : points)
        farthest = std::max(farthest, height(p - middle_));
    reach_ = 2.0 * std::asin(std::min(0.5 * farthest, 1.0));
    if (!is_disk_) // a disk's outline may lie entirely in the horizon
        for (std::size_t i = 0; i < circle_count_; ++i)
            reach_ = std::max(reach_, std::atan2(cones_[i].sin_sigma, cones_[i].cos_sigma));
}

// The chord that the ray's plane cuts from a disk, as far as the ray meets it.
PolarInterval LightRegion::chord(const Circle& c, Vec pole, Vec tangent) const {
    const Vec m = cross(pole, tangent);
    const Angles cut = solve_circle(dot(m, c.u) * c.radius, dot(m, c.v) * c.radius, -dot(m, c.center));
    if (!cut.exist) return {};
    std::array<double, 2> theta{};
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec end = c.at(std::cos(cut.t[i]), std::sin(cut.t[i]));
        theta[i] = std::atan2(dot(end, tangent), dot(end, pole));
    }
    const auto [low, high] = std::minmax(theta[0], theta[1]);
    // The chord subtends less than π: it passes over the pole, or over the point opposite it.
    return high - low < pi ? PolarInterval{std::max(low, 0.0), high} : PolarInterval{std::max(high, 0.0), pi};
}

PolarInterval LightRegion::along(Vec pole, Vec tangent) const {
    const PolarInterval lit = above(pole, tangent);
    if (whole_) return lit;
    PolarInterval seen;
    if (is_disk_) {
        for (std::size_t i = 0; i < circle_count_; ++i)
            seen = hull(seen, chord(circles_[i], pole, tangent));
    } else {
        for (std::size_t i = 0; i < circle_count_; ++i) {
            const Cone& cone = cones_[i];
            const double off = dot(cone.axis, cross(pole, tangent)); // sine of the axis' angle to the ray's plane
            const double half2 = (cone.sin_sigma - off) * (cone.sin_sigma + off);
            if (!(half2 > 0.0)) continue;
            const double half = std::atan2(std::sqrt(half2), cone.cos_sigma);
            seen = hull(seen, around(std::atan2(dot(cone.axis, tangent), dot(cone.axis, pole)), half));
        }
    }
    if (has_polygon_) {
        PolarInterval inside{0.0, pi};
        for (const Vec& side : inward_)
            inside = both(inside, half_space(side, pole, tangent));
        seen = hull(seen, inside);
    }
    return both(seen, lit);
}

PolarInterval LightRegion::above(Vec pole, Vec tangent) const {
    return half_space(normal_, pole, tangent);
}

// Points of the rim at which the distance from the pole is a local maximum or minimum.
std::vector<Vec> LightRegion::farthest_of_rim(const Circle& c, Vec pole) const {
    constexpr int steps = 48;
    constexpr double step = 2.0 * pi / steps;
    // The change of the distance along the rim: d(pole·p/|p|)/dt times |p|³.
    const auto slope = [&](double t) {
        const double cos_t = std::cos(t);
        const double sin_t = std::sin(t);
        const Vec p = c.at(cos_t, sin_t);
        const Vec along = c.v * (c.radius * cos_t) - c.u * (c.radius * sin_t);
        return dot(pole, along) * dot(p, p) - dot(pole, p) * dot(p, along);
    };
    std::vector<Vec> points;
    double before = slope(0.0);
    for (int k = 0; k < steps; ++k) {
        double low = step * k;
        double high = step * (k + 1);
        const double after = slope(high);
        const bool turns = (before < 0.0) != (after < 0.0);
        const bool rising = before < 0.0;
        before = after;
        if (!turns) continue;
        for (int halving = 0; halving < 40; ++halving) {
            const double middle = 0.5 * (low + high);
            ((slope(middle) < 0.0) == rising ? low : high) = middle;
        }
        points.push_back(c.at(std::cos(low), std::sin(low)));
    }
    return points;
}

std::vector<Vec> LightRegion::turns(Vec pole) const {
    std::vector<Vec> points;
    if (whole_ || dark_) return points;
    add_horizon_points(points);
    for (std::size_t i = 0; i < circle_count_; ++i) {
        // pole · (p × dp/dt) = 0.
        const Circle& c = circles_[i];
        const Angles touch = solve_circle(dot(pole, cross(c.center, c.v)), -dot(pole, cross(c.center, c.u)),
                                          -c.radius * dot(pole, cross(c.u, c.v)));
        if (!touch.exist) continue;
        for (const double t : touch.t) {
            const Vec p = c.at(std::cos(t), std::sin(t));
            if (dot(normal_, p) > 0.0) points.push_back(p);
        }
    }
    // A disk seen at a slant is a narrow ellipse; near its ends the rays' lengths change fast.
    for (std::size_t i = 0; is_disk_ && i < circle_count_; ++i)
        for (const Vec& p : farthest_of_rim(circles_[i], pole))
            if (dot(normal_, p) > 0.0) points.push_back(p);
    return points;
}

} // namespace gonio::detail
