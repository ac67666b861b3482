// The directions in which a receiver sees an area light above its horizon: a convex part of the unit sphere, evaluated
// along rays from a pole.
//
// Seen from a receiver every area shape is the convex hull of at most two circular cones, or of at most two oblique
// ones (disks), and one polygon, cut by the receiver's horizon. A ray is the half great circle from a pole through an
// azimuth; its intersection with a convex set is one interval, in closed form for each of these. The corners, the
// horizon's crossings and the tangents from the pole are closed forms too, so that between neighbouring `turns()` the
// ends of the intervals are smooth functions of the azimuth. The receiver is the origin of all vectors.
#pragma once

#include <gonio/shading/vec3.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace gonio::detail {

using Vec = shading::vec3<double>;

// Angles from the pole [rad]; empty unless from < to.
struct PolarInterval {
    double from = 0.0;
    double to = 0.0;

    bool empty() const { return !(from < to); }
};

// `center`: from the receiver to the light's centre [m]; axes and the receiver's `normal` are unit. A receiver inside a
// sphere or tube, or on the luminous face of a disk or rectangle, sees the light over the whole hemisphere (of the
// face).
class LightRegion {
public:
    static LightRegion sphere(Vec center, double radius, Vec normal);
    // A cap of angular radius σ about a unit direction, σ ≤ π/2: used for the sun.
    static LightRegion cap(Vec axis, double sin_sigma, double cos_sigma, Vec normal);
    // Disk and rectangle emit towards +axis, or to both sides.
    static LightRegion disk(Vec center, Vec axis, double radius, bool two_sided, Vec normal);
    static LightRegion rectangle(Vec center, Vec axis, Vec width_direction, double width, double height, bool two_sided,
                                 Vec normal);
    static LightRegion tube(Vec center, Vec axis, double radius, double length, Vec normal);
    // A solid cylinder with its flat ends; dark from within the prolonged cylinder.
    static LightRegion cylinder(Vec center, Vec axis, double radius, double length, Vec normal);

    // True if nothing of the light is above the horizon, or the receiver is on its dark side.
    bool dark() const { return dark_; }
    // A unit direction inside the region, and approximately the largest angle from it to a point of the outline [rad].
    Vec middle() const { return middle_; }
    double reach() const { return reach_; }

    // The part of the region on the ray from the pole p along its unit tangent q.
    PolarInterval along(Vec pole, Vec tangent) const;
    // The part of the hemisphere above the horizon on that ray.
    PolarInterval above(Vec pole, Vec tangent) const;

    // Directions on the outline at which the rays' intervals stop being smooth: corners, crossings of the horizon, and
    // points where a ray is tangent to the outline. In no particular order.
    std::vector<Vec> turns(Vec pole) const;

private:
    // p(t) = center + radius (u cos t + v sin t), u × v along the axis.
    struct Circle {
        Vec center, u, v;
        double radius;

        Vec at(double cos_t, double sin_t) const { return center + u * (radius * cos_t) + v * (radius * sin_t); }
    };
    struct Cone {
        Vec axis;
        double sin_sigma, cos_sigma;
    };

    explicit LightRegion(Vec normal) : normal_(normal) {}

    void add_cone(Vec axis, double sin_sigma, double cos_sigma);
    void add_sphere(Vec center, double radius);
    void set_polygon(const std::array<Vec, 4>& corners, Vec within);
    void finish();
    std::vector<Vec> farthest_of_rim(const Circle& c, Vec pole) const;
    PolarInterval chord(const Circle& c, Vec pole, Vec tangent) const;
    void add_horizon_points(std::vector<Vec>& points) const;

    Vec normal_;
    std::array<Circle, 2> circles_{}; // outlines of the cones, or the rims of disks
    std::array<Cone, 2> cones_{};
    std::size_t circle_count_ = 0;
    bool is_disk_ = false; // the circles are rims, not the outlines of cones about their own axes
    std::array<Vec, 4> corners_{};
    std::array<Vec, 4> inward_{}; // normals of the polygon's sides
    bool has_polygon_ = false;
    bool whole_ = false; // the receiver is inside: the hemisphere
    bool dark_ = false;
    Vec middle_{0.0, 0.0, 1.0};
    double reach_ = 0.0;
};

} // namespace gonio::detail
