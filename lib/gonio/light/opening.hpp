// Opening: the luminous opening of a luminaire in the frame of its light, and the grammar of "rect:w=1.2m,h=0.3m".
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/profile/luminous_opening.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// Sizes in metres, all ≥ 0, centred at the light's position. A round opening has its diameters in the two or three
// axes that it spans.
struct Opening {
    OpeningShape shape = OpeningShape::point;
    glm::dvec3 size_m{0.0};                    // along X (C0), Y (C90) and Z (up)
    std::array<double, 4> side_heights_m = {}; // of a box: how high the sides facing C0, C90, C180 and C270 shine

    double largest_m() const;
};

// Of a file, as its own C-planes have it: LM-63 and TM-33 measure the length along C0, EULUMDAT the width. An opening
// whose sizes are all 0 is a point.
Opening opening_of(const Profile& profile);

// "rect:w=LENGTH,h=LENGTH" (w along C0, h along C90), "box:w=,h=,d=" (d upwards), "disk:r=", "ellipse:w=,h=",
// "cylinder:r=,l=" (upright), "tube:r=,l=" (along C0), "sphere:r=", "point"; d= is the diameter where r= is the radius.
// Fails (usage) as parse_kind_text() does, on unknown or missing keys and on lengths that are not greater than 0.
Result<Opening> parse_opening(std::string_view text);

// The kinds of parse_opening(): "rect, box, disk, …".
std::string opening_kinds();

// "rectangle, 1.2 × 0.3 m"; "point".
std::string to_text(const Opening& opening);

} // namespace gonio
#pragma GCC visibility pop
