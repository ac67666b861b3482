// Diagnostic codes of webs: those that resolving a profile (01), writing a web back into a file (02) and the
// plausibility check (03) may emit.
#pragma once

#include <gonio/base/diagnostic_codes.hpp>

#include <array>

namespace gonio {

inline constexpr auto web_codes = std::to_array<DiagnosticCode>({
    {"WEB0101", Severity::warning, Strict::same, "the last C-plane is missing",
     "A table without symmetry should list its first plane again at 360°. This one ends one step before it. The "
     "gap is closed with the first plane."},
    {"WEB0102", Severity::warning, Strict::same, "C-planes do not cover the full turn",
     "The planes end more than one step before the full turn, and their range does not match a symmetry. "
     "Directions outside them get no light."},
    {"WEB0103", Severity::warning, Strict::same, "a single C-plane that is not at 0°",
     "One plane means the same light for every C, at whatever angle it was measured."},
    {"WEB0104", Severity::warning, Strict::same, "a factor where the standard has none",
     "LM-63-1986 and LM-63-1991 have a ballast-lamp factor as the twelfth number. LM-63-1995 and LM-63-2002 "
     "reserve it as 1. It is not applied."},
    {"WEB0105", Severity::warning, Strict::same, "negative intensities",
     "Subtracting stray light from a measurement can leave values below 0. Flux and samples count them as they "
     "are; textures and pictures hold 0 instead."},
    {"WEB0106", Severity::warning, Strict::same, "no light", "Every intensity of the table is 0."},
    {"WEB0107", Severity::warning, Strict::same, "a table that covers no solid angle",
     "A table of type A or B needs at least two horizontal and two vertical angles, because its light lies "
     "between them. A single angle is a line of directions, which carries no flux."},
    {"WEB0108", Severity::error, Strict::same, "an intensity out of range",
     "An intensity, with the factors of the file or its lamps applied, is above 1e30 cd. The sun has 3e27 cd, and "
     "no luminaire comes near it. Textures and engines hold 32-bit floats, which end at 3.4e38. A factor or an "
     "exponent is wrong."},
    {"WEB0109", Severity::warning, Strict::same, "a single C-plane without symmetry",
     "EULUMDAT states rotational symmetry as 1. A file with symmetry 0 and one plane has no light at any other C "
     "by the letter, but those who write it mean a round light. The plane is used for every C."},
    {"WEB0110", Severity::warning, Strict::same, "intensities that are not candela",
     "A keyword states that the table holds radiant intensity, for example mW/sr of an ultraviolet lamp. Its sums are "
     "milliwatts, not lumens. Textures, assets and pictures are refused unless --as-candela asks for them."},

    {"WEB0201", Severity::warning, Strict::same, "keywords left out",
     "The target has no place for these keywords. EULUMDAT keeps only the company, the name and number of the "
     "luminaire, the report number, the date and the lamp."},
    {"WEB0202", Severity::warning, Strict::same, "TILT factors applied",
     "The target cannot hold the factors for a tilted lamp. The table was multiplied by the factor of one tilt, "
     "which is 0 unless you ask for another. The other factors are lost."},
    {"WEB0203", Severity::warning, Strict::same, "other lamp sets left out",
     "EULUMDAT lists alternative sets of lamps; the target describes one. The intensities are those of the set "
     "that was asked for, the first by default."},
    {"WEB0204", Severity::warning, Strict::same, "spectrum left out",
     "The source holds a spectrum. LM-63 and EULUMDAT cannot store one."},
    {"WEB0205", Severity::warning, Strict::same, "resampled to type C",
     "The source was measured in type A or B coordinates, and the target holds only type C. The web was rotated "
     "exactly and sampled on C-planes. Between the samples it is interpolated, with the stated error."},
    {"WEB0206", Severity::note, Strict::same, "gamma range padded with zeros",
     "There is no light outside the angles of a table. But many readers repeat its first and last value there, "
     "and the formats ask for tables that begin at 0 or 90 and end at 90 or 180 degrees. Zeros were written "
     "outside, beginning 0.0001 degrees beyond the last value."},
    {"WEB0207", Severity::note, Strict::same, "dark sector padded with zeros",
     "The planes do not cover the full turn, and the sector between them is dark. It was written as planes of "
     "zeros that begin 0.0001 degrees beside the last lit plane."},
    {"WEB0208", Severity::note, Strict::same, "symmetry written out",
     "The target does not have this symmetry, or its readers do not know it. The mirrored planes were written "
     "out. Nothing is lost."},
    {"WEB0209", Severity::warning, Strict::same, "shape of the luminous opening changed",
     "The target has no code for this shape. The nearest shape with the same sizes was written."},
    {"WEB0210", Severity::warning, Strict::same, "fields of EULUMDAT left out",
     "LM-63 cannot store the size of the housing, the file name, the ratios or the tilt during the measurement."},
    {"WEB0211", Severity::warning, Strict::same, "file generation type left out",
     "The twelfth number of LM-63-2019 says how a file was made: measured, simulated or scaled, and by what kind "
     "of laboratory. Other formats do not store this."},
    {"WEB0212", Severity::warning, Strict::same, "text converted to ASCII",
     "The portable dialect is written in ASCII. Letters lost their accents, and other characters became question "
     "marks."},
    {"WEB0213", Severity::note, Strict::same, "lumens are those of the table",
     "The portable dialect has one lamp, and its lumens are the flux of the table. With -1, absolute photometry, "
     "some loaders fail and others assume 1000 lumens. Some scale the light to the declared lumens."},
    {"WEB0214", Severity::note, Strict::same, "planes at 0 and 360 degrees kept apart",
     "The source has two different planes at the same angle. EULUMDAT lists the angle once, so the other plane "
     "was written 0.0001 degrees before the full turn."},
    {"WEB0215", Severity::note, Strict::same, "required keywords added",
     "LM-63-2002 and later require [TEST], [TESTLAB], [ISSUEDATE] and [MANUFAC]. Those that the source does not "
     "give were written as \"unknown\"."},
    {"WEB0217", Severity::note, Strict::same, "TILT factors written into the file",
     "The source names another file that holds its TILT factors. They are written as TILT=INCLUDE, because that "
     "file may not be in the folder of the output."},
    {"WEB0218", Severity::warning, Strict::same, "emitters added up",
     "TM-33 describes each emitter of a luminaire; the target has one table and one lamp. The intensities were "
     "added. The description of the lamp is that of the first emitter."},
    {"WEB0219", Severity::note, Strict::same, "stored by its symmetry",
     "You asked to look for symmetry, and the planes of the table repeat one another. The planes that the "
     "symmetry restores are left out. The light is the same, within the tolerance that you asked for."},
    {"WEB0220", Severity::note, Strict::same, "azimuths of the other standard",
     "In LM-63 and TM-33, C0 is along the luminaire; in EULUMDAT it is across. Length, width and C were written under "
     "the same names as in the source, so a program that follows both standards shows the light turned by 90 degrees. "
     "Many files of manufacturers are written like this, because programs differ. '--azimuth' turns the light."},
    {"WEB0221", Severity::warning, Strict::same, "control characters left out",
     "XML cannot hold control characters other than tab and the ends of lines. They are left out of the keywords."},

    {"WEB0301", Severity::warning, Strict::same, "more light than the lamps give",
     "The flux of the table exceeds the lumens that the file declares for its lamps. Usual causes are the lumens "
     "of another lamp, a factor that was applied twice, or absolute photometry with lumens written beside it. "
     "gonio uses the table."},
    {"WEB0302", Severity::warning, Strict::same, "hardly any of the light of the lamps",
     "The flux of the table is below a tenth of the lumens that the file declares. Usual causes are the lumens of "
     "another lamp or a missing factor. gonio uses the table."},
    {"WEB0303", Severity::error, Strict::same, "more lumens per watt than light can have",
     "Light of 555 nm has 683 lumens per watt, and no light has more. The input watts or the table are wrong."},
    {"WEB0304", Severity::warning, Strict::same, "more lumens per watt than any luminaire has",
     "No known white light source has more than 300 lumens per watt. The input watts are probably those of "
     "another lamp."},
    {"WEB0305", Severity::note, Strict::same, "no input power", "The file gives no watts, so there is no efficacy."},
    {"WEB0306", Severity::warning, Strict::same, "luminous opening of an implausible size",
     "A size is above 50 metres, or below half a millimetre but not 0. It is probably written in another unit "
     "than the file names."},
    {"WEB0307", Severity::warning, Strict::same, "brighter than the sun",
     "The greatest intensity divided by the area of the luminous opening is above the luminance of the sun's "
     "disk, 1.6e9 cd/m2. The opening or the table is written in another unit."},
    {"WEB0308", Severity::warning, Strict::same, "an isolated value",
     "One value of the table is far above all its neighbours. No optic does this: the value has a digit too many, "
     "or the measurement failed there."},
    {"WEB0309", Severity::warning, Strict::same, "light at the edge of the table",
     "The table ends where the light still has more than a tenth of its peak. What lies beyond was not measured "
     "and is taken as dark. Programs that continue the last value show a different light."},
    // WEB0310 was "a dark hemisphere", and is never used again.
    {"WEB0311", Severity::note, Strict::same, "more planes than the light needs",
     "The light is the same in mirrored planes. The formats allow a file to leave these out."},
    {"WEB0312", Severity::warning, Strict::same, "downward flux fraction does not match the table",
     "Line 22 of EULUMDAT is the share of the light that goes below the horizon, in per cent. It differs from the "
     "share in the table by more than two percentage points."},
    {"WEB0313", Severity::warning, Strict::same, "light output ratio does not match the table",
     "Line 23 of EULUMDAT is the share of the lamps' flux that leaves the luminaire, in per cent. It differs from "
     "the share in the table by more than two percentage points."},
    {"WEB0314", Severity::warning, Strict::same, "impossible direct ratios",
     "A direct ratio is a share of the downward flux and rises with the room index. It lies between 0 and 1 and "
     "never falls."},
    {"WEB0315", Severity::warning, Strict::same, "lamps without flux",
     "EULUMDAT lists candela per 1000 lumens of the lamps. Without lumens there is no light."},
    {"WEB0316", Severity::warning, Strict::same, "luminous area larger than the luminaire",
     "The luminous area is a part of the luminaire, but its sizes in millimetres are larger."},
    {"WEB0317", Severity::warning, Strict::same, "impossible colour",
     "The colour temperature of light sources lies between 1000 and 25000 kelvin, and a colour rendering index "
     "does not exceed 100."},
    {"WEB0318", Severity::warning, Strict::same, "input power of 1 W",
     "More than 300 lm/W from exactly 1 W: programs write 1 where the watts are not known. The standard has 0 for "
     "that."},
    {"WEB0319", Severity::warning, Strict::same, "a large luminous opening",
     "One of the sizes is above 4 m. There are such luminaires, but more often the unit of the file is not that of "
     "its sizes."},
});
static_assert(in_order(web_codes));

using WebCode = CodeOf<web_codes>;

} // namespace gonio
