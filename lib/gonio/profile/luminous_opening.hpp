// The luminous opening of a luminaire: shape and size, decoded from the encoding of each format.
#pragma once

#include <gonio/profile/profile.hpp>

#pragma GCC visibility push(default)
namespace gonio {

// The shapes that profiles can state.
enum class OpeningShape {
    point,
    rectangle,
    box,
    disk,
    ellipse,
    vertical_cylinder,
    horizontal_cylinder,        // with its axis along the length
    horizontal_cylinder_across, // with its axis along the width
    upright_disk,               // facing the horizon
    sphere,
    ellipsoid
};

const char* to_text(OpeningShape shape); // "vertical-cylinder"

// Sizes in metres, all ≥ 0. A round opening has its diameter in both of the dimensions that it spans, an ellipse or
// elliptic cylinder its two axes.
struct LuminousOpening {
    OpeningShape shape = OpeningShape::point;
    double width_m = 0.0;
    double length_m = 0.0;
    double height_m = 0.0;
};

// LM-63 encodes the shape in the signs of width, length and height, with tables that differ between 1986/1991, 1995 and
// 2002/2019. A combination that the file's edition does not define is a box of these sizes. EULUMDAT has circles and
// rectangles with a height; a width of 0 makes the length a diameter. TM-33 has areas on the faces of an emitter; if
// its bottom face does not have exactly one, the luminaire's own dimensions are used.
LuminousOpening luminous_opening(const Profile& profile);

} // namespace gonio
#pragma GCC visibility pop
