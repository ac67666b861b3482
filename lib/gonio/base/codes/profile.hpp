// Diagnostic codes of photometric files: what the readers may emit. PRF…: any of them, IES…: LM-63, LDT…: EULUMDAT,
// TM3…: TM-33. 01 is of the text, 02 of numbers and counts, 03 of angles, 04 of what the table says.
#pragma once

#include <gonio/base/diagnostic_codes.hpp>

#include <array>

namespace gonio {

inline constexpr auto profile_codes = std::to_array<DiagnosticCode>({
    {"PRF0101", Severity::error, Strict::same, "empty file", "The file holds nothing, or blanks alone."},
    {"PRF0102", Severity::error, Strict::same, "not a photometric file",
     "IES and EULUMDAT files are text. Control bytes mean something else under a photometric name: a picture, an "
     "archive, a resource fork that a copy left behind."},
    {"PRF0103", Severity::error, Strict::same, "format not recognised",
     "An IES file names its version in the first line or has a TILT= line; a EULUMDAT file has numbers in lines 2 to "
     "7; a TM-33 document is XML with an outermost element of a known name. This text has none of it, and the file's "
     "name does not tell."},
    {"PRF0104", Severity::warning, Strict::same, "byte order mark",
     "The text begins with the three bytes of a UTF-8 byte order mark. Both formats ask for plain text; many readers "
     "fail to recognise the first line behind such a mark. It is ignored."},
    {"PRF0105", Severity::warning, Strict::same, "data after Ctrl-Z",
     "Ctrl-Z (byte 26) ends a text in the DOS tradition. What follows it is ignored."},
    {"PRF0106", Severity::warning, Strict::error, "UTF-16 text",
     "The file is UTF-16: two bytes a character. The formats are defined over single bytes, and hardly another "
     "program reads this. It is converted to UTF-8 and read; lines and columns are those of the converted text."},
    {"PRF0108", Severity::warning, Strict::same, "XML that is not UTF-8",
     "TM-33 is XML, whose text is UTF-8. This one has other bytes; it is read as Windows-1252."},

    {"IES0101", Severity::warning, Strict::same, "unusual spelling of the version line",
     "The standards write IESNA91, IESNA:LM-63-1995, IESNA:LM-63-2002 and IES:LM-63-2019, without blanks around. "
     "Other spellings of the same years are understood; other programs may refuse them."},
    {"IES0102", Severity::warning, Strict::same, "unknown version",
     "The first line claims LM-63 but names no version that gonio knows. The file is read as LM-63-2002: the twelfth "
     "number is not a factor, and dimensions follow the codes of 2002."},
    {"IES0103", Severity::warning, Strict::same, "no version line",
     "Files of LM-63-1986 have no version line, and this one is read as such: the twelfth number is a factor. A newer "
     "file that lost its first line means something else by it."},
    {"IES0104", Severity::warning, Strict::same, "line without a keyword",
     "From 1991 on every line before TILT= begins with a keyword in brackets. The line is kept as a label."},
    {"IES0105", Severity::warning, Strict::same, "[MORE] continues nothing",
     "[MORE] continues the keyword before it, and there is none. It is kept as a keyword of its own."},
    {"IES0106", Severity::warning, Strict::same, "required keyword missing",
     "LM-63-2002 and later require [TEST], [TESTLAB], [ISSUEDATE] and [MANUFAC]."},
    {"IES0107", Severity::warning, Strict::only, "line too long",
     "LM-63-2002 allows 256 characters in a line, LM-63-1995 and before 132, line ends included. Some readers cut "
     "longer lines."},
    {"IES0108", Severity::error, Strict::same, "no TILT= line",
     "A line TILT=NONE, TILT=INCLUDE or TILT=FILE separates the keywords from the numbers; without it the numbers "
     "cannot be told from text."},
    {"IES0109", Severity::warning, Strict::same, "blanks in the TILT line",
     "The line should be TILT=NONE, TILT=INCLUDE or TILT=FILE from its first column and without blanks; several "
     "programs find it only so."},
    {"IES0110", Severity::warning, Strict::error, "TILT line not in capitals",
     "The standard writes TILT, NONE and INCLUDE in capitals."},
    {"IES0111", Severity::warning, Strict::error, "TILT factors are not read",
     "The factors for a tilted lamp are in a file of their own, which must lie beside the profile and be named "
     "without a folder. It could not be had, and the profile is read without factors: as for a lamp that is used in "
     "the position it was measured in. Put the factors into this file as TILT=INCLUDE."},
    {"IES0112", Severity::warning, Strict::error, "TILT file in LM-63-2019",
     "LM-63-2019 allows TILT=NONE and TILT=INCLUDE only. The file is read as in the editions before."},
    {"IES0113", Severity::error, Strict::same, "lamp geometry out of range",
     "Behind TILT=INCLUDE, and in the file of TILT=FILE, stands the lamp-to-luminaire geometry, which is 1, 2 or 3."},
    {"IES0114", Severity::error, Strict::same, "TILT table broken",
     "A TILT table announces a number of tilt angles; as many ascending angles and as many factors must follow."},
    {"IES0115", Severity::warning, Strict::only, "keyword of no standard",
     "From LM-63-2002 on, a keyword that the standard does not define begins with an underscore: [_MOUNTING]."},

    {"IES0201", Severity::error, Strict::same, "not a number",
     "From the line after TILT= on the file holds numbers only, separated by blanks, commas or line ends. A decimal "
     "comma is never read as one in IES: a comma separates."},
    {"IES0202", Severity::error, Strict::same, "not a finite number up to 1e30",
     "Infinite and undefined values, and numbers above 1e30 in magnitude, mean nothing in a photometric file: the sun "
     "has 3e27 cd, and what gonio makes of a table must fit 32-bit floats."},
    {"IES0203", Severity::error, Strict::same, "not a whole number in range",
     "Counts and codes are whole numbers; counts of angles are at least 1. 37.0 is read as 37."},
    {"IES0204", Severity::error, Strict::same, "vertical angles missing",
     "The fourth number behind TILT announces how many vertical angles follow, and fewer do: the file is cut off, or "
     "the count is wrong."},
    {"IES0205", Severity::error, Strict::same, "horizontal angles missing",
     "The fifth number behind TILT announces how many horizontal angles follow, and fewer do: the file is cut off, or "
     "the count is wrong."},
    {"IES0206", Severity::error, Strict::same, "candela values missing",
     "There must be one value for every vertical angle in every horizontal plane: the file is cut off, or a count is "
     "wrong."},
    {"IES0207", Severity::error, Strict::same, "header numbers missing",
     "Thirteen numbers stand between TILT and the angles: lamps, lumens per lamp, multiplier, counts of vertical and "
     "horizontal angles, photometric type, unit, width, length, height, ballast factor, a field whose meaning depends "
     "on the version, and input watts."},
    {"IES0208", Severity::error, Strict::same, "unknown photometric type",
     "The sixth number behind TILT is 1 for type C, 2 for type B, 3 for type A."},
    {"IES0209", Severity::error, Strict::same, "unknown unit of length",
     "The seventh number behind TILT is 1 for feet, 2 for metres."},
    {"IES0210", Severity::warning, Strict::error, "lumens neither positive nor -1",
     "Lumens per lamp are positive, or -1 in absolute photometry. Any other value is read as absolute."},
    {"IES0211", Severity::error, Strict::same, "candela multiplier not positive",
     "The multiplier scales the whole table; zero or less leaves no light to speak of."},
    {"IES0212", Severity::warning, Strict::same, "ballast factor not positive",
     "The ballast factor scales the whole table and is near 1 in real luminaires."},
    {"IES0213", Severity::warning, Strict::same, "field 12 has no such value",
     "The twelfth number is a ballast-lamp factor up to 1991, reserved and 1 in 1995 and 2002, and the file "
     "generation type in 2019: 1.00001 undefined, 1.0001 simulated, 1 and 1.1 tested at an unaccredited or accredited "
     "laboratory, with .001 for scaled lumens and .01 for interpolated angles. Here it is none of these; it is kept, "
     "and from 1995 on it is not a factor."},
    {"IES0214", Severity::warning, Strict::same, "text after the table",
     "The announced values were all read and something follows. Either it is a remark, or a count is wrong."},
    {"IES0215", Severity::warning, Strict::same, "number of lamps not positive",
     "A luminaire has at least one lamp. The count does not change the candela values."},
    {"IES0216", Severity::warning, Strict::only, "number with an exponent",
     "LM-63 writes plain decimals; some readers stop at an exponent. The value is read."},
    {"IES0217", Severity::warning, Strict::only, "count with a decimal point",
     "LM-63 writes counts and codes as integers since 1991; some readers refuse 37.0. The value is read."},
    {"IES0218", Severity::warning, Strict::same, "negative input watts",
     "The input power in watts cannot be negative. It is kept as written."},
    {"IES0219", Severity::warning, Strict::error, "unknown shape of the luminous opening",
     "The signs of width, length and height code the shape of the luminous opening, by a table that differs between "
     "versions. This combination is in none of them for this version; it is taken as a box of these dimensions."},

    {"IES0301", Severity::error, Strict::same, "vertical angles not ascending",
     "Vertical angles are listed from the lowest to the highest. A count that is wrong also shows like this, because "
     "the next list is then read too early or too late."},
    {"IES0302", Severity::error, Strict::same, "horizontal angles not ascending",
     "Horizontal angles are listed from the lowest to the highest. A count that is wrong also shows like this, "
     "because the lists around it are then read too early or too late."},
    {"IES0303", Severity::warning, Strict::same, "vertical angle repeated",
     "Two values are given for the same vertical angle; between them the light jumps."},
    {"IES0304", Severity::warning, Strict::same, "horizontal angle repeated",
     "Two planes are given for the same horizontal angle; between them the light jumps."},
    {"IES0305", Severity::warning, Strict::same, "vertical range unusual",
     "Type C runs from 0 or 90 to 90 or 180 degrees, types A and B from -90 or 0 to 90. Directions outside the listed "
     "angles get no light."},
    {"IES0306", Severity::warning, Strict::same, "horizontal range unusual",
     "Type C runs from 0 to 0, 90, 180 or 360 degrees (in 1995 also from 90 to 270), types A and B from -90 or 0 to "
     "90. Directions that no symmetry reaches get no light."},
    {"IES0307", Severity::error, Strict::same, "angle out of range",
     "No direction has such an angle: vertical angles lie in 0 to 180 degrees in type C and in -90 to 90 in types A "
     "and B; horizontal angles span one turn at most."},
    {"IES0308", Severity::warning, Strict::same, "single plane not at 0",
     "A file with one plane is the same all around; its horizontal angle should be 0 and is not used."},
    {"IES0309", Severity::warning, Strict::same, "no plane at 360 degrees",
     "A table around the full turn ends with the plane at 360 degrees, equal to the one at 0. It is missing and the "
     "gap is as wide as a step, so the turn is closed with the plane at 0."},
    {"IES0310", Severity::warning, Strict::same, "planes from 90 to 270 degrees",
     "A table from 90 to 270 degrees, symmetric about the plane 90-270, was defined in LM-63-1995 only. It is read so "
     "in every version."},
    {"IES0311", Severity::error, Strict::same, "more vertical angles than announced",
     "The list of vertical angles seems to go on behind the announced count, in the line where the horizontal angles "
     "should begin: the fourth number behind TILT is too small, and every value would stand at another angle."},

    {"IES0401", Severity::warning, Strict::same, "negative candela",
     "A table whose stray light was subtracted too eagerly has values below zero. They are kept."},
    {"IES0402", Severity::warning, Strict::same, "no light", "Every value of the table is zero."},
    {"IES0403", Severity::warning, Strict::same, "planes disagree at the pole",
     "All planes of type C meet at nadir (0 degrees) and zenith (180 degrees), where there is one intensity. Here "
     "they differ by more than a thousandth of the peak; each plane keeps its own value."},
    {"IES0404", Severity::warning, Strict::same, "planes at 0 and 360 degrees differ",
     "They are the same plane, and differ by more than a thousandth of the peak. Both are kept: the light jumps "
     "there."},

    {"LDT0101", Severity::error, Strict::same, "file ends in its head",
     "A EULUMDAT file has 26 lines, six for each set of lamps, ten direct ratios, and then the table."},
    {"LDT0102", Severity::error, Strict::same, "not a number",
     "This line must hold one number. A decimal comma is read as a point."},
    {"LDT0103", Severity::error, Strict::same, "not a finite number up to 1e30",
     "Infinite and undefined values, and numbers above 1e30 in magnitude, mean nothing in a photometric file: the sun "
     "has 3e27 cd, and what gonio makes of a table must fit 32-bit floats."},
    {"LDT0104", Severity::warning, Strict::error, "blank line for a number",
     "A number is expected in this line and it is blank. It is read as 0."},
    {"LDT0105", Severity::warning, Strict::same, "decimal comma",
     "EULUMDAT writes a decimal point. The comma is read as one; other programs read the number only up to it."},
    {"LDT0106", Severity::warning, Strict::same, "text field too long",
     "EULUMDAT allows 78 characters in a text, 24 for a lamp's type, 16 for its colour and 6 for its colour "
     "rendering. The text is kept whole."},
    {"LDT0107", Severity::warning, Strict::only, "file name too long",
     "EULUMDAT allows 8 characters for the file's name in line 11, as DOS did. Longer names are usual and harm "
     "nothing; the name is kept whole."},

    {"LDT0201", Severity::error, Strict::same, "not a whole number in range",
     "Counts and codes are whole numbers; there is at least one plane, one angle and one set of lamps."},
    {"LDT0202", Severity::error, Strict::same, "unknown symmetry",
     "Line 3 is 0 without symmetry, 1 about the vertical axis, 2 to plane C0-C180, 3 to plane C90-C270, 4 to both."},
    {"LDT0203", Severity::warning, Strict::error, "unknown type of luminaire",
     "Line 2 is 1 for a point source with symmetry about the vertical axis, 2 for a linear luminaire, 3 for a point "
     "source with another symmetry; some programs write 0."},
    {"LDT0204", Severity::error, Strict::same, "C-planes missing",
     "Line 4 announces how many C-planes there are over the full turn; all their angles are listed, also of the "
     "planes that symmetry leaves out of the table."},
    {"LDT0205", Severity::error, Strict::same, "gamma angles missing",
     "Line 6 announces how many gamma angles are listed, and fewer are."},
    {"LDT0206", Severity::error, Strict::same, "intensities missing",
     "The table has one value for every gamma angle in every plane that the symmetry stores."},
    {"LDT0207", Severity::warning, Strict::same, "text after the table",
     "The announced values were all read and something follows. Either it is a remark, or a count is wrong."},
    {"LDT0208", Severity::warning, Strict::error, "symmetric planes written out",
     "Line 3 announces a symmetry, by which some planes are left out of the table, and yet the table holds all of "
     "them. It is read as it stands, plane by plane."},
    {"LDT0209", Severity::warning, Strict::same, "plane count does not fit the symmetry",
     "A symmetry to one plane needs an even number of planes, to both a multiple of four, else the planes of symmetry "
     "are not among those stored."},
    {"LDT0210", Severity::warning, Strict::same, "no lamps in a set",
     "The number of lamps in a set is positive, or negative in absolute photometry."},

    {"LDT0301", Severity::error, Strict::same, "C-planes not ascending",
     "C-planes are listed from the lowest angle to the highest. A wrong count or a missing line also shows like "
     "this."},
    {"LDT0302", Severity::error, Strict::same, "gamma angles not ascending",
     "Gamma angles are listed from the lowest to the highest. A wrong count or a missing line also shows like this."},
    {"LDT0303", Severity::warning, Strict::same, "C-plane repeated",
     "Two planes are given at the same angle; between them the light jumps."},
    {"LDT0304", Severity::warning, Strict::same, "gamma angle repeated",
     "Two values are given for the same gamma angle; between them the light jumps."},
    {"LDT0305", Severity::warning, Strict::same, "C-plane distance does not fit",
     "Line 5 is the distance between C-planes, 0 when they are not equidistant. The listed angles say otherwise, and "
     "they are used."},
    {"LDT0306", Severity::warning, Strict::same, "gamma distance does not fit",
     "Line 7 is the distance between gamma angles, 0 when they are not equidistant. The listed angles say otherwise, "
     "and they are used."},
    {"LDT0307", Severity::error, Strict::same, "angle out of range",
     "C-planes lie in 0 to 360 degrees, gamma angles in 0 to 180."},
    {"LDT0308", Severity::warning, Strict::same, "gamma range unusual",
     "Gamma angles run from 0 or 90 to 90 or 180 degrees. Directions outside the listed angles get no light."},

    {"LDT0401", Severity::warning, Strict::same, "negative intensity",
     "A table whose stray light was subtracted too eagerly has values below zero. They are kept."},
    {"LDT0402", Severity::warning, Strict::same, "no light", "Every value of the table is zero."},
    {"LDT0403", Severity::warning, Strict::same, "planes disagree at the pole",
     "All planes meet at nadir (0 degrees) and zenith (180 degrees), where there is one intensity. Here they differ "
     "by more than a thousandth of the peak; each plane keeps its own value."},
    {"LDT0404", Severity::warning, Strict::same, "direct ratios all zero",
     "The ten direct ratios are for the utilisation-factor method and can be computed from the table."},
    {"LDT0405", Severity::warning, Strict::same, "light output ratio is zero",
     "Line 23 is the share of the lamps' flux that leaves the luminaire, 100 in absolute photometry."},
    {"LDT0406", Severity::note, Strict::same, "conversion factor is not 1",
     "Line 24 is a factor on the intensities that depends on the measurement."},
    {"LDT0407", Severity::note, Strict::same, "tilted during measurement",
     "Line 25 is the luminaire's tilt while it was measured, of importance for road luminaires. Nothing is turned."},
    {"LDT0408", Severity::warning, Strict::same, "absolute photometry with losses",
     "A negative number of lamps says that the flux is the luminaire's own, so that all of it leaves the luminaire: "
     "line 23 should be 100. The intensities are per 1000 lm of that flux whatever stands there."},

    {"TM30101", Severity::error, Strict::same, "not well-formed XML",
     "The document breaks the rules of XML at this place: a tag that is not closed, an attribute without quotes, a "
     "sign that must be written as an entity."},
    {"TM30102", Severity::error, Strict::same, "no TM-33 document",
     "The outermost element of TM-33 is IESTM33-22, before 2023 IESTM33; ATLA_S001 and LuminaireOpticalData are read "
     "as well."},
    {"TM30103", Severity::warning, Strict::error, "required element missing",
     "The schema of TM-33 requires these elements; what they say is not known."},
    {"TM30104", Severity::warning, Strict::same, "unknown version",
     "Versions 1.0 and 1.1 are known. The document is read as they are."},
    {"TM30105", Severity::error, Strict::same, "no emitter",
     "All light of TM-33 is described by Emitter elements, and there is none."},
    {"TM30106", Severity::warning, Strict::same, "dialect of a program",
     "LuminaireOpticalData is how some programs write what TM-33 describes, partly with other names. It is "
     "understood."},
    {"TM30107", Severity::error, Strict::same, "nested too deeply",
     "TM-33 needs eight levels of elements; more than 64 are refused."},
    {"TM30201", Severity::warning, Strict::error, "not a number",
     "The element should hold a number. It is taken as not given, and written back as it stands."},
    {"TM30202", Severity::warning, Strict::error, "neither true nor false",
     "The element should be true or false. It is taken as not given, and written back as it stands."},
    {"TM30203", Severity::warning, Strict::error, "count does not fit",
     "NumberMeasured, NumberHorz, NumberVert and NumberWavelength say how many points and angles there are. The "
     "points say otherwise, and they are used."},
    {"TM30204", Severity::error, Strict::same, "points missing",
     "Every vertical angle must have a point in every horizontal plane; scattered points are not interpolated."},
    {"TM30205", Severity::error, Strict::same, "point given twice",
     "Two points stand at the same pair of angles, so that the intensity there is not known."},
    {"TM30206", Severity::error, Strict::same, "point without angles",
     "Each point of the intensity carries a horizontal and a vertical angle, as the attributes h and v."},
    {"TM30207", Severity::error, Strict::same, "not a number in a table",
     "Points of intensity and spectra, their angles and wavelengths are numbers."},
    {"TM30208", Severity::error, Strict::same, "multiplier not positive",
     "The multiplier scales the whole table; zero or less leaves no light to speak of."},
    {"TM30209", Severity::warning, Strict::error, "odd quantity",
     "Quantity is how many such emitters there are; it does not scale the intensity. 4294967295 is a minus one that a "
     "program took for a positive number."},
    {"TM30210", Severity::warning, Strict::error, "unknown symmetry",
     "Symm is Symm_None, Symm_Bi_0, Symm_Bi_90, Symm_Quad, Symm_Full or Symm_Arbitrary. The planes of the table tell "
     "what is needed."},
    {"TM30211", Severity::error, Strict::same, "not a finite number up to 1e30",
     "Infinite and undefined values, and numbers above 1e30 in magnitude, mean nothing in a photometric file: the sun "
     "has 3e27 cd, and what gonio makes of a table must fit 32-bit floats."},
    {"TM30212", Severity::warning, Strict::error, "tilt left out",
     "TiltAngles holds a factor for each of several ascending tilt angles."},
    {"TM30213", Severity::error, Strict::same, "spectrum lists of unequal length",
     "There is one value for each wavelength."},
    {"TM30301", Severity::warning, Strict::same, "symmetry does not fit the planes",
     "One plane is Symm_Full, 0 to 90 degrees Symm_Quad, 0 to 180 Symm_Bi_0, 90 to 270 Symm_Bi_90, 0 to 360 "
     "Symm_None. The planes are used as they are."},
    {"TM30302", Severity::error, Strict::same, "angle out of range",
     "No direction has such an angle: vertical angles lie in 0 to 180 degrees in type C and in -90 to 90 in types A "
     "and B; horizontal angles span one turn at most."},
    {"TM30303", Severity::warning, Strict::same, "wavelengths not ascending",
     "The points of a spectrum are listed by wavelength. They are kept as they stand."},
    {"TM30304", Severity::warning, Strict::same, "no plane at 360 degrees",
     "A table around the full turn ends with the plane at 360 degrees, equal to the one at 0. Where the gap is as "
     "wide as a step, the turn is closed with the plane at 0."},
    {"TM30401", Severity::warning, Strict::same, "negative intensity",
     "A table whose stray light was subtracted too eagerly has values below zero. They are kept."},
    {"TM30402", Severity::warning, Strict::same, "no light", "Every value of the table is zero."},
    {"TM30403", Severity::warning, Strict::same, "planes disagree at the pole",
     "All planes meet at nadir (0 degrees) and zenith (180 degrees), where there is one intensity. Here they differ "
     "by more than a thousandth of the peak; each plane keeps its own value."},
    {"TM30404", Severity::warning, Strict::same, "no luminous intensity",
     "The document describes radiant or photon intensity only, or spectra: it can be read and written, but there are "
     "no candela to work with."},
    {"TM30405", Severity::warning, Strict::error, "intensity without points",
     "The element of the luminous intensity holds no point."},
});
static_assert(in_order(profile_codes));

using ProfileCode = CodeOf<profile_codes>;

} // namespace gonio
