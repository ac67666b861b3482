// Diagnostic codes of webs: what resolving a profile (01), writing a web back into a file (02) and the check of
// plausibility (03) may emit.
#pragma once

#include <gonio/base/diagnostic_codes.hpp>

#include <array>

namespace gonio {

inline constexpr auto web_codes = std::to_array<DiagnosticCode>({
    {"WEB0101", Severity::warning, Strict::same, "the last C-plane is missing",
     "A table without symmetry should list its first plane again at 360°. This one ends one step before; the gap is "
     "closed with the first plane."},
    {"WEB0102", Severity::warning, Strict::same, "C-planes do not cover the circle",
     "The planes end further than one step before the first one comes round again, and their range is none that means "
     "a symmetry. Outside them the light is taken as dark."},
    {"WEB0103", Severity::warning, Strict::same, "a single C-plane that is not at 0°",
     "One plane means the same light for every C, wherever it was measured."},
    {"WEB0104", Severity::warning, Strict::same, "a factor where the standard has none",
     "LM-63-1986 and -1991 have a ballast-lamp factor as the twelfth number; LM-63-1995 and -2002 reserve it as 1. It "
     "is not applied."},
    {"WEB0105", Severity::warning, Strict::same, "negative intensities",
     "Stray light that is subtracted from a measurement can leave values below 0. They count in flux and samples as "
     "they are; textures and pictures hold 0 for them."},
    {"WEB0106", Severity::warning, Strict::same, "no light", "Every intensity of the table is 0."},
    {"WEB0107", Severity::warning, Strict::same, "a table that encloses no directions",
     "A table of type A or B needs at least two horizontal and two vertical angles: between them lies its light. One "
     "angle alone is a line of directions, which carries no flux."},
    {"WEB0108", Severity::error, Strict::same, "an intensity beyond the range",
     "An intensity, with the factors that the file or its lamps give it, is above 1e30 cd. The sun has 3e27 cd; no "
     "luminaire comes near it, and textures and engines hold 32-bit floats, which end at 3.4e38. A factor or an "
     "exponent is wrong."},

    {"WEB0201", Severity::warning, Strict::same, "keywords left out",
     "The target has no place for these keywords: EULUMDAT keeps the company, the luminaire's name and number, the "
     "report's number, the date and the lamp, and nothing else."},
    {"WEB0202", Severity::warning, Strict::same, "TILT factors applied",
     "The target cannot hold the factors for a tilted lamp. The table was multiplied by the factor of one tilt, 0 "
     "unless another was asked for, and the others are lost."},
    {"WEB0203", Severity::warning, Strict::same, "other lamp sets left out",
     "EULUMDAT lists alternative sets of lamps; the target describes one. The intensities are those of the set that "
     "was asked for, the first by default."},
    {"WEB0204", Severity::warning, Strict::same, "spectrum left out",
     "The source holds a spectrum. LM-63 and EULUMDAT have no place for one."},
    {"WEB0205", Severity::warning, Strict::same, "resampled to type C",
     "The source was measured in type A or B coordinates and the target holds type C alone. The web was rotated truly "
     "and sampled on C-planes; between the samples it is interpolated, with the error that is stated."},
    {"WEB0206", Severity::note, Strict::same, "gamma range padded with zeros",
     "There is no light outside the angles of a table, but many readers repeat its first and last value there, and "
     "the formats ask for tables that begin at 0 or 90 and end at 90 or 180 degrees. Zeros were written outside, "
     "beginning 0.0001 degrees beyond the last value."},
    {"WEB0207", Severity::note, Strict::same, "dark sector padded with zeros",
     "The planes do not cover the circle, and the sector between them is dark. It was written as planes of zeros that "
     "begin 0.0001 degrees beside the last lit plane."},
    {"WEB0208", Severity::note, Strict::same, "symmetry written out",
     "The target has no such symmetry, or its readers do not know it: the mirrored planes were written out. Nothing "
     "is lost by it."},
    {"WEB0209", Severity::warning, Strict::same, "shape of the luminous opening changed",
     "The target has no code for this shape; the nearest one with the same sizes was written."},
    {"WEB0210", Severity::warning, Strict::same, "fields of EULUMDAT left out",
     "LM-63 has no place for the housing's size, the file's name, the ratios, or the tilt during the measurement."},
    {"WEB0211", Severity::warning, Strict::same, "file generation type left out",
     "LM-63-2019 says in its twelfth number how a file came about: measured, simulated, scaled, by what laboratory. "
     "Other formats do not."},
    {"WEB0212", Severity::warning, Strict::same, "text made ASCII",
     "The portable dialect is written in ASCII. Letters lost their accents, and other signs became question marks."},
    {"WEB0213", Severity::note, Strict::same, "lumens are those of the table",
     "The portable dialect has one lamp whose lumens are the flux of the table. Of -1, absolute photometry, some "
     "loaders fail and others make 1000 lumens; and some scale the light to the lumens that are declared."},
    {"WEB0214", Severity::note, Strict::same, "planes at 0 and 360 degrees kept apart",
     "The source has two different planes at the same angle. EULUMDAT lists it once; the other was written 0.0001 "
     "degrees before the full turn."},
    {"WEB0215", Severity::note, Strict::same, "required keywords added",
     "LM-63-2002 and later require [TEST], [TESTLAB], [ISSUEDATE] and [MANUFAC]. What the source does not tell was "
     "written as \"unknown\"."},
    {"WEB0217", Severity::note, Strict::same, "TILT factors taken into the file",
     "The source names another file that holds its TILT factors. They are written as TILT=INCLUDE, because that file "
     "need not lie beside the one that is written."},
    {"WEB0218", Severity::warning, Strict::same, "emitters added up",
     "TM-33 describes each emitter of a luminaire; the target has one table and one lamp. The intensities were added, "
     "the lamp's description is that of the first emitter."},
    {"WEB0219", Severity::note, Strict::same, "stored under its symmetry",
     "The table's planes repeat one another, as it was asked to look for: those that the symmetry gives back are left "
     "out. The light is the same, within the tolerance that was asked for."},

    {"WEB0301", Severity::warning, Strict::same, "more light than the lamps give",
     "The table's flux exceeds the lumens that the file declares for its lamps. Lumens of another lamp, a factor that "
     "was applied twice, or absolute photometry with lumens written beside it. The table is believed."},
    {"WEB0302", Severity::warning, Strict::same, "hardly any of the lamps' light",
     "The table's flux is below a tenth of the lumens that the file declares. Lumens of another lamp or a missing "
     "factor show like this. The table is believed."},
    {"WEB0303", Severity::error, Strict::same, "more lumens per watt than light can have",
     "Light of 555 nm alone has 683 lumens per watt, and nothing has more. The input watts are wrong, or the table "
     "is."},
    {"WEB0304", Severity::warning, Strict::same, "more lumens per watt than any luminaire has",
     "Above 300 lumens per watt no white light source is known. The input watts are likely those of another lamp."},
    {"WEB0305", Severity::note, Strict::same, "no input power",
     "The file gives no watts, so that there is no efficacy."},
    {"WEB0306", Severity::warning, Strict::same, "luminous opening of an odd size",
     "A size above 50 metres, or one that is not 0 and below half a millimetre, is written in another unit than the "
     "one that the file names."},
    {"WEB0307", Severity::warning, Strict::same, "brighter than the sun",
     "The greatest intensity over the area of the luminous opening is above the luminance of the sun's disk, 1.6e9 "
     "cd/m2. The opening is written in another unit, or the table is."},
    {"WEB0308", Severity::warning, Strict::same, "a lone value",
     "One value of the table stands far above all its neighbours, as no optic makes it: a digit too many, or an error "
     "of the measurement."},
    {"WEB0309", Severity::warning, Strict::same, "light at the edge of the table",
     "The table ends where the light still has more than a tenth of its peak. What lies beyond was not measured, and "
     "is taken as dark; programs that continue the last value see another light."},
    {"WEB0310", Severity::note, Strict::same, "a hemisphere that is dark",
     "The table lists a whole hemisphere of zeros. It could end at 90 degrees and mean the same."},
    {"WEB0311", Severity::note, Strict::same, "more planes than the light needs",
     "The light is the same in mirrored planes, which the formats allow to leave out."},
    {"WEB0312", Severity::warning, Strict::same, "downward flux fraction does not fit the table",
     "Line 22 of EULUMDAT is the share of the light that goes below the horizon, in per cent. It differs from that of "
     "the table by more than two per cent of the whole."},
    {"WEB0313", Severity::warning, Strict::same, "light output ratio does not fit the table",
     "Line 23 of EULUMDAT is the share of the lamps' flux that leaves the luminaire, in per cent. It differs from the "
     "table's by more than two per cent."},
    {"WEB0314", Severity::warning, Strict::same, "direct ratios that cannot be",
     "A direct ratio is a share of the downward flux and rises with the room's index: they lie between 0 and 1 and do "
     "not fall."},
    {"WEB0315", Severity::warning, Strict::same, "lamps without flux",
     "EULUMDAT lists candela for each 1000 lumens of the lamps. With no lumens there is no light."},
    {"WEB0316", Severity::warning, Strict::same, "luminous area larger than the luminaire",
     "The luminous area is a part of the luminaire. Its sizes, in millimetres, are larger."},
    {"WEB0317", Severity::warning, Strict::same, "colour that cannot be",
     "A colour temperature of light sources lies between 1000 and 25000 kelvin, and a colour rendering index does not "
     "exceed 100."},
});
static_assert(in_order(web_codes));

using WebCode = CodeOf<web_codes>;

} // namespace gonio
