// The luminous opening of a luminaire: shape and size, decoded from what each format encodes it by.
#pragma once

#include <gonio/profile/profile.hpp>

namespace gonio {

enum class OpeningShape {
    point,
    rectangle,
    box,
    disk,
    ellipse,
    vertical_cylinder,
    horizontal_cylinder,
    sphere,
    unknown
};

const char* to_text(OpeningShape shape); // "vertical-cylinder"

// Sizes in metres, all ≥ 0. Of a disk or cylinder, width is the diameter; a horizontal cylinder's axis runs along
// length. `unknown` keeps the sizes of a code that the edition does not define.
struct LuminousOpening {
    OpeningShape shape = OpeningShape::point;
    double width_m = 0.0;
    double length_m = 0.0;
    double height_m = 0.0;
};

// LM-63 codes the shape by the signs of width, length and height: the tables of LM-63-1995 and of LM-63-2002/2019.
// The editions of 1986 and 1991 are read by the table of 1995.
LuminousOpening luminous_opening(const Profile& profile);

} // namespace gonio
