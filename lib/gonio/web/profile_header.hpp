// ProfileHeader: the data of a photometric file other than its table, independent of the format.
//
// The texts are LM-63 keywords, to which the fields of every format are mapped: EULUMDAT's company is MANUFAC, the
// luminaire's name LUMINAIRE, its number LUMCAT, the report's number TEST, date and user ISSUEDATE (DATE before 2002),
// the lamps' type LAMP. TM-33's elements are mapped likewise; a keyword without an element becomes a Comment "[KEYWORD]
// text". Colour temperature and colour rendering, for which LM-63 has no keyword, are the user keywords _CCT and _CRI.
// EULUMDAT and LM-63 both list a length and a width of the luminous opening, but disagree on which of them is along C0:
// sizes keep their names, because azimuths are rotated only on request.
#pragma once

#include <gonio/profile/luminous_opening.hpp>
#include <gonio/profile/profile.hpp>
#include <gonio/web/resolve.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// What a profile states about the luminaire besides its intensities, in any format.
struct ProfileHeader {
    std::string source;               // names the input in messages
    std::vector<IesKeyword> keywords; // in the file's order
    int lamp_count = 1;
    std::optional<double> lamp_flux_lm; // of all lamps together; empty for absolute photometry
    double input_watts = 0.0;
    LuminousOpening opening;

    double length_m = 0.0; // of the housing, which LM-63 does not store; 0, 0, 0: same as the luminous opening
    double width_m = 0.0;
    double height_m = 0.0;

    // The convention by which the web counts C; as_written: none, as for light that was made or turned by hand.
    AzimuthConvention azimuth = AzimuthConvention::as_written;

    // EULUMDAT only.
    std::optional<int> type_indicator; // derived from the light if not given
    double tilt_deg = 0.0;             // during the measurement
    std::string file_name;
    bool has_ratios = false; // direct ratios other than 0, which only EULUMDAT keeps

    // Data that the web already contains or cannot contain; reported when a file is made from the web.
    bool tilt_applied = false;         // a TILT table was multiplied in
    double file_generation_type = 1.0; // LM-63-2019
    std::size_t other_lamp_sets = 0;   // alternatives to the one the web was resolved with
    std::size_t emitters = 1;          // of TM-33; their tables were added
    std::size_t spectra = 0;           // of TM-33
};

// The header of a file, for a web resolved with `options`. A lamp set that the file does not have counts as the first.
ProfileHeader header_of(const Profile& profile, const ResolveOptions& options = {});

// Whether two keyword names are the same; case does not matter.
bool same_keyword(std::string_view a, std::string_view b);

// The text of the first keyword of that name, ignoring case; empty if there is none.
std::string_view keyword_text(const ProfileHeader& header, std::string_view name);

// Adds the keyword, or replaces the text of the first one of that name.
void set_keyword(ProfileHeader& header, std::string_view name, std::string_view text);

} // namespace gonio
#pragma GCC visibility pop
