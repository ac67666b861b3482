// The points that a command probes: named one by one, from a table, or on a grid.
#pragma once

#include <gonio/base/limits.hpp>
#include <gonio/base/result.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/scene/receiver_grid.hpp>
#include <gonio/scene/stage.hpp>

#include "../arguments.hpp"
#include "../command.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace gonio::cli {

inline constexpr std::array points_options{
    Option{"--at", "X,Y,Z", "a point in metres", {}, true},
    Option{
        "--normal", "X,Y,Z", "normal of the surface (0,0,1; grid: U x V); one for all or one for each --at", {}, true},
    Option{"--points", "FILE", "points from a CSV file, '-' for stdin; each line is x,y,z or x,y,z,nx,ny,nz"},
    Option{"--grid", "O:U:V[:NxM]",
           "N by M cell centres of the rectangle at corner O with edges U and V; without NxM spaced as EN 12464-1 has "
           "it"},
    Option{"--polygon", "P:P:P…", "cell centres in the flat polygon with these corners, each X,Y,Z"},
    Option{"--workplane", "HEIGHT", "cell centres at this height between the walls of the stage"},
    Option{"--wall-zone", "LENGTH", "with --workplane: distance from the walls that has no points (50cm)"},
    Option{
        "--spacing", "LENGTH",
        "of the points of a grid (EN 12464-1: 0.2 m · 5^log10(side in m), at most 10 m); en12193: for sports, an odd "
        "number along each side"},
};

inline constexpr OptionGroup points_group{"points", points_options};

// The largest number of points in one run.
inline constexpr std::size_t max_points = limit("points").value;

// The working plane of a stage, which is read later.
struct Workplane {
    double height_m = 0.75;
    double wall_zone_m = 0.5;
    GridSpacing spacing;
};

struct Points {
    std::vector<Receiver> receivers;    // of a grid: first along U
    std::optional<ReceiverGrid> grid;   // without its receivers
    std::optional<Workplane> workplane; // the points are missing until place_on() has made them
    bool has_normals = false;           // of --normal
};

// Fails: usage unless points are given in exactly one of the ways, or a normal is zero; io and malformed (with
// line and column) on the file.
Result<Points> points_input(const Arguments& arguments);

// Makes the points of a working plane. Fails (usage) if the stage has no walls on four sides, or no room between them.
Result<void> place_on(const Stage& stage, Points& points);

// Points of CSV text that messages call `source`. The first line may name columns: x, y, z, and all or none of nx, ny,
// nz, in any order; other columns are ignored. Empty lines and lines that start with # are skipped.
Result<std::vector<Receiver>> parse_points(std::string_view text, const std::string& source,
                                           const glm::dvec3& default_normal);

} // namespace gonio::cli
