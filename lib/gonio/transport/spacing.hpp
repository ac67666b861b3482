// How close the lines that divide a flat chart lie: closer where light changes faster.
#pragma once

#include <gonio/scene/stage.hpp>
#include <gonio/transport/chart.hpp>

#include <glm/vec3.hpp>

#include <limits>
#include <span>
#include <vector>

namespace gonio::detail {

// Where a light is, as far as the division of a stage depends on it.
struct LightPlace {
    glm::dvec3 position{0.0};
    glm::dvec3 side{0.0}; // unit, of a light that emits to one side of its plane alone; else 0

    // Whether any point of a sphere is before the light.
    bool may_light(const glm::dvec3& middle, double radius_m) const {
        return glm::dot(middle - position, side) >= -radius_m;
    }
    friend bool operator==(const LightPlace&, const LightPlace&) = default;
};

// An interval of the coordinate, and the distance between lines there.
struct Grading {
    double low;
    double high;
    double spacing_m;
    double growth = std::numeric_limits<double>::infinity(); // if less than that of the coordinate
};

// Along one coordinate.
struct Spacing {
    Range range;
    double widest_m;
    double growth;        // with the distance from what lines lie closer for
    double growth_beyond; // with the distance from the core of the range
    std::vector<Grading> gradings;
    std::vector<double> cuts; // a line on each side

    double operator()(double x) const;
};

struct SpacingPair {
    Spacing u, v;
};

// Of the nodes of indirect light: closer at the chart's edges, where others stand on it, and at the sides of boxes.
SpacingPair spacing_of_nodes(const Stage& stage, const Chart& chart, double widest_m, double least_m);

// Of the patches of direct light: closer near lights, at edges of other surfaces, which lie between patches, and at the
// feet of solids, there in proportion to `coarseness`.
SpacingPair spacing_of_patches(const Stage& stage, std::span<const LightPlace> lights, const Chart& chart,
                               double widest_m, double coarseness);

// From one end of the range to the other, no farther apart than `spacing` says. Those at ends and cuts are moved
// inwards by `inset_m`.
std::vector<double> lines_of(const Spacing& spacing, double inset_m);

// The distance of a point from a surface, as a solid or a sheet; 0 inside.
double distance_to_surface(const Primitive& geometry, const glm::dvec3& point);

} // namespace gonio::detail
