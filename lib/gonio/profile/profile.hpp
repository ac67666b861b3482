// Profile: a photometric file as it was written, with its diagnostics.
//
// Nothing is applied here: no multiplier, no ballast factor, no symmetry, no lm/klm scaling. Angles are in degrees and
// in the order of the file, lengths in the file's own unit where the format leaves a choice. The meaning of a file is
// decided once, when a Web is resolved from it (gonio/web/resolve.hpp). Writing a Profile back loses nothing.
#pragma once

#include <gonio/base/diagnostics.hpp>
#include <gonio/profile/field_places.hpp>
#include <gonio/profile/photometry_type.hpp>
#include <gonio/profile/tm33_file.hpp>

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// ANSI/IES LM-63 ------------------------------------------------------------------------------------------------------

// The edition of LM-63 that a file names in its first line.
enum class IesVersion { lm63_1986, lm63_1991, lm63_1995, lm63_2002, lm63_2019 };

const char* to_text(IesVersion version); // "LM-63-2002"

// A keyword line of an LM-63 file.
struct IesKeyword {
    std::string name; // without brackets, as written: "MANUFAC", "_LOCAL"; empty for a label line without brackets
    std::string text; // without leading blanks; lines of [MORE] are joined by '\n'
};

// An LM-63 file as written.
struct IesFile {
    IesVersion version = IesVersion::lm63_2002;
    std::string version_line;          // as written; empty when the file has none
    std::vector<IesKeyword> keywords;  // in the file's order, repeats kept
    std::string tilt_keyword = "NONE"; // the text after TILT=
    IesTilt tilt;                      // of TILT=INCLUDE, or of the file that TILT names if it could be read
    int lamp_count = 1;
    double lumens_per_lamp = -1.0; // −1: absolute photometry
    double candela_multiplier = 1.0;
    Photometry photometry = Photometry::c;
    bool feet = false;  // unit of the three dimensions
    double width = 0.0; // the signs of the three encode the luminous opening's shape, by version
    double length = 0.0;
    double height = 0.0;
    double ballast_factor = 1.0;
    double field_12 = 1.0; // ballast-lamp factor (1986, 1991), reserved (1995, 2002), file generation type (2019)
    double input_watts = 0.0;
    std::vector<double> vertical_deg;
    std::vector<double> horizontal_deg;
    std::vector<double> candela; // [horizontal][vertical], before any factor
};

// How the file was made, from field 12 since 2019, for example "test at an accredited laboratory"; nullptr for a number
// that LM-63-2019 does not list, and for older files, where the field has another meaning.
const char* file_generation_type(const IesFile& file);

// EULUMDAT ------------------------------------------------------------------------------------------------------------

// A lamp set of a EULUMDAT file.
struct LdtLampSet {
    int lamp_count = 1; // negative: absolute photometry
    std::string lamp_type;
    double flux_lm = 0.0;          // of the whole set
    std::string color_temperature; // text: "3000", "nw", …
    std::string color_rendering;   // text: "80", "1A/>90", …
    double input_watts = 0.0;      // ballast included
};

// A EULUMDAT file as written.
struct LdtFile {
    std::string company;         // line 1
    int type_indicator = 0;      // Ityp, line 2: 0 point without symmetry, 1 point with symmetry, 2 linear, 3 other
    int symmetry = 0;            // Isym, line 3: 0 none, 1 axial, 2 C0–C180, 3 C90–C270, 4 both
    int plane_count = 0;         // Mc, line 4: planes over 0–360°, not the stored ones
    double plane_step_deg = 0.0; // Dc, line 5; 0 = not equidistant
    int gamma_count = 0;         // Ng, line 6
    double gamma_step_deg = 0.0; // Dg, line 7; 0 = not equidistant
    std::string report_number;   // line 8
    std::string luminaire_name;
    std::string luminaire_number;
    std::string file_name;
    std::string date_user;  // line 12
    double length_mm = 0.0; // or diameter
    double width_mm = 0.0;  // 0: circular
    double height_mm = 0.0;
    double luminous_length_mm = 0.0; // or diameter
    double luminous_width_mm = 0.0;  // 0: circular
    double luminous_height_c0_mm = 0.0;
    double luminous_height_c90_mm = 0.0;
    double luminous_height_c180_mm = 0.0;
    double luminous_height_c270_mm = 0.0;
    double downward_flux_percent = 0.0;      // DFF
    double light_output_ratio_percent = 0.0; // LORL
    double conversion_factor = 1.0;
    double tilt_deg = 0.0;
    std::vector<LdtLampSet> lamp_sets;
    std::vector<double> direct_ratios;   // ten, for room indices 0.6 … 5
    std::vector<double> planes_deg;      // Mc angles
    std::vector<double> gammas_deg;      // Ng angles
    std::vector<double> candela_per_klm; // [stored plane][gamma]; which planes are stored follows from Isym
};

// How many of `plane_count` planes over 0–360° a EULUMDAT table stores under the symmetry 0 … 4: all; one; half plus
// one; half plus one; a quarter plus one.
constexpr int stored_plane_count(int symmetry, int plane_count) {
    if (symmetry == 1) return 1;
    if (symmetry == 2 || symmetry == 3) return plane_count / 2 + 1;
    if (symmetry == 4) return plane_count / 4 + 1;
    return plane_count;
}

// ---------------------------------------------------------------------------------------------------------------------

// A profile of any format, as read.
struct Profile {
    std::string source; // the name in diagnostics: a path, or "-"
    std::variant<IesFile, LdtFile, Tm33File> file;
    Diagnostics diagnostics; // warnings and notes; an error would have prevented the Profile
    FieldPlaces places = {}; // as read; empty for a profile that was not read
};

// The place of the field in the profile's file, or the whole file if that is not known.
Location location_of(const Profile& profile, ProfileField field);

// The same for a EULUMDAT lamp set, numbered from 1: its line if it is not the first.
Location location_of_lamps(const Profile& profile, ProfileField field, int lamp_set);

} // namespace gonio
#pragma GCC visibility pop
