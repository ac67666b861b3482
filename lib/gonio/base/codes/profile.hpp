// Diagnostic codes of photometric files: those that the readers may emit. PRF…: any format, IES…: LM-63, LDT…:
// EULUMDAT, TM3…: TM-33. 01 concerns the text, 02 numbers and counts, 03 angles, 04 the content of the table.
#pragma once

#include <gonio/base/diagnostic_codes.hpp>

#include <array>

namespace gonio {

inline constexpr auto profile_codes = std::to_array<DiagnosticCode>({
    {"PRF0101", Severity::error, Strict::same, "empty file", "The file is empty or holds only blanks."},
    {"PRF0102", Severity::error, Strict::same, "not a photometric file",
     "IES and EULUMDAT files are text. This file is something else under the name of a photometric file, by its first "
     "bytes or because it has control bytes: a picture, an archive, a web page in place of a download, or a resource "
     "fork that a copy left behind."},
    {"PRF0103", Severity::error, Strict::same, "format not recognised",
     "An IES file names its version in the first line or has a TILT= line. A EULUMDAT file has numbers in lines 2 "
     "to 7. A TM-33 document is XML with a known root element. This text has none of these, and the file name "
     "does not show the format."},
    {"PRF0104", Severity::warning, Strict::same, "byte order mark",
     "The text begins with the three bytes of a UTF-8 byte order mark. Both formats ask for plain text, and many "
     "readers do not recognise the first line after such a mark. The mark is ignored."},
    {"PRF0105", Severity::warning, Strict::same, "data after Ctrl-Z",
     "Ctrl-Z (byte 26) ends a text by DOS convention. Anything after it is ignored."},
    {"PRF0106", Severity::warning, Strict::error, "UTF-16 text",
     "The file is UTF-16, with two bytes per character. The formats are defined over single bytes, and hardly any "
     "other program reads UTF-16. The file is converted to UTF-8 and read; lines and columns are those of the "
     "converted text."},
    {"PRF0108", Severity::warning, Strict::same, "XML that is not UTF-8",
     "TM-33 is XML in UTF-8. This file has other bytes; it is read as Windows-1252."},

    {"IES0101", Severity::warning, Strict::same, "unusual spelling of the version line",
     "The standards write IESNA91, IESNA:LM-63-1995, IESNA:LM-63-2002 and IES:LM-63-2019, with no blanks around "
     "them. gonio understands other spellings of the same years; other programs may refuse them."},
    {"IES0102", Severity::warning, Strict::same, "unknown version",
     "The first line claims LM-63 but names no version that gonio knows. The file is read as LM-63-2002: the "
     "twelfth number is not a factor, and dimensions follow the codes of 2002."},
    {"IES0103", Severity::warning, Strict::same, "no version line",
     "Files of LM-63-1986 have no version line, and this file is read as one of them: the twelfth number is a "
     "factor. In a newer file that lost its first line, that number means something else."},
    {"IES0104", Severity::warning, Strict::same, "line without a keyword",
     "From 1991 on, every line before TILT= begins with a keyword in brackets. This line is kept as a label."},
    {"IES0105", Severity::warning, Strict::same, "[MORE] continues nothing",
     "[MORE] continues the keyword before it, but there is none here. It is kept as a keyword of its own."},
    {"IES0106", Severity::warning, Strict::same, "required keyword missing",
     "LM-63-2002 and later require [TEST], [TESTLAB], [ISSUEDATE] and [MANUFAC]."},
    {"IES0107", Severity::warning, Strict::only, "line too long",
     "LM-63-2002 allows 256 characters per line, LM-63-1995 and earlier 132, line ends included. Some readers cut "
     "longer lines."},
    {"IES0108", Severity::error, Strict::same, "no TILT= line",
     "A line TILT=NONE, TILT=INCLUDE or TILT=FILE separates the keywords from the numbers. Without it, a reader "
     "cannot tell the numbers from text."},
    {"IES0109", Severity::warning, Strict::same, "blanks in the TILT line",
     "The line should be TILT=NONE, TILT=INCLUDE or TILT=FILE, start in the first column and contain no blanks. "
     "Several programs find it only in this form."},
    {"IES0110", Severity::warning, Strict::error, "TILT line not in capitals",
     "The standard writes TILT, NONE and INCLUDE in capitals."},
    {"IES0111", Severity::warning, Strict::error, "TILT factors not read",
     "The factors for a tilted lamp are in a separate file, which must be in the same folder as the profile and "
     "be named without a folder. It could not be read, so the profile is read without factors, as for a lamp that "
     "is used in the position it was measured in. Put the factors into this file as TILT=INCLUDE."},
    {"IES0112", Severity::warning, Strict::error, "TILT file in LM-63-2019",
     "LM-63-2019 allows only TILT=NONE and TILT=INCLUDE. The file is read as in earlier editions."},
    {"IES0113", Severity::error, Strict::same, "lamp geometry out of range",
     "The lamp-to-luminaire geometry follows TILT=INCLUDE, or comes first in the file of TILT=FILE. It must be 1, "
     "2 or 3."},
    {"IES0114", Severity::error, Strict::same, "TILT table broken",
     "A TILT table states its number of tilt angles. That many ascending angles and that many factors must follow."},
    {"IES0115", Severity::warning, Strict::only, "keyword not in the standard",
     "From LM-63-2002 on, a keyword that the standard does not define begins with an underscore: [_MOUNTING]."},

    {"IES0201", Severity::error, Strict::same, "not a number",
     "After the TILT= line, the file holds only numbers, separated by blanks, commas or line ends. A comma in an "
     "IES file is always a separator, never a decimal comma."},
    {"IES0202", Severity::error, Strict::same, "not a finite number up to 1e30",
     "Infinite and undefined values, and magnitudes above 1e30, have no meaning in a photometric file: the sun "
     "has 3e27 cd. What gonio computes from a table must also fit into 32-bit floats."},
    {"IES0203", Severity::error, Strict::same, "not a whole number in range",
     "Counts and codes are whole numbers, and counts of angles are at least 1. 37.0 is read as 37."},
    {"IES0204", Severity::error, Strict::same, "vertical angles missing",
     "The fourth number after TILT states how many vertical angles follow, but there are fewer. The file is cut "
     "off, or the count is wrong."},
    {"IES0205", Severity::error, Strict::same, "horizontal angles missing",
     "The fifth number after TILT states how many horizontal angles follow, but there are fewer. The file is cut "
     "off, or the count is wrong."},
    {"IES0206", Severity::error, Strict::same, "candela values missing",
     "There must be one value for every vertical angle in every horizontal plane. The file is cut off, or a count "
     "is wrong."},
    {"IES0207", Severity::error, Strict::same, "header numbers missing",
     "There are thirteen numbers between TILT and the angles: lamps, lumens per lamp, multiplier, counts of "
     "vertical and horizontal angles, photometric type, unit, width, length, height, ballast factor, a field "
     "whose meaning depends on the version, and input watts."},
    {"IES0208", Severity::error, Strict::same, "unknown photometric type",
     "The sixth number after TILT is 1 for type C, 2 for type B and 3 for type A."},
    {"IES0209", Severity::error, Strict::same, "unknown unit of length",
     "The seventh number after TILT is 1 for feet and 2 for metres."},
    {"IES0210", Severity::warning, Strict::error, "lumens neither positive nor -1",
     "Lumens per lamp are positive, or -1 in absolute photometry. Any other value is read as absolute."},
    {"IES0211", Severity::error, Strict::same, "candela multiplier not positive",
     "The multiplier scales the whole table. Zero or a negative value leaves no usable light."},
    {"IES0212", Severity::warning, Strict::same, "ballast factor not positive",
     "The ballast factor scales the whole table and is near 1 in real luminaires."},
    {"IES0213", Severity::warning, Strict::same, "unknown value in field 12",
     "The twelfth number is a ballast-lamp factor up to 1991, and reserved as 1 in 1995 and 2002. In 2019 it is "
     "the file generation type: 1.00001 undefined, 1.0001 simulated, 1 and 1.1 tested at an unaccredited or "
     "accredited laboratory, with .001 for scaled lumens and .01 for interpolated angles. This value is none of "
     "these. It is kept, and from 1995 on it is not a factor."},
    {"IES0214", Severity::warning, Strict::same, "text after the table",
     "All announced values were read, and more text follows. It is a remark, or a count is wrong."},
    {"IES0215", Severity::warning, Strict::same, "number of lamps not positive",
     "A luminaire has at least one lamp. The count does not change the candela values."},
    {"IES0216", Severity::warning, Strict::only, "number with an exponent",
     "LM-63 writes plain decimals, and some readers stop at an exponent. gonio reads the value."},
    {"IES0217", Severity::warning, Strict::only, "count with a decimal point",
     "LM-63 has written counts and codes as integers since 1991, and some readers refuse 37.0. gonio reads the "
     "value."},
    {"IES0218", Severity::warning, Strict::same, "negative input watts",
     "The input power cannot be negative. It is kept as written."},
    {"IES0219", Severity::warning, Strict::error, "unknown shape of the luminous opening",
     "The signs of width, length and height encode the shape of the luminous opening, by a table that differs "
     "between versions. The table of this version does not have this combination. The opening is taken as the "
     "shape that it has in LM-63-1995, otherwise as a box of these dimensions."},
    {"IES0220", Severity::error, Strict::same, "line with ballast factor and watts missing",
     "Before the vertical angles stand a line of ten numbers and a line of three: ballast factor, field 12 and input "
     "watts. The second line is not there, so that the first three angles are read in its place."},

    {"IES0301", Severity::error, Strict::same, "vertical angles not ascending",
     "Vertical angles are listed from lowest to highest. A wrong count has the same effect, because the next list "
     "is then read too early or too late."},
    {"IES0302", Severity::error, Strict::same, "horizontal angles not ascending",
     "Horizontal angles are listed from lowest to highest. A wrong count has the same effect, because the lists "
     "around it are then read too early or too late."},
    {"IES0303", Severity::warning, Strict::same, "vertical angle repeated",
     "Two values are given for the same vertical angle. The intensity jumps there."},
    {"IES0304", Severity::warning, Strict::same, "horizontal angle repeated",
     "Two planes are given for the same horizontal angle. The intensity jumps there."},
    {"IES0305", Severity::warning, Strict::same, "vertical range unusual",
     "A table of type C runs from 0 or 90 to 90 or 180 degrees, a table of type A or B from -90 or 0 to 90. "
     "Directions outside the listed angles get no light."},
    {"IES0306", Severity::warning, Strict::same, "horizontal range unusual",
     "A table of type C runs from 0 to 0, 90, 180 or 360 degrees (in 1995 also from 90 to 270), a table of type A "
     "or B from -90 or 0 to 90. Directions that no symmetry covers get no light."},
    {"IES0307", Severity::error, Strict::same, "angle out of range",
     "No direction has such an angle. Vertical angles lie between 0 and 180 degrees in type C and between -90 and "
     "90 in types A and B. Horizontal angles span at most one full turn."},
    {"IES0308", Severity::warning, Strict::same, "single plane not at 0",
     "A file with one plane has the same light all around. Its horizontal angle should be 0 and is not used."},
    {"IES0309", Severity::warning, Strict::same, "no plane at 360 degrees",
     "A table over the full turn ends with the plane at 360 degrees, which equals the plane at 0. That plane is "
     "missing and the gap is one step wide, so the turn is closed with the plane at 0."},
    {"IES0310", Severity::warning, Strict::same, "planes from 90 to 270 degrees",
     "Only LM-63-1995 defines tables from 90 to 270 degrees, symmetric about the plane 90-270. gonio reads them "
     "this way in every version."},
    {"IES0311", Severity::error, Strict::same, "more vertical angles than announced",
     "The list of vertical angles seems to continue past the announced count, in the line where the horizontal "
     "angles should begin. The fourth number after TILT is too small, and every value would get the wrong angle."},

    {"IES0401", Severity::warning, Strict::same, "negative candela",
     "A table has values below zero when too much stray light was subtracted. They are kept."},
    {"IES0402", Severity::warning, Strict::same, "no light", "Every value of the table is zero."},
    {"IES0403", Severity::warning, Strict::same, "planes disagree at the pole",
     "All planes of type C meet at nadir (0 degrees) and zenith (180 degrees), where there is only one intensity. "
     "Here they differ by more than a hundredth of the peak. Each plane keeps its own value."},
    {"IES0404", Severity::warning, Strict::same, "planes at 0 and 360 degrees differ",
     "They are the same plane, but they differ by more than a thousandth of the peak. Both are kept, and the "
     "intensity jumps there."},

    {"LDT0101", Severity::error, Strict::same, "file ends in its header",
     "A EULUMDAT file has 26 lines, then six lines for each set of lamps, ten direct ratios and the table."},
    {"LDT0102", Severity::error, Strict::same, "not a number",
     "This line must hold one number. A decimal comma is read as a decimal point."},
    {"LDT0103", Severity::error, Strict::same, "not a finite number up to 1e30",
     "Infinite and undefined values, and magnitudes above 1e30, have no meaning in a photometric file: the sun "
     "has 3e27 cd. What gonio computes from a table must also fit into 32-bit floats."},
    {"LDT0104", Severity::warning, Strict::error, "blank line instead of a number",
     "This line should hold a number, but it is blank. It is read as 0."},
    {"LDT0105", Severity::warning, Strict::same, "decimal comma",
     "EULUMDAT writes a decimal point. The comma is read as a decimal point; other programs read the number only "
     "up to the comma."},
    {"LDT0106", Severity::warning, Strict::same, "text field too long",
     "EULUMDAT allows 78 characters for a text, 24 for a lamp type, 16 for its colour and 6 for its colour "
     "rendering. The whole text is kept."},
    {"LDT0107", Severity::warning, Strict::only, "file name too long",
     "EULUMDAT allows 8 characters for the file name in line 11, as DOS did. Longer names are common and "
     "harmless. The whole name is kept."},

    {"LDT0201", Severity::error, Strict::same, "not a whole number in range",
     "Counts and codes are whole numbers. There is at least one plane, one angle and one set of lamps."},
    {"LDT0202", Severity::error, Strict::same, "unknown symmetry",
     "Line 3 is 0 for no symmetry, 1 for symmetry about the vertical axis, 2 for symmetry to plane C0-C180, 3 to "
     "plane C90-C270 and 4 to both."},
    {"LDT0203", Severity::warning, Strict::error, "unknown type of luminaire",
     "Line 2 is 1 for a point source with symmetry about the vertical axis, 2 for a linear luminaire and 3 for a "
     "point source with another symmetry. Some programs write 0."},
    {"LDT0204", Severity::error, Strict::same, "C-planes missing",
     "Line 4 states how many C-planes the full turn has. All their angles are listed, even those of the planes "
     "that symmetry leaves out of the table."},
    {"LDT0205", Severity::error, Strict::same, "gamma angles missing",
     "Line 6 states how many gamma angles are listed, but there are fewer."},
    {"LDT0206", Severity::error, Strict::same, "intensities missing",
     "The table has one value for every gamma angle in every plane that the symmetry stores."},
    {"LDT0207", Severity::warning, Strict::same, "text after the table",
     "All announced values were read, and more text follows. It is a remark, or a count is wrong."},
    {"LDT0208", Severity::warning, Strict::error, "symmetric planes written out",
     "Line 3 announces a symmetry, which leaves some planes out of the table, but the table holds all of them. It "
     "is read as written, plane by plane."},
    {"LDT0209", Severity::warning, Strict::same, "plane count does not match the symmetry",
     "Symmetry to one plane needs an even number of planes, and symmetry to both planes a multiple of four. "
     "Otherwise the planes of symmetry are not among those stored."},
    {"LDT0210", Severity::warning, Strict::same, "no lamps in a set",
     "The number of lamps in a set is positive, or negative in absolute photometry."},

    {"LDT0301", Severity::error, Strict::same, "C-planes not ascending",
     "C-planes are listed from the lowest angle to the highest. A wrong count or a missing line has the same "
     "effect."},
    {"LDT0302", Severity::error, Strict::same, "gamma angles not ascending",
     "Gamma angles are listed from lowest to highest. A wrong count or a missing line has the same effect."},
    {"LDT0303", Severity::warning, Strict::same, "C-plane repeated",
     "Two planes are given at the same angle. The intensity jumps there."},
    {"LDT0304", Severity::warning, Strict::same, "gamma angle repeated",
     "Two values are given for the same gamma angle. The intensity jumps there."},
    {"LDT0305", Severity::warning, Strict::same, "C-plane distance does not match",
     "Line 5 is the distance between C-planes, or 0 when they are not equidistant. The listed angles disagree "
     "with it, and the listed angles are used."},
    {"LDT0306", Severity::warning, Strict::same, "gamma distance does not match",
     "Line 7 is the distance between gamma angles, or 0 when they are not equidistant. The listed angles disagree "
     "with it, and the listed angles are used."},
    {"LDT0307", Severity::error, Strict::same, "angle out of range",
     "C-planes lie between 0 and 360 degrees, gamma angles between 0 and 180."},
    {"LDT0308", Severity::warning, Strict::same, "gamma range unusual",
     "Gamma angles run from 0 or 90 to 90 or 180 degrees. Directions outside the listed angles get no light."},

    {"LDT0401", Severity::warning, Strict::same, "negative intensity",
     "A table has values below zero when too much stray light was subtracted. They are kept."},
    {"LDT0402", Severity::warning, Strict::same, "no light", "Every value of the table is zero."},
    {"LDT0403", Severity::warning, Strict::same, "planes disagree at the pole",
     "All planes meet at nadir (0 degrees) and zenith (180 degrees), where there is only one intensity. Here they "
     "differ by more than a hundredth of the peak. Each plane keeps its own value."},
    {"LDT0404", Severity::note, Strict::same, "direct ratios all zero",
     "The ten direct ratios are for the utilisation-factor method. They can be computed from the table."},
    {"LDT0405", Severity::warning, Strict::same, "light output ratio is zero",
     "Line 23 is the share of the lamps' flux that leaves the luminaire, in per cent. It is 100 in absolute "
     "photometry."},
    {"LDT0406", Severity::note, Strict::same, "conversion factor is not 1",
     "Line 24 is a factor for the intensities. It depends on the measurement."},
    {"LDT0407", Severity::note, Strict::same, "tilted during measurement",
     "Line 25 is the tilt of the luminaire during the measurement. It matters for road luminaires. The table is "
     "not rotated."},
    {"LDT0408", Severity::warning, Strict::same, "absolute photometry with losses",
     "A negative number of lamps means that the flux is the luminaire's own, so line 23 should be 100. The "
     "intensities are per 1000 lm of that flux, whatever line 23 says."},

    {"TM30101", Severity::error, Strict::same, "not well-formed XML",
     "The document breaks the rules of XML at this place: a tag that is not closed, an attribute without quotes, "
     "or a character that must be written as an entity."},
    {"TM30102", Severity::error, Strict::same, "not a TM-33 document",
     "The root element of TM-33 is IESTM33-22, or IESTM33 before 2023. ATLA_S001 and LuminaireOpticalData are "
     "read as well."},
    {"TM30103", Severity::warning, Strict::error, "required element missing",
     "The schema of TM-33 requires these elements. Their values are unknown."},
    {"TM30104", Severity::warning, Strict::same, "unknown version",
     "Versions 1.0 and 1.1 are known. The document is read as one of them."},
    {"TM30105", Severity::error, Strict::same, "no emitter",
     "TM-33 describes all light by Emitter elements, and this document has none."},
    {"TM30106", Severity::warning, Strict::same, "dialect of a program",
     "Some programs write LuminaireOpticalData, which describes the same as TM-33, partly with other names. gonio "
     "understands it."},
    {"TM30107", Severity::error, Strict::same, "nested too deeply",
     "TM-33 needs eight levels of elements. More than 64 are refused."},
    {"TM30201", Severity::warning, Strict::error, "not a number",
     "The element should hold a number. It is taken as not given, and written back unchanged."},
    {"TM30202", Severity::warning, Strict::error, "neither true nor false",
     "The element should be true or false. It is taken as not given, and written back unchanged."},
    {"TM30203", Severity::warning, Strict::error, "count does not match",
     "NumberMeasured, NumberHorz, NumberVert and NumberWavelength state how many points and angles there are. The "
     "points disagree with them, and the points are used."},
    {"TM30204", Severity::error, Strict::same, "points missing",
     "Every vertical angle must have a point in every horizontal plane. gonio does not interpolate scattered "
     "points."},
    {"TM30205", Severity::error, Strict::same, "point given twice",
     "Two points have the same pair of angles, so the intensity there is unknown."},
    {"TM30206", Severity::error, Strict::same, "point without angles",
     "Each point of the intensity needs a horizontal and a vertical angle, as the attributes h and v."},
    {"TM30207", Severity::error, Strict::same, "not a number in a table",
     "The points of intensities and spectra, their angles and their wavelengths must be numbers."},
    {"TM30208", Severity::error, Strict::same, "multiplier not positive",
     "The multiplier scales the whole table. Zero or a negative value leaves no usable light."},
    {"TM30209", Severity::warning, Strict::error, "implausible quantity",
     "Quantity is the number of such emitters. It does not scale the intensity. 4294967295 is -1, which a program "
     "stored as a positive number."},
    {"TM30210", Severity::warning, Strict::error, "unknown symmetry",
     "Symm is Symm_None, Symm_Bi_0, Symm_Bi_90, Symm_Quad, Symm_Full or Symm_Arbitrary. gonio takes the symmetry "
     "from the planes of the table."},
    {"TM30211", Severity::error, Strict::same, "not a finite number up to 1e30",
     "Infinite and undefined values, and magnitudes above 1e30, have no meaning in a photometric file: the sun "
     "has 3e27 cd. What gonio computes from a table must also fit into 32-bit floats."},
    {"TM30212", Severity::warning, Strict::error, "tilt left out",
     "Each Tilt in TiltAngles holds an angle and a factor, and the angles ascend. This one does not, and it is "
     "left out."},
    {"TM30213", Severity::error, Strict::same, "spectrum lists of unequal length",
     "A spectrum has one value for each wavelength."},
    {"TM30301", Severity::warning, Strict::same, "symmetry does not match the planes",
     "Symm_Full has one plane. Symm_Quad runs from 0 to 90 degrees, Symm_Bi_0 from 0 to 180, Symm_Bi_90 from 90 "
     "to 270 and Symm_None from 0 to 360. The planes are used as they are."},
    {"TM30302", Severity::error, Strict::same, "angle out of range",
     "No direction has such an angle. Vertical angles lie between 0 and 180 degrees in type C and between -90 and "
     "90 in types A and B. Horizontal angles span at most one full turn."},
    {"TM30303", Severity::warning, Strict::same, "wavelengths not ascending",
     "The points of a spectrum are listed by ascending wavelength. They are kept in the order of the file."},
    {"TM30304", Severity::warning, Strict::same, "no plane at 360 degrees",
     "A table over the full turn ends with the plane at 360 degrees, which equals the plane at 0. Where the gap "
     "is one step wide, the turn is closed with the plane at 0."},
    {"TM30401", Severity::warning, Strict::same, "negative intensity",
     "A table has values below zero when too much stray light was subtracted. They are kept."},
    {"TM30402", Severity::warning, Strict::same, "no light", "Every value of the table is zero."},
    {"TM30403", Severity::warning, Strict::same, "planes disagree at the pole",
     "All planes meet at nadir (0 degrees) and zenith (180 degrees), where there is only one intensity. Here they "
     "differ by more than a hundredth of the peak. Each plane keeps its own value."},
    {"TM30404", Severity::warning, Strict::same, "no luminous intensity",
     "The document describes only radiant or photon intensity, or spectra. It can be read and written, but there "
     "are no candela to work with."},
    {"TM30405", Severity::warning, Strict::error, "intensity without points",
     "The element for the luminous intensity holds no points."},
});
static_assert(in_order(profile_codes));

using ProfileCode = CodeOf<profile_codes>;

} // namespace gonio
