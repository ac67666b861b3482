// What may stand before a light, and the light itself, as plain numbers that kernels of every instruction set read.
#pragma once

#include <cstdint>

namespace gonio::detail {

// A point touches a one-sided surface within this share of its distance from the origin and of 1 m.
inline constexpr double touching_share = 1e-7;

// A primitive; lengths in metres, in the coordinates of the stage.
struct ShadowBody {
    enum class Kind : std::uint8_t { plane, panel, ball, box, capsule };

    Kind kind = Kind::plane;
    // Whether a plane is known that has it on one side and the light on the other.
    bool is_apart = false;
    double middle[3] = {}; // of a plane: a point of it
    // Unit. Planes and panels face along z, capsules extend along x.
    double x[3] = {1.0, 0.0, 0.0};
    double y[3] = {0.0, 1.0, 0.0};
    double z[3] = {0.0, 0.0, 1.0};
    double half_size[3] = {}; // of a panel and a box; of a capsule, the first to the middles of its ends
    double radius = 0.0;      // of a ball and a capsule
    double around = 0.0;      // radius of the bounding sphere about the middle; not of planes
    // If it is apart: a point of that plane, and its normal of any length, towards the light.
    double between[3] = {};
    double to_light[3] = {};
};

// A light that is divided into lines.
struct LinedLight {
    enum class Kind : std::uint8_t { none, ball, tube, disk, ellipse, rectangle, cylinder };

    Kind kind = Kind::none; // no surface at a finite distance
    bool is_two_sided = false;
    double center[3] = {};
    double x[3] = {1.0, 0.0, 0.0}; // unit; long lights extend along x, flat ones emit along −z
    double y[3] = {0.0, 1.0, 0.0};
    double z[3] = {0.0, 0.0, 1.0};
    double half_size[2] = {}; // along x and y; of long lights the first
    double radius = 0.0;      // of round lights
    double around[3] = {};    // the middle of a sphere that it lies in
    double around_radius = 0.0;
};

} // namespace gonio::detail
