// The points that a command probes: named one by one, from a table, or on a grid.
#pragma once

#include <gonio/base/limits.hpp>
#include <gonio/base/result.hpp>
#include <gonio/scene/probe.hpp>

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
    Option{"--grid", "O:U:V:NxM", "N by M cell centres of the rectangle at corner O with edges U and V"},
};

inline constexpr OptionGroup points_group{"points", points_options};

// The largest number of points in one run.
inline constexpr std::size_t max_points = limit("points").value;

struct GridSize {
    int across = 0; // along U
    int along = 0;  // along V
};

struct Points {
    std::vector<Receiver> receivers; // of a grid: first along U
    std::optional<GridSize> grid;
};

// Fails: usage unless points are given in exactly one of the three ways, or a normal is zero; io and malformed (with
// line and column) on the file.
Result<Points> points_input(const Arguments& arguments);

// Points of CSV text that messages call `source`. The first line may name columns: x, y, z, and all or none of nx, ny,
// nz, in any order; other columns are ignored. Empty lines and lines that start with # are skipped.
Result<std::vector<Receiver>> parse_points(std::string_view text, const std::string& source,
                                           const glm::dvec3& default_normal);

} // namespace gonio::cli
