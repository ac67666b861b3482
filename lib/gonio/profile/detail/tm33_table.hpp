// The points of a TM-33 table, arranged in a grid. Internal.
#pragma once

#include <pugixml.hpp>

#include <string>
#include <vector>

namespace gonio::profile_detail {

struct PointTable {
    enum class Problem {
        none,
        angle_missing, // a point without both angles
        not_a_number,
        not_finite,
        duplicate, // two points at the same angles
        incomplete // the grid of the angles has more places than there are points
    };

    std::vector<double> horizontal_deg; // ascending, each angle once
    std::vector<double> vertical_deg;
    std::vector<double> values; // [horizontal][vertical]
    std::size_t points = 0;
    bool plain = true; // no point has anything besides its angles and its value

    Problem problem = Problem::none;
    const char* where = nullptr; // in the parsed buffer: the place of the problem
    std::string text;            // the text at that place
};

// Points may come in any order: planes first, angles first, or mixed.
PointTable read_points(pugi::xml_node parent);

} // namespace gonio::profile_detail
