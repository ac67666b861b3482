// The table of unified glare ratings of a luminaire, by CIE 117:1995 and CIE 190:2010.
//
// Luminaires lie in a grid on the ceiling of nineteen standard rooms, and an observer at the middle of a wall looks
// level across the room: UGR = 8 log₁₀(0.25/Lb ΣL²ω/p²). The background's luminance Lb comes from what walls receive by
// reflection, after CIE 190's zonal flux and its four cones; p is Guth's, by its table.
#pragma once

#include <gonio/figures/box_room.hpp>
#include <gonio/figures/figure.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/web/web.hpp>

#include <array>
#include <cstddef>

#pragma GCC visibility push(default)
namespace gonio {

// Sides of a room in heights of the luminaires above the eye: X across the line of sight, Y along it.
struct UgrRoom {
    int across = 0;
    int along = 0;
};

// The rows of a table, 2×2 to 12×8.
inline constexpr std::array<UgrRoom, 19> ugr_rooms{{{2, 2},
                                                    {2, 3},
                                                    {2, 4},
                                                    {2, 6},
                                                    {2, 8},
                                                    {2, 12},
                                                    {4, 2},
                                                    {4, 3},
                                                    {4, 4},
                                                    {4, 6},
                                                    {4, 8},
                                                    {4, 12},
                                                    {8, 4},
                                                    {8, 6},
                                                    {8, 8},
                                                    {8, 12},
                                                    {12, 4},
                                                    {12, 6},
                                                    {12, 8}}};

// The columns for one direction of view.
inline constexpr std::array<RoomReflectances, 5> ugr_reflectances{
    {{0.7, 0.5, 0.2}, {0.7, 0.3, 0.2}, {0.5, 0.5, 0.2}, {0.5, 0.3, 0.2}, {0.3, 0.3, 0.2}}};

// Between the measured directions either the intensity is linear, and is divided by the area seen from each direction;
// or the luminance is, computed at the measured directions. Tables by the first are within 0.11 of CIE 190's example,
// those by the second within 0.27 of Relux', the first within 0.34.
enum class UgrInterpolation { intensity, luminance };

// What a table of UGR is made for.
struct UgrOptions {
    double spacing = 0.25; // between luminaires, in the unit of the rooms' sides, which it divides; 1 in CIE 190
    UgrInterpolation interpolation = UgrInterpolation::intensity;

    // The C of the web from which the luminaire is seen crosswise: 0 in EULUMDAT, −90 in LM-63. Endwise is 90° further.
    double crosswise_c_deg = 0.0;
};

// Unrounded. Ten columns: ugr_reflectances seen crosswise, then endwise, along the luminaire. −∞ in a room where no
// light reaches the eye.
using UgrTable = std::array<std::array<double, 2 * ugr_reflectances.size()>, ugr_rooms.size()>;

// That of a luminaire as it shines, with its own lumens ("corrected for the lamps' flux"); that for lamps of 1000 lm is
// lower by 8 log₁₀(Φ/1000 lm). Only the quarter of C from crosswise to endwise is read, as the rule has it. The opening
// is in the frame of the web. There is none without an opening, if it has no area towards a direction in which it
// shines, if no room has light that reaches the eye, and with a spacing that does not divide the rooms.
Figure<UgrTable> ugr_table(const Web& web, const Opening& opening, const UgrOptions& options = {});

// Luminance of the background in one of the rooms, with the luminaires 1 m above the eye [cd/m²]; it falls with the
// square of that height. `row` and `column` are those of ugr_rooms and ugr_reflectances.
double ugr_background_nt(const Web& web, std::size_t row, std::size_t column, double spacing = 0.25);

} // namespace gonio
#pragma GCC visibility pop
