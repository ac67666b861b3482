// Diagnostic codes about results: colours, outputs and units that are not quite what was asked for. None of them is an
// error.
#pragma once

#include <gonio/base/diagnostic_codes.hpp>

#include <array>
#include <string>
#include <utility>

namespace gonio {

inline constexpr auto result_codes = std::to_array<DiagnosticCode>({
    {"RES0101", Severity::warning, Strict::same, "colour far from the Planckian locus",
     "Beyond a Duv of 0.05 a colour temperature means little, according to the CIE. It is printed all the same."},
    {"RES0102", Severity::warning, Strict::same, "colour without a temperature",
     "The colour is outside the range in which colour temperature is defined. Its other values are printed."},
    {"RES0103", Severity::warning, Strict::same, "spectrum that is too short",
     "The spectrum does not cover 380 to 780 nm. It is taken as 0 outside its own range."},
    {"RES0104", Severity::warning, Strict::same, "colour outside Rec.709",
     "Lights have colours of linear Rec.709. The colour is moved into it at the same luminance."},
    {"RES0105", Severity::warning, Strict::same, "several spectra",
     "The profile has more than one spectrum, and a light has one colour: that of the first."},
    {"RES0106", Severity::warning, Strict::same, "colour temperature that cannot be read",
     "The profile states a colour temperature in words that gonio does not understand. The light is white."},
    {"RES0107", Severity::warning, Strict::same, "colour configuration without an interchange role",
     "The configuration does not say which of its spaces is ACES2065-1. Linear Rec.709 is taken for its scene_linear."},
    {"RES0108", Severity::warning, Strict::same, "colour outside the artists' charts",
     "Few real materials have such a colour, according to the charts of Remember Me (2013). The value is used as "
     "given."},
    {"RES0109", Severity::warning, Strict::same, "colour rendering far from the reference illuminant",
     "The light is more than 5.4e-3 in u, v from the reference illuminant of its temperature. CIE 13.3 considers Ra "
     "and "
     "R1 to R15 inaccurate then. They are printed all the same."},
    {"RES0110", Severity::warning, Strict::same, "spectrum in coarse steps",
     "Figures of quality are defined for spectra in steps of at most 5 nm. Between its points this one is taken as "
     "linear."},
    {"RES0111", Severity::warning, Strict::same, "light without a reference illuminant",
     "Colour rendering compares a light with one of the same colour temperature, from 500 to 25000 K. This light has "
     "no such temperature."},

    {"RES0201", Severity::warning, Strict::same, "something that the target cannot store",
     "The program that the file is for does not have this. The message states what is written instead."},
    {"RES0202", Severity::warning, Strict::same, "error not reached",
     "The evaluation of a light stopped at its limit of evaluations before it reached the requested error."},
    {"RES0203", Severity::warning, Strict::same, "illuminance at its limit",
     "The value is the greatest that gonio computes. The true value is higher."},
    {"RES0204", Severity::note, Strict::same, "layer with another name",
     "The name of the light is not the name of a layer yet: other characters are replaced, and equal names numbered."},
    {"RES0205", Severity::warning, Strict::same, "names that differ only in case",
     "On a file system that ignores case, one of the files replaces the other."},
    {"RES0206", Severity::warning, Strict::same, "black texture",
     "The layout covers only some directions, and the light shines in others: an uplight has nothing below the "
     "horizon."},
    {"RES0207", Severity::warning, Strict::same, "black picture",
     "There are lights that shine, but no surface that the camera sees gets any: the lights are hidden behind a wall, "
     "stand outside the stage, or face away."},
    {"RES0208", Severity::note, Strict::same, "table smoothed",
     "You asked for a smooth curve between the angles of a profile's table. All values of the table are kept. Between "
     "them the luminaire was not measured: the flux is that of the curve, and the message states it before and "
     "after."},
    {"RES0209", Severity::warning, Strict::same, "report without pictures",
     "A report shows each profile in a picture, which needs the modules of the package gonio-media. They are not "
     "installed, so the report is written without them. With --no-picture it leaves them out without a warning."},
    {"RES0210", Severity::note, Strict::same, "letters that a sheet cannot show",
     "Data sheets have the letters of DejaVu Sans: Latin, Greek, Cyrillic and signs. Others, and control characters, "
     "are shown as U+FFFD. The profile keeps them."},

    {"RES0301", Severity::warning, Strict::same, "amount that the program takes for another",
     "By the convention of the program, the light does not emit what the number states in SI units."},
    {"RES0302", Severity::note, Strict::same, "unit that the program does not use",
     "The convention of the program does not cover this unit. The amount keeps its physical meaning."},
    {"RES0303", Severity::note, Strict::same, "lobe of the program",
     "The program has one way in which the light of a spot falls towards the edge, and it is not the way that you "
     "named. The numbers are those of the light that the program shows."},

    {"RES0401", Severity::warning, Strict::same, "point on a light without size",
     "The illuminance at the position of a point light is infinite. The light counts as 0 there."},
    {"RES0402", Severity::note, Strict::same, "point inside a light",
     "The point is inside a luminous solid, which lights it from all sides."},
    {"RES0403", Severity::note, Strict::same, "surface seen from below",
     "The view comes from below the surface, where its luminance is 0."},
    {"RES0404", Severity::note, Strict::same, "luminaire without an opening",
     "You asked for the luminous opening of a profile that declares none, or one of size zero. The light is a point."},
    {"RES0405", Severity::warning, Strict::same, "opening of an implausible size",
     "The luminous opening is larger than luminaires are. Its sizes may be written in another unit."},
    {"RES0406", Severity::warning, Strict::same, "light through the back of an opening",
     "The opening is flat, and the profile has light on both of its sides. So both sides emit, each with the "
     "intensities of its own hemisphere."},
    {"RES0407", Severity::warning, Strict::same, "point near a luminaire",
     "A profile is measured from far away. Nearer than five times the size of its luminous opening, a point with its "
     "intensities is several per cent off, and within its size by a factor of two and more."},
    {"RES0408", Severity::warning, Strict::same, "point inside a solid",
     "No light reaches the inside of a solid or the back of a plane. Both hide light only from points outside and in "
     "front, so the value has no meaning."},
    {"RES0409", Severity::note, Strict::same, "cells too small for their numbers",
     "The plan of a grid has a number in each cell where the cell has room for it at a legible size."},

    {"RES0501", Severity::warning, Strict::same, "pixels that cannot be light",
     "The image has pixels that are negative, infinite or not a number. You asked to go on: they are black."},
    {"RES0502", Severity::warning, Strict::same, "image at the end of half floats",
     "16-bit floats end at 65504. The sun is far brighter in most units, so its light is cut off and the lux are too "
     "low."},
    {"RES0503", Severity::warning, Strict::same, "image with a flat maximum",
     "Many pixels have exactly the greatest value, far above the mean. A camera or a program has cut off what was "
     "brighter."},
    {"RES0504", Severity::warning, Strict::same, "image with a sun",
     "A small spot has a large share of the light: the sun or a lamp in the pixels. Its shadows and highlights are as "
     "coarse as the texels, and directions that are sampled evenly miss it. Taken out, it is a light of its own."},
    {"RES0505", Severity::note, Strict::same, "image with an exposure",
     "The lines EXPOSURE= of a Radiance picture say by what its pixels were multiplied. They are divided by it."},

    {"RES0601", Severity::warning, Strict::same, "glare outside the range of the rule",
     "UGR holds for luminaires that fill 0.0003 to 0.1 sr of the view. A larger one, as a luminous ceiling or one "
     "close "
     "to the eye, is rated all the same."},
    {"RES0602", Severity::note, Strict::same, "no rating of glare",
     "UGR needs the luminance of the luminaires, and the profile states no luminous opening; or none of their light "
     "reaches the eye."},
});
static_assert(in_order(result_codes));

inline Diagnostic result_diagnostic(CodeOf<result_codes> code, std::string message, std::string hint = {},
                                    std::string file = {}) {
    return {std::string(code->code), code->severity, {std::move(file), 0, 0}, std::move(message), std::move(hint)};
}

} // namespace gonio
